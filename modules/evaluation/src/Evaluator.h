// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TrialRun.h"
#include "palpate/evaluation/Evaluation.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Seconds that parts may take, over all motions of a subject.
struct Times
{
    double truth, bruteForce, other;
    int motion_ms;
    int largestSphere;
};

/// Runs every solver and every knob within its time; see evaluate().
class Evaluator
{
  public:
    Evaluator(const EvaluateOptions& options, std::size_t subjects);
    Evaluation run(const std::vector<std::shared_ptr<const Subject>>& subjects, const std::vector<HandMotion>& given);

  private:
    static constexpr double kPartsOfASubject = 16.0; // about, for the progress

    /// One thing that is measured of a subject.
    struct Part
    {
        std::string what;
        std::function<void(double)> measure; ///< told the seconds that it may take
    };

    [[nodiscard]] double elapsed_s() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_started).count();
    }
    bool next(const std::string& what, double weight = 1.0)
    {
        m_result.isCancelled =
            m_result.isCancelled || (m_options.progress && !m_options.progress(std::min(1.0, m_done / m_parts), what));
        m_done += weight;
        return !m_result.isCancelled;
    }
    void evaluateSubject(const Subject& subject, const std::vector<HandMotion>& motions, double seconds);
    void findTruth(const Subject& subject, double seconds);
    [[nodiscard]] std::vector<Part> partsOf(const Subject& subject);
    void feel(Trial description, LayerSolvers solvers, const std::vector<const Surface*>& own, bool isOnTruth,
              double seconds, bool fromContact = false);
    template<class Make>
    void feelOn(const Subject& subject, Trial description, bool isGodObject, double seconds, bool fromContact,
                const Make& make);
    void feelBall(const Subject& subject, double fingertip_mm, double seconds);
    void feelDecimated(const Subject& subject, double share, double seconds);
    void feelSpheres();
    void runHard();
    void elimination();

    const EvaluateOptions& m_options;
    Times m_times;
    double m_limit_s, m_subjects, m_parts, m_done = 0.0;
    std::chrono::steady_clock::time_point m_started = std::chrono::steady_clock::now();
    Evaluation m_result;
    const Subject* m_subject = nullptr;
    const std::vector<HandMotion>* m_motions = nullptr;
    std::vector<Truth> m_truths;
    std::vector<geometry::TriangleMesh> m_fewer; ///< the last decimated copy of each layer
    double m_decimation_s;                       ///< for each triangle removed, as measured last
    double m_subjectEnd_s = 0.0;
};

} // namespace palpate::evaluation
