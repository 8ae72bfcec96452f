// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Stability.h"
#include "report/HtmlStyle.h"
#include "report/SvgChart.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/CsvCell.h>
#include <palpate/core/Numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::evaluation::stability {

namespace {

constexpr const char* kWith = "#0b7a75";
constexpr const char* kWithout = "#c2542d";
constexpr const char* kBound = "#39424e";
constexpr const char* kWindow = "#7457a6";

std::string heldText(double stiffness_N_per_mm)
{
    if (stiffness_N_per_mm >= kStiffest_N_per_mm) {
        return "≥ " + shortNumber(kStiffest_N_per_mm);
    }
    return stiffness_N_per_mm > 0.0 ? shortNumber(stiffness_N_per_mm) : "&lt; 0.05";
}

std::string row(const std::vector<std::string>& cells, const char* tag)
{
    std::string out = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        out += std::string("<") + tag + (i < 2 ? " class='left'>" : ">") + cells[i] + "</" + tag + ">";
    }
    return out + "</tr>";
}

std::string table(const Result& result)
{
    std::string out = "<table><thead>" +
                      row({"Device", "Shape", "stated<br>[N/mm]", "held without<br>controller",
                           "held with<br>controller", "at rest at the<br>stated [mm]", "",
                           "force error [%]<br>stated, mean", "<br>99 %", "0.3 N/mm<br>mean", "<br>99 %"},
                          "th") +
                      "</thead><tbody>";
    for (const Row& r : result.rows) {
        out += row({escaped(r.device), escaped(r.shape), shortNumber(r.stated_N_per_mm), heldText(r.without_N_per_mm),
                    heldText(r.with_N_per_mm), shortNumber(r.restless_mm),
                    !std::isfinite(r.restless_mm) ? "<span class='fail'>no touch</span>"
                    : r.isHeld()                  ? "<span class='pass'>held</span>"
                                                  : "<span class='fail'>not held</span>",
                    shortNumber(r.cost.mean_percent), shortNumber(r.cost.p99_percent),
                    shortNumber(r.costSoft.mean_percent), shortNumber(r.costSoft.p99_percent)},
                   "td");
    }
    return out + "</tbody></table>";
}

void addCurve(SvgChart& chart, const Sweep& sweep, double SweepPoint::*value, const char* colour, bool isDashed,
              const std::string& label, double low)
{
    std::vector<std::array<double, 2>> points;
    for (const SweepPoint& p : sweep.points) {
        if (p.*value > 0.0) {
            points.push_back({p.x, std::max(low, p.*value)});
        }
        if (!isDashed) {
            SvgChart::Mark mark;
            mark.x = p.x;
            mark.y = std::max(low, p.*value);
            mark.colour = colour;
            mark.tooltip = label + ", " + shortNumber(p.x) + " " + sweep.unit + ": " + shortNumber(p.*value) + " N/mm";
            chart.add(mark);
        }
    }
    chart.addLine(points, colour, isDashed ? 1.6 : 2.0, isDashed, label);
}

std::string chartOf(const Sweep& sweep)
{
    std::vector<double> xs, ys;
    for (const SweepPoint& p : sweep.points) {
        xs.push_back(p.x);
        for (const double y : {p.with_N_per_mm, p.without_N_per_mm, p.passive_N_per_mm, p.held_N_per_mm}) {
            if (y > 0.0) {
                ys.push_back(y);
            }
        }
    }
    const bool isRate = sweep.what == "rate";
    const std::string title = sweep.what + " [" + sweep.unit + "]";
    const ChartAxis x = isRate ? ChartAxis::decades(xs, title) : ChartAxis::linear(xs, title);
    const ChartAxis y = ChartAxis::decades(ys, "stiffness held on a wall [N/mm]");
    SvgChart chart(560, 360, x, y);
    addCurve(chart, sweep, &SweepPoint::passive_N_per_mm, kBound, true, "b > K T/2 + |B|", y.low);
    addCurve(chart, sweep, &SweepPoint::held_N_per_mm, kWindow, true, "the window allows", y.low);
    addCurve(chart, sweep, &SweepPoint::without_N_per_mm, kWithout, false, "without controller", y.low);
    addCurve(chart, sweep, &SweepPoint::with_N_per_mm, kWith, false, "with controller", y.low);
    return "<div class='card'><h3>" + escaped(sweep.device + ": " + sweep.what) + "</h3>" +
           chart.svg("Held stiffness against " + sweep.what + ", " + sweep.device) + "</div>";
}

} // namespace

