// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/LagrangeElimination.h"
#include "palpate/evaluation/Report.h"
#include "report/Advice.h"
#include "report/HtmlStyle.h"
#include "report/ReportCharts.h"
#include "report/SvgChart.h"

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

/// Table cell with a median and, below, the spread over the paths.
std::string spreadCell(const Spread& spread)
{
    const bool isOne = spread.values.size() < 2;
    return cell(
        number(spread.median) +
        (isOne ? "" : "<br><span class='soft'>" + number(spread.low) + " … " + number(spread.high) + "</span>"));
}

std::string shareCell(std::size_t part, std::size_t of, double most_mm)
{
    if (of == 0) {
        return cell("–");
    }
    return cell(number(100.0 * static_cast<double>(part) / static_cast<double>(of)) +
                (part > 0 ? "<br><span class='soft'>" + number(most_mm) + " mm</span>" : ""));
}

std::string errorCells(const Trial& t)
{
    if (t.isReference) {
        return "<td colspan='9' class='left soft'>the truth: what the others are compared with</td>";
    }
    if (t.position_mm.count == 0) {
        return "<td colspan='9' class='left soft'>did not touch</td>";
    }
    return spreadCell(t.pathPosition_mm) + cell(number(t.position_mm.p99)) + cell(number(t.position_mm.max)) +
           spreadCell(t.pathForcePercent) + cell(number(t.direction_deg.p99)) +
           shareCell(t.elsewhere, t.position_mm.count, t.elsewhere_mm.max) +
           shareCell(t.sameState.parted, t.sameState.ticks, t.sameState.parted_mm) +
           cell(t.residual_mm.count > 0 ? number(t.residual_mm.max) : "–") +
           cell(t.popThroughs > 0 ? "<span class='fail'>" + core::grouped(t.popThroughs) + "</span>" : "0");
}

std::string trialRow(const Trial& t)
{
    const bool isShort = t.ticks < t.wanted;
    const Tail tail = tailOf(t.time_us);
    std::string row =
        cell(escaped(t.solver + (t.setting.empty() ? "" : ", " + t.setting)), true) + cell(core::grouped(t.triangles));
    if (t.time_us.count == 0) {
        row += cell("–") + cell("–") + cell("–");
    } else {
        row += (t.isReference ? cell(number(t.time_us.p50)) : spreadCell(t.pathTime_us)) +
               cell(t.isReference ? "–" : number(tail.value) + "<br><span class='soft'>" + tail.name + "</span>") +
               cell(t.isReference ? "–" : number(t.time_us.max));
    }
    row += cell(t.freeTime_us.count > 0 ? number(t.freeTime_us.p50) : "–") + errorCells(t) +
           cell(t.isReference ? "" : core::grouped(t.time_us.count)) +
           cell(t.isReference ? "" : core::grouped(t.position_mm.count)) +
           cell(core::grouped(t.ticks) + (isShort ? " of " + core::grouped(t.wanted) : ""));
    return tag("tr", row, t.knob == Knob::Solver && t.solver == "Palpate" ? "class='strong'" : "");
}

std::string trialTable(const std::vector<Trial>& trials, const std::string& subject)
{
    std::string rows;
    for (const Trial& t : trials) {
        rows += t.subject == subject ? trialRow(t) : "";
    }
    return tag("table",
               head({"Solver", "triangles", "time [µs]<br>median", "<br>tail", "<br>worst", "<br>in free<br>space",
                     "error [mm]<br>mean", "<br>99 %", "<br>most", "force error<br>[%], 99 %", "direction<br>[°], 99 %",
                     "apart [%],<br>most", "parts from<br>one state<br>[%], most", "residual<br>[mm], max",
                     "pop-<br>throughs", "ticks<br>timed", "in<br>contact", "run"}) +
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
    const std::size_t all = hardCaseCount(HardCaseChoice::All);
    const std::string notRun =
        all > order.size() ? ", " + std::to_string(all - order.size()) + " of " + std::to_string(all) + " not run" : "";
    return tag("h2", "Hard cases: " + std::to_string(passed) + " of " + std::to_string(order.size()) +
                         " that were run pass" + notRun) +
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

/// Lists each distinct stiffness, with the names of the structures if there are few.
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

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ", ") + escaped(name);
    }
    return text;
}

constexpr const char* kMethod =
    R"(<p>Solver error: the solver and the exact one (long double, every side decided exactly, brute force) get the same
