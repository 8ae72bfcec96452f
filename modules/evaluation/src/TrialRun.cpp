// SPDX-License-Identifier: BSD-3-Clause
#include "TrialRun.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace palpate::evaluation {

namespace {

// The exact solver is asked for residuals at every so many ticks, and wherever an answer differs, up to a bound.
constexpr std::size_t kResidualEvery = 16;
constexpr std::size_t kMostResiduals = 1500;
// A god-object at rest, the gaps of the ray solvers included; and what solvers at one minimum don't differ by. In mm,
// or as a share of the surface's extent where that is less.
constexpr double kAtRest_mm = 1e-3, kAtRestShare = 2e-6;
constexpr double kDiffers_mm = 1e-3, kDiffersShare = 1e-5;
constexpr double kLeastShare = 0.02; // of the longest spring: percentages and directions of less are noise
constexpr double kContact_mm = 1e-9; // a shorter spring is none
constexpr std::size_t kHistogram = 33;
constexpr std::size_t kLeadIn = 10; // ticks before the first contact

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

Truth truthOf(const Surface& surface, const HandMotion& motion, double seconds)
{
    Truth truth;
    ExactSolver exact(surface, 1);
    exact.start(motion.p_WH.front());
    const TimeLimit limit(seconds);
    std::vector<double> time_us;
    double tick_us = 0.0;
    truth.firstContact = motion.p_WH.size();
    for (const Vec3& hip : motion.p_WH) {
        const auto before = core::monotonicNow_ns();
        const SolverStep step = exact.step(hip);
        tick_us += 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
        if (step.spring_mm.norm() > kContact_mm) {
            truth.firstContact = std::min(truth.firstContact, truth.samples);
        }
        truth.longest_mm = std::max(truth.longest_mm, step.spring_mm.norm());
        truth.p_WG.push_back(step.p_WG);
        truth.spring_mm.push_back(step.spring_mm);
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

TrialRun::TrialRun(Trial description, const Surface& own, const Surface* full, double stiffness_N_per_mm)
    : m_trial(std::move(description))
    , m_own(own)
    , m_exact(full != nullptr ? std::make_unique<ExactSolver>(*full, 1) : nullptr)
    , m_stiffness(stiffness_N_per_mm)
{
    m_trial.iterations.assign(kHistogram, 0);
}

/// A god-object is behind a surface that it started in front of; a penalty pushes the hand further in.
bool TrialRun::isPoppedThrough(const SolverStep& step, const Vec3& spring, int windingAtStart) const
{
    if (m_trial.solver.starts_with("vector field")) {
        return step.spring_mm.dot(spring) < 0.0;
    }
    // On a surface the winding number is a matter of rounding: only what lies deeper counts.
    if (!m_own.isClosed() || m_own.winding(step.p_WG) <= windingAtStart) {
        return false;
    }
    const Vec3 out = spring.norm() > 0.0 ? Vec3(1e-6 * spring.normalized()) : Vec3::Zero();
    return m_own.winding(step.p_WG + out) > windingAtStart;
}

/// Decides whether the god-object of a tick rests in another minimum than the exact one.
void TrialRun::look(const SolverStep& step, const Vec3& hip, const Vec3& god)
{
    const double error = (step.p_WG - god).norm(), extent = m_own.bounds().sizes().maxCoeff();
    const double differs = std::min(kDiffers_mm, kDiffersShare * extent);
    if (m_exact != nullptr && m_residuals < kMostResiduals &&
        (m_trial.ticks % kResidualEvery == 0 || error > differs)) {
        ++m_residuals;
        const double residual = residual_mm(*m_exact, step.p_WG, hip);
        m_residual_mm.push_back(residual);
        m_isElsewhere = error > differs && residual <= std::min(kAtRest_mm, kAtRestShare * extent) &&
                        m_own.winding(step.p_WG) <= m_own.winding(god);
    } else if (error <= differs) {
        m_isElsewhere = false;
    }
}

/// Takes the errors of what the hand feels at a sample of the truth.
void TrialRun::take(const SolverStep& step, const Truth& truth, std::size_t sample)
{
    const Vec3& spring = truth.spring_mm[sample];
    if (spring.norm() <= kContact_mm && step.spring_mm.norm() <= kContact_mm) {
        return; // neither touches
    }
    if (m_isElsewhere) {
        ++m_trial.otherMinimum;
        return;
    }
    const double error = (step.p_WG - truth.p_WG[sample]).norm();
    m_position_mm.push_back(error);
    m_springSum_mm += spring.norm();
    const double force_N = (step.spring_mm - spring).norm() * m_stiffness, exact_N = spring.norm() * m_stiffness;
    m_force_N.push_back(force_N);
    if (spring.norm() >= kLeastShare * truth.longest_mm && exact_N > 0.0) {
        m_forcePercent.push_back(100.0 * force_N / exact_N);
        const double length = step.spring_mm.norm();
        const double sine = length > 0.0 ? step.spring_mm.cross(spring).norm() / (length * spring.norm()) : 0.0;
        const double angle = std::asin(std::min(1.0, sine)) * 180.0 / std::numbers::pi;
        m_direction_deg.push_back(length > 0.0 && step.spring_mm.dot(spring) < 0.0 ? 180.0 - angle : angle);
    }
    m_series.time_s.push_back(static_cast<double>(sample) / HandMotion::kBase_Hz);
    m_series.error_mm.push_back(error);
}

void TrialRun::feel(ReferenceSolver& solver, const HandMotion& motion, const Truth& truth, double seconds)
{
    const auto stride = static_cast<std::size_t>(std::lround(HandMotion::kBase_Hz / m_trial.rate_Hz));
    const TimeLimit limit(seconds);
    m_trial.wanted += (truth.samples + stride - 1) / stride;
    m_series = {m_trial.subject, m_trial.solver, motion.name, {}, {}};
    m_isElsewhere = false;
    // Brute force may not get far: what it gets through should be touch.
    const std::size_t lead = kLeadIn * stride;
    const std::size_t begin =
        seconds < 1e3 && truth.firstContact > lead ? (truth.firstContact - lead) / stride * stride : 0;
    solver.start(motion.p_WH[begin]);
    const int windingAtStart = m_own.winding(motion.p_WH[begin]);
    for (std::size_t sample = begin; sample < truth.samples; sample += stride) {
        const Vec3& hip = motion.p_WH[sample];
        const auto before = core::monotonicNow_ns();
        const SolverStep step = solver.step(hip);
        const double took_us = 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
        (truth.spring_mm[sample].norm() > kContact_mm ? m_time_us : m_freeTime_us).push_back(took_us);
        ++m_trial.iterations[std::min<std::size_t>(step.iterations, kHistogram - 1)];
        look(step, hip, truth.p_WG[sample]);
        if (m_trial.knob != Knob::Rate) {
            take(step, truth, sample);
        } else if (sample + stride < truth.samples) {
            take(step, truth, sample + stride); // held until here, where it is oldest
        }
        if (m_trial.ticks % 4 == 0 && isPoppedThrough(step, truth.spring_mm[sample], windingAtStart)) {
            ++m_trial.popThroughs;
        }
        ++m_trial.ticks;
        if (limit.isOver()) {
            break;
        }
    }
}

Trial TrialRun::result() const
{
    Trial trial = m_trial;
    trial.time_us = percentilesOf(m_time_us);
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
