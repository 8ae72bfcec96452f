// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"
#include "palpate/evaluation/ExactSolver.h"

#include <memory>
#include <vector>

namespace palpate::evaluation {

/// What the exact solver says of one layer, tick by tick.
struct LayerTruth
{
    std::vector<Vec3> p_WG;             ///< [mm]
    std::vector<Vec3> spring_mm;        ///< zero in free space
    std::vector<ContactSprings> answer; ///< of the tissue touched; in free space the layer's stiffest
};

/// What the exact solver says of a motion that it is given at one rate.
struct Truth
{
    std::size_t stride = 1; ///< base samples of a tick: 4 at 1 kHz
    std::vector<LayerTruth> layers;
    std::vector<Vec3> f_W;        ///< the layers' answers together; zero in free space [N]
    std::vector<char> isTouching; ///< any layer
    Percentiles time_us;          ///< a tick
    std::size_t ticks = 0;        ///< computed; fewer than the motion has when time was up
    double largest_N = 0.0;       ///< force
};

/// One solver for each layer of a subject.
using LayerSolvers = std::vector<std::unique_ptr<ReferenceSolver>>;

/// Processor time of this thread: how much is run must not depend on what else the machine does. [s]
[[nodiscard]] double threadTime_s();

/// Processor time that a piece of work may take. [s]
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

/// Runs the exact solver over every `stride`-th sample of a motion, at most `seconds` long.
/// @param fingertip_mm  radius of the ball that touches; 0 is a point
[[nodiscard]] Truth truthOf(const Subject& subject, const HandMotion& motion, std::size_t stride, double seconds,
                            double fingertip_mm = 0.0);

/// Adds up one trial over the motions of its paths.
class TrialRun
{
  public:
    /// @param own  what the solvers touch, layer by layer: for pop-throughs
    /// @param isOnTruth  true for god-objects on the very surfaces of the truth: their residuals are taken
    TrialRun(Trial description, std::vector<const Surface*> own, bool isOnTruth);

    /// Feels one motion, at most `seconds` long, with all that is measured of it.
    /// @param truth  with the stride of the trial's rate; for Knob::Rate every sample of the motion
    void feel(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds);
    /// Takes only times, from just before the first contact on: of solvers too slow for a whole path. What `feel` took
    /// of the same trial is no time then.
    void time(LayerSolvers& solvers, const HandMotion& motion, const Truth& truth, double seconds);
    /// Closes a path: the figures of its motions together are one value of each spread.
    void endPath();
    [[nodiscard]] Trial result() const;
    [[nodiscard]] const Trial& description() const noexcept { return m_trial; }
    /// Errors of the motion last felt. [mm]
    [[nodiscard]] const ErrorSeries& series() const noexcept { return m_series; }

  private:
    /// The solver against the truth, at one tick of it.
    struct Errors
    {
        bool isTouching = false; ///< either of them
        double position_mm = 0.0, force_N = 0.0, forcePercent = 0.0;
        double direction_deg = -1.0; ///< negative: the force is too small to have one
        double spring_mm = 0.0;
    };
    /// Values of a path's ticks, or of all of them.
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
    std::vector<std::unique_ptr<ExactSolver>> m_exact; ///< by layer; empty without residuals
    std::vector<SolverStep> m_steps;                   ///< of this tick, by layer
    std::vector<int> m_windingAtStart;
    std::vector<double> m_intrusion_mm; ///< of a ball, by layer, when last looked at
    double m_apart_mm;                  ///< what is farther from the exact one is elsewhere
    Ticks m_path, m_all;
    std::vector<double> m_interrupted_us, m_freeTime_us, m_force_N, m_direction_deg, m_residual_mm, m_elsewhere_mm,
        m_elsewhereForcePercent;
    std::vector<double> m_pathTime_us, m_pathPosition_mm, m_pathForcePercent, m_pathElsewherePercent;
    double m_springSum_mm = 0.0, m_largestPosition_mm = 0.0;
    bool m_isTimedApart = false;
    ErrorSeries m_series;
};

} // namespace palpate::evaluation
