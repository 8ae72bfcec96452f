// SPDX-License-Identifier: BSD-3-Clause
#include "Advice.h"
#include "HtmlStyle.h"
#include "ReportCharts.h"
#include "SvgChart.h"
#include "palpate/evaluation/LagrangeElimination.h"
#include "palpate/evaluation/Report.h"

#include <palpate/core/Text.h>

#include <algorithm>
#include <map>

namespace palpate::evaluation {

namespace {

std::string tag(const std::string& name, const std::string& content, const std::string& attributes = "")
{
    return "<" + name + (attributes.empty() ? "" : " " + attributes) + ">" + content + "</" + name + ">";
}

std::string cell(const std::string& content, bool isLeft = false)
{
    return tag("td", content, isLeft ? "class='left'" : "");
}

std::string head(const std::vector<std::string>& titles)
{
    std::string row;
    for (const std::string& t : titles) {
        row += tag("th", t);
    }
    return tag("thead", tag("tr", row));
}

std::string number(double value)
{
    return shortNumber(value);
}

std::string card(const std::string& title, const std::string& content)
{
    return "<div class='card'>" + tag("h3", escaped(title)) + content + "</div>";
}

std::string trialTable(const Evaluation& evaluation, const std::string& subject)
{
    std::string rows;
    for (const Trial& t : evaluation.trials) {
        if (t.subject != subject) {
            continue;
        }
        const bool isSampled = t.ticks + 200 < t.wanted;
        std::string row = cell(escaped(t.solver + (t.setting.empty() ? "" : ", " + t.setting)), true) +
                          cell(core::grouped(t.triangles)) + cell(t.time_us.count > 0 ? number(t.time_us.p50) : "–") +
                          cell(t.time_us.count > 0 ? number(t.time_us.p999) : "–") +
                          cell(t.time_us.count > 0 ? number(t.time_us.max) : "–") +
                          cell(t.freeTime_us.count > 0 ? number(t.freeTime_us.p50) : "–");
        if (t.isReference) {
            row += "<td colspan='6' class='left soft'>the truth: what the others are compared with</td>";
        } else if (t.position_mm.count == 0) {
            row += "<td colspan='6' class='left soft'>did not touch</td>";
        } else {
            row += cell(number(t.position_mm.mean)) + cell(number(t.position_mm.p99)) +
                   cell(number(t.forcePercent.p99)) + cell(number(t.direction_deg.p99)) +
                   cell(t.residual_mm.count > 0 ? number(t.residual_mm.max) : "–") +
                   cell(t.popThroughs > 0 ? "<span class='fail'>" + std::to_string(t.popThroughs) + "</span>" : "0");
        }
        row += cell(t.isReference ? "" : std::to_string(t.otherMinimum)) +
               cell(t.isReference ? "" : std::to_string(t.interrupted)) +
               cell(core::grouped(t.ticks) + (isSampled ? " of " + core::grouped(t.wanted) : ""));
        rows += tag("tr", row, t.knob == Knob::Solver && t.solver == "Palpate" ? "class='strong'" : "");
    }
    return tag("table",
               head({"Solver", "triangles", "time [µs]<br>median", "<br>99.9 %", "<br>worst", "<br>in free<br>space",
                     "error [mm]<br>mean", "<br>99 %", "force error<br>[%], 99 %", "direction<br>[°], 99 %",
                     "residual<br>[mm], max", "pop-<br>throughs", "other<br>minimum", "inter-<br>rupted", "ticks"}) +
                   tag("tbody", rows));
}

std::string hardCaseSection(const Evaluation& evaluation)
{
    if (evaluation.hardCases.empty()) {
        return "";
    }
    std::vector<const HardCaseResult*> order;
    std::size_t passed = 0;
    for (const HardCaseResult& r : evaluation.hardCases) {
        order.push_back(&r);
        passed += r.passed() ? 1 : 0;
    }
    std::stable_sort(order.begin(), order.end(), [](auto a, auto b) { return a->passed() < b->passed(); });
    std::string rows;
    for (const HardCaseResult* r : order) {
        std::string name = escaped(r->name), figures;
        for (const HardCaseFigure& f : r->figures) {
            if (!f.passed()) {
                name += "<br><span class='small soft'>" + escaped(f.what) + ": " + number(f.measured) + ", bound " +
                        number(f.bound) + ", first or worst at tick " + std::to_string(f.worstTick) + "</span>";
            }
        }
        for (const char* what : {"pop-throughs", "residual", "spring", "jump", "most iterations"}) {
            const auto f = std::find_if(r->figures.begin(), r->figures.end(),
                                        [what](const HardCaseFigure& g) { return g.what.starts_with(what); });
            figures += cell(f == r->figures.end() ? "" : number(f->measured));
        }
        rows += tag("tr", "<td class='left case'>" + name + "</td>" +
                              cell(r->passed() ? "<span class='pass'>pass</span>" : "<span class='fail'>FAIL</span>") +
                              figures + cell(core::grouped(r->triangles)) +
                              cell(core::grouped(static_cast<std::size_t>(r->ticks))));
    }
    return tag("h2", "Hard cases: " + std::to_string(passed) + " of " + std::to_string(order.size()) + " pass") +
           "<p class='soft'>Each requires as well: nothing non-finite, bad input without effect, every tick converged, "
           "at "
           "rest elsewhere than the exact solver in at most 0.1 % of the ticks (with a ball 1 %). Lengths of scaled "
           "scenes have scaled "
           "bounds.</p><div class='card'>" +
           tag("table", head({"Case", "", "pop-<br>throughs<br>= 0", "residual<br>[mm]<br>≤ 10⁻⁶",
                              "spring beyond<br>the exact [mm]<br>≤ 10⁻³", "jump beyond<br>the exact [mm]<br>≤ 10⁻³",
                              "most moves<br>in a tick<br>&lt; 512", "triangles", "ticks"}) +
                            tag("tbody", rows)) +
           "</div>";
}

/// Each stiffness once, with the structures that have it where there are few.
std::string tissuesOf(const SubjectInfo& subject)
{
    std::map<double, std::vector<std::string>> byStiffness;
    for (const SubjectStructure& s : subject.structures) {
        byStiffness[s.stiffness_N_per_mm].push_back(escaped(s.name));
    }
    std::string text;
    for (const auto& [stiffness, names] : byStiffness) {
        text += (text.empty() ? "" : "<br>") + number(stiffness) +
                " N/mm: " + (names.size() <= 3 ? names.front() : std::to_string(names.size()) + " structures");
        for (std::size_t i = 1; names.size() <= 3 && i < names.size(); ++i) {
            text += ", " + names[i];
        }
    }
    return text + (subject.layers > 1 ? "<br>" + std::to_string(subject.layers) + " layers" : "");
}

std::string methodSection(const Evaluation& evaluation)
{
    const VectorFieldFigures& v = evaluation.vectorField;
    std::string operations;
    for (std::size_t k = 0; k < 3; ++k) {
        operations += (k > 0 ? ", " : "") + std::to_string(evaluation.eliminationOperations[k]) +
                      " (paper: " + std::to_string(kPaperOperations[k]) + ")";
    }
    std::string hashes;
    for (const SubjectInfo& s : evaluation.subjects) {
        hashes += tag("tr", cell(escaped(s.name), true) + cell(tissuesOf(s), true) + cell(core::grouped(s.triangles)) +
                                cell(number(s.extent_mm)) + cell(number(static_cast<double>(s.bytes) / 1e6)) +
                                cell(number(static_cast<double>(s.bytes) / static_cast<double>(s.triangles))) +
                                cell(number(s.build_ms)) + cell("<code>" + s.hash + "</code>", true));
    }
    std::string motions;
    for (const std::string& m : evaluation.motions) {
        motions += (motions.empty() ? "" : ", ") + escaped(m);
    }
    return tag("h2", "What the vector field costs, and the paper's sums") + "<div class='card'><p>A plate of " +
           number(v.plate_mm) + " mm pushes the hand out on its far side from a depth of " +
           number(v.popThroughDepth_mm) + " mm on. In the middle of a cube of 20 mm the force jumps by " +
           number(v.jumpAtTheMiddle_N) + " N at 1 N/mm. Where two boxes overlap the summed stiffness is " +
           number(v.stiffnessOverlapped) + " N/mm instead of " + number(v.stiffnessAlone) +
           ". A god-object has none of these.</p><p>Multiplications and divisions to eliminate the system of 1, 2 and "
           "3 "
           "planes: " +
           operations + ".</p></div>" + tag("h2", "How it was measured") +
           "<div class='card small'><p>Motions: " + motions +
           ". Position error: distance to the god-object of the exact solver (long double, every side decided exactly, "
           "brute force, four steps a tick) at the same tick, while either touches; with several layers the largest of "
           "them. Force: the layers' springs together, each with the stiffness of the tissue that the exact "
           "god-object touches; percentages and directions where the exact force is at least 2 % of its largest. "
           "Residual: how much "
           "nearer to "
           "the "
           "HIP legal moves could still bring the god-object. Other minimum: ticks in which it rests legally elsewhere "
           "than the exact one, after two ways parted; they are not errors and left out of them. Rates: the force is "
           "held between ticks, and the error is taken just before the next one. Balls: a fingertip of that radius, "
           "compared with the exact ball; nearer than its radius to what it faces counts as a pop-through. Copies with "
           "fewer triangles choose "
           "their "
           "own ways at ridges: that is in their last hundredth. Brute-force solvers get through fewer ticks in their "
           "time: "
           "the column says how many. Times are of the solver's step alone, by the monotonic clock, in contact unless "
           "said otherwise; ticks in which another program took the core are counted apart (interrupted).</p>" +
           tag("table", head({"Scene", "stiffness", "triangles", "extent [mm]", "haptic copy [MB]", "bytes a triangle",
                              "index [ms]", "SHA-256"}) +
                            tag("tbody", hashes)) +
           "<p class='soft'>" + escaped(evaluation.machine.cpu) + ", " + std::to_string(evaluation.machine.cores) +
           " cores, load " + number(evaluation.machine.load) + "; " + escaped(evaluation.machine.compiler) +
           "; build " + escaped(evaluation.machine.build) + "; seed " + std::to_string(evaluation.seed) + "; " +
           escaped(evaluation.machine.startedUtc) + ", " + number(evaluation.duration_s) + " s" +
           (evaluation.isQuick ? ", quick run" : "") + ". The same numbers: results.csv, results.json.</p></div>";
}

/// The product against what others would write, with what is wanted of it.
std::string ratioCard(const Evaluation& evaluation)
{
    if (evaluation.ratios.empty()) {
        return "";
    }
    std::string rows;
    for (const Ratio& r : evaluation.ratios) {
        const char* style = r.wanted <= 0.0 ? "" : r.times >= r.wanted ? "class='good'" : "class='missed'";
        rows += tag("tr", cell(core::grouped(r.triangles)) + cell(escaped(r.solver), true) +
                              cell(tag("span", number(r.times) + " ×", style)) +
                              cell(r.wanted > 0.0 ? "≥ " + number(r.wanted) + " ×" : ""));
    }
    return card("Median time of a tick over Palpate's (spheres, in turns)",
                tag("table", head({"triangles", "", "takes", "wanted"}) + tag("tbody", rows)));
}

/// What friction, a law and a map add to a tick.
std::string tissueCard(const Evaluation& evaluation)
{
    std::string rows;
    for (const SizePoint& p : evaluation.tissues) {
        rows += tag("tr", cell(escaped(p.solver), true) + cell(number(p.time_us.p50)) + cell(number(p.time_us.p99)));
    }
    return rows.empty() ? ""
                        : card("What tissue costs (sphere of " + core::grouped(evaluation.tissues.front().triangles) +
                                   " triangles, in turns)",
                               tag("table", head({"", "µs, median", "99 %"}) + tag("tbody", rows)));
}

std::string notes(const Evaluation& evaluation)
{
    std::string text;
    if (evaluation.machine.load > evaluation.machine.cores) {
        text += "<p class='soft small'>The machine was busy (load " + number(evaluation.machine.load) + " on " +
                std::to_string(evaluation.machine.cores) +
                " cores): ticks in which another program "
                "took the core are left out of the times, those slowed by cold caches are not.</p>";
    }
    if (!evaluation.leftOut.empty()) {
        std::string list;
        for (const std::string& line : evaluation.leftOut) {
            list += (list.empty() ? "" : "; ") + escaped(line);
        }
        text += "<p class='soft small'>Left out: " + list + ".</p>";
    }
    return text;
}

std::string legend()
{
    return "<p class='legend small soft'><span>● solver</span><span>■ Palpate on fewer triangles</span>"
           "<span>○ Palpate with a ball as fingertip, against the exact ball</span>"
           "<span>◆ one pass a tick, as in the paper</span><span>△ error just before the next tick, the force "
           "held</span><span>‐ ‐ nothing without pop-through is both faster and nearer</span></p>";
}

} // namespace

std::string chartSvg(const Evaluation& evaluation)
{
    if (evaluation.subjects.empty()) {
        return "<svg xmlns='http://www.w3.org/2000/svg'/>\n";
    }
    std::string svg = speedAgainstErrorChart(evaluation, evaluation.subjects.front().name);
    svg.insert(svg.find("<title>"),
               std::string("<style>") + kChartStyle + "</style><rect width='100%' height='100%' fill='#fff'/>");
    return svg + "\n";
}

std::string reportHtml(const Evaluation& evaluation)
{
    std::string advice;
    for (const Advice& a : evaluation.advice) {
        std::string why;
        for (const std::string& line : a.why) {
            why += tag("li", escaped(line));
        }
        if (!a.warning.empty()) {
            advice += "<div class='card warning'>" + escaped(a.warning) + "</div>";
        }
        advice += "<div class='card advice'><span class='soft small'>" + escaped(a.subject) + ": use</span><br><b>" +
                  escaped(a.setting) + "</b>" + tag("ul", why) + "</div>";
    }
    std::string body = tag("h1", "Speed against error") +
                       "<p class='soft'>What a servo tick costs and how far off the "
                       "god-object is, solver by solver, knob by knob." +
                       (evaluation.isCancelled ? " <b>Cancelled: not all was measured.</b>" : "") + "</p>";
    body += advice + notes(evaluation);
    for (const SubjectInfo& s : evaluation.subjects) {
        body += card(s.name + ", " + core::grouped(s.triangles) + " triangles",
                     speedAgainstErrorChart(evaluation, s.name) + legend());
        body += "<details" + std::string(evaluation.subjects.size() == 1 ? " open" : "") + "><summary>All figures of " +
                escaped(s.name) + "</summary><div class='card' style='overflow-x:auto'>" +
                trialTable(evaluation, s.name) + "</div></details>";
    }
    body += tag("h2", "Size, time and iterations") + "<div class='pair'>";
    if (!evaluation.sizes.empty()) {
        body += card("Cost by mesh size (spheres; dashed: 99.9 %)", costBySizeChart(evaluation));
    }
    body +=
        ratioCard(evaluation) + tissueCard(evaluation) + card("Palpate's moves in a tick", iterationsChart(evaluation));
    for (const SubjectInfo& s : evaluation.subjects) {
        body +=
            card("Error over time, " + (evaluation.motions.empty() ? "" : evaluation.motions.front()) + ": " + s.name,
                 errorOverTimeChart(evaluation, s.name));
    }
    body += "</div>" + hardCaseSection(evaluation) + methodSection(evaluation);
    return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
           "content='width=device-width, initial-scale=1'><title>Palpate: speed against error</title><style>" +
           std::string(kReportStyle) + kChartStyle + "</style></head><body>" + tag("main", body) + "</body></html>\n";
}

} // namespace palpate::evaluation
