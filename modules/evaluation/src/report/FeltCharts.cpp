// SPDX-License-Identifier: BSD-3-Clause
#include "report/FeltCharts.h"

#include "report/SvgChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace palpate::evaluation::felt {

namespace {

constexpr const char* kBand = "#dcecea";
constexpr const char* kBell = "#0b7a75";
constexpr const char* kPunch = "#c2542d";

SvgChart::Mark markOf(double x, double y, const char* colour, bool isHollow, std::string tooltip)
{
    SvgChart::Mark mark;
    mark.x = mark.xEnd = x;
    mark.y = mark.yEnd = y;
    mark.colour = colour;
    mark.isHollow = isHollow;
    mark.shape = isHollow ? MarkShape::Diamond : MarkShape::Circle;
    mark.tooltip = std::move(tooltip);
    return mark;
}

std::string nameOf(const SphereCase& c)
{
    return "radius " + shortNumber(c.sphereRadius) + ", cover " + shortNumber(c.cover) + ", ratio " +
           ratioText(c.ratio);
}

template<class Value>
std::vector<double> distinct(const std::vector<SphereCase>& cases, Value SphereCase::*value)
{
    std::set<double> all;
    for (const SphereCase& c : cases) {
        all.insert(c.*value);
    }
    return {all.begin(), all.end()};
}

} // namespace

std::string ratioText(double ratio)
{
    if (std::abs(3.0 * ratio - 1.0) < 1e-9) {
        return "1/3";
    }
    return std::isinf(ratio) ? "rigid" : shortNumber(ratio);
}

std::vector<double> radiiOf(const Comparison& comparison)
{
    return distinct(comparison.spheres, &SphereCase::sphereRadius);
}

std::vector<double> ratiosOf(const Comparison& comparison)
{
    return distinct(comparison.spheres, &SphereCase::ratio);
}

std::string coverChart(const Comparison& comparison, double sphereRadius, double ratio)
{
    constexpr double kDeepest = 3.2, kShallowest = 0.1, kStep = 0.05;
    std::vector<std::array<double, 2>> low, estimate, high;
    for (double cover = kShallowest; cover < kDeepest + 0.5 * kStep; cover += kStep) {
        const buried::Stiffening k =
            buried::stiffening(buried::shareOfSphere(sphereRadius, cover + sphereRadius, 1.0), ratio);
        low.push_back({cover, k.low});
        estimate.push_back({cover, k.estimate});
        high.push_back({cover, std::min(k.high, 1e6)});
    }
    // Limit the axis to slightly above the plotted data: the upper bound of a stiff lump exceeds the chart.
    double least = ratio < 1.0 ? low.front()[1] : 1.0, most = ratio < 1.0 ? 1.0 : 1.15 * estimate.front()[1] - 0.15;
    for (const SphereCase& c : comparison.spheres) {
        if (c.sphereRadius == sphereRadius && c.ratio == ratio) {
            least = std::min({least, c.punch, c.bell});
            most = std::max({most, c.punch, c.bell});
        }
    }
    SvgChart chart(420, 280, {0.0, kDeepest, false, "cover [contact radii]"}, {least, most, false, "k/k0"});
    chart.addRegion(low, high, kBand);
    chart.addLine(estimate, kBell, 2.0);
    for (const SphereCase& c : comparison.spheres) {
        if (c.sphereRadius == sphereRadius && c.ratio == ratio) {
            chart.add(markOf(c.cover, c.punch, kPunch, true, nameOf(c) + ", punch: " + shortNumber(c.punch)));
            chart.add(markOf(c.cover, c.bell, kBell, false, nameOf(c) + ", bell: " + shortNumber(c.bell)));
        }
    }
    return chart.svg("Stiffness against cover for a sphere of radius " + shortNumber(sphereRadius) + ", ratio " +
                     ratioText(ratio));
}

std::string estimateChart(const Comparison& comparison)
{
    const auto error = [](double estimate, double truth) { return 100.0 * ((estimate - 1.0) / (truth - 1.0) - 1.0); };
    std::vector<double> excesses;
    double largest = 35.0;
    for (const SphereCase& c : comparison.spheres) {
        excesses.insert(excesses.end(), {std::abs(c.bell - 1.0), std::abs(c.punch - 1.0)});
        largest = std::max(
            {largest, std::abs(error(c.model.estimate, c.bell)), std::abs(error(c.modelWithPunch.estimate, c.punch))});
    }
    SvgChart chart(1120, 400, ChartAxis::decades(excesses, "|k/k0 − 1| by the elements"),
                   {-largest, largest, false, "error of the estimate of k/k0 − 1 [%]"});
    chart.addHorizontalRule(30.0, "30 % too much");
    chart.addHorizontalRule(0.0, "");
    chart.addHorizontalRule(-30.0, "30 % too little");
    for (const SphereCase& c : comparison.spheres) {
        chart.add(markOf(std::abs(c.punch - 1.0), error(c.modelWithPunch.estimate, c.punch), kPunch, true,
                         nameOf(c) + ", punch, its own share: " + shortNumber(c.punch) + ", estimate " +
                             shortNumber(c.modelWithPunch.estimate)));
        chart.add(markOf(std::abs(c.bell - 1.0), error(c.model.estimate, c.bell), kBell, false,
                         nameOf(c) + ", bell: " + shortNumber(c.bell) + ", estimate " + shortNumber(c.model.estimate)));
    }
    return chart.svg("Error of the estimate against how much of a lump is felt");
}

} // namespace palpate::evaluation::felt