std::string html(const Result& result)
{
    std::size_t held = 0;
    for (const Row& r : result.rows) {
        held += r.isHeld() ? 1 : 0;
    }
    std::string charts;
    for (const Sweep& sweep : result.sweeps) {
        charts += chartOf(sweep);
    }
    std::string out = "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
                      "content='width=device-width, initial-scale=1'><title>Palpate: stability</title><style>" +
                      std::string(kReportStyle) + kChartStyle +
                      "</style></head><body><main><h1>Stability</h1><p class='soft'>" + escaped(result.subject) + ", " +
                      shortNumber(result.rate_Hz) + " Hz, a force acts " + std::to_string(result.delayTicks) +
                      " tick late. Device and hand are simulated, in virtual time; the servo's own tick closes the "
                      "loop. Held: no motion of " +
                      shortNumber(kLimitCycle_mm) +
                      " mm or more between 1 s and 1.5 s after the hand rests, for two grips and two speeds of "
                      "approach.</p><h2>The stated stiffness is held in " +
                      std::to_string(held) + " of " + std::to_string(result.rows.size()) +
                      " cases</h2><div class='card' style='overflow-x:auto'>" + table(result) + "</div>";
    if (!charts.empty()) {
        out += "<h2>What decides it</h2><div class='pair'>" + charts + "</div>";
    }
    out += "<p class='small soft'>b > K T/2 + |B|: Colgate &amp; Schenkel 1997, the bound for every hand; a hand's own "
           "damping and the device's friction hold more. Controller: time-domain passivity, Hannaford &amp; Ryu 2002. "
           "Force error: what the controller adds, in percent of the force, while pressing and sliding at 100 mm/s. " +
           shortNumber(result.duration_s) + " s.</p></main></body></html>\n";
    return out;
}

std::string csv(const Result& result)
{
    std::string out = "device,shape,rate_hz,delay_ticks,stated_n_per_mm,held_without_n_per_mm,held_with_n_per_mm,"
                      "restless_mm,force_error_mean_percent,force_error_p99_percent,soft_error_mean_percent,"
                      "soft_error_p99_percent\n";
    const auto add = [&out](std::initializer_list<double> values) {
        for (const double v : values) {
            out += ',';
            core::appendNumber(out, v);
        }
        out += '\n';
    };
    for (const Row& r : result.rows) {
        out += core::csvCell(r.device) + ',' + core::csvCell(r.shape);
        add({result.rate_Hz, static_cast<double>(result.delayTicks), r.stated_N_per_mm, r.without_N_per_mm,
             r.with_N_per_mm, r.restless_mm, r.cost.mean_percent, r.cost.p99_percent, r.costSoft.mean_percent,
             r.costSoft.p99_percent});
    }
    out += "\ndevice,against,unit,x,held_without_n_per_mm,held_with_n_per_mm,passive_n_per_mm,window_n_per_mm\n";
    for (const Sweep& s : result.sweeps) {
        for (const SweepPoint& p : s.points) {
            out += core::csvCell(s.device) + ',' + core::csvCell(s.what) + ',' + core::csvCell(s.unit);
            add({p.x, p.without_N_per_mm, p.with_N_per_mm, p.passive_N_per_mm, p.held_N_per_mm});
        }
    }
    return out;
}

core::Status writeReport(const std::filesystem::path& folder, const Result& result)
{
    const std::vector<std::filesystem::path> files = reportFiles(folder);
    std::size_t next = 0;
    for (const auto make : {csv, html}) {
        if (core::Status status = core::writeAtomically(files[next++], make(result)); !status.isOk()) {
            return status;
        }
    }
    return {};
}

std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder)
{
    return {folder / "stability.csv", folder / "stability.html"};
}

} // namespace palpate::evaluation::stability
