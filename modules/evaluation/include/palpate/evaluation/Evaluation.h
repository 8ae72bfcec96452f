// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/CornerForce.h"
#include "palpate/evaluation/HardCases.h"
#include "palpate/evaluation/Spread.h"
#include "palpate/evaluation/Subject.h"
#include "palpate/evaluation/VectorFieldSolver.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Mean, median and tails of what was measured.
struct Percentiles
{
    std::size_t count = 0;
    double mean = 0.0;
    double p50 = 0.0;
    double p99 = 0.0;
    double p999 = 0.0;
    double max = 0.0;
};

/// @return percentiles by the nearest rank; zeros without values
[[nodiscard]] Percentiles percentilesOf(std::vector<double> values);

/// The farthest percentile that at least ten of the values lie beyond: 99.9 % from 10,000 values on, 99 % from 1,000
/// on, otherwise the largest value. What is nearer to the end is decided by single values.
struct Tail
{
    double value = 0.0;
    const char* name = "most"; ///< "99.9 %", "99 %" or "most"
};
[[nodiscard]] Tail tailOf(const Percentiles& percentiles);
inline constexpr std::size_t kFewestForP999 = 10000; ///< values

/// What a trial varies from the product as it is.
enum class Knob
{
    Solver,    ///< another solver on the same mesh
    Decimated, ///< the product on a copy with fewer triangles
    OnePass,   ///< the product with one pass a tick
    Rate,      ///< the product at another servo rate; errors are against the exact solver at 4 kHz, force held
    Radius,    ///< the product with a ball as fingertip; errors are against the exact solver with the same ball
};

/// A solver against one tick of the exact solver that starts from the state the solver was in, with the same hand.
struct SameState
{
    std::size_t ticks = 0;    ///< compared: every tick in contact
    std::size_t parted = 0;   ///< in which the two end more than the threshold of `Trial::elsewhere` apart
    double parted_mm = 0.0;   ///< largest distance of those
    double longer_mm = 0.0;   ///< by how much the solver's spring was longer than the exact one's, at most, in those
    double together_mm = 0.0; ///< largest distance in all other ticks
};

/// One mark of the report: a solver with its knob on one subject, all paths together.
///
/// The solver and the exact one on the full mesh get the same samples of the hand, each runs on from its own state, and
/// every tick in which either touches counts. With Knob::Rate the exact one gets all 4,000 samples a second.
struct Trial
{
    std::string subject;
    std::string solver;
    std::string setting; ///< "25 % of the triangles", "2000 Hz", or empty
    Knob knob = Knob::Solver;
    double knobValue = 0.0;    ///< share of the triangles, Hz or mm
    double fingertip_mm = 0.0; ///< radius of the ball; 0 is a point
    std::size_t triangles = 0;
    double rate_Hz = 1000.0;
    std::size_t ticks = 0;       ///< run
    std::size_t wanted = 0;      ///< that the paths have; fewer are run only when a time limit ends
    std::size_t interrupted = 0; ///< ticks in which another program took the core: not in the times, unless all are
    Percentiles time_us;         ///< a tick in which the exact solver touches; of brute force, the first of each path
    Percentiles freeTime_us;     ///< any other tick
    Percentiles position_mm;     ///< |god-object - exact|, of the layer where it is largest
    Percentiles force_N;         ///< |force - exact|
    Percentiles forcePercent;    ///< of the exact force, or of 2 % of the path's largest force where that is more
    Percentiles direction_deg;   ///< where the exact force is at least 2 % of its largest
    Percentiles residual_mm;     ///< of a sample of ticks; god-objects on the full mesh only
    std::size_t popThroughs = 0;
    /// Ticks in which solver and exact one, given the same sample, are more than 1e-3 mm apart (on what is smaller than
    /// 100 mm: 1e-5 of its extent). They are part of all errors above.
    std::size_t elsewhere = 0;
    Percentiles elsewhere_mm;             ///< distance in those ticks
    Percentiles elsewhereForcePercent;    ///< and the force's error
    SameState sameState;                  ///< god-objects on the full mesh only
    std::vector<std::int64_t> iterations; ///< ticks by iterations
    double spring_mm = 0.0;   ///< mean of the exact force over the stiffest tissue touched, while any is: with one
                              ///< layer the spring's length
    bool isReference = false; ///< the exact solver itself: its error is 0 by definition
    bool isOnFront = false;   ///< no other trial of the subject is both faster and nearer
    // By path.
    Spread pathTime_us;          ///< median of the path's ticks
    Spread pathPosition_mm;      ///< mean of the path's ticks
    Spread pathForcePercent;     ///< 99th percentile of the path's ticks
    Spread pathElsewherePercent; ///< share of its ticks
};

