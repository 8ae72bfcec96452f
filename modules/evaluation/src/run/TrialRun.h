// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"
#include "palpate/evaluation/ExactSolver.h"

#include <memory>
#include <vector>

namespace palpate::evaluation {

/// Results of the exact solver for one layer, by tick.
struct LayerTruth
{
    std::vector<Vec3> p_WG;             ///< [mm]
    std::vector<Vec3> spring_mm;        ///< zero in free space
    std::vector<ContactSprings> answer; ///< tissue in contact; in free space the stiffest tissue of the layer
};

/// Results of the exact solver for a motion at one rate.
struct Truth
{
    std::size_t stride = 1; ///< base samples per tick: 4 at 1 kHz
    std::vector<LayerTruth> layers;
    std::vector<Vec3> f_W;        ///< sum of the forces of all layers; zero in free space [N]
    std::vector<char> isTouching; ///< contact in any layer
    Percentiles time_us;          ///< per tick
    std::size_t ticks = 0;        ///< computed; fewer than in the motion if the time limit was reached
    double largest_N = 0.0;       ///< largest force
};

/// One solver per layer of a subject.
using LayerSolvers = std::vector<std::unique_ptr<ReferenceSolver>>;

/// CPU time of this thread. Used for time limits, so that the amount of work does not depend on other load. [s]
[[nodiscard]] double threadTime_s();

/// CPU time limit of a piece of work. [s]
class TimeLimit
{
  public:
    explicit TimeLimit(double seconds)
        : m_end_s(threadTime_s() + seconds)
    {
    }
    [[nodiscard]] bool isOver() const { return threadTime_s() >= m_end_s; }

  private:
    double m_end_s;
};

/// Runs the exact solver over every `stride`-th sample of a motion for at most `seconds`.
/// @param fingertip_mm  fingertip radius; 0: point contact
[[nodiscard]] Truth truthOf(const Subject& subject, const HandMotion& motion, std::size_t stride, double seconds,
                            double fingertip_mm = 0.0);

/// Accumulates one trial over all motions of its paths.
class TrialRun
{
  public:
    /// @param own  surfaces of the solvers by layer, used to detect pop-throughs
    /// @param isOnTruth  true for god-objects on the same surfaces as the exact solver, which allows residuals
    TrialRun(Trial description, std::vector<const Surface*> own, bool isOnTruth);

    /// Runs one motion for at most `seconds` and records all figures.
    /// @param truth  with the stride of the trial's rate; for Knob::Rate with every sample of the motion
    void feel(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds);
    /// Records only times, starting just before the first contact, for solvers too slow for a whole path. From then on
    /// `feel` records no times.
    void time(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds);
    /// Ends a path: its motions together give one value of each Spread.
    void endPath();
    [[nodiscard]] Trial result() const;
    [[nodiscard]] const Trial& description() const noexcept { return m_trial; }
    /// Errors over the last motion. [mm]
    [[nodiscard]] const ErrorSeries& series() const noexcept { return m_series; }

  private:
    /// Errors of the solver against the exact solver in one tick.
    struct Errors
    {
        bool isTouching = false; ///< contact of either solver
        double position_mm = 0.0, force_N = 0.0, forcePercent = 0.0;
        double direction_deg = -1.0; ///< negative: force too small for a direction
        double spring_mm = 0.0;
    };
    /// Values of the ticks of one path, or of all paths.
    struct Ticks
    {
        std::vector<double> time_us, position_mm, forcePercent;
        std::size_t elsewhere = 0;
    };

    [[nodiscard]] Errors errorsAt(const Truth& truth, std::size_t index) const;
    void take(const Errors& errors, double time_s);
    void takeElsewhere(const Errors& errors);
    void compareFromSameState(const std::vector<Vec3>& before, const Vec3& hipBefore, const Vec3& hip);
    void takeResiduals(const Vec3& hip);
    [[nodiscard]] bool isPoppedThrough(std::size_t layer, const Vec3& spring);
    double step(LayerSolvers& solvers, const Vec3& hip, bool isTouching, bool isTimed);

    Trial m_trial;
    std::vector<const Surface*> m_own;
    std::vector<std::unique_ptr<ExactSolver>> m_exact; ///< per layer; empty without residuals
    std::vector<SolverStep> m_steps;                   ///< of the current tick, per layer
    std::vector<int> m_windingAtStart;
    std::vector<double> m_intrusion_mm; ///< penetration of a sphere per layer at the last check
    double m_apart_mm;                  ///< larger distances to the exact god-object count as `elsewhere`
    Ticks m_path, m_all;
    std::vector<double> m_interrupted_us, m_freeTime_us, m_force_N, m_direction_deg, m_residual_mm, m_elsewhere_mm,
        m_elsewhereForcePercent;
    std::vector<double> m_pathTime_us, m_pathPosition_mm, m_pathForcePercent, m_pathElsewherePercent;
    double m_springSum_mm = 0.0, m_largestPosition_mm = 0.0;
    bool m_isTimedApart = false;
    ErrorSeries m_series;
};

} // namespace palpate::evaluation
