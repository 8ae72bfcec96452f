// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QColor>
#include <QString>

#include <deque>
#include <vector>

namespace palpate::ui {

/// Force component of a layer in a chart sample.
struct LayerForce
{
    QColor colour; ///< colour of the structure
    double force_N = 0.0;
};

/// Sample of the running chart.
struct TouchSample
{
    double time_s = 0.0;
    double force_N = 0.0;
    double depth_mm = 0.0;
    std::vector<LayerForce> layers{}; ///< outermost first; the components add up to the force
    double along_N = 0.0;             ///< tangential component of the force (friction)
    QString over{};                   ///< lump felt through the organ with its change: "over lump 20 mm: +55 %"
};

/// Force and depth samples of the last `kLength_s` seconds.
class PALPATE_EXPORT TouchHistory
{
  public:
    static constexpr double kLength_s = 10.0;

    /// Adds a sample. A time earlier than the last sample (another recording, a seek) clears the history first.
    void add(const TouchSample& sample);
    void clear() { m_samples.clear(); }
    [[nodiscard]] const std::deque<TouchSample>& samples() const noexcept { return m_samples; }
    [[nodiscard]] double peakForce_N() const;
    [[nodiscard]] double peakDepth_mm() const;
    /// True when a sample contains several layers.
    [[nodiscard]] bool hasLayers() const;
    /// True when a sample contains a tangential force.
    [[nodiscard]] bool hasFriction() const;

  private:
    std::deque<TouchSample> m_samples;
};

/// Upper end of an axis: the smallest 1, 2 or 5 times a power of ten at or above `value`; 1 for zero or less.
[[nodiscard]] PALPATE_EXPORT double axisTop(double value);

} // namespace palpate::ui
