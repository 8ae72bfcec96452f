// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/CornerForce.h"
#include "palpate/evaluation/HardCases.h"
#include "palpate/evaluation/MotionComparison.h"
#include "palpate/evaluation/SmoothComparison.h"
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

/// Mean, median and upper percentiles of a series of measurements.
struct Percentiles
{
    std::size_t count = 0;
    double mean = 0.0;
    double p50 = 0.0;
    double p99 = 0.0;
    double p999 = 0.0;
    double max = 0.0;
};

/// @return nearest-rank percentiles; all zero if `values` is empty
[[nodiscard]] Percentiles percentilesOf(std::vector<double> values);

/// Highest percentile with at least ten values above: 99.9 % from 10,000 values, 99 % from 1,000 values, otherwise the
/// maximum. Higher percentiles would depend on single values.
struct Tail
{
    double value = 0.0;
    const char* name = "most"; ///< "99.9 %", "99 %" or "most"
};
[[nodiscard]] Tail tailOf(const Percentiles& percentiles);
inline constexpr std::size_t kMinCountForP999 = 10000; ///< values

/// Parameter in which a trial differs from the default product.
enum class Knob
{
    Solver,    ///< another solver on the same mesh
    Decimated, ///< the product on a decimated mesh
    OnePass,   ///< the product with one solver pass per tick
    Rate,      ///< the product at another servo rate; errors relative to the exact solver at 4 kHz, with the force held
               ///< between ticks
    Radius,    ///< the product with a spherical fingertip; errors relative to the exact solver with the same sphere
};

/// Comparison of a solver with the exact solver, both started from the solver's state and given the same HIP, tick by
/// tick.
struct SameState
{
    std::size_t ticks = 0;    ///< compared: all ticks in contact
    std::size_t parted = 0;   ///< in which the results differ by more than the threshold of `Trial::elsewhere`
    double parted_mm = 0.0;   ///< largest distance in these ticks
    double longer_mm = 0.0;   ///< largest excess of the solver's spring length over the exact one in these ticks
    double together_mm = 0.0; ///< largest distance in all other ticks
};

/// One data point of the report: a solver with one setting on one subject, over all paths.
///
/// The solver and the exact solver (on the full mesh) receive the same HIP samples, and each continues from its own
/// state. All ticks in which either is in contact count. With Knob::Rate, the exact solver receives all 4,000 samples
/// per second.
struct Trial
{
    std::string subject;
    std::string solver;
    std::string setting; ///< "25 % of the triangles", "2000 Hz", or empty
    Knob knob = Knob::Solver;
    double variationValue = 0.0; ///< fraction of the triangles, Hz or mm
    double fingertip_mm = 0.0;   ///< fingertip radius; 0: point contact
    std::size_t triangles = 0;
    double rate_Hz = 1000.0;
    std::size_t ticks = 0;       ///< executed
    std::size_t wanted = 0;      ///< in all paths; fewer are executed only if the time limit ends the run
    std::size_t interrupted = 0; ///< ticks preempted by another process; excluded from the timings unless all were
    Percentiles time_us; ///< ticks in which the exact solver is in contact; for brute force only the first such ticks
                         ///< of each path
    Percentiles freeTime_us;   ///< all other ticks
    Percentiles position_mm;   ///< |god-object - exact|, of the layer with the largest value
    Percentiles force_N;       ///< |force - exact|
    Percentiles forcePercent;  ///< relative to the exact force, or to 2 % of the path's largest force if that is larger
    Percentiles direction_deg; ///< where the exact force is at least 2 % of its maximum
    Percentiles residual_mm;   ///< of a sample of ticks; only for god-object solvers on the full mesh
    std::size_t popThroughs = 0;
    /// Ticks in which the solver and the exact solver differ by more than 1e-3 mm for the same sample (for subjects
    /// below 100 mm: 1e-5 of the extent). These ticks are included in all errors above.
    std::size_t elsewhere = 0;
    Percentiles elsewhere_mm;             ///< distance in these ticks
    Percentiles elsewhereForcePercent;    ///< force error in these ticks
    SameState sameState;                  ///< only for god-object solvers on the full mesh
    std::vector<std::int64_t> iterations; ///< number of ticks by iteration count
    double spring_mm = 0.0;       ///< mean over the ticks in contact of the exact force divided by the stiffness of the
                                  ///< stiffest tissue in contact; with one layer the spring length
    bool isReference = false;     ///< the exact solver itself, with an error of 0 by definition
    bool isParetoOptimal = false; ///< Pareto-optimal: no other trial of the subject is both faster and more accurate
    // One value per path.
    Spread pathTime_us;          ///< median over the ticks of the path
    Spread pathPosition_mm;      ///< mean over the ticks of the path
    Spread pathForcePercent;     ///< 99th percentile over the ticks of the path
    Spread pathElsewherePercent; ///< percentage of the ticks of the path
};

