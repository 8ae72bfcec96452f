// SPDX-License-Identifier: BSD-3-Clause
#include "Advice.h"
#include "ChartAxis.h"
#include "CostOnSphere.h"
#include "Evaluator.h"
#include "Machine.h"
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

constexpr Times kQuick{2.5, 0.3, 1.0, 600, 64};
constexpr Times kFull{60.0, 3.0, 20.0, 3000, 256};
constexpr double kNoLimit_s = 1e6;
constexpr double kFullSize_mm = 100.0;  // what is smaller gets a smaller fingertip
constexpr double kBallTruthShare = 0.7; // of the time for a ball: the exact one is brute force
// Of a limited time, the subjects' share; the spheres and the hard cases get the rest. And the truth's share of that.
constexpr double kSubjectsShare = 0.6, kTruthShare = 0.3;
constexpr int kTissueSphere = 32;      // 20,480 triangles
constexpr double kDecimation_s = 2e-5; // for each triangle removed, until it has been measured

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g %% of the triangles", 100.0 * share);
    return text;
}

std::string ballOf(double radius_mm)
{
    return "ball of " + shortNumber(radius_mm) + " mm";
}

} // namespace

Evaluator::Evaluator(const EvaluateOptions& options, std::size_t subjects)
    : m_options(options)
    , m_times(options.isQuick ? kQuick : kFull)
    , m_limit_s(options.seconds > 0.0 ? options.seconds : kNoLimit_s)
    , m_subjects(static_cast<double>(subjects))
    , m_parts(m_subjects * kPartsOfASubject + (options.withHardCases ? 6 : 0) + 2)
    , m_decimation_s(kDecimation_s)
{
    m_times.truth /= m_subjects;
    m_times.other /= m_subjects;
    m_times.bruteForce /= m_subjects;
}

