// SPDX-License-Identifier: BSD-3-Clause
#include "CostOnSphere.h"
#include "Machine.h"
#include "TrialRun.h"
#include "VtkMesh.h"
#include "palpate/evaluation/LagrangeElimination.h"
#include "palpate/evaluation/PaperSolver.h"
#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/RaySolver.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace palpate::evaluation {

namespace {

/// Seconds that parts may take, over all motions of a subject.
struct Times
{
    double truth, bruteForce, other;
    int motion_ms;
    int largestSphere;
};
constexpr Times kQuick{2.5, 0.3, 1.0, 600, 64};
constexpr Times kFull{60.0, 3.0, 20.0, 3000, 256};
constexpr double kNoLimit_s = 1e6;

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g %% of the triangles", 100.0 * share);
    return text;
}

class Evaluator
{
  public:
    Evaluator(const EvaluateOptions& options, std::size_t subjects)
        : m_options(options)
        , m_times(options.isQuick ? kQuick : kFull)
        , m_parts(static_cast<double>(subjects * 9 + (options.withHardCases ? 6 : 0) + 2))
    {
        m_times.truth /= static_cast<double>(subjects);
        m_times.other /= static_cast<double>(subjects);
        m_times.bruteForce /= static_cast<double>(subjects);
    }

    Evaluation run(const std::vector<std::shared_ptr<const Subject>>& subjects, const HandMotion* given);

  private:
    bool next(const std::string& what, double weight = 1.0)
    {
        m_result.isCancelled =
            m_result.isCancelled || (m_options.progress && !m_options.progress(std::min(1.0, m_done / m_parts), what));
        m_done += weight;
        return !m_result.isCancelled;
    }
    void evaluateSubject(const Subject& subject, const std::vector<HandMotion>& motions);
    void feel(Trial description, ReferenceSolver& solver, const Surface& own, bool isGodObject, double seconds);
    void feelDecimated(const Subject& subject);
    void feelSpheres();
    void elimination();

    const EvaluateOptions& m_options;
    Times m_times;
    double m_parts, m_done = 0.0;
    Evaluation m_result;
    const Subject* m_subject = nullptr;
    const std::vector<HandMotion>* m_motions = nullptr;
    std::vector<Truth> m_truths;
};

Evaluation Evaluator::run(const std::vector<std::shared_ptr<const Subject>>& subjects, const HandMotion* given)
{
    const auto started = std::chrono::steady_clock::now();
    m_result.machine = thisMachine();
    m_result.seed = m_options.seed;
    m_result.stiffness_N_per_mm = m_options.stiffness_N_per_mm;
    m_result.isQuick = m_options.isQuick;
    m_result.vectorField = measureVectorField();
    elimination();
    for (const auto& subject : subjects) {
        const std::vector<HandMotion> motions =
            given != nullptr ? std::vector{*given}
                             : standardMotions(subject->surface, m_options.seed, m_times.motion_ms);
        if (m_result.motions.empty()) {
            for (const HandMotion& motion : motions) {
                m_result.motions.push_back(motion.name);
            }
        }
        evaluateSubject(*subject, motions);
    }
    feelSpheres();
    if (m_options.withHardCases && !m_result.isCancelled) {
        const double from = m_done / m_parts;
        m_result.hardCases = runHardCases(m_options.isQuick, [&](double share, const std::string& what) {
            return !m_options.progress || m_options.progress(from + share * (1.0 - from), what);
        });
    }
    m_result.advice = adviceFor(m_result);
    m_result.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return std::move(m_result);
}

void Evaluator::elimination()
{
    const std::array<Plane, 3> planes{Plane{Vec3::UnitX(), 0.0}, Plane{Vec3::UnitY(), 0.0}, Plane{Vec3::UnitZ(), 0.0}};
    for (std::size_t k = 1; k <= 3; ++k) {
        m_result.eliminationOperations[k - 1] =
            eliminate(Vec3(-1, -2, -3), std::span(planes).first(k)).multiplicativeOperations;
    }
}

void Evaluator::feel(Trial description, ReferenceSolver& solver, const Surface& own, bool isGodObject, double seconds)
{
    description.subject = m_subject->name;
    description.solver = solver.name();
    description.triangles = own.triangleCount();
    TrialRun run(std::move(description), own, isGodObject ? &m_subject->surface : nullptr,
                 m_options.stiffness_N_per_mm);
    for (std::size_t i = 0; i < m_motions->size(); ++i) {
        run.feel(solver, (*m_motions)[i], m_truths[i],
                 seconds >= kNoLimit_s ? seconds : seconds / static_cast<double>(m_motions->size()));
        if (i == 0 && run.result().knob == Knob::Solver) {
            m_result.series.push_back(run.series());
        }
    }
    m_result.trials.push_back(run.result());
}

