// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/ChartAxis.h"

#include <palpate/core/Export.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::study {

enum class MarkShape
{
    Circle,
    Square,
    Diamond,
    Triangle,
};

/// Draws a self-contained SVG chart: axes, marks with non-overlapping labels, lines and bars.
class PALPATE_EXPORT SvgChart
{
  public:
    SvgChart(int width, int height, ChartAxis x, ChartAxis y);

    struct Mark
    {
        double x = 0.0, y = 0.0;
        double xEnd = 0.0, yEnd = 0.0; ///< upper ends of the error bars; drawn if larger than x, y
        double xLow = 0.0, yLow = 0.0; ///< lower ends of the error bars; drawn if smaller than x, y; 0: no bar
        MarkShape shape = MarkShape::Circle;
        std::string colour;
        bool isHollow = false;
        std::string label, tooltip; ///< label: may be empty
        bool isStrong = false;
    };
    void add(const Mark& mark);
    void addLine(const std::vector<std::array<double, 2>>& points, std::string_view colour, double width_px,
                 bool isDashed = false, std::string_view label = {});
    /// Fills the area between two lines. @param lower, upper  with the same ascending x values
    void addRegion(const std::vector<std::array<double, 2>>& lower, const std::vector<std::array<double, 2>>& upper,
                   std::string_view colour);
    void addBand(double yLow, double yHigh, std::string_view colour);
    void addVerticalRule(double x, std::string_view label);
    void addHorizontalRule(double y, std::string_view label);
    void addBar(double xLow, double xHigh, double y, std::string_view colour, std::string_view tooltip);

    /// @param description  text alternative of the chart for screen readers
    [[nodiscard]] std::string svg(std::string_view description) const;

  private:
    struct Rectangle
    {
        double x, y, w, h;
    };
    [[nodiscard]] double px(double x) const;
    [[nodiscard]] double py(double y) const;
    void placeLabel(double x, double y, const std::string& text, std::string_view colour, bool isStrong);

    int m_width, m_height;
    ChartAxis m_x, m_y;
    std::string m_back, m_body, m_labels;
    std::vector<Rectangle> m_taken;
    struct Waiting
    {
        double x, y;
        std::string text, colour;
        bool isStrong;
    };
    std::vector<Waiting> m_waiting;
};

} // namespace palpate::study