Evaluation Evaluator::run(const std::vector<std::shared_ptr<const Subject>>& subjects,
                          const std::vector<HandMotion>& given)
{
    m_result.machine = thisMachine();
    m_result.seed = m_options.seed;
    m_result.isQuick = m_options.isQuick;
    m_result.vectorField = measureVectorField();
    elimination();
    double remaining = m_subjects;
    for (const auto& subject : subjects) {
        std::vector<HandMotion> motions;
        if (given.empty() || m_options.withLaidMotions) {
            motions = standardMotions(subject->layers.front().surface, m_options.seed, m_times.motion_ms);
        }
        motions.insert(motions.end(), given.begin(), given.end());
        if (m_result.motions.empty()) {
            for (const HandMotion& motion : motions) {
                m_result.motions.push_back(motion.name);
            }
        }
        const double left = std::max(0.0, kSubjectsShare * m_limit_s - elapsed_s());
        evaluateSubject(*subject, motions, left / remaining);
        remaining -= 1.0;
    }
    feelSpheres();
    if (m_options.withHardCases && !m_result.isCancelled) {
        runHard();
    }
    m_result.advice = adviceFor(m_result);
    m_result.duration_s = elapsed_s();
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

void Evaluator::feel(Trial description, LayerSolvers solvers, const std::vector<const Surface*>& own, bool isOnTruth,
                     double seconds, bool fromContact)
{
    description.subject = m_subject->name;
    description.solver = solvers.front()->name();
    for (const Surface* surface : own) {
        description.triangles += surface->triangleCount();
    }
    TrialRun run(std::move(description), own, isOnTruth);
    for (std::size_t i = 0; i < m_motions->size(); ++i) {
        run.feel(solvers, (*m_motions)[i], m_truths[i], seconds / static_cast<double>(m_motions->size()), fromContact);
        if (i == 0 && run.result().knob == Knob::Solver) {
            m_result.series.push_back(run.series());
        }
    }
    m_result.trials.push_back(run.result());
}

/// @param make  makes the solver of one layer, told its surface and its number
template<class Make>
void Evaluator::feelOn(const Subject& subject, Trial description, bool isGodObject, double seconds, bool fromContact,
                       const Make& make)
{
    LayerSolvers solvers;
    std::vector<const Surface*> own;
    for (std::size_t l = 0; l < subject.layers.size(); ++l) {
        own.push_back(&subject.layers[l].surface);
        solvers.push_back(make(subject.layers[l].surface, l));
        if (solvers.back() == nullptr) {
            return; // not in this build
        }
    }
    feel(std::move(description), std::move(solvers), own, isGodObject, seconds, fromContact);
}

void Evaluator::findTruth(const Subject& subject, double seconds)
{
    m_truths.clear();
    Trial exact;
    exact.subject = subject.name;
    exact.solver = "exact";
    exact.triangles = subject.triangleCount();
    exact.isReference = true;
    for (const HandMotion& motion : *m_motions) {
        if (!next(subject.name + ": exact, " + motion.name)) {
            return;
        }
        const Truth& truth =
            m_truths.emplace_back(truthOf(subject, motion, seconds / static_cast<double>(m_motions->size())));
        exact.ticks += truth.samples / 4;
        exact.wanted += motion.p_WH.size() / 4;
        if (exact.time_us.count == 0 || truth.time_us.p50 > exact.time_us.p50) {
            exact.time_us = truth.time_us;
        }
    }
    m_result.trials.push_back(exact);
}

std::vector<Evaluator::Part> Evaluator::partsOf(const Subject& subject)
{
    using Solver = std::unique_ptr<ReferenceSolver>;
    std::vector<Part> parts;
    const auto product = [this, &subject](const Trial& trial, std::uint32_t iterations) {
        return [this, &subject, trial, iterations](double seconds) {
            feelOn(subject, trial, true, seconds, false, [&](const Surface&, std::size_t layer) -> Solver {
                return std::make_unique<ProductSolver>(subject.scene, "Palpate", iterations, layer);
            });
        };
    };
    parts.push_back({"Palpate", product({}, 0)});
    Trial onePass;
    onePass.knob = Knob::OnePass;
    onePass.setting = "one pass a tick";
    parts.push_back({"one pass a tick", product(onePass, 1)});
    // Smaller on what is small.
    const double size = std::min(1.0, subject.bounds().sizes().maxCoeff() / kFullSize_mm);
    for (const double radius : {0.5, 1.0, 2.0}) {
        parts.push_back(
            {ballOf(size * radius), [this, &subject, size, radius](double s) { feelBall(subject, size * radius, s); }});
    }
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        Trial trial;
        trial.knob = Knob::Rate;
        trial.knobValue = trial.rate_Hz = rate;
        trial.setting = "force held at " + std::to_string(std::lround(rate)) + " Hz";
        parts.push_back({trial.setting, product(trial, 0)});
    }
    const auto other = [&](const std::string& what, bool isGodObject, bool isBruteForce, auto make) {
        parts.push_back({what, [this, &subject, isGodObject, isBruteForce, make](double seconds) {
                             feelOn(subject, {}, isGodObject,
                                    std::min(seconds, isBruteForce ? m_times.bruteForce : m_times.other), isBruteForce,
                                    make);
                         }});
    };
    other("VTK locator", true, false, [](const Surface& surface, std::size_t) -> Solver {
        return std::make_unique<RaySolver>(surface, makeVtkCaster(surface));
    });
    other("Embree", true, false, [](const Surface& surface, std::size_t) -> Solver {
        auto caster = makeEmbreeCaster(surface);
        return caster == nullptr ? nullptr : std::make_unique<RaySolver>(surface, std::move(caster));
    });
    other("paper", true, true,
          [](const Surface& surface, std::size_t) -> Solver { return std::make_unique<PaperSolver>(surface); });
    other("vector field", false, true,
          [](const Surface& surface, std::size_t) -> Solver { return std::make_unique<VectorFieldSolver>(surface); });
    const auto isWorthSumming = [](const SubjectLayer& layer) {
        return layer.surface.componentCount() > 1 && layer.surface.componentCount() < 100;
    };
    if (std::any_of(subject.layers.begin(), subject.layers.end(), isWorthSumming)) {
        other("vector field, summed", false, true, [](const Surface& surface, std::size_t) -> Solver {
            return std::make_unique<VectorFieldSolver>(surface, VectorFieldSolver::Overlap::Sum);
        });
    }
    for (const double share : {0.5, 0.25, 0.1, 0.05, 0.01}) {
        parts.push_back(
            {percent(share), [this, &subject, share](double seconds) { feelDecimated(subject, share, seconds); }});
    }
    return parts;
}

void Evaluator::evaluateSubject(const Subject& subject, const std::vector<HandMotion>& motions, double seconds)
{
    if (m_result.isCancelled) {
        return;
    }
    m_subject = &subject;
    m_motions = &motions;
    m_fewer.clear();
    m_subjectEnd_s = elapsed_s() + seconds;
    SubjectInfo info;
    info.name = subject.name;
    info.hash = subject.hash;
    for (const SubjectLayer& layer : subject.layers) {
        info.structures.insert(info.structures.end(), layer.structures.begin(), layer.structures.end());
    }
    info.layers = subject.layers.size();
    info.triangles = subject.triangleCount();
    info.extent_mm = subject.bounds().sizes().maxCoeff();
    info.bytes = subject.scene->byteSize();
    info.build_ms = subject.build_ms;
    m_result.subjects.push_back(std::move(info));

    findTruth(subject, std::min(m_times.truth, kTruthShare * seconds));
    const std::vector<Part> parts = partsOf(subject);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!next(subject.name + ": " + parts[i].what, (kPartsOfASubject - 3.0) / static_cast<double>(parts.size()))) {
            return;
        }
        const double left = m_subjectEnd_s - elapsed_s();
        if (i > 0 && left <= 0.0) {
            m_result.leftOut.push_back(subject.name + ": " + parts[i].what + ", for lack of time");
            continue;
        }
        parts[i].measure(std::min(m_times.other, left / static_cast<double>(parts.size() - i)));
    }
    markFront(m_result.trials, subject.name);
}

