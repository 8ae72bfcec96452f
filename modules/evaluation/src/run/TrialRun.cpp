// SPDX-License-Identifier: BSD-3-Clause
#include "run/TrialRun.h"

#include "cases/Interruptions.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include <time.h>

namespace palpate::evaluation {

namespace {

constexpr std::size_t kResidualEvery = 16; // ticks; each check costs a step of the exact solver
// Largest distance between god-objects in the same minimum, including the gaps of the ray solvers, in mm or relative
// to the extent of the surface, whichever is less.
constexpr double kApart_mm = 1e-3, kApartShare = 1e-5;
constexpr double kLeastShare = 0.02;   // of the largest force: limit for directions and smallest base of percentages
constexpr double kContact_mm = 1e-9;   // shorter springs count as no contact
constexpr double kIntrusion_mm = 1e-6; // for a sphere
constexpr std::size_t kIterationCounts = 33;
constexpr std::size_t kLeadIn = 4;          // ticks before the first contact
constexpr std::size_t kFewestTicks = 12;    // per motion regardless of the time limit, so that some are in contact
constexpr std::size_t kPopThroughEvery = 4; // ticks; the winding number costs more than the tick
constexpr double kLeastError_mm = 1e-12, kLeastPercent = 1e-9, kLeastTime_us = 1e-3; // lower limits for logarithms

} // namespace

double threadTime_s()
{
    timespec time{};
    return ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0
               ? static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)
               : 0.0;
}

Percentiles percentilesOf(std::vector<double> values)
{
    Percentiles result;
    result.count = values.size();
    if (values.empty()) {
        return result;
    }
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
        return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
    };
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    result.p50 = at(0.5);
    result.p99 = at(0.99);
    result.p999 = at(0.999);
    result.max = values.back();
    return result;
}

Tail tailOf(const Percentiles& percentiles)
{
    if (percentiles.count >= kMinCountForP999) {
        return {percentiles.p999, "99.9 %"};
    }
    return percentiles.count >= kMinCountForP999 / 10 ? Tail{percentiles.p99, "99 %"} : Tail{percentiles.max, "most"};
}

Truth truthOf(const Subject& subject, const HandMotion& motion, std::size_t stride, double seconds, double fingertip_mm)
{
    Truth truth;
    truth.stride = stride;
    std::vector<std::unique_ptr<ExactSolver>> exact;
    for (const SubjectLayer& layer : subject.layers) {
        exact.push_back(std::make_unique<ExactSolver>(layer.surface, 1, fingertip_mm));
        exact.back()->start(motion.p_WH.front());
    }
    truth.layers.resize(exact.size());
    std::vector<SolverStep> steps(exact.size());
    const TimeLimit limit(seconds);
    std::vector<double> time_us;
    for (std::size_t sample = 0; sample < motion.p_WH.size(); sample += stride) {
        const auto before = core::monotonicNow_ns();
        for (std::size_t l = 0; l < exact.size(); ++l) {
            steps[l] = exact[l]->step(motion.p_WH[sample]);
        }
        time_us.push_back(1e-3 * static_cast<double>(core::monotonicNow_ns() - before));
        Vec3 f_W = Vec3::Zero();
        bool isTouching = false;
        for (std::size_t l = 0; l < exact.size(); ++l) {
            const SubjectLayer& layer = subject.layers[l];
            const bool touches = steps[l].spring_mm.norm() > kContact_mm;
            const Vec3 spring_mm = touches ? steps[l].spring_mm : Vec3::Zero();
            truth.layers[l].answer.push_back(layer.springsAt(steps[l].p_WG, spring_mm, fingertip_mm));
            truth.layers[l].p_WG.push_back(steps[l].p_WG);
            truth.layers[l].spring_mm.push_back(steps[l].spring_mm);
            f_W += truth.layers[l].answer.back().force(steps[l].spring_mm);
            isTouching = isTouching || touches;
        }
        truth.f_W.push_back(f_W);
        truth.isTouching.push_back(isTouching ? 1 : 0);
        truth.largest_N = std::max(truth.largest_N, f_W.norm());
        if (++truth.ticks % 4 == 0 && limit.isOver()) {
            break;
        }
    }
    truth.time_us = percentilesOf(std::move(time_us));
    return truth;
}

