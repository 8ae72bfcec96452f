// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"
#include "palpate/evaluation/ExactSolver.h"

#include <chrono>
#include <memory>
#include <vector>

namespace palpate::evaluation {

/// What the exact solver says of one layer, sample by sample.
struct LayerTruth
{
    std::vector<Vec3> p_WG;                 ///< [mm]
    std::vector<Vec3> spring_mm;            ///< zero in free space
    std::vector<double> stiffness_N_per_mm; ///< of the tissue touched; in free space the layer's stiffest
};

/// What the exact solver says of a motion, at the base rate.
struct Truth
{
    std::vector<LayerTruth> layers;
    std::vector<Vec3> f_W;        ///< the layers' springs in parallel; zero in free space [N]
    std::vector<char> isTouching; ///< any layer
    Percentiles time_us;          ///< a tick at 1 kHz, of four samples
    std::size_t samples = 0;      ///< computed; fewer than the motion has when time was up
    std::size_t firstContact = 0;
    double largest_N = 0.0; ///< force
};

/// One solver for each layer of a subject.
using LayerSolvers = std::vector<std::unique_ptr<ReferenceSolver>>;

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
/// @param fingertip_mm  radius of the ball that touches, which is asked at 1 kHz only and held between; 0 is a point
[[nodiscard]] Truth truthOf(const Subject& subject, const HandMotion& motion, double seconds,
                            double fingertip_mm = 0.0);

/// Adds up one trial over its motions.
class TrialRun
{
  public:
    /// @param own  what the solvers touch, layer by layer: for pop-throughs
    /// @param isOnTruth  true for god-objects on the very surfaces of the truth: their residuals are taken
    TrialRun(Trial description, std::vector<const Surface*> own, bool isOnTruth);

    /// Feels one motion, at most `seconds` long, with all that is measured of it.
    /// @param fromContact  starts just before the first contact, for solvers that get through few ticks
    void feel(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds, bool fromContact);
    [[nodiscard]] Trial result() const;
    /// Errors of the motion last felt. [mm]
    [[nodiscard]] const ErrorSeries& series() const noexcept { return m_series; }

  private:
    void look(std::size_t layer, const Vec3& hip, const Vec3& god);
    void take(const Truth& truth, std::size_t sample);
    [[nodiscard]] bool isPoppedThrough(std::size_t layer, const Vec3& spring);

    Trial m_trial;
    std::vector<const Surface*> m_own;
    std::vector<std::unique_ptr<ExactSolver>> m_exact; ///< by layer; empty without residuals
    std::vector<SolverStep> m_steps;                   ///< of this tick, by layer
    std::vector<int> m_windingAtStart;
    std::vector<char> m_isElsewhere;    ///< by layer
    std::vector<double> m_intrusion_mm; ///< of a ball, by layer, when last looked at
    std::vector<double> m_time_us, m_interrupted_us, m_freeTime_us, m_position_mm, m_force_N, m_forcePercent,
        m_direction_deg, m_residual_mm;
    double m_springSum_mm = 0.0;
    std::size_t m_residuals = 0;
    ErrorSeries m_series;
};

} // namespace palpate::evaluation
