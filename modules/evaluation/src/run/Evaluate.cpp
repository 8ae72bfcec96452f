// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/LagrangeElimination.h"
#include "palpate/evaluation/PaperBody.h"
#include "palpate/evaluation/PaperSolver.h"
#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/RaySolver.h"
#include "peers/VtkMesh.h"
#include "report/Advice.h"
#include "report/ChartAxis.h"
#include "run/CostOnSphere.h"
#include "run/Evaluator.h"
#include "run/Machine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace palpate::evaluation {

namespace {

constexpr Extent kQuick{3, 600, 2.0, 22.0, 1.0, 1.0, 64};
constexpr Extent kFull{16, 1000, 20.0, 560.0, 6.0, 20.0, 256};
constexpr double kFullSize_mm = 100.0; // smaller subjects get a smaller fingertip
constexpr double kSubjectsShare = 0.6; // fraction of the time; the rest is for the spheres and the hard cases
constexpr double kHardShare = 0.2;     // fraction of the time reserved for the hard cases, even when late
constexpr double kFirstShare = 0.3;    // fraction of the remaining time for one part of the first path
constexpr int kTissueSphere = 32;      // 20,480 triangles
constexpr std::size_t kStride = 4;     // base samples per tick at 1 kHz
constexpr double kDecimation_s = 2e-5; // per removed triangle, measured on a slow case
constexpr std::uint32_t kFewestTriangles = 8;

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

/// Returns one solver per layer, or an empty result if the solver is not available in this build.
template<class Make>
LayerSolvers solversOf(const Subject& subject, const Make& make)
{
    LayerSolvers solvers;
    for (std::size_t l = 0; l < subject.layers.size(); ++l) {
        solvers.push_back(make(subject.layers[l].surface, l));
        if (solvers.back() == nullptr) {
            return {};
        }
    }
    return solvers;
}

std::vector<const Surface*> surfacesOf(const Subject& subject)
{
    std::vector<const Surface*> surfaces;
    for (const SubjectLayer& layer : subject.layers) {
        surfaces.push_back(&layer.surface);
    }
    return surfaces;
}

LayerSolvers productOn(const Subject& subject, const std::shared_ptr<const haptics::HapticScene>& scene,
                       std::uint32_t iterations = 0)
{
    return solversOf(subject, [&](const Surface&, std::size_t layer) {
        return std::make_unique<ProductSolver>(scene, "Palpate", iterations, layer);
    });
}

LayerSolvers paperOn(const Subject& subject, PaperSolver::Search search)
{
    return solversOf(subject, [search](const Surface& surface, std::size_t) {
        return std::make_unique<PaperSolver>(surface, search);
    });
}

std::size_t samplesOf(const HandPaths& path)
{
    std::size_t samples = 0;
    for (const HandMotion& motion : path.motions) {
        samples += motion.p_WH.size();
    }
    return samples;
}

} // namespace

Evaluator::Evaluator(const EvaluateOptions& options, std::size_t subjects)
    : m_options(options)
    , m_extent(options.isQuick ? kQuick : kFull)
    , m_subjects(static_cast<double>(subjects))
{
    m_extent.limit_s = options.seconds > 0.0 ? options.seconds : m_extent.limit_s;
    m_extent.seeds = options.seeds > 0 ? options.seeds : m_extent.seeds;
    m_extent.bruteForce_s /= m_subjects;
}

bool Evaluator::next(const std::string& what)
{
    m_result.isCancelled =
        m_result.isCancelled || (m_options.progress && !m_options.progress(std::min(1.0, m_done / m_parts), what));
    m_done += 1.0;
    return !m_result.isCancelled;
}