/// A ball has a truth of its own: where the exact ball is.
void Evaluator::feelBall(const Subject& subject, double fingertip_mm, double seconds)
{
    std::vector<Truth> truths;
    for (const HandMotion& motion : *m_motions) {
        truths.push_back(
            truthOf(subject, motion, kBallTruthShare * seconds / static_cast<double>(m_motions->size()), fingertip_mm));
    }
    const auto scene = std::make_shared<haptics::HapticScene>(subject.scene->structures(), fingertip_mm);
    Trial trial;
    trial.knob = Knob::Radius;
    trial.knobValue = trial.fingertip_mm = fingertip_mm;
    trial.setting = ballOf(fingertip_mm);
    std::swap(truths, m_truths);
    feelOn(subject, trial, true, (1.0 - kBallTruthShare) * seconds, false,
           [&](const Surface&, std::size_t layer) -> std::unique_ptr<ReferenceSolver> {
               return std::make_unique<ProductSolver>(scene, "Palpate", 0, layer);
           });
    std::swap(truths, m_truths);
}

/// Each copy is made from the one before, which takes a quarter of the time of making each from all triangles.
void Evaluator::feelDecimated(const Subject& subject, double share, double seconds)
{
    if (m_fewer.empty()) {
        for (const SubjectLayer& layer : subject.layers) {
            m_fewer.push_back(layer.surface.repaired().mesh);
        }
    }
    double removed = 0.0;
    for (std::size_t l = 0; l < m_fewer.size(); ++l) {
        removed += static_cast<double>(m_fewer[l].triangles.size()) - share * subject.layers[l].surface.triangleCount();
    }
    if (removed * m_decimation_s > m_subjectEnd_s - elapsed_s()) {
        m_result.leftOut.push_back(subject.name + ": " + percent(share) + ", for lack of time");
        return;
    }
    const double before = elapsed_s();
    for (std::size_t l = 0; l < m_fewer.size(); ++l) {
        const auto now = static_cast<double>(m_fewer[l].triangles.size());
        m_fewer[l] = decimated(m_fewer[l], share * subject.layers[l].surface.triangleCount() / std::max(1.0, now));
    }
    m_decimation_s = std::max(kDecimation_s, (elapsed_s() - before) / std::max(1.0, removed));
    std::vector<Surface> surfaces;
    std::vector<const Surface*> own;
    LayerSolvers solvers;
    surfaces.reserve(m_fewer.size());
    for (const geometry::TriangleMesh& mesh : m_fewer) {
        own.push_back(&surfaces.emplace_back(geometry::repair(mesh)));
        if (own.back()->triangleCount() < 8) {
            return;
        }
        solvers.push_back(std::make_unique<ProductSolver>(sceneOf(own.back()->repaired()), "Palpate"));
    }
    Trial trial;
    trial.knob = Knob::Decimated;
    trial.knobValue = share;
    trial.setting = percent(share);
    feel(trial, std::move(solvers), own, false, seconds);
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
    m_result.ratios = ratiosOf(m_result.sizes);
    m_result.tissues = costOfTissue(kTissueSphere, m_times.other);
}

void Evaluator::runHard()
{
    const double from = m_done / m_parts;
    const HardCaseChoice choice = m_options.isQuick ? HardCaseChoice::Quick : HardCaseChoice::Ordinary;
    bool isTimeUp = false;
    m_result.hardCases = runHardCases(choice, [&](double share, const std::string& what) {
        isTimeUp = isTimeUp || elapsed_s() > m_limit_s;
        return !isTimeUp && (!m_options.progress || m_options.progress(from + share * (1.0 - from), what));
    });
    if (const std::size_t missing = hardCaseCount(choice) - m_result.hardCases.size(); missing > 0) {
        m_result.isCancelled = !isTimeUp;
        m_result.leftOut.push_back(std::to_string(missing) + " of " + std::to_string(hardCaseCount(choice)) +
                                   " hard cases, for lack of time");
    }
    if (const std::size_t longer = hardCaseCount(HardCaseChoice::All) - hardCaseCount(choice); longer > 0) {
        m_result.leftOut.push_back(std::to_string(longer) + (longer == 1 ? " hard case" : " hard cases") +
                                   " of many ticks: palpate evaluate --stability --long");
    }
}

Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects, const std::vector<HandMotion>& given,
                    const EvaluateOptions& options)
{
    return Evaluator(options, subjects.size()).run(subjects, given);
}

} // namespace palpate::evaluation
