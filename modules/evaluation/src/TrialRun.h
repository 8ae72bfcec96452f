// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"
#include "palpate/evaluation/ExactSolver.h"

#include <chrono>

namespace palpate::evaluation {

/// What the exact solver says of a motion, at the base rate.
struct Truth
{
    std::vector<Vec3> p_WG;      ///< [mm]
    std::vector<Vec3> spring_mm; ///< zero in free space
    Percentiles time_us;         ///< a tick at 1 kHz, of four samples
    std::size_t samples = 0;     ///< computed; fewer than the motion has when time was up
    std::size_t firstContact = 0;
    double longest_mm = 0.0; ///< spring
};

/// Time that a piece of work may take. [s]
class TimeLimit
{
  public:
    explicit TimeLimit(double seconds)
        : m_end(std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds))
    {
    }
    [[nodiscard]] bool isOver() const { return std::chrono::steady_clock::now() >= m_end; }

  private:
    std::chrono::time_point<std::chrono::steady_clock, std::chrono::duration<double>> m_end;
};

/// Runs the exact solver over a motion, at most `seconds` long.
[[nodiscard]] Truth truthOf(const Surface& surface, const HandMotion& motion, double seconds);

/// Adds up one trial over its motions.
class TrialRun
{
  public:
    /// @param own     what the solver touches: for pop-throughs
    /// @param full    the surface of the truth, for residuals; null for a solver on another mesh or without god-object
    TrialRun(Trial description, const Surface& own, const Surface* full, double stiffness_N_per_mm);

    /// Feels one motion, at most `seconds` long; such a short run starts just before the first contact.
    void feel(ReferenceSolver& solver, const HandMotion& motion, const Truth& truth, double seconds);
    [[nodiscard]] Trial result() const;
    /// Errors of the motion last felt. [mm]
    [[nodiscard]] const ErrorSeries& series() const noexcept { return m_series; }

  private:
    void look(const SolverStep& step, const Vec3& hip, const Vec3& god);
    void take(const SolverStep& step, const Truth& truth, std::size_t sample);
    [[nodiscard]] bool isPoppedThrough(const SolverStep& step, const Vec3& spring, int windingAtStart) const;

    Trial m_trial;
    const Surface& m_own;
    std::unique_ptr<ExactSolver> m_exact;
    double m_stiffness;
    std::vector<double> m_time_us, m_freeTime_us, m_position_mm, m_force_N, m_forcePercent, m_direction_deg,
        m_residual_mm;
    double m_springSum_mm = 0.0;
    std::size_t m_residuals = 0;
    bool m_isElsewhere = false;
    ErrorSeries m_series;
};

} // namespace palpate::evaluation