std::vector<HandPaths> Evaluator::pathsOn(const Surface& surface, const std::vector<HandMotion>& given)
{
    std::vector<HandPaths> paths;
    for (int i = 0; i < m_extent.seeds && (given.empty() || m_options.withGeneratedMotions); ++i) {
        const std::uint64_t seed = m_options.seed + static_cast<std::uint64_t>(i);
        paths.push_back({"seed " + std::to_string(seed), standardMotions(surface, seed, m_extent.motion_ms)});
    }
    for (const HandMotion& motion : given) {
        paths.push_back({motion.name, {motion}});
        std::vector<Vec3>& samples = paths.back().motions.front().p_WH;
        const auto most = static_cast<std::size_t>(m_extent.given_s * HandMotion::kBase_Hz);
        if (samples.size() > most) {
            samples.resize(most);
            const std::string line = motion.name + ": all but its first " + shortNumber(m_extent.given_s) + " s";
            if (std::find(m_result.skippedItems.begin(), m_result.skippedItems.end(), line) ==
                m_result.skippedItems.end()) {
                m_result.skippedItems.push_back(line);
            }
        }
    }
    return paths;
}

Evaluation Evaluator::run(const std::vector<std::shared_ptr<const Subject>>& subjects,
                          const std::vector<HandMotion>& given)
{
    m_result.machine = thisMachine();
    m_result.seed = m_options.seed;
    m_result.isQuick = m_options.isQuick;
    m_result.vectorField = measureVectorField();
    m_result.corners = forceInCorners();
    if (m_options.isQuick) {
        m_result.skippedItems.push_back("smooth surfaces");
        m_result.skippedItems.push_back("moving surfaces");
    } else {
        m_result.smooth = compareSmoothSurfaces();
        m_result.moving = compareMotions();
    }
    elimination();
    const double pathCount = m_extent.seeds + static_cast<double>(given.size());
    m_parts = m_subjects * pathCount * 3.0 + (m_options.withHardCases ? m_subjects * pathCount : 0.0) + 3.0;
    double remaining = m_subjects;
    for (const auto& subject : subjects) {
        const std::vector<HandPaths> paths = pathsOn(subject->layers.front().surface, given);
        if (m_result.motions.empty()) {
            for (const HandPaths& path : {paths.front(), paths.back()}) {
                for (const HandMotion& motion : path.motions) {
                    if (std::find(m_result.motions.begin(), m_result.motions.end(), motion.name) ==
                        m_result.motions.end()) {
                        m_result.motions.push_back(motion.name);
                    }
                }
            }
        }
        const double left = std::max(0.0, kSubjectsShare * m_extent.limit_s - (threadTime_s() - m_startedThread_s));
        evaluateSubject(*subject, paths, threadTime_s() + left / remaining);
        remaining -= 1.0;
    }
    evaluatePaperBody();
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

void Evaluator::addPart(Trial description, const std::vector<const Surface*>& own, bool isOnTruth, LayerSolvers solvers,
                        LayerSolvers timed)
{
    description.subject = m_exact.subject;
    description.solver = solvers.front()->name();
    for (const Surface* surface : own) {
        description.triangles += surface->triangleCount();
    }
    m_marks.push_back({TrialRun(std::move(description), own, isOnTruth), std::move(solvers), std::move(timed)});
}

/// Adds the product with default settings, with one pass per tick, at four rates and with three fingertip radii.
void Evaluator::addProducts(const Subject& subject)
{
    const std::vector<const Surface*> own = surfacesOf(subject);
    Trial onePass;
    onePass.knob = Knob::OnePass;
    onePass.setting = "one pass a tick";
    addPart(onePass, own, true, productOn(subject, subject.scene, 1));
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        Trial trial;
        trial.knob = Knob::Rate;
        trial.variationValue = trial.rate_Hz = rate;
        trial.setting = "force held at " + std::to_string(std::lround(rate)) + " Hz";
        addPart(trial, own, true, productOn(subject, subject.scene));
    }
    const double size = std::min(1.0, subject.bounds().sizes().maxCoeff() / kFullSize_mm);
    for (const double radius : {0.5, 1.0, 2.0}) {
        Trial trial;
        trial.knob = Knob::Radius;
        trial.variationValue = trial.fingertip_mm = size * radius;
        trial.setting = ballOf(trial.fingertip_mm);
        addPart(trial, own, true,
                productOn(subject,
                          std::make_shared<haptics::HapticScene>(subject.scene->structures(), trial.fingertip_mm)));
    }
}

