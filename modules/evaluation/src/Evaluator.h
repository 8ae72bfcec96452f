// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TrialRun.h"
#include "palpate/evaluation/Evaluation.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// How much is run, and the seconds that parts may take.
struct Extent
{
    int seeds;
    int motion_ms;       ///< of each laid motion
    double given_s;      ///< of a given motion
    double limit_s;      ///< for all of it, on an idle machine
    double bruteForce_s; ///< for the times of a brute-force solver, over all paths of a subject
    double sphere_s;     ///< for a solver on one sphere
    int largestSphere;
};

/// Motions that together give one value of each spread.
struct HandPaths
{
    std::string name; ///< "seed 1", or that of a given motion
    std::vector<HandMotion> motions;
};

/// Runs every solver and every knob within its time; see evaluate().
class Evaluator
{
  public:
    Evaluator(const EvaluateOptions& options, std::size_t subjects);
    Evaluation run(const std::vector<std::shared_ptr<const Subject>>& subjects, const std::vector<HandMotion>& given);

  private:
    /// One mark in the making: its solvers live through all paths of a subject.
    struct Part
    {
        TrialRun run;
        LayerSolvers solvers;
        LayerSolvers timed; ///< where `solvers` are a faster copy: what the times are taken of
    };

    /// On the clock, for the hard cases: they are cut where the time is up.
    [[nodiscard]] double elapsed_s() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_started).count();
    }
    /// @return false when the run is cancelled
    bool next(const std::string& what);
    void leaveOut(const std::string& what) { m_result.leftOut.push_back(what + ", for lack of time"); }

    [[nodiscard]] std::vector<HandPaths> pathsOn(const Surface& surface, const std::vector<HandMotion>& given);
    void describe(const Subject& subject);
    void makeParts(const Subject& subject, double end_s);
    void addPart(Trial description, const std::vector<const Surface*>& own, bool isOnTruth, LayerSolvers solvers,
                 LayerSolvers timed = {});
    void addProducts(const Subject& subject);
    void addOthers(const Subject& subject);
    void addDecimated(const Subject& subject, double end_s);
    /// @param end_s  processor time at which no more is begun, here and below
    void evaluateSubject(const Subject& subject, const std::vector<HandPaths>& paths, double end_s);
    void feelPath(const Subject& subject, const HandPaths& path, double end_s, std::size_t paths, bool isFirst);
    void feelMotion(const Subject& subject, const HandMotion& motion, double end_s, std::size_t paths, bool isFirst);
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
    // Of the subject at hand.
    std::vector<Part> m_marks;
    std::vector<std::unique_ptr<Surface>> m_fewer; ///< surfaces of the decimated copies
    Trial m_exact;
    std::vector<double> m_exactTime_us; ///< medians of the motions
};

} // namespace palpate::evaluation