void Evaluator::evaluateSubject(const Subject& subject, const std::vector<HandMotion>& motions)
{
    m_subject = &subject;
    m_motions = &motions;
    m_truths.clear();
    const double extent = subject.surface.bounds().sizes().maxCoeff();
    m_result.subjects.push_back({subject.name, subject.hash, subject.surface.triangleCount(), extent,
                                 subject.scene->byteSize(), subject.build_ms});
    Trial exact;
    exact.subject = subject.name;
    exact.solver = "exact";
    exact.triangles = subject.surface.triangleCount();
    exact.isReference = true;
    for (const HandMotion& motion : motions) {
        if (!next(subject.name + ": exact, " + motion.name)) {
            return;
        }
        const Truth& truth = m_truths.emplace_back(
            truthOf(subject.surface, motion, m_times.truth / static_cast<double>(motions.size())));
        exact.ticks += truth.samples / 4;
        exact.wanted += motion.p_WH.size() / 4;
        if (exact.time_us.count == 0 || truth.time_us.p50 > exact.time_us.p50) {
            exact.time_us = truth.time_us;
        }
    }
    m_result.trials.push_back(exact);

    const Surface& surface = subject.surface;
    if (!next(subject.name + ": product")) {
        return;
    }
    ProductSolver product(subject.scene, "Palpate");
    feel({}, product, surface, true, kNoLimit_s);
    Trial onePass;
    onePass.knob = Knob::OnePass;
    onePass.setting = "one pass a tick";
    ProductSolver single(subject.scene, "Palpate", 1);
    feel(onePass, single, surface, true, kNoLimit_s);
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        Trial trial;
        trial.knob = Knob::Rate;
        trial.knobValue = trial.rate_Hz = rate;
        trial.setting = std::to_string(std::lround(rate)) + " Hz held";
        feel(trial, product, surface, true, kNoLimit_s);
    }
    if (!next(subject.name + ": VTK locator")) {
        return;
    }
    RaySolver vtk(surface, makeVtkCaster(surface));
    feel({}, vtk, surface, true, m_times.other);
    if (auto caster = makeEmbreeCaster(surface)) {
        RaySolver embree(surface, std::move(caster));
        feel({}, embree, surface, true, m_times.other);
    }
    if (!next(subject.name + ": paper and vector field")) {
        return;
    }
    {
        PaperSolver paper(surface);
        feel({}, paper, surface, true, m_times.bruteForce);
    }
    VectorFieldSolver nearest(surface), sum(surface, VectorFieldSolver::Overlap::Sum);
    feel({}, nearest, surface, false, m_times.bruteForce);
    if (surface.componentCount() > 1 && surface.componentCount() < 100) {
        feel({}, sum, surface, false, m_times.bruteForce);
    }
    feelDecimated(subject);
    markFront(m_result.trials, subject.name);
}

void Evaluator::feelDecimated(const Subject& subject)
{
    for (const double share : {0.5, 0.25, 0.1, 0.05, 0.01}) {
        if (!next(subject.name + ": " + percent(share), 0.5)) {
            return;
        }
        const geometry::TriangleMesh fewer = decimated(subject.surface.repaired().mesh, share);
        const Surface own(geometry::repair(fewer));
        if (own.triangleCount() < 8) {
            continue;
        }
        Trial trial;
        trial.knob = Knob::Decimated;
        trial.knobValue = share;
        trial.setting = percent(share);
        ProductSolver product(sceneOf(own.repaired()), "Palpate");
        feel(trial, product, own, false, kNoLimit_s);
    }
}

void Evaluator::feelSpheres()
{
    for (int n = 8; n <= m_times.largestSphere; n *= 2) {
        if (!next("sphere of " + std::to_string(20 * n * n) + " triangles", 0.3)) {
            return;
        }
        for (SizePoint& point : costOnSphere(n, m_times.other, m_times.bruteForce)) {
            m_result.sizes.push_back(std::move(point));
        }
    }
}

} // namespace

Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects, const HandMotion* given,
                    const EvaluateOptions& options)
{
    return Evaluator(options, subjects.size()).run(subjects, given);
}

std::vector<HardCaseResult> runHardCases(bool isQuick, const std::function<bool(double, const std::string&)>& progress)
{
    constexpr std::int64_t kQuickTicks = 20000;
    std::vector<HardCaseResult> results;
    const auto& cases = hardCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(cases.size());
        if (cases[i].isLong || (isQuick && cases[i].ticks > kQuickTicks)) {
            continue;
        }
        const auto keepGoing = [&] { return !progress || progress(share, cases[i].name); };
        if (!keepGoing()) {
            break;
        }
        results.push_back(run(cases[i], keepGoing));
    }
    return results;
}

} // namespace palpate::evaluation