1,000 samples of the hand a second and run on from their own states. The position error is the distance of their
god-objects at each tick in which either touches, with several layers that of the layer where it is largest. No tick
is left out, and the rule is the same for all solvers. Rate error: the product at each rate against the exact solver
at 4 kHz; the force is held between ticks, and the error is taken just before the next one. Force: the layers' springs
together, each with the stiffness of the tissue that the exact god-object touches; in percent of the exact force, or
of 2 % of its largest where that is more. Directions where it is at least 2 % of its largest.</p>
<p>Apart: share of the ticks in contact in which, given the same sample, the two god-objects are more than 0.001 mm
apart (on what is smaller than 100 mm: 10⁻⁵ of its extent), and the largest distance. These are mostly ticks in which
each rests in another minimum after a way parted, and they are part of all errors. Parts from one state: the exact
solver is put into the solver's state before each tick in contact and gets the same sample; share of ticks that end
apart, and the largest distance. Residual: how much nearer to the HIP legal moves could still bring the god-object, of
every 16th tick. Balls: a fingertip of that radius against the exact ball; nearer than its radius to what it faces
counts as a pop-through. Pop-throughs are looked for in every fourth tick.</p>
<p>Spread: each path gives one value; the table has the median of the paths and below it the range in which one more
path falls in 95 % of cases, if logarithms of the values are normally distributed. Tail: 99.9 % from 10,000 timed
ticks on, 99 % from 1,000 on, otherwise the slowest tick. Times are of the solver's step alone, by the monotonic
clock, in contact unless said otherwise; ticks in which another program took the core are not in them. The errors of
the paper's solver are those of a copy that finds its facets through boxes and gives the same bits; its times are of
brute force, from the contact of each path on (ticks timed).</p>)";

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
    const std::string motions = listed(evaluation.motions);
    const std::string paths = evaluation.subjects.empty() ? "" : listed(evaluation.subjects.front().paths);
    return tag("h2", "What the vector field costs, and the paper's sums") + "<div class='card'><p>A plate of " +
           number(v.plate_mm) + " mm pushes the hand out on its far side from a depth of " +
           number(v.popThroughDepth_mm) + " mm on. In the middle of a cube of 20 mm the force jumps by " +
           number(v.jumpAtTheMiddle_N) + " N at 1 N/mm. Where two boxes overlap the summed stiffness is " +
           number(v.stiffnessOverlapped) + " N/mm instead of " + number(v.stiffnessAlone) +
           ". A god-object has none of these. The chart shows figure 3: pressed into the corner of two surfaces, the "
           "summed "
           "force is right where they are perpendicular, too large where they are obtuse, twice the right one where "
           "they "
           "are parallel, and too small where they are acute.</p><div style='max-width:560px'>" +
           cornerChart(evaluation) +
           "</div><p>Multiplications and divisions to eliminate the system of 1, 2 and "
           "3 "
           "planes: " +
           operations + ".</p></div>" + tag("h2", "How it was measured") +
           "<div class='card small'><p>Paths: " + paths + ", each of these motions: " + motions + ".</p>" + kMethod +
           tag("table", head({"Scene", "stiffness", "triangles", "extent [mm]", "haptic copy [MB]", "bytes a triangle",
                              "index [ms]", "SHA-256"}) +
                            tag("tbody", hashes)) +
           (evaluation.paperBody.empty()
                ? ""
                : "<p>The paper's solver and Palpate on a body of 616 triangles, as many as the paper's space shuttle "
                  "had "
                  "at 1 kHz on a Pentium of 66 MHz:</p><div style='overflow-x:auto'>" +
                      trialTable(evaluation.paperBody, evaluation.paperBody.front().subject) + "</div>") +
           "<p class='soft'>" + escaped(evaluation.machine.cpu) + ", " + std::to_string(evaluation.machine.cores) +
           " cores, load " + number(evaluation.machine.load) + "; " + escaped(evaluation.machine.compiler) +
           "; build " + escaped(evaluation.machine.build) + "; first seed " + std::to_string(evaluation.seed) + "; " +
           escaped(evaluation.machine.startedUtc) + ", " + number(evaluation.duration_s) + " s" +
           (evaluation.isQuick ? ", quick run" : "") + ". The same numbers: results.csv, results.json.</p></div>";
}

/// Card that compares the product's speed with the other solvers and with the required ratios.
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

/// Card with the additional cost per tick of friction, a force law and a stiffness map.
std::string tissueCard(const Evaluation& evaluation)
{
    std::string rows;
    for (const SizePoint& p : evaluation.tissues) {
        const Tail tail = tailOf(p.time_us);
        rows += tag("tr", cell(escaped(p.solver), true) + cell(number(p.time_us.p50)) +
                              cell(number(tail.value) + " (" + tail.name + ")"));
    }
    return rows.empty() ? ""
                        : card("What tissue costs (sphere of " + core::grouped(evaluation.tissues.front().triangles) +
                                   " triangles, in turns)",
                               tag("table", head({"", "µs, median", "tail"}) + tag("tbody", rows)));
}