void Evaluator::addOthers(const Subject& subject)
{
    const std::vector<const Surface*> own = surfacesOf(subject);
    addPart({}, own, true, solversOf(subject, [](const Surface& surface, std::size_t) {
                return std::make_unique<RaySolver>(surface, makeVtkCaster(surface));
            }));
    LayerSolvers embree = solversOf(subject, [](const Surface& surface, std::size_t) -> std::unique_ptr<RaySolver> {
        auto caster = makeEmbreeCaster(surface);
        return caster == nullptr ? nullptr : std::make_unique<RaySolver>(surface, std::move(caster));
    });
    const std::string noEmbree =
        "Embree: not in this build; install libembree-dev (Debian), configure with cmake and build again";
    if (!embree.empty()) {
        addPart({}, own, true, std::move(embree));
    } else if (std::find(m_result.skippedItems.begin(), m_result.skippedItems.end(), noEmbree) ==
               m_result.skippedItems.end()) {
        m_result.skippedItems.push_back(noEmbree);
    }
    // The god-object of this solver may be a roundoff behind a facet, so the exact solver cannot start from its state.
    addPart({}, own, false, paperOn(subject, PaperSolver::Search::Boxes),
            paperOn(subject, PaperSolver::Search::BruteForce));
    using Overlap = VectorFieldSolver::Overlap;
    const auto field = [&](Overlap overlap) {
        addPart({}, own, false, solversOf(subject, [overlap](const Surface& surface, std::size_t) {
                    return std::make_unique<VectorFieldSolver>(surface, overlap);
                }));
    };
    field(Overlap::Nearest);
    const auto isWorthSumming = [](const SubjectLayer& layer) {
        return layer.surface.componentCount() > 1 && layer.surface.componentCount() < 100;
    };
    if (std::any_of(subject.layers.begin(), subject.layers.end(), isWorthSumming)) {
        field(Overlap::Sum);
    }
}

/// Decimates each copy from the previous one, which takes a quarter of the time of decimating the full mesh each time.
void Evaluator::addDecimated(const Subject& subject, double end_s)
{
    std::vector<geometry::TriangleMesh> fewer;
    for (const SubjectLayer& layer : subject.layers) {
        fewer.push_back(layer.surface.repaired().mesh);
    }
    double perTriangle_s = kDecimation_s;
    for (const double share : {0.5, 0.25, 0.1, 0.05, 0.01}) {
        double removed = 0.0;
        for (std::size_t l = 0; l < fewer.size(); ++l) {
            removed +=
                static_cast<double>(fewer[l].triangles.size()) - share * subject.layers[l].surface.triangleCount();
        }
        const double before_s = threadTime_s();
        if (removed * perTriangle_s > end_s - before_s) {
            leaveOut(subject.name + ": " + percent(share));
            continue;
        }
        std::vector<const Surface*> own;
        LayerSolvers solvers;
        for (std::size_t l = 0; l < fewer.size(); ++l) {
            const auto now = static_cast<double>(fewer[l].triangles.size());
            fewer[l] = decimated(fewer[l], share * subject.layers[l].surface.triangleCount() / std::max(1.0, now));
            m_fewer.push_back(std::make_unique<Surface>(geometry::repair(fewer[l], geometry::Facing::AsGiven)));
            own.push_back(m_fewer.back().get());
            if (own.back()->triangleCount() < kFewestTriangles) {
                return;
            }
            solvers.push_back(std::make_unique<ProductSolver>(sceneOf(own.back()->repaired()), "Palpate"));
        }
        perTriangle_s = std::max(kDecimation_s, (threadTime_s() - before_s) / std::max(1.0, removed));
        Trial trial;
        trial.knob = Knob::Decimated;
        trial.variationValue = share;
        trial.setting = percent(share);
        addPart(trial, own, false, std::move(solvers));
    }
}