/// Error of one trial tick by tick, thinned for drawing.
struct ErrorSeries
{
    std::string subject, solver, motion;
    std::vector<double> time_s;
    std::vector<double> error_mm;
};

/// Cost on one generated sphere.
struct SizePoint
{
    std::string solver;
    std::size_t triangles = 0;
    std::size_t ticks = 0;
    Percentiles time_us;
};

struct SubjectInfo
{
    std::string name, hash;
    std::vector<SubjectStructure> structures;
    std::size_t layers = 1;
    std::size_t triangles = 0;
    double extent_mm = 0.0;
    std::size_t bytes = 0;          ///< of the haptic copy
    double build_ms = 0.0;          ///< of its index
    std::vector<std::string> paths; ///< that every mark was run on: "seed 1", or the name of a given motion
};

/// What a person should do, worked out from the trials.
struct Advice
{
    std::string subject, setting;
    std::vector<std::string> why; ///< one sentence or two each: cost, error, what other settings would give
    std::string warning;          ///< what to mend before all else; mostly empty
};

/// How many times the product's median on a sphere the median of another solver is, both in the same run.
struct Ratio
{
    std::string solver;
    std::size_t triangles = 0;
    double times = 0.0;
    double wanted = 0.0; ///< at least
};

struct Machine
{
    std::string cpu, compiler, build, startedUtc;
    int cores = 0;
    double load = 0.0; ///< programs that wanted a core in the minute before
};

/// All that the report shows.
struct Evaluation
{
    Machine machine;
    std::uint64_t seed = 0; ///< of the first path
    bool isQuick = false;
    bool isCancelled = false;
    std::vector<std::string> leftOut; ///< what there was no time for, one line each
    double duration_s = 0.0;
    std::vector<std::string> motions;
    std::vector<SubjectInfo> subjects;
    std::vector<Trial> trials;       ///< of each subject the exact solver, the product, its knobs, the other solvers
    std::vector<ErrorSeries> series; ///< of the first motion of the first path
    std::vector<SizePoint> sizes;
    std::vector<SizePoint> tissues; ///< the product on one sphere, plain and with friction, a law, a map, all
    std::vector<Ratio> ratios;
    std::vector<HardCaseResult> hardCases;
    std::vector<Advice> advice;
    VectorFieldFigures vectorField;
    std::vector<CornerForce> corners;
    std::vector<Trial> paperBody; ///< the paper's solver, then the product, on paperBody() of 616 triangles
    std::array<int, 3> eliminationOperations{}; ///< for 1, 2 and 3 planes
};

struct EvaluateOptions
{
    bool isQuick = false; ///< fewer paths, smaller spheres, no long hard case
    double seconds = 0.0; ///< leaves out what it could not end within this time; 0: ten minutes
    bool withHardCases = true;
    bool withLaidMotions = true; ///< beside given ones; without any they are laid in any case
    std::uint64_t seed = 1;      ///< of the first path; the next ones have the next seeds
    int seeds = 0;               ///< paths that are laid on each subject; 0: 16, of a quick run 3
    /// Told the share done, 0 … 1, and what is being done; false cancels. May be empty.
    std::function<bool(double, const std::string&)> progress;
};

/// Runs every solver and every knob.
/// @param subjects  at least one
/// @param given     motions to use, each of them a path of its own
[[nodiscard]] Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects,
                                  const std::vector<HandMotion>& given, const EvaluateOptions& options);

/// Which rows of the table of hard cases are run.
enum class HardCaseChoice
{
    Quick,    ///< none of more than 20,000 ticks
    Ordinary, ///< those that are not left to the nightly run
    All,
};

/// Runs the rows in their order. @param progress  as in EvaluateOptions; a row that it cancels is no result
[[nodiscard]] std::vector<HardCaseResult> runHardCases(HardCaseChoice choice,
                                                       const std::function<bool(double, const std::string&)>& progress);
/// How many rows that is.
[[nodiscard]] std::size_t hardCaseCount(HardCaseChoice choice);

} // namespace palpate::evaluation
