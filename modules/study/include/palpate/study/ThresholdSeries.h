// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <vector>

namespace palpate::study {

/// Settings of a ThresholdSeries.
struct SeriesOptions
{
    std::size_t trials = 60;
    /// Number of places to choose from in a trial, 2 to 16, of which one is stiffer. More places make a lucky guess
    /// rarer and the estimate narrower.
    std::size_t choices = 4;
    double first_percent = 80.0; ///< increase of stiffness in the first trial
};

/// Estimated threshold of a hand: the increase of stiffness that it finds in 70.7 % of the trials.
struct HandThreshold
{
    double percent = 0.0;
    double low_percent = 0.0, high_percent = 0.0; ///< 95 % credible interval
};

/// Share of right answers to which the series converges: two in a row as likely as not.
inline constexpr double kSeriesTarget = 0.70710678118654752;

/// Probability of a right answer by a Weibull function of the increase of stiffness (Watson & Pelli, "QUEST: a Bayesian
/// adaptive psychometric method", Perception & Psychophysics 33, 1983).
/// @param percent  increase of stiffness, >= 0
/// @param threshold_percent  increase with kSeriesTarget right answers, > 0
/// @param slope  exponent, > 0, typically 1 to 6
/// @param choices  >= 2; a guess is right once in so many trials
[[nodiscard]] PALPATE_EXPORT double rightAnswers(double percent, double threshold_percent, double slope,
                                                 std::size_t choices) noexcept;

/// Adaptive series of trials for the smallest increase of stiffness that a hand detects: two right answers in a row
/// make the next trial harder, a wrong one makes it easier (Levitt, "Transformed up-down methods in psychoacoustics",
/// J. Acoust. Soc. Am. 49, 1971). Levels change by a factor that shrinks at the first reversals.
///
/// The threshold is not the mean of the reversals, but the mean of the posterior distribution of its logarithm, given
/// all answers, over thresholds and slopes (as recommended by King-Smith et al., "Efficient and unbiased modifications
/// of the QUEST threshold method", Vision Research 34, 1994).
class PALPATE_EXPORT ThresholdSeries
{
  public:
    struct Trial
    {
        double percent = 0.0;
        bool isRight = false;
    };
    /// @return OutOfRange for options out of range
    [[nodiscard]] static core::Result<ThresholdSeries> create(const SeriesOptions& options = {});

    /// Increase of stiffness in the next trial, 1 to 200 %.
    [[nodiscard]] double percent() const noexcept { return m_percent; }
    [[nodiscard]] bool isDone() const noexcept { return m_trials.size() >= m_options.trials; }
    /// Adds the answer to the next trial. No effect after the last one.
    void answer(bool isRight);
    [[nodiscard]] const std::vector<Trial>& trials() const noexcept { return m_trials; }
    [[nodiscard]] std::size_t reversals() const noexcept { return m_reversals; }
    /// Estimates the threshold from the answers so far.
    [[nodiscard]] HandThreshold estimate() const;

  private:
    explicit ThresholdSeries(const SeriesOptions& options);

    SeriesOptions m_options;
    double m_percent;
    std::vector<Trial> m_trials;
    int m_rightInARow = 0;
    int m_direction = 0; ///< of the last change: 1 easier, -1 harder, 0 none yet
    std::size_t m_reversals = 0;
};

} // namespace palpate::study