void Evaluator::describe(const Subject& subject)
{
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
    m_exact = {};
    m_exact.subject = subject.name;
    m_exact.solver = "exact";
    m_exact.triangles = subject.triangleCount();
    m_exact.isReference = true;
    m_exactTime_us.clear();
}

void Evaluator::makeParts(const Subject& subject, double end_s)
{
    m_marks.clear();
    m_fewer.clear();
    addPart({}, surfacesOf(subject), true, productOn(subject, subject.scene));
    const auto fits = [&](const char* what) {
        if (threadTime_s() <= end_s) {
            return true;
        }
        leaveOut(subject.name + ": " + what);
        return false;
    };
    if (fits("one pass, rates and balls")) {
        addProducts(subject);
    }
    if (fits("the other solvers")) {
        addOthers(subject);
    }
    addDecimated(subject, end_s);
}

void Evaluator::evaluateMotion(const Subject& subject, const HandMotion& motion, double end_s, std::size_t paths,
                               bool isFirst)
{
    const auto limit_s = [&] { return std::max(0.0, end_s - threadTime_s()) * (isFirst ? kFirstShare : 1.0); };
    const Truth truth = truthOf(subject, motion, kStride, limit_s());
    m_exact.ticks += truth.ticks;
    m_exact.wanted += (motion.p_WH.size() + kStride - 1) / kStride;
    m_exactTime_us.push_back(truth.time_us.p50);
    Truth fast; // exact solver at the full sample rate, computed on first use by a rate trial
    for (Part& part : m_marks) {
        const Trial& trial = part.run.description();
        if (trial.knob == Knob::Radius) {
            const Truth ball = truthOf(subject, motion, kStride, limit_s(), trial.fingertip_mm);
            part.run.feel(part.solvers, motion, ball, limit_s());
            continue;
        }
        if (trial.knob == Knob::Rate && fast.ticks == 0) {
            fast = truthOf(subject, motion, 1, limit_s());
        }
        if (!part.timed.empty()) {
            part.run.time(part.timed, motion, truth,
                          std::min(limit_s(), m_extent.bruteForce_s / static_cast<double>(paths)));
        }
        part.run.feel(part.solvers, motion, trial.knob == Knob::Rate ? fast : truth, limit_s());
    }
}

void Evaluator::evaluatePath(const Subject& subject, const HandPaths& path, double end_s, std::size_t paths,
                             bool isFirst)
{
    for (const HandMotion& motion : path.motions) {
        if (!next(subject.name + ": " + path.name + ", " + motion.name)) {
            return;
        }
        evaluateMotion(subject, motion, end_s, paths, isFirst);
        for (const Part& part : m_marks) {
            if (isFirst && &motion == &path.motions.front() && part.run.description().knob == Knob::Solver) {
                m_result.series.push_back(part.run.series());
            }
        }
    }
    for (Part& part : m_marks) {
        part.run.endPath();
    }
}

void Evaluator::evaluateSubject(const Subject& subject, const std::vector<HandPaths>& paths, double end_s)
{
    if (m_result.isCancelled || !next(subject.name + ": solvers")) {
        return;
    }
    describe(subject);
    makeParts(subject, end_s);
    const double started_s = threadTime_s();
    std::size_t done = 0; // samples
    std::vector<std::string> run;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        // Run only complete paths: all trials must cover the same paths.
        const double perSample_s = done > 0 ? (threadTime_s() - started_s) / static_cast<double>(done) : 0.0;
        if (i > 0 && threadTime_s() + perSample_s * static_cast<double>(samplesOf(paths[i])) > end_s) {
            leaveOut(subject.name + ": " + paths[i].name);
            continue;
        }
        evaluatePath(subject, paths[i], end_s, paths.size(), i == 0);
        if (m_result.isCancelled) {
            return;
        }
        done += samplesOf(paths[i]);
        run.push_back(paths[i].name);
    }
    m_result.subjects.back().paths = std::move(run);
    m_exact.time_us = percentilesOf(m_exactTime_us);
    m_result.trials.push_back(m_exact);
    for (const Part& part : m_marks) {
        m_result.trials.push_back(part.run.result());
    }
    markParetoFront(m_result.trials, subject.name);
}