/// Position error of one trial over time, thinned for plotting.
struct ErrorSeries
{
    std::string subject, solver, motion;
    std::vector<double> time_s;
    std::vector<double> error_mm;
};

/// Cost per tick on one generated sphere.
struct SizePoint
{
    std::string solver;
    std::size_t triangles = 0;
    std::size_t ticks = 0;
    Percentiles time_us;
};

/// Geometry, structures and paths of an evaluated subject.
struct SubjectInfo
{
    std::string name, hash;
    std::vector<SubjectStructure> structures;
    std::size_t layers = 1;
    std::size_t triangles = 0;
    double extent_mm = 0.0;
    std::size_t bytes = 0;          ///< size of the haptic copy
    double build_ms = 0.0;          ///< time to build the spatial index
    std::vector<std::string> paths; ///< paths of every trial: "seed 1", or the name of a given motion
};

/// Recommended settings, derived from the trials.
struct Advice
{
    std::string subject, setting;
    std::vector<std::string> why; ///< reasons, one or two sentences each: cost, error, effect of other settings
    std::string warning;          ///< problem to fix first; usually empty
};

/// Median time of another solver divided by the product's median on a sphere, both from the same run.
struct Ratio
{
    std::string solver;
    std::size_t triangles = 0;
    double times = 0.0;
    double wanted = 0.0; ///< required minimum
};

/// Hardware and build of a run.
struct Machine
{
    std::string cpu, compiler, build, startedUtc;
    int cores = 0;
    double load = 0.0; ///< load average over the minute before the run
};

/// Complete content of the report.
struct Evaluation
{
    Machine machine;
    std::uint64_t seed = 0; ///< seed of the first path
    bool isQuick = false;
    bool isCancelled = false;
    std::vector<std::string> skippedItems; ///< items skipped because of the time limit, one line each
    double duration_s = 0.0;
    std::vector<std::string> motions;
    std::vector<SubjectInfo> subjects;
    std::vector<Trial> trials;       ///< for each subject: exact solver, product, product variants, other solvers
    std::vector<ErrorSeries> series; ///< first motion of the first path
    std::vector<SizePoint> sizes;
    std::vector<SizePoint> tissues; ///< the product on one sphere: plain, with friction, with a force law, with a
                                    ///< stiffness map, with buried lumps; with friction, law and map
    std::vector<Ratio> ratios;
    std::vector<HardCaseResult> hardCases;
    std::vector<Advice> advice;
    VectorFieldFigures vectorField;
    std::vector<CornerForce> corners;
    std::vector<SmoothRow> smooth;              ///< empty in a quick run
    std::vector<MotionRow> moving;              ///< empty in a quick run
    std::vector<Trial> paperBody;               ///< PaperSolver, then the product, on paperBody() with 616 triangles
    std::array<int, 3> eliminationOperations{}; ///< for 1, 2 and 3 planes
};

/// Extent of an evaluation. The defaults run everything that fits into ten minutes.
struct EvaluateOptions
{
    bool isQuick = false; ///< fewer paths, smaller spheres, no long hard cases
    double seconds = 0.0; ///< time limit; items that would exceed the limit are skipped; 0: ten minutes
    bool withHardCases = true;
    bool withGeneratedMotions =
        true;               ///< generated motions in addition to given ones; always generated if none are given
    std::uint64_t seed = 1; ///< of the first path; the following paths use consecutive seeds
    int seeds = 0;          ///< number of generated paths per subject; 0: 16, or 3 in a quick run
    /// Progress callback: fraction done (0 to 1) and current activity. Return false to cancel. May be empty.
    std::function<bool(double, const std::string&)> progress;
};

/// Runs all solvers and all product variants. For example, for a sphere of 50 mm radius:
/// @code
/// const auto sphere = subjectOf("sphere", shapes::bumpySphere(16, 50.0, 0.0));
/// const Evaluation result = evaluate({sphere}, {}, {.isQuick = true});
/// const core::Status written = writeReport("report", result);
/// @endcode
/// @param subjects  at least one
/// @param given     recorded motions, each evaluated as a separate path
[[nodiscard]] Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects,
                                  const std::vector<HandMotion>& given, const EvaluateOptions& options);

/// Selection of hard cases to run.
enum class HardCaseChoice
{
    Quick,    ///< only cases of at most 20,000 ticks
    Ordinary, ///< all except those reserved for the nightly run
    All,
};

/// Runs the cases in table order. @param progress  as in EvaluateOptions; a cancelled case yields no result
[[nodiscard]] std::vector<HardCaseResult> runHardCases(HardCaseChoice choice,
                                                       const std::function<bool(double, const std::string&)>& progress);
/// Number of cases in the selection.
[[nodiscard]] std::size_t hardCaseCount(HardCaseChoice choice);

} // namespace palpate::evaluation
