// SPDX-License-Identifier: BSD-3-Clause
#include "report/ReportCharts.h"

#include "report/Advice.h"
#include "report/SvgChart.h"

#include <palpate/core/Text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace palpate::evaluation {

namespace {

constexpr double kBudget_us = 1000.0;
constexpr double kFloor_mm = 1e-12; // plotted position of an error of exactly 0

MarkShape shapeOf(const Trial& t)
{
    switch (t.knob) {
    case Knob::Solver:
        return MarkShape::Circle;
    case Knob::Decimated:
        return MarkShape::Square;
    case Knob::OnePass:
        return MarkShape::Diamond;
    case Knob::Rate:
        return MarkShape::Triangle;
    case Knob::Radius:
        return MarkShape::Circle;
    }
    return MarkShape::Circle;
}

std::string labelOf(const Trial& t)
{
    switch (t.knob) {
    case Knob::Solver:
        return t.solver + (2 * t.ticks < t.wanted ? ", " + core::grouped(t.ticks) + " ticks only" : "");
    case Knob::Decimated:
        return shortNumber(100.0 * t.variationValue) + " %";
    case Knob::OnePass:
        return "one pass";
    case Knob::Rate:
        return t.rate_Hz < 1000.0 ? shortNumber(t.rate_Hz) + " Hz" : shortNumber(t.rate_Hz / 1000.0) + " kHz";
    case Knob::Radius:
        return t.setting;
    }
    return {};
}

} // namespace

std::string colourOf(const std::string& solver)
{
    static const std::map<std::string, std::string, std::less<>> kColours{{"Palpate", "#0b7a75"},
                                                                          {"VTK static cell locator", "#c2542d"},
                                                                          {"Embree", "#7457a6"},
                                                                          {"paper (brute force)", "#39424e"},
                                                                          {"vector field, nearest", "#a87b00"},
                                                                          {"vector field, sum", "#8f5f00"}};
    const auto found = kColours.find(solver);
    return found != kColours.end() ? found->second : "#6b7480";
}

std::string speedAgainstErrorChart(const Evaluation& evaluation, const std::string& subject)
{
    std::vector<double> times{0.12, 2.0 * kBudget_us}, errors;
    std::vector<const Trial*> shown;
    double spring_mm = 0.0;
    if (!evaluation.paperBody.empty()) {
        shown.push_back(&evaluation.paperBody.front()); // the paper's solver as the starting point
    }
    for (const Trial& t : evaluation.trials) {
        if (t.subject == subject && !t.isReference) {
            shown.push_back(&t);
            spring_mm = t.knob == Knob::Solver && t.solver == "Palpate" ? t.spring_mm : spring_mm;
        }
    }
    std::erase_if(shown, [](const Trial* t) { return t->position_mm.count == 0 || t->time_us.count == 0; });
    for (const Trial* t : shown) {
        times.insert(times.end(), {t->pathTime_us.median, tailOf(t->time_us).value});
        for (const double v : t->pathPosition_mm.values) {
            errors.push_back(std::max(kFloor_mm, v));
        }
    }
    const double jnd_mm = spring_mm * kForceJnd_percent / 100.0;
    if (jnd_mm > 0.0) {
        errors.insert(errors.end(), {jnd_mm, 0.1 * jnd_mm});
    }
    const ChartAxis x = ChartAxis::decades(
        times, "time per tick in contact [µs]: median of the paths, whisker to the slowest ticks (right)");
    const ChartAxis y =
        ChartAxis::decades(errors, "mean position error [mm]: median of the paths, whisker another path");
    SvgChart chart(1120, 500, x, y);
    if (jnd_mm > 0.0) {
        chart.addBand(y.low, 0.1 * jnd_mm, "#eef7f4");
        chart.addHorizontalRule(jnd_mm, "7 % of the force: what a hand can tell");
        chart.addHorizontalRule(0.1 * jnd_mm, "a tenth of that: aim below");
    }
    chart.addVerticalRule(kBudget_us, "1 ms: the whole tick");
    std::vector<std::array<double, 2>> front;
    for (const Trial* t : shown) {
        if (t->isParetoOptimal) {
            front.push_back({t->pathTime_us.median, std::max(kFloor_mm, t->pathPosition_mm.median)});
        }
    }
    std::sort(front.begin(), front.end());
    chart.addLine(front, "#0b7a75", 1.6, true);
    for (const Trial* t : shown) {
        const Tail tail = tailOf(t->time_us);
        const bool isPaperBody = t->subject != subject;
        SvgChart::Mark mark;
        mark.x = t->pathTime_us.median;
        mark.xLow = t->pathTime_us.low;
        mark.xEnd = std::max(tail.value, t->pathTime_us.high);
        mark.y = std::max(kFloor_mm, t->pathPosition_mm.median);
        mark.yLow = std::max(kFloor_mm, t->pathPosition_mm.low);
        mark.yEnd = t->pathPosition_mm.high;
        mark.shape = shapeOf(*t);
        mark.colour = colourOf(t->solver);
        mark.isHollow = isPaperBody || t->knob == Knob::Rate || t->knob == Knob::Radius;
        mark.isStrong = t->knob == Knob::Solver && t->solver == "Palpate";
        mark.label = isPaperBody ? "paper, its " + core::grouped(t->triangles) + " triangles" : labelOf(*t);
        mark.tooltip = (isPaperBody ? mark.label : t->solver + (t->setting.empty() ? "" : ", " + t->setting)) + ": " +
                       shortNumber(t->pathTime_us.median) + " µs median, " + shortNumber(tail.value) + " µs " +
                       tail.name + "; mean error " + shortNumber(t->pathPosition_mm.median) + " mm, another path " +
                       shortNumber(t->pathPosition_mm.low) + " to " + shortNumber(t->pathPosition_mm.high) +
                       " mm; most of a tick " + shortNumber(t->position_mm.max) + " mm";
        chart.add(mark);
    }
    return chart.svg("Time per tick against position error on " + subject);
}