TrialRun::TrialRun(Trial description, std::vector<const Surface*> own, bool isOnTruth)
    : m_trial(std::move(description))
    , m_own(std::move(own))
    , m_steps(m_own.size())
    , m_windingAtStart(m_own.size())
    , m_intrusion_mm(m_own.size())
    , m_apart_mm(kApart_mm)
{
    m_trial.iterations.assign(kIterationCounts, 0);
    for (const Surface* surface : m_own) {
        m_apart_mm = std::min(m_apart_mm, kApartShare * surface->bounds().sizes().maxCoeff());
        if (isOnTruth) {
            m_exact.push_back(std::make_unique<ExactSolver>(*surface, 1, m_trial.fingertip_mm));
        }
    }
}

/// Pop-through: a point is behind a surface that it started in front of, a sphere is closer than its radius to one, or
/// a penalty force pushes the hand further in.
bool TrialRun::isPoppedThrough(std::size_t layer, const Vec3& spring)
{
    const SolverStep& step = m_steps[layer];
    if (m_trial.solver.starts_with("vector field")) {
        return step.spring_mm.dot(spring) < 0.0;
    }
    if (m_trial.fingertip_mm > 0.0) {
        const double before = std::exchange(m_intrusion_mm[layer], m_exact[layer]->intrusion_mm(step.p_WG));
        if (m_intrusion_mm[layer] > std::max(0.0, before) + kIntrusion_mm) { // deeper than before
            return true;
        }
    }
    // On the surface, the winding number is decided by rounding: only deeper positions count.
    const Surface& own = *m_own[layer];
    if (!own.isClosed() || own.winding(step.p_WG) <= m_windingAtStart[layer]) {
        return false;
    }
    const Vec3 out = spring.norm() > 0.0 ? Vec3(1e-6 * spring.normalized()) : Vec3::Zero();
    return own.winding(step.p_WG + out) > m_windingAtStart[layer];
}

/// Runs the exact solver for the same tick from the solver's state, to isolate the error of this tick.
void TrialRun::compareFromSameState(const std::vector<Vec3>& before, const Vec3& hipBefore, const Vec3& hip)
{
    double apart = 0.0, longer = 0.0;
    bool isTouching = false;
    for (std::size_t l = 0; l < m_exact.size(); ++l) {
        m_exact[l]->resume(before[l], hipBefore);
        const SolverStep exact = m_exact[l]->step(hip);
        apart = std::max(apart, (exact.p_WG - m_steps[l].p_WG).norm());
        longer = std::max(longer, m_steps[l].spring_mm.norm() - exact.spring_mm.norm());
        isTouching = isTouching || std::max(exact.spring_mm.norm(), m_steps[l].spring_mm.norm()) > kContact_mm;
    }
    if (!isTouching) {
        return;
    }
    SameState& same = m_trial.sameState;
    ++same.ticks;
    if (apart > m_apart_mm) {
        ++same.parted;
        same.parted_mm = std::max(same.parted_mm, apart);
        same.longer_mm = std::max(same.longer_mm, longer);
    } else {
        same.together_mm = std::max(same.together_mm, apart);
    }
}

void TrialRun::takeResiduals(const Vec3& hip)
{
    for (std::size_t l = 0; l < m_exact.size() && m_trial.ticks % kResidualEvery == 0; ++l) {
        m_residual_mm.push_back(residual_mm(*m_exact[l], m_steps[l].p_WG, hip));
    }
}

TrialRun::Errors TrialRun::errorsAt(const Truth& truth, std::size_t index) const
{
    Errors errors;
    errors.isTouching = truth.isTouching[index] != 0;
    double stiffest = 0.0;
    Vec3 f_W = Vec3::Zero();
    for (std::size_t l = 0; l < m_steps.size(); ++l) {
        const LayerTruth& layer = truth.layers[l];
        const ContactSprings& answer = layer.answer[index];
        const bool touches = m_steps[l].spring_mm.norm() > kContact_mm;
        errors.isTouching = errors.isTouching || touches;
        if (touches || layer.spring_mm[index].norm() > kContact_mm) {
            errors.position_mm = std::max(errors.position_mm, (m_steps[l].p_WG - layer.p_WG[index]).norm());
            stiffest = std::max(stiffest, answer.stiffest_N_per_mm());
        }
        // With the same planes, so that rounding at a seam does not count as an error.
        f_W += answer.force(m_steps[l].spring_mm);
    }
    const Vec3& exact = truth.f_W[index];
    const double exact_N = exact.norm(), length_N = f_W.norm(), least_N = kLeastShare * truth.largest_N;
    errors.spring_mm = stiffest > 0.0 ? exact_N / stiffest : 0.0;
    errors.force_N = (f_W - exact).norm();
    const double of_N = std::max(exact_N, least_N);
    errors.forcePercent = of_N > 0.0 ? 100.0 * errors.force_N / of_N : errors.force_N > 0.0 ? 100.0 : 0.0;
    if (exact_N >= least_N && exact_N > 0.0) {
        const double sine = length_N > 0.0 ? f_W.cross(exact).norm() / (length_N * exact_N) : 0.0;
        const double angle = std::asin(std::min(1.0, sine)) * 180.0 / std::numbers::pi;
        errors.direction_deg = length_N > 0.0 && f_W.dot(exact) < 0.0 ? 180.0 - angle : angle;
    }
    return errors;
}

