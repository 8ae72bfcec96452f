// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/FeltComparison.h"
#include "report/FeltCharts.h"
#include "report/HtmlStyle.h"
#include "report/SvgChart.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/Numbers.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <utility>

namespace palpate::evaluation::felt {

namespace {

std::string number(const char* format, double value)
{
    if (std::isinf(value)) {
        return "∞";
    }
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string percent(double value)
{
    return number("%.1f %%", 100.0 * value);
}

std::string outOf(std::size_t n, std::size_t all)
{
    return std::to_string(n) + " of " + std::to_string(all);
}

std::string tableRow(std::initializer_list<std::string> cells, const char* tag)
{
    std::string out = "<tr>";
    for (const std::string& cell : cells) {
        out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
    }
    return out + "</tr>";
}

std::string verdictMark(bool isGood)
{
    return isGood ? "<span class='pass'>within</span>" : "<span class='fail'>outside</span>";
}

/// Text for results that are not required to be within the bounds.
std::string remark(bool isWithinBounds)
{
    return isWithinBounds ? "within" : "outside";
}

std::string layersTable(const Comparison& comparison)
{
    std::string out = "<table><thead>" +
                      tableRow({"thickness", "ratio", "exact, punch", "elements, punch", "error", "elements, bell",
                                "lower bound", "estimate", "upper bound", "bell", "punch"},
                               "th") +
                      "</thead><tbody>";
    for (const LayerCase& c : comparison.layers) {
        out += tableRow({shortNumber(c.thickness), ratioText(c.ratio), number("%.4f", c.exact), number("%.4f", c.punch),
                         number("%.3f %%", 100.0 * std::abs(c.punch / c.exact - 1.0)), number("%.4f", c.bell),
                         number("%.3f", c.model.low), number("%.3f", c.model.estimate), number("%.3f", c.model.high),
                         verdictMark(isWithin(c.model, c.bell)), remark(isWithin(c.model, c.punch))},
                        "td");
    }
    return out + "</tbody></table>";
}

std::string spheresTable(const Comparison& comparison)
{
    std::string out = "<table><thead>" +
                      tableRow({"radius", "cover", "ratio", "S", "lower<br>bound", "estimate", "upper<br>bound",
                                "elements,<br>bell", "", "error of<br>the excess", "elements,<br>punch", "",
                                "S under<br>the punch", "estimate<br>with it", "", "error of<br>the excess"},
                               "th") +
                      "</thead><tbody>";
    for (const SphereCase& c : comparison.spheres) {
        out += tableRow({shortNumber(c.sphereRadius), shortNumber(c.cover), ratioText(c.ratio), number("%.4f", c.share),
                         number("%.4f", c.model.low), number("%.4f", c.model.estimate), number("%.4f", c.model.high),
                         number("%.4f", c.bell), verdictMark(isWithin(c.model, c.bell)),
                         percent(excessError(c.model.estimate, c.bell)), number("%.4f", c.punch),
                         remark(isWithin(c.model, c.punch)), number("%.4f", c.shareOfPunch),
                         number("%.4f", c.modelWithPunch.estimate), verdictMark(isWithin(c.modelWithPunch, c.punch)),
                         percent(excessError(c.modelWithPunch.estimate, c.punch))},
                        "td");
    }
    return out + "</tbody></table>";
}

/// The estimate's formula with another weight between the bounds.
double weighted(double share, double ratio, double beta)
{
    const double rest = beta * (1.0 - share);
    return std::isinf(ratio) ? 1.0 + share / rest : 1.0 + share * (ratio - 1.0) / (1.0 + rest * (ratio - 1.0));
}

/// Table of the errors for other weights on the same cases.
std::string weightsTable(const Comparison& comparison)
{
    struct Weight
    {
        const char* name;
        double constant, byShare;
    };
    std::string out = "<table><thead>" +
                      tableRow({"β", "bell: largest", "median", "punch, its own share: largest", "median"}, "th") +
                      "</thead><tbody>";
    for (const Weight& w : {Weight{"2/5", 0.4, 0.0}, Weight{"0.53, the best constant under the bell", 0.53, 0.0},
                            Weight{"2/5 (1 + S), in use", buried::kBeta, buried::kBeta}}) {
        std::vector<double> bell, punch;
        for (const SphereCase& c : comparison.spheres) {
            bell.push_back(excessError(weighted(c.share, c.ratio, w.constant + w.byShare * c.share), c.bell));
            punch.push_back(
                excessError(weighted(c.shareOfPunch, c.ratio, w.constant + w.byShare * c.shareOfPunch), c.punch));
        }
        const Spread b = spreadOf(std::move(bell)), p = spreadOf(std::move(punch));
        out += tableRow({w.name, percent(b.largest), percent(b.median), percent(p.largest), percent(p.median)}, "td");
    }
    return out + "</tbody></table>";
}

std::string summary(const Comparison& comparison, const Verdict& v)
{
    const std::size_t n = comparison.spheres.size();
    const auto item = [](const std::string& text) { return "<li>" + text + "</li>"; };
    return "<div class='card advice" + std::string(v.isProved(n) ? "" : " warning") + "'><b>" +
           (v.isProved(n) ? "The bounds hold in every case in which they must"
                          : "Something that must hold does not: see below") +
           "</b><ul>" +
           item("Elements against the exact layer: " + number("%.2f %%", 100.0 * v.layerError) +
                " off at most (1 % is allowed); their share of a sphere against the formula: " +
                shortNumber(v.shareError) + " at most.") +
           item("Under the model's bell of pressure the bounds hold in " + outOf(v.bellWithin, n) +
                " cases; the estimate's error in the excess k/k0 − 1 is " + percent(v.bell.largest) + " at most, " +
                percent(v.bell.median) + " in the middle.") +
           item("Under a flat punch with its own share they hold in " + outOf(v.punchWithinOwn, n) + "; error " +
                percent(v.punchOwn.largest) + " at most, " + percent(v.punchOwn.median) + " in the middle.") +
           item("With the bell's share for a flat punch they hold in " + outOf(v.punchWithinBell, n) +
                ". They need not: a punch presses at its rim, the bell in its middle. Below less than a contact "
                "radius of cover a lump smaller than the contact depends on which it is.") +
           "</ul></div>";
}

std::string asFile(std::string svg)
{
    svg.insert(svg.find("<title>"),
               std::string("<style>") + kChartStyle + "</style><rect width='100%' height='100%' fill='#fff'/>");
    return svg + "\n";
}

std::string coverCharts(const Comparison& comparison)
{
    std::string out;
    for (const double ratio : ratiosOf(comparison)) {
        out += "<h3>Ratio " + ratioText(ratio) + "</h3><div class='cards small'>";
        for (const double radius : radiiOf(comparison)) {
            out += "<div class='card'><h3>radius " + shortNumber(radius) + "</h3>" +
                   coverChart(comparison, radius, ratio) + "</div>";
        }
        out += "</div>";
    }
    return out;
}

} // namespace

std::string html(const Comparison& comparison)
{
    const Verdict verdict = verdictOf(comparison);
    return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
           "content='width=device-width, initial-scale=1'><title>Palpate: what can be felt</title><style>" +
           std::string(kReportStyle) + kChartStyle +
           ".small{grid-template-columns:repeat(auto-fit,minmax(250px,1fr))}</style></head><body><main><h1>What can be "
           "felt of a buried lump</h1><p class='soft'>Bounds and estimate of the felt ratio k/k0, held against an "
           "exact "
           "layered solution and finite elements. Lengths are in radii of the contact; the ratio is the lump's modulus "
           "by the organ's; S is the share of the press's elastic energy inside the lump. " +
           std::to_string(comparison.spheres.size()) + " spheres and " + std::to_string(comparison.layers.size()) +
           " layers" + (comparison.isWhole ? "" : ", cancelled before the end") + ".</p>" +
           summary(comparison, verdict) +
           "<h2>Stiffness against cover</h2><p>Band: the bounds. Line: the estimate. "
           "<span style='color:#0b7a75'>●</span> elements under the bell. <span style='color:#c2542d'>◇</span> "
           "elements "
           "under a flat punch. The upper bound of a rigid lump is infinite.</p>" +
           coverCharts(comparison) + "<h2>Estimate against elements</h2><div class='card'>" +
           estimateChart(comparison) +
           "</div><p>● bell; ◇ flat punch, the estimate with the punch's own share.</p><h2>The estimate's weight</h2>"
           "<div class='card'>" +
           weightsTable(comparison) +
           "</div><p>Estimate: k/k0 = 1 + S (ρ − 1) / (1 + β (1 − S)(ρ − 1)); β = 1 and β = 0 are the bounds. 2/5 is "
           "exact "
           "for a small, deep sphere (Eshelby 1957).</p><h2>Layers</h2><div class='card' style='overflow-x:auto'>" +
           layersTable(comparison) + "</div><h2>Spheres</h2><div class='card' style='overflow-x:auto'>" +
           spheresTable(comparison) + "</div><p class='small soft'>Elements: up to " +
           std::to_string(comparison.elements) + " in a case, Q2–P1; without a lump their stiffness is at most " +
           number("%.2f %%", 100.0 * comparison.farError) + " off. " + shortNumber(comparison.duration_s) +
           " s.</p></main></body></html>\n";
}

std::string csv(const Comparison& comparison)
{
    std::string out = "kind,sphere_radius,cover,ratio,share,share_bell_elements,share_punch_elements,low,estimate,high,"
                      "bell_elements,punch_elements,punch_exact,bell_within,punch_within,own_low,own_estimate,"
                      "own_high,punch_within_own\n";
    const auto add = [&out](std::initializer_list<double> values) {
        for (const double v : values) {
            out += ',';
            if (!std::isnan(v)) {
                core::appendNumber(out, v);
            }
        }
        out += '\n';
    };
    const double none = std::nan("");
    for (const LayerCase& c : comparison.layers) {
        out += "layer";
        add({none, c.thickness, c.ratio, buried::shareBelow(c.thickness, 1.0), none, none, c.model.low,
             c.model.estimate, c.model.high, c.bell, c.punch, c.exact, isWithin(c.model, c.bell) ? 1.0 : 0.0,
             isWithin(c.model, c.punch) ? 1.0 : 0.0, none, none, none, none});
    }
    for (const SphereCase& c : comparison.spheres) {
        out += "sphere";
        add({c.sphereRadius, c.cover, c.ratio, c.share, c.shareOfBell, c.shareOfPunch, c.model.low, c.model.estimate,
             c.model.high, c.bell, c.punch, none, isWithin(c.model, c.bell) ? 1.0 : 0.0,
             isWithin(c.model, c.punch) ? 1.0 : 0.0, c.modelWithPunch.low, c.modelWithPunch.estimate,
             c.modelWithPunch.high, isWithin(c.modelWithPunch, c.punch) ? 1.0 : 0.0});
    }
    return out;
}

core::Status writeReport(const std::filesystem::path& folder, const Comparison& comparison)
{
    const std::pair<const char*, std::string> files[]{{"felt.csv", csv(comparison)},
                                                      {"felt-cover.svg", asFile(coverChart(comparison, 2.0, 4.4))},
                                                      {"felt-estimate.svg", asFile(estimateChart(comparison))},
                                                      {"felt.html", html(comparison)}};
    for (const auto& [name, content] : files) {
        if (core::Status status = core::writeAtomically(folder / name, content); !status.isOk()) {
            return status;
        }
    }
    return {};
}

} // namespace palpate::evaluation::felt
