// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchHistory.h"

#include <algorithm>
#include <cmath>

namespace palpate::ui {

void TouchHistory::add(const TouchSample& sample)
{
    if (!m_samples.empty() && sample.time_s < m_samples.back().time_s) {
        m_samples.clear();
    }
    m_samples.push_back(sample);
    while (m_samples.front().time_s < sample.time_s - kLength_s) {
        m_samples.pop_front();
    }
}

double TouchHistory::peakForce_N() const
{
    double peak = 0.0;
    for (const TouchSample& sample : m_samples) {
        peak = std::max(peak, sample.force_N);
    }
    return peak;
}

double TouchHistory::peakDepth_mm() const
{
    double peak = 0.0;
    for (const TouchSample& sample : m_samples) {
        peak = std::max(peak, sample.depth_mm);
    }
    return peak;
}

bool TouchHistory::hasLayers() const
{
    return std::any_of(m_samples.begin(), m_samples.end(),
                       [](const TouchSample& sample) { return sample.layers.size() > 1; });
}

bool TouchHistory::hasFriction() const
{
    constexpr double kShown_N = 1e-3; // tolerance for rounding: without friction the force is along the normal
    return std::any_of(m_samples.begin(), m_samples.end(),
                       [](const TouchSample& sample) { return sample.along_N > kShown_N; });
}

double axisTop(double value)
{
    if (!(value > 0.0) || !std::isfinite(value)) {
        return 1.0;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (value <= step * decade * (1.0 + 1e-9)) {
            return step * decade;
        }
    }
    return 10.0 * decade;
}

} // namespace palpate::ui
