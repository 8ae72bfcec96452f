// SPDX-License-Identifier: BSD-3-Clause
#include "TrialRun.h"

#include "Interruptions.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace palpate::evaluation {

namespace {

// The exact solver is asked for residuals at every so many ticks, and wherever an answer differs, up to a bound.
constexpr std::size_t kResidualEvery = 16;
constexpr std::size_t kMostResiduals = 1500;
// A god-object at rest, the gaps of the ray solvers included; and what solvers at one minimum don't differ by. In mm,
// or as a share of the surface's extent where that is less.
constexpr double kAtRest_mm = 1e-3, kAtRestShare = 2e-6;
constexpr double kDiffers_mm = 1e-3, kDiffersShare = 1e-5;
constexpr double kLeastShare = 0.02;   // of the largest force: percentages and directions of less are noise
constexpr double kContact_mm = 1e-9;   // a shorter spring is none
constexpr double kIntrusion_mm = 1e-6; // of a ball
constexpr std::size_t kIterationCounts = 33;
constexpr std::size_t kLeadIn = 4;          // ticks before the first contact
constexpr std::size_t kFewestTicks = 12;    // of a motion, however long they take: some in contact
constexpr std::size_t kPopThroughEvery = 4; // ticks: the winding number costs more than the tick

} // namespace

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