/// Records the errors of one tick.
void TrialRun::take(const Errors& errors, double time_s)
{
    if (!errors.isTouching) {
        return;
    }
    m_path.position_mm.push_back(errors.position_mm);
    m_path.forcePercent.push_back(errors.forcePercent);
    m_springSum_mm += errors.spring_mm;
    m_largestPosition_mm = std::max(m_largestPosition_mm, errors.position_mm);
    m_force_N.push_back(errors.force_N);
    if (errors.direction_deg >= 0.0) {
        m_direction_deg.push_back(errors.direction_deg);
    }
    m_series.time_s.push_back(time_s);
    m_series.error_mm.push_back(errors.position_mm);
}

void TrialRun::takeElsewhere(const Errors& errors)
{
    if (errors.isTouching && errors.position_mm > m_apart_mm) {
        ++m_path.elsewhere;
        m_elsewhere_mm.push_back(errors.position_mm);
        m_elsewhereForcePercent.push_back(errors.forcePercent);
    }
}

/// Runs one tick of all layers. @return duration [µs], recorded if `isTimed`
double TrialRun::step(LayerSolvers& solvers, const Vec3& hip, bool isTouching, bool isTimed)
{
    const long interruptionsBefore = interruptions();
    const auto before = core::monotonicNow_ns();
    for (std::size_t l = 0; l < solvers.size(); ++l) {
        m_steps[l] = solvers[l]->step(hip);
    }
    const double took_us = 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
    if (!isTimed) {
        return took_us;
    }
    if (interruptions() != interruptionsBefore) {
        ++m_trial.interrupted;
        if (isTouching) {
            m_interrupted_us.push_back(took_us);
        }
    } else {
        (isTouching ? m_path.time_us : m_freeTime_us).push_back(took_us);
    }
    return took_us;
}

void TrialRun::feel(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds)
{
    const auto stride = static_cast<std::size_t>(std::lround(HandMotion::kBase_Hz / m_trial.rate_Hz));
    const TimeLimit limit(seconds);
    m_trial.wanted += (motion.p_WH.size() + stride - 1) / stride;
    m_series = {m_trial.subject, m_trial.solver, motion.name, {}, {}};
    Vec3 hipBefore = motion.p_WH.front();
    std::vector<Vec3> before(solvers.size(), hipBefore);
    for (std::size_t l = 0; l < solvers.size(); ++l) {
        solvers[l]->start(hipBefore);
        m_windingAtStart[l] = m_own[l]->winding(hipBefore);
        m_intrusion_mm[l] = m_exact.empty() ? 0.0 : m_exact[l]->intrusion_mm(hipBefore);
    }
    std::size_t done = 0;
    for (std::size_t sample = 0; sample / truth.stride < truth.ticks; sample += stride) {
        const std::size_t index = sample / truth.stride, next = (sample + stride) / truth.stride;
        const Vec3& hip = motion.p_WH[sample];
        (void)step(solvers, hip, truth.isTouching[index] != 0, !m_isTimedApart);
        std::size_t iterations = 0;
        bool isThrough = false;
        for (std::size_t l = 0; l < solvers.size(); ++l) {
            iterations += m_steps[l].iterations;
            isThrough = isThrough ||
                        (m_trial.ticks % kPopThroughEvery == 0 && isPoppedThrough(l, truth.layers[l].spring_mm[index]));
        }
        ++m_trial.iterations[std::min(iterations, kIterationCounts - 1)];
        m_trial.popThroughs += isThrough ? 1 : 0;
        takeResiduals(hip);
        if (m_trial.knob == Knob::Solver && !m_exact.empty()) {
            compareFromSameState(before, hipBefore, hip);
            for (std::size_t l = 0; l < solvers.size(); ++l) {
                before[l] = m_steps[l].p_WG;
            }
            hipBefore = hip;
        }
        const Errors errors = errorsAt(truth, index);
        takeElsewhere(errors);
        if (m_trial.knob != Knob::Rate) {
            take(errors, static_cast<double>(sample) / HandMotion::kBase_Hz);
        } else if (next < truth.ticks) { // the held force is oldest at this sample
            take(errorsAt(truth, next), static_cast<double>(sample + stride) / HandMotion::kBase_Hz);
        }
        ++m_trial.ticks;
        if (++done > kFewestTicks && limit.isOver()) {
            break;
        }
    }
}