/// Evaluates the paper's configuration: its solver with brute force, and the product, on a body with as many triangles
/// as the paper's space shuttle.
void Evaluator::evaluatePaperBody()
{
    const auto body = subjectOf("paper's 616 triangles", paperBody());
    m_exact = {};
    m_exact.subject = body->name;
    m_marks.clear();
    const std::vector<const Surface*> own = surfacesOf(*body);
    addPart({}, own, false, paperOn(*body, PaperSolver::Search::BruteForce));
    addPart({}, own, true, productOn(*body, body->scene));
    for (const HandPaths& path : pathsOn(body->layers.front().surface, {})) {
        if (!next("the paper's 616 triangles: " + path.name)) {
            return;
        }
        for (const HandMotion& motion : path.motions) {
            const Truth truth = truthOf(*body, motion, kStride, m_extent.bruteForce_s);
            for (Part& part : m_marks) {
                part.run.feel(part.solvers, motion, truth, m_extent.bruteForce_s);
            }
        }
        for (Part& part : m_marks) {
            part.run.endPath();
        }
    }
    for (const Part& part : m_marks) {
        m_result.paperBody.push_back(part.run.result());
    }
}

void Evaluator::feelSpheres()
{
    for (int n = 8; n <= m_extent.largestSphere; n *= 2) {
        if (!next("sphere of " + std::to_string(20 * n * n) + " triangles")) {
            return;
        }
        for (SizePoint& point : costOnSphere(n, m_extent.sphere_s, m_extent.bruteForce_s)) {
            m_result.sizes.push_back(std::move(point));
        }
    }
    m_result.ratios = ratiosOf(m_result.sizes);
    m_result.tissues = costOfTissue(kTissueSphere, m_extent.sphere_s);
}

void Evaluator::runHard()
{
    const double from = std::min(1.0, m_done / m_parts);
    const HardCaseChoice choice = m_options.isQuick ? HardCaseChoice::Quick : HardCaseChoice::Ordinary;
    bool isTimeUp = false;
    const double end_s = std::max(m_extent.limit_s, elapsed_s() + kHardShare * m_extent.limit_s);
    m_result.hardCases = runHardCases(choice, [&](double share, const std::string& what) {
        isTimeUp = isTimeUp || elapsed_s() > end_s;
        return !isTimeUp && (!m_options.progress || m_options.progress(from + share * (1.0 - from), what));
    });
    if (const std::size_t missing = hardCaseCount(choice) - m_result.hardCases.size(); missing > 0) {
        m_result.isCancelled = !isTimeUp;
        m_result.skippedItems.push_back(std::to_string(missing) + " of " + std::to_string(hardCaseCount(choice)) +
                                        " hard cases, for lack of time");
    }
    if (const std::size_t longer = hardCaseCount(HardCaseChoice::All) - hardCaseCount(choice); longer > 0) {
        m_result.skippedItems.push_back(std::to_string(longer) + (longer == 1 ? " hard case" : " hard cases") +
                                        " of many ticks: palpate evaluate --stability --long");
    }
}

Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects, const std::vector<HandMotion>& given,
                    const EvaluateOptions& options)
{
    return Evaluator(options, subjects.size()).run(subjects, given);
}

} // namespace palpate::evaluation