Truth truthOf(const Subject& subject, const HandMotion& motion, double seconds, double fingertip_mm)
{
    Truth truth;
    std::vector<std::unique_ptr<ExactSolver>> exact;
    for (const SubjectLayer& layer : subject.layers) {
        exact.push_back(std::make_unique<ExactSolver>(layer.surface, 1, fingertip_mm));
        exact.back()->start(motion.p_WH.front());
    }
    truth.layers.resize(exact.size());
    std::vector<SolverStep> steps(exact.size());
    const TimeLimit limit(seconds);
    std::vector<double> time_us;
    double tick_us = 0.0;
    truth.firstContact = motion.p_WH.size();
    for (const Vec3& hip : motion.p_WH) {
        const auto before = core::monotonicNow_ns();
        for (std::size_t l = 0; l < exact.size() && (fingertip_mm == 0.0 || truth.samples % 4 == 0); ++l) {
            steps[l] = exact[l]->step(hip);
        }
        tick_us += 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
        Vec3 f_W = Vec3::Zero();
        bool isTouching = false;
        for (std::size_t l = 0; l < exact.size(); ++l) {
            const SubjectLayer& layer = subject.layers[l];
            const bool touches = steps[l].spring_mm.norm() > kContact_mm;
            const double k = touches ? layer.stiffnessAt(steps[l].p_WG, fingertip_mm) : layer.stiffest();
            truth.layers[l].p_WG.push_back(steps[l].p_WG);
            truth.layers[l].spring_mm.push_back(steps[l].spring_mm);
            truth.layers[l].stiffness_N_per_mm.push_back(k);
            f_W += k * steps[l].spring_mm;
            isTouching = isTouching || touches;
        }
        if (isTouching) {
            truth.firstContact = std::min(truth.firstContact, truth.samples);
        }
        truth.f_W.push_back(f_W);
        truth.isTouching.push_back(isTouching ? 1 : 0);
        truth.largest_N = std::max(truth.largest_N, f_W.norm());
        if (++truth.samples % 4 == 0) {
            time_us.push_back(tick_us);
            tick_us = 0.0;
            if (limit.isOver()) {
                break;
            }
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
    , m_isElsewhere(m_own.size())
    , m_intrusion_mm(m_own.size())
{
    m_trial.iterations.assign(kIterationCounts, 0);
    for (std::size_t l = 0; isOnTruth && l < m_own.size(); ++l) {
        m_exact.push_back(std::make_unique<ExactSolver>(*m_own[l], 1, m_trial.fingertip_mm));
    }
}

/// A god-object is behind a surface that it started in front of, a ball nearer to one than its radius; a penalty pushes
/// the hand further in.
bool TrialRun::isPoppedThrough(std::size_t layer, const Vec3& spring)
{
    const SolverStep& step = m_steps[layer];
    if (m_trial.solver.starts_with("vector field")) {
        return step.spring_mm.dot(spring) < 0.0;
    }
    if (m_trial.fingertip_mm > 0.0) {
        const double before = std::exchange(m_intrusion_mm[layer], m_exact[layer]->intrusion_mm(step.p_WG));
        if (m_intrusion_mm[layer] > std::max(0.0, before) + kIntrusion_mm) { // put down too deep, it goes no deeper
            return true;
        }
    }
    // On a surface the winding number is a matter of rounding: only what lies deeper counts.
    const Surface& own = *m_own[layer];
    if (!own.isClosed() || own.winding(step.p_WG) <= m_windingAtStart[layer]) {
        return false;
    }
    const Vec3 out = spring.norm() > 0.0 ? Vec3(1e-6 * spring.normalized()) : Vec3::Zero();
    return own.winding(step.p_WG + out) > m_windingAtStart[layer];
}

/// Decides whether the god-object of a layer rests in another minimum than the exact one.
void TrialRun::look(std::size_t layer, const Vec3& hip, const Vec3& god)
{
    const Surface& own = *m_own[layer];
    const Vec3& p = m_steps[layer].p_WG;
    const double error = (p - god).norm(), extent = own.bounds().sizes().maxCoeff();
    const double differs = std::min(kDiffers_mm, kDiffersShare * extent);
    if (!m_exact.empty() && m_residuals < kMostResiduals && (m_trial.ticks % kResidualEvery == 0 || error > differs)) {
        ++m_residuals;
        const double residual = residual_mm(*m_exact[layer], p, hip);
        m_residual_mm.push_back(residual);
        m_isElsewhere[layer] = error > differs && residual <= std::min(kAtRest_mm, kAtRestShare * extent) &&
                               own.winding(p) <= own.winding(god);
    } else if (error <= differs) {
        m_isElsewhere[layer] = false;
    }
}

/// Takes the errors of what the hand feels at a sample of the truth.
void TrialRun::take(const Truth& truth, std::size_t sample)
{
    bool isTouching = truth.isTouching[sample] != 0;
    double error = 0.0, stiffest = 0.0;
    Vec3 f_W = Vec3::Zero();
    for (std::size_t l = 0; l < m_steps.size(); ++l) {
        const LayerTruth& layer = truth.layers[l];
        const double k = layer.stiffness_N_per_mm[sample];
        const bool touches = m_steps[l].spring_mm.norm() > kContact_mm;
        isTouching = isTouching || touches;
        if (touches || layer.spring_mm[sample].norm() > kContact_mm) {
            error = std::max(error, (m_steps[l].p_WG - layer.p_WG[sample]).norm());
            stiffest = std::max(stiffest, k);
        }
        f_W += k * m_steps[l].spring_mm;
    }
    if (!isTouching) {
        return;
    }
    if (std::find(m_isElsewhere.begin(), m_isElsewhere.end(), 1) != m_isElsewhere.end()) {
        ++m_trial.otherMinimum;
        return;
    }
    const Vec3& exact = truth.f_W[sample];
    const double exact_N = exact.norm(), length_N = f_W.norm();
    m_position_mm.push_back(error);
    m_springSum_mm += stiffest > 0.0 ? exact_N / stiffest : 0.0;
    m_force_N.push_back((f_W - exact).norm());
    if (exact_N >= kLeastShare * truth.largest_N && exact_N > 0.0) {
        m_forcePercent.push_back(100.0 * (f_W - exact).norm() / exact_N);
        const double sine = length_N > 0.0 ? f_W.cross(exact).norm() / (length_N * exact_N) : 0.0;
        const double angle = std::asin(std::min(1.0, sine)) * 180.0 / std::numbers::pi;
        m_direction_deg.push_back(length_N > 0.0 && f_W.dot(exact) < 0.0 ? 180.0 - angle : angle);
    }
    m_series.time_s.push_back(static_cast<double>(sample) / HandMotion::kBase_Hz);
    m_series.error_mm.push_back(error);
}

void TrialRun::feel(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds,
                    bool fromContact)
{
    const auto stride = static_cast<std::size_t>(std::lround(HandMotion::kBase_Hz / m_trial.rate_Hz));
    const TimeLimit limit(seconds);
    m_trial.wanted += (truth.samples + stride - 1) / stride;
    m_series = {m_trial.subject, m_trial.solver, motion.name, {}, {}};
    const std::size_t lead = kLeadIn * stride;
    const std::size_t begin =
        fromContact && truth.firstContact > lead ? (truth.firstContact - lead) / stride * stride : 0;
    for (std::size_t l = 0; l < solvers.size(); ++l) {
        solvers[l]->start(motion.p_WH[begin]);
        m_windingAtStart[l] = m_own[l]->winding(motion.p_WH[begin]);
        m_isElsewhere[l] = false;
        m_intrusion_mm[l] = m_exact.empty() ? 0.0 : m_exact[l]->intrusion_mm(motion.p_WH[begin]);
    }
    std::size_t done = 0;
    for (std::size_t sample = begin; sample < truth.samples; sample += stride) {
        const Vec3& hip = motion.p_WH[sample];
        const long interruptionsBefore = interruptions();
        const auto before = core::monotonicNow_ns();
        for (std::size_t l = 0; l < solvers.size(); ++l) {
            m_steps[l] = solvers[l]->step(hip);
        }
        const double took_us = 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
        if (interruptions() != interruptionsBefore) {
            ++m_trial.interrupted;
            if (truth.isTouching[sample] != 0) {
                m_interrupted_us.push_back(took_us);
            }
        } else {
            (truth.isTouching[sample] != 0 ? m_time_us : m_freeTime_us).push_back(took_us);
        }
        std::size_t iterations = 0;
        bool isThrough = false;
        for (std::size_t l = 0; l < solvers.size(); ++l) {
            iterations += m_steps[l].iterations;
            look(l, hip, truth.layers[l].p_WG[sample]);
            isThrough = isThrough || (m_trial.ticks % kPopThroughEvery == 0 &&
                                      isPoppedThrough(l, truth.layers[l].spring_mm[sample]));
        }
        ++m_trial.iterations[std::min(iterations, kIterationCounts - 1)];
        m_trial.popThroughs += isThrough ? 1 : 0;
        if (m_trial.knob != Knob::Rate) {
            take(truth, sample);
        } else if (sample + stride < truth.samples) {
            take(truth, sample + stride); // held until here, where it is oldest
        }
        ++m_trial.ticks;
        if (++done > kFewestTicks && limit.isOver()) {
            break;
        }
    }
}

Trial TrialRun::result() const
{
    Trial trial = m_trial;
    // A tick longer than a program's turn is always interrupted: then those times are all there is.
    trial.time_us = percentilesOf(m_time_us.empty() ? m_interrupted_us : m_time_us);
    trial.freeTime_us = percentilesOf(m_freeTime_us);
    trial.position_mm = percentilesOf(m_position_mm);
    trial.force_N = percentilesOf(m_force_N);
    trial.forcePercent = percentilesOf(m_forcePercent);
    trial.direction_deg = percentilesOf(m_direction_deg);
    trial.residual_mm = percentilesOf(m_residual_mm);
    trial.spring_mm = m_position_mm.empty() ? 0.0 : m_springSum_mm / static_cast<double>(m_position_mm.size());
    return trial;
}

} // namespace palpate::evaluation