void TrialRun::time(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds)
{
    m_isTimedApart = true;
    const TimeLimit limit(seconds);
    const auto touched = std::find(truth.isTouching.begin(), truth.isTouching.end(), 1);
    const auto contact = static_cast<std::size_t>(std::distance(truth.isTouching.begin(), touched));
    const std::size_t first = contact - std::min(contact, kLeadIn);
    for (const auto& solver : solvers) {
        solver->start(motion.p_WH[std::min(first * truth.stride, motion.p_WH.size() - 1)]);
    }
    for (std::size_t index = first; index < truth.ticks; ++index) {
        (void)step(solvers, motion.p_WH[index * truth.stride], truth.isTouching[index] != 0, true);
        if (index >= first + kFewestTicks && limit.isOver()) {
            break;
        }
    }
}

void TrialRun::endPath()
{
    const auto add = [](std::vector<double>& all, const std::vector<double>& path) {
        all.insert(all.end(), path.begin(), path.end());
    };
    if (!m_path.time_us.empty()) {
        m_pathTime_us.push_back(percentilesOf(m_path.time_us).p50);
    }
    if (!m_path.position_mm.empty()) {
        m_pathPosition_mm.push_back(percentilesOf(m_path.position_mm).mean);
        m_pathForcePercent.push_back(percentilesOf(m_path.forcePercent).p99);
        m_pathElsewherePercent.push_back(100.0 * static_cast<double>(m_path.elsewhere) /
                                         static_cast<double>(m_path.position_mm.size()));
    }
    add(m_all.time_us, m_path.time_us);
    add(m_all.position_mm, m_path.position_mm);
    add(m_all.forcePercent, m_path.forcePercent);
    m_all.elsewhere += m_path.elsewhere;
    m_path = {};
}

Trial TrialRun::result() const
{
    Trial trial = m_trial;
    // Ticks longer than a scheduler time slice are always preempted; then only those times are available.
    const std::vector<double>& times = m_all.time_us.empty() ? m_interrupted_us : m_all.time_us;
    trial.time_us = percentilesOf(times);
    trial.freeTime_us = percentilesOf(m_freeTime_us);
    trial.position_mm = percentilesOf(m_all.position_mm);
    trial.force_N = percentilesOf(m_force_N);
    trial.forcePercent = percentilesOf(m_all.forcePercent);
    trial.direction_deg = percentilesOf(m_direction_deg);
    trial.residual_mm = percentilesOf(m_residual_mm);
    trial.elsewhere = m_all.elsewhere;
    trial.elsewhere_mm = percentilesOf(m_elsewhere_mm);
    trial.elsewhereForcePercent = percentilesOf(m_elsewhereForcePercent);
    const auto touched = static_cast<double>(m_all.position_mm.size());
    trial.spring_mm = touched > 0.0 ? m_springSum_mm / touched : 0.0;
    trial.pathTime_us = spreadOf(
        m_pathTime_us.empty() && !times.empty() ? std::vector{trial.time_us.p50} : m_pathTime_us, kLeastTime_us);
    trial.pathPosition_mm = spreadOf(m_pathPosition_mm, kLeastError_mm, m_largestPosition_mm);
    trial.pathForcePercent = spreadOf(m_pathForcePercent, kLeastPercent, trial.forcePercent.max);
    trial.pathElsewherePercent = spreadOf(m_pathElsewherePercent, kLeastPercent, 100.0);
    return trial;
}

} // namespace palpate::evaluation