/// Section that compares the ways to hide facets.
std::string smoothSection(const Evaluation& evaluation)
{
    std::string rows;
    for (const SmoothRow& r : evaluation.smooth) {
        rows += tag("tr", cell(escaped(r.shape), true) + cell(escaped(r.way), true) + cell(core::grouped(r.triangles)) +
                              cell(number(r.position_mm / r.extent_mm)) + cell(number(r.direction_deg)) +
                              cell(number(r.step_N)) + cell(number(r.work_mJ)));
    }
    return rows.empty()
               ? ""
               : tag("h2", "Smooth surfaces") +
                     "<p class='soft'>Facets of a sphere, a cylinder and a torus against the true surface, "
                     "frictionless: "
                     "the largest distance of the god-object from the true surface, the largest angle of the force, "
                     "its "
                     "largest change in a tick at 25 mm/s and a depth of 4 mm, and the work on the hand over a closed "
                     "path, which is 0 for a spring. The press itself holds " +
                     number(evaluation.smooth.front().press_mJ) + " mJ.</p><div class='card'>" +
                     tag("table", head({"", "", "triangles", "position<br>[radius]", "direction<br>[°]", "step<br>[N]",
                                        "work<br>[mJ]"}) +
                                      tag("tbody", rows)) +
                     "</div>";
}

/// Section that counts how often a moving surface passes through the hand.
std::string movingSection(const Evaluation& evaluation)
{
    std::string rows;
    for (const MotionRow& r : evaluation.moving) {
        rows += tag("tr", cell(escaped(r.motion), true) + cell(escaped(r.way), true) + cell(core::grouped(r.ticks)) +
                              cell(core::grouped(r.touched)) + cell(core::grouped(r.passes)) +
                              cell(number(100.0 * r.share)));
    }
    return rows.empty() ? ""
                        : tag("h2", "Moving surfaces") +
                              "<p class='soft'>How often a surface that moves under the hand passes through the "
                              "god-object at 1 kHz: when the nodes of the mesh are moved between ticks, and when the "
                              "hand is taken back to the rest shape, where nothing moves but the hand.</p>"
                              "<div class='card'>" +
                              tag("table", head({"", "", "ticks", "in contact", "passes", "behind<br>[% of ticks]"}) +
                                               tag("tbody", rows)) +
                              "</div>";
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
    if (!evaluation.skippedItems.empty()) {
        std::string list;
        for (const std::string& line : evaluation.skippedItems) {
            list += (list.empty() ? "" : "; ") + escaped(line);
        }
        text += "<p class='soft small'>Left out: " + list + ".</p>";
    }
    return text;
}

std::string legend()
{
    return "<p class='legend small soft'><span>● solver</span><span>■ Palpate on fewer triangles</span>"
           "<span>○ Palpate with a ball as fingertip, against the exact ball; the paper on its own body</span>"
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
    std::string body =
        tag("h1", "Speed against error") +
        "<p class='soft'>What a servo tick costs and how far the god-object is from that of an exact solver "
        "that gets the same hand: every tick in contact, solver by solver, knob by knob, over several "
        "paths." +
        (evaluation.isCancelled ? " <b>Cancelled: not all was measured.</b>" : "") + "</p>";
    body += advice + notes(evaluation);
    for (const SubjectInfo& s : evaluation.subjects) {
        body += card(s.name + ", " + core::grouped(s.triangles) + " triangles",
                     speedAgainstErrorChart(evaluation, s.name) + legend());
        body += "<details" + std::string(evaluation.subjects.size() == 1 ? " open" : "") + "><summary>All figures of " +
                escaped(s.name) + "</summary><div class='card' style='overflow-x:auto'>" +
                trialTable(evaluation.trials, s.name) + "</div></details>";
    }
    body += tag("h2", "Size, time and iterations") + "<div class='pair'>";
    if (!evaluation.sizes.empty()) {
        body += card("Cost by mesh size (spheres; dashed: the slowest hundredth)", costBySizeChart(evaluation));
    }
    body +=
        ratioCard(evaluation) + tissueCard(evaluation) + card("Palpate's moves in a tick", iterationsChart(evaluation));
    for (const SubjectInfo& s : evaluation.subjects) {
        body +=
            card("Error over time, " + (evaluation.motions.empty() ? "" : evaluation.motions.front()) + ": " + s.name,
                 errorOverTimeChart(evaluation, s.name));
    }
    body += "</div>" + hardCaseSection(evaluation) + smoothSection(evaluation) + movingSection(evaluation) +
            methodSection(evaluation);
    return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
           "content='width=device-width, initial-scale=1'><title>Palpate: speed against error</title><style>" +
           std::string(kReportStyle) + kChartStyle + "</style></head><body>" + tag("main", body) + "</body></html>\n";
}

} // namespace palpate::evaluation
