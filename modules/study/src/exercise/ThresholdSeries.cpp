// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ThresholdSeries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace palpate::study {

namespace {

constexpr double kEasiest_percent = 200.0, kHardest_percent = 1.0;
constexpr std::size_t kMostTrials = 10000, kMostChoices = 16;
/// Share of trials that are wrong however large the change: a slip of the hand.
constexpr double kSlips = 0.02;
constexpr std::array kSlopes{1.0, 1.7, 2.8, 4.8, 8.0};

double weibull(double percent, double threshold_percent, double slope, std::size_t choices, double slips)
{
    const double guess = 1.0 / static_cast<double>(choices);
    const double range = 1.0 - guess - slips;
    const double atThreshold = -std::log(1.0 - (kSeriesTarget - guess) / range);
    return guess + range * -std::expm1(-atThreshold * std::pow(percent / threshold_percent, slope));
}

} // namespace

double rightAnswers(double percent, double threshold_percent, double slope, std::size_t choices) noexcept
{
    return weibull(percent, threshold_percent, slope, choices, 0.0);
}

core::Result<ThresholdSeries> ThresholdSeries::create(const SeriesOptions& options)
{
    if (options.trials < 1 || options.trials > kMostTrials) {
        return core::Status(core::StatusCode::OutOfRange, PALPATE_TEXT("trials: found %1, expected 1 to %2"),
                            options.trials, kMostTrials);
    }
    if (options.choices < 2 || options.choices > kMostChoices) {
        return core::Status(core::StatusCode::OutOfRange, PALPATE_TEXT("places: found %1, expected 2 to %2"),
                            options.choices, kMostChoices);
    }
    if (!(options.first_percent >= kHardest_percent && options.first_percent <= kEasiest_percent)) {
        return core::Status(core::StatusCode::OutOfRange, PALPATE_TEXT("first change: found %1 %, expected %2 to %3 %"),
                            options.first_percent, kHardest_percent, kEasiest_percent);
    }
    return ThresholdSeries(options);
}

ThresholdSeries::ThresholdSeries(const SeriesOptions& options)
    : m_options(options)
    , m_percent(options.first_percent)
{
}

void ThresholdSeries::answer(bool isRight)
{
    if (isDone()) {
        return;
    }
    m_trials.push_back({m_percent, isRight});
    m_rightInARow = isRight ? m_rightInARow + 1 : 0;
    if (isRight && m_rightInARow < 2) {
        return;
    }
    m_rightInARow = 0;
    const int direction = isRight ? -1 : 1;
    m_reversals += m_direction != 0 && direction != m_direction ? 1 : 0;
    m_direction = direction;
    const double step = m_reversals < 2 ? 1.6 : m_reversals < 4 ? 1.25 : 1.12;
    m_percent = std::clamp(isRight ? m_percent / step : m_percent * step, kHardest_percent, kEasiest_percent);
}

HandThreshold ThresholdSeries::estimate() const
{
    constexpr std::size_t kSteps = 200;
    const double step = std::log(kEasiest_percent / kHardest_percent) / (kSteps - 1);
    const auto thresholdAt = [step](double i) { return kHardest_percent * std::exp(step * i); };
    std::vector<double> logs;
    for (std::size_t i = 0; i < kSteps; ++i) {
        for (const double slope : kSlopes) {
            double sum = 0.0;
            for (const Trial& trial : m_trials) {
                const double right =
                    weibull(trial.percent, thresholdAt(static_cast<double>(i)), slope, m_options.choices, kSlips);
                sum += std::log(trial.isRight ? right : 1.0 - right);
            }
            logs.push_back(sum);
        }
    }
    const double most = *std::max_element(logs.begin(), logs.end());
    std::vector<double> weights(kSteps, 0.0);
    for (std::size_t i = 0; i < logs.size(); ++i) {
        weights[i / kSlopes.size()] += std::exp(logs[i] - most);
    }
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    double mean = 0.0, below = 0.0;
    std::array<double, 2> bounds{};
    for (std::size_t i = 0; i < kSteps; ++i) {
        const double share = weights[i] / all;
        mean += share * static_cast<double>(i);
        bounds[0] = below < 0.025 ? static_cast<double>(i) : bounds[0];
        bounds[1] = below < 0.975 ? static_cast<double>(i) : bounds[1];
        below += share;
    }
    return {thresholdAt(mean), thresholdAt(bounds[0]), thresholdAt(bounds[1])};
}

} // namespace palpate::study
