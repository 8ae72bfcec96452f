// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"
#include "run/TrialRun.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Amount of work, and time limits of its parts in seconds.
struct Extent
{
    int seeds;
    int motion_ms;       ///< of each generated motion
    double given_s;      ///< of a given motion
    double limit_s;      ///< total, on an idle machine
    double bruteForce_s; ///< for the timings of a brute-force solver, over all paths of a subject
    double sphere_s;     ///< per solver on one sphere
    int largestSphere;
};

/// Motions that together give one value of each Spread.
struct HandPaths
{
    std::string name; ///< "seed 1", or the name of a given motion
    std::vector<HandMotion> motions;
};

/// Runs all solvers and product variants within the time limit; see evaluate().
class Evaluator
{
  public:
    Evaluator(const EvaluateOptions& options, std::size_t subjects);
    Evaluation run(const std::vector<std::shared_ptr<const Subject>>& subjects, const std::vector<HandMotion>& given);

  private:
    /// Trial in progress; its solvers persist over all paths of a subject.
    struct Part
    {
        TrialRun run;
        LayerSolvers solvers;
        LayerSolvers timed; ///< used for timings if `solvers` are a faster equivalent
    };

    /// Wall-clock time, used to cut off the hard cases at the time limit.
    [[nodiscard]] double elapsed_s() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_started).count();
    }
    /// @return false if the run is cancelled
    bool next(const std::string& what);
    void leaveOut(const std::string& what) { m_result.skippedItems.push_back(what + ", for lack of time"); }

    [[nodiscard]] std::vector<HandPaths> pathsOn(const Surface& surface, const std::vector<HandMotion>& given);
    void describe(const Subject& subject);
    void makeParts(const Subject& subject, double end_s);
    void addPart(Trial description, const std::vector<const Surface*>& own, bool isOnTruth, LayerSolvers solvers,
                 LayerSolvers timed = {});
    void addProducts(const Subject& subject);
    void addOthers(const Subject& subject);
    void addDecimated(const Subject& subject, double end_s);
    /// @param end_s  thread CPU time after which no new work is started, also for the functions below
    void evaluateSubject(const Subject& subject, const std::vector<HandPaths>& paths, double end_s);
    void evaluatePath(const Subject& subject, const HandPaths& path, double end_s, std::size_t paths, bool isFirst);
    void evaluateMotion(const Subject& subject, const HandMotion& motion, double end_s, std::size_t paths,
                        bool isFirst);
    void evaluatePaperBody();
    void feelSpheres();
    void runHard();
    void elimination();

    const EvaluateOptions& m_options;
    Extent m_extent;
    double m_subjects, m_parts = 1.0, m_done = 0.0;
    std::chrono::steady_clock::time_point m_started = std::chrono::steady_clock::now();
    double m_startedThread_s = threadTime_s();
    Evaluation m_result;
    // State of the current subject.
    std::vector<Part> m_marks;
    std::vector<std::unique_ptr<Surface>> m_fewer; ///< surfaces of the decimated copies
    Trial m_exact;
    std::vector<double> m_exactTime_us; ///< median tick time of each motion
};

} // namespace palpate::evaluation
