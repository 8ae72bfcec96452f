// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/HardCases.h"
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

/// What a trial varies from the product as it is.
enum class Knob
{
    Solver,    ///< another solver on the same mesh
    Decimated, ///< the product on a copy with fewer triangles
    OnePass,   ///< the product with one pass a tick
    Rate,      ///< the product at another servo rate; errors include that the force is held between ticks
};

/// One mark of the report: a solver with its knob on one subject, all motions together.
///
/// Errors are taken at each tick against the exact solver on the full mesh, while either touches. Ticks in which the
/// god-object rests legally in another local minimum than the exact one are counted, not taken as errors: where two
/// ways part, either is right.
struct Trial
{
    std::string subject;
    std::string solver;
    std::string setting; ///< "25 % of the triangles", "2000 Hz", or empty
    Knob knob = Knob::Solver;
    double knobValue = 0.0; ///< share of the triangles, or Hz
    std::size_t triangles = 0;
    double rate_Hz = 1000.0;
    std::size_t ticks = 0;    ///< run
    std::size_t wanted = 0;   ///< that the motions have; a brute-force solver may get through fewer in its time
    Percentiles time_us;      ///< a tick in which the exact solver touches
    Percentiles freeTime_us;  ///< any other tick
    Percentiles position_mm;  ///< |god-object - exact|
    Percentiles force_N;      ///< |force - exact|
    Percentiles forcePercent; ///< of the exact force
    Percentiles direction_deg;
    Percentiles residual_mm; ///< of a sample of ticks; god-objects on the full mesh only
    std::size_t popThroughs = 0;
    std::size_t otherMinimum = 0;
    std::vector<std::int64_t> iterations; ///< ticks by iterations
    double spring_mm = 0.0;               ///< mean of the exact spring while it touches
    bool isReference = false;             ///< the exact solver itself: its error is 0 by definition
    bool isOnFront = false;               ///< no other trial of the subject is both faster and nearer
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
    std::size_t triangles = 0;
    double extent_mm = 0.0;
    std::size_t bytes = 0; ///< of the haptic copy
    double build_ms = 0.0; ///< of its index
};

/// What a person should do, worked out from the trials.
struct Advice
{
    std::string subject, setting, why;
};

struct Machine
{
    std::string cpu, compiler, build, startedUtc;
    int cores = 0;
};

/// All that the report shows.
struct Evaluation
{
    Machine machine;
    std::uint64_t seed = 0;
    double stiffness_N_per_mm = 0.5;
    bool isQuick = false;
    bool isCancelled = false;
    double duration_s = 0.0;
    std::vector<std::string> motions;
    std::vector<SubjectInfo> subjects;
    std::vector<Trial> trials;
    std::vector<ErrorSeries> series;
    std::vector<SizePoint> sizes;
    std::vector<HardCaseResult> hardCases;
    std::vector<Advice> advice;
    VectorFieldFigures vectorField;
    std::array<int, 3> eliminationOperations{}; ///< for 1, 2 and 3 planes
};

struct EvaluateOptions
{
    bool isQuick = false; ///< ends within half a minute: shorter motions, smaller spheres, no long hard case
    bool withHardCases = true;
    double stiffness_N_per_mm = 0.5;
    std::uint64_t seed = 1;
    /// Told the share done, 0 … 1, and what is being done; false cancels. May be empty.
    std::function<bool(double, const std::string&)> progress;
};

/// Runs every solver and every knob.
/// @param subjects  at least one
/// @param given     a motion to use instead of those that are laid on the surfaces; null for those
[[nodiscard]] Evaluation evaluate(const std::vector<std::shared_ptr<const Subject>>& subjects, const HandMotion* given,
                                  const EvaluateOptions& options);

/// Runs the rows of the table that are not left to the nightly run.
/// @param isQuick  leaves out those of more than 20,000 ticks as well
[[nodiscard]] std::vector<HardCaseResult> runHardCases(bool isQuick,
                                                       const std::function<bool(double, const std::string&)>& progress);

} // namespace palpate::evaluation
