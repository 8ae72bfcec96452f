// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>

#include <deque>
#include <vector>

namespace palpate::ui {

/// A layer's part of the force in the running chart.
struct LayerForce
{
    QColor colour; ///< the structure's
    double force_N = 0.0;
};

/// One point of the running chart.
struct TouchSample
{
    double time_s = 0.0;
    double force_N = 0.0;
    double depth_mm = 0.0;
    std::vector<LayerForce> layers{}; ///< outermost first; they add up to the force
    double along_N = 0.0;             ///< part of the force along the surface: friction
};

/// The last seconds of force and depth.
class TouchHistory
{
  public:
    static constexpr double kLength_s = 10.0;

    /// Adds a sample. Time that runs backwards (another recording, a seek) starts anew.
    void add(const TouchSample& sample);
    void clear() { m_samples.clear(); }
    [[nodiscard]] const std::deque<TouchSample>& samples() const noexcept { return m_samples; }
    [[nodiscard]] double peakForce_N() const;
    [[nodiscard]] double peakDepth_mm() const;
    /// @return true when several layers were felt at once.
    [[nodiscard]] bool hasLayers() const;
    /// @return true when some of the force was along the surface.
    [[nodiscard]] bool hasFriction() const;

  private:
    std::deque<TouchSample> m_samples;
};

/// The next 1, 2 or 5 times a power of ten at or above `value`: the top of an axis. @return 1 for zero or less
[[nodiscard]] double axisTop(double value);

} // namespace palpate::ui