std::string cornerChart(const Evaluation& evaluation)
{
    std::vector<std::array<double, 2>> field, god;
    for (const CornerForce& c : evaluation.corners) {
        field.push_back({c.angle_deg, c.vectorField});
        god.push_back({c.angle_deg, c.godObject});
    }
    SvgChart chart(560, 380, ChartAxis::linear({180.0}, "angle between the surfaces [°]"),
                   ChartAxis::linear({2.0}, "force over the right force"));
    chart.addHorizontalRule(1.0, "right");
    chart.addLine(field, colourOf("vector field, sum"), 2.2, false, "vector field, sum");
    chart.addLine(god, colourOf("Palpate"), 2.2, false, "Palpate");
    return chart.svg("Force in the corner of two surfaces over the angle between them");
}

std::string costBySizeChart(const Evaluation& evaluation)
{
    std::vector<double> sizes, times;
    std::map<std::string, std::vector<const SizePoint*>> bySolver;
    for (const SizePoint& p : evaluation.sizes) {
        sizes.push_back(static_cast<double>(p.triangles));
        times.insert(times.end(), {p.time_us.p50, tailOf(p.time_us).value});
        bySolver[p.solver].push_back(&p);
    }
    SvgChart chart(560, 380, ChartAxis::decades(sizes, "triangles"), ChartAxis::decades(times, "time per tick [µs]"));
    for (const auto& [solver, points] : bySolver) {
        std::vector<std::array<double, 2>> median, tail;
        for (const SizePoint* p : points) {
            median.push_back({static_cast<double>(p->triangles), p->time_us.p50});
            tail.push_back({static_cast<double>(p->triangles), tailOf(p->time_us).value});
        }
        chart.addLine(tail, colourOf(solver), 1.0, true);
        chart.addLine(median, colourOf(solver), 2.2);
        for (const SizePoint* p : points) {
            SvgChart::Mark mark;
            mark.x = static_cast<double>(p->triangles);
            mark.y = p->time_us.p50;
            mark.colour = colourOf(solver);
            mark.label = p == points.back() ? solver : "";
            mark.tooltip = solver + ", " + std::to_string(p->triangles) + " triangles: " + shortNumber(p->time_us.p50) +
                           " µs median over " + std::to_string(p->ticks) + " ticks";
            chart.add(mark);
        }
    }
    return chart.svg("Cost of a tick by mesh size");
}

std::string errorOverTimeChart(const Evaluation& evaluation, const std::string& subject)
{
    constexpr std::size_t kColumns = 240;
    std::vector<double> times, errors;
    for (const ErrorSeries& s : evaluation.series) {
        if (s.subject == subject && !s.time_s.empty()) {
            times.push_back(s.time_s.back());
            errors.push_back(std::max(kFloor_mm, *std::max_element(s.error_mm.begin(), s.error_mm.end())));
            errors.push_back(std::max(kFloor_mm, s.error_mm[s.error_mm.size() / 2]));
        }
    }
    const ChartAxis x = ChartAxis::linear(times, "time [s]");
    SvgChart chart(560, 380, x, ChartAxis::decades(errors, "position error [mm]"));
    for (const ErrorSeries& s : evaluation.series) {
        if (s.subject != subject || s.time_s.empty()) {
            continue;
        }
        // Keep the largest error per column, so that thinning does not hide peaks.
        std::map<std::size_t, double> worst;
        for (std::size_t i = 0; i < s.time_s.size(); ++i) {
            double& w = worst[static_cast<std::size_t>(x.share(s.time_s[i]) * kColumns)];
            w = std::max({w, s.error_mm[i], kFloor_mm});
        }
        std::vector<std::array<double, 2>> points;
        for (const auto& [column, error] : worst) {
            points.push_back({x.high * static_cast<double>(column) / kColumns, error});
        }
        chart.addLine(points, colourOf(s.solver), s.solver == "Palpate" ? 2.4 : 1.3, false, s.solver);
    }
    return chart.svg("Error over time on " + subject);
}

std::string iterationsChart(const Evaluation& evaluation)
{
    std::vector<double> counts;
    for (const Trial& t : evaluation.trials) {
        if (t.solver == "Palpate" && t.knob == Knob::Solver) {
            counts.resize(std::max(counts.size(), t.iterations.size()));
            for (std::size_t i = 0; i < t.iterations.size(); ++i) {
                counts[i] += static_cast<double>(t.iterations[i]);
            }
        }
    }
    const bool isCut = !counts.empty() && counts.back() > 0.0;
    while (counts.size() > 9 && counts.back() == 0.0) {
        counts.pop_back();
    }
    counts.push_back(1.0);
    const ChartAxis y = ChartAxis::decades(counts, "ticks");
    counts.pop_back();
    SvgChart chart(560, 380,
                   {-0.5, static_cast<double>(counts.size()) - 0.5, false,
                    std::string("moves tried in a tick") + (isCut ? ", 32 and more in one bar" : "")},
                   y);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0.0) {
            const auto at = static_cast<double>(i);
            chart.addBar(at - 0.5, at + 0.5, counts[i], "#0b7a75",
                         std::to_string(i) + " moves: " + shortNumber(counts[i]) + " ticks");
        }
    }
    return chart.svg("Histogram of the product's iterations");
}

} // namespace palpate::evaluation
