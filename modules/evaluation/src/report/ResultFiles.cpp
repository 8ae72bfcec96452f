// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Report.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/CsvCell.h>
#include <palpate/core/Numbers.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace palpate::evaluation {

namespace {

const char* nameOf(Knob knob)
{
    switch (knob) {
    case Knob::Solver:
        return "solver";
    case Knob::Decimated:
        return "triangles";
    case Knob::OnePass:
        return "one pass";
    case Knob::Rate:
        return "rate";
    case Knob::Radius:
        return "radius";
    }
    return "";
}

QString text(const std::string& s)
{
    return QString::fromStdString(s);
}

bool hasP999(const Percentiles& p)
{
    return p.count >= kMinCountForP999;
}

QJsonObject object(const Percentiles& p)
{
    return {{"count", qint64(p.count)},
            {"mean", p.mean},
            {"p50", p.p50},
            {"p99", p.p99},
            {"p99_9", hasP999(p) ? QJsonValue(p.p999) : QJsonValue()},
            {"max", p.max}};
}

QJsonObject object(const Spread& s)
{
    QJsonArray values;
    for (const double v : s.values) {
        values.append(v);
    }
    return {{"by_path", values},
            {"median", s.median},
            {"median_low", s.medianLow},
            {"median_high", s.medianHigh},
            {"median_confidence", s.confidence},
            {"spread_low", s.low},
            {"spread_high", s.high}};
}

QJsonObject object(const SameState& s)
{
    return {{"ticks", qint64(s.ticks)},
            {"parted", qint64(s.parted)},
            {"parted_mm_max", s.parted_mm},
            {"spring_longer_mm_max", s.longer_mm},
            {"others_mm_max", s.together_mm}};
}

QJsonArray array(const std::vector<std::int64_t>& values)
{
    QJsonArray result;
    for (const std::int64_t v : values) {
        result.append(qint64(v));
    }
    return result;
}

QJsonArray array(const std::vector<std::string>& lines)
{
    QJsonArray result;
    for (const std::string& line : lines) {
        result.append(text(line));
    }
    return result;
}

QJsonObject object(const Trial& t)
{
    return {{"subject", text(t.subject)},
            {"solver", text(t.solver)},
            {"setting", text(t.setting)},
            {"knob", nameOf(t.knob)},
            {"knob_value", t.variationValue},
            {"fingertip_mm", t.fingertip_mm},
            {"triangles", qint64(t.triangles)},
            {"rate_hz", t.rate_Hz},
            {"ticks", qint64(t.ticks)},
            {"ticks_of_motion", qint64(t.wanted)},
            {"ticks_interrupted", qint64(t.interrupted)},
            {"time_us", object(t.time_us)},
            {"free_time_us", object(t.freeTime_us)},
            {"position_error_mm", object(t.position_mm)},
            {"force_error_n", object(t.force_N)},
            {"force_error_percent", object(t.forcePercent)},
            {"direction_error_deg", object(t.direction_deg)},
            {"residual_mm", object(t.residual_mm)},
            {"pop_throughs", qint64(t.popThroughs)},
            {"ticks_apart", qint64(t.elsewhere)},
            {"apart_mm", object(t.elsewhere_mm)},
            {"apart_force_error_percent", object(t.elsewhereForcePercent)},
            {"from_the_same_state", object(t.sameState)},
            {"path_time_us", object(t.pathTime_us)},
            {"path_mean_position_error_mm", object(t.pathPosition_mm)},
            {"path_p99_force_error_percent", object(t.pathForcePercent)},
            {"path_apart_percent", object(t.pathElsewherePercent)},
            {"ticks_by_iterations", array(t.iterations)},
            {"mean_spring_mm", t.spring_mm},
            {"is_reference", t.isReference},
            {"is_on_pareto_front", t.isParetoOptimal}};
}

QJsonObject object(const SizePoint& p)
{
    return {{"solver", text(p.solver)},
            {"triangles", qint64(p.triangles)},
            {"ticks", qint64(p.ticks)},
            {"time_us", object(p.time_us)}};
}

QJsonObject object(const HardCaseResult& r)
{
    QJsonArray figures;
    for (const HardCaseFigure& f : r.figures) {
        figures.append(QJsonObject{{"what", text(f.what)},
                                   {"measured", f.measured},
                                   {"bound", f.bound},
                                   {"worst_tick", qint64(f.worstTick)},
                                   {"passed", f.passed()}});
    }
    return {{"name", text(r.name)},     {"passed", r.passed()},
            {"ticks", qint64(r.ticks)}, {"triangles", qint64(r.triangles)},
            {"figures", figures},       {"ticks_by_iterations", array(r.iterations)}};
}

void appendPercentiles(std::string& out, const Percentiles& p)
{
    const auto append = [&out](double v) {
        out += ',';
        core::appendNumber(out, v);
    };
    append(p.mean);
    append(p.p50);
    append(p.p99);
    if (hasP999(p)) {
        append(p.p999);
    } else {
        out += ',';
    }
    append(p.max);
}

void appendSpread(std::string& out, const Spread& s)
{
    for (const double v : {s.median, s.medianLow, s.medianHigh, s.low, s.high}) {
        out += ',';
        core::appendNumber(out, v);
    }
}

} // namespace

std::string resultsCsv(const Evaluation& evaluation)
{
    std::string out =
        "subject,solver,setting,knob,knob_value,triangles,rate_hz,ticks,ticks_of_motion,ticks_interrupted,pop_throughs,"
        "ticks_apart,ticks_from_same_state,ticks_parted,is_on_pareto_front";
    for (const char* what : {"time_us", "free_time_us", "position_error_mm", "force_error_n", "force_error_percent",
                             "direction_error_deg", "residual_mm"}) {
        for (const char* share : {"mean", "p50", "p99", "p99_9", "max"}) {
            out += std::string(",") + what + "_" + share;
        }
    }
    for (const char* what : {"path_time_us", "path_mean_position_error_mm", "path_p99_force_error_percent"}) {
        for (const char* figure : {"median", "median_low", "median_high", "spread_low", "spread_high"}) {
            out += std::string(",") + what + "_" + figure;
        }
    }
    out += ",paths,mesh_sha256,seed,cpu,compiler,build\n";
    const auto origin = [&evaluation](const std::string& hash) {
        return ',' + hash + ',' + std::to_string(evaluation.seed) + ',' + core::csvCell(evaluation.machine.cpu) + ',' +
               core::csvCell(evaluation.machine.compiler) + ',' + core::csvCell(evaluation.machine.build) + '\n';
    };
    std::vector<Trial> trials = evaluation.trials;
    trials.insert(trials.end(), evaluation.paperBody.begin(), evaluation.paperBody.end());
    for (const Trial& t : trials) {
        out += core::csvCell(t.subject) + ',' + core::csvCell(t.solver) + ',' + core::csvCell(t.setting) + ',' +
               nameOf(t.knob) + ',';
        core::appendNumber(out, t.variationValue);
        out += ',' + std::to_string(t.triangles) + ',';
        core::appendNumber(out, t.rate_Hz);
        out += ',' + std::to_string(t.ticks) + ',' + std::to_string(t.wanted) + ',' + std::to_string(t.interrupted) +
               ',' + std::to_string(t.popThroughs) + ',' + std::to_string(t.elsewhere) + ',' +
               std::to_string(t.sameState.ticks) + ',' + std::to_string(t.sameState.parted) + ',' +
               (t.isParetoOptimal ? "1" : "0");
        for (const Percentiles* p : {&t.time_us, &t.freeTime_us, &t.position_mm, &t.force_N, &t.forcePercent,
                                     &t.direction_deg, &t.residual_mm}) {
            appendPercentiles(out, *p);
        }
        for (const Spread* spread : {&t.pathTime_us, &t.pathPosition_mm, &t.pathForcePercent}) {
            appendSpread(out, *spread);
        }
        out += ',' + std::to_string(t.pathPosition_mm.values.size());
        const auto subject = std::find_if(evaluation.subjects.begin(), evaluation.subjects.end(),
                                          [&t](const SubjectInfo& s) { return s.name == t.subject; });
        out += origin(subject != evaluation.subjects.end() ? subject->hash : "");
    }
    std::vector<SizePoint> points = evaluation.sizes;
    for (const SizePoint& p : evaluation.tissues) {
        points.push_back(p);
        points.back().solver = "Palpate " + p.solver;
    }
    for (const SizePoint& p : points) {
        out += "sphere," + core::csvCell(p.solver) + ",,size," + std::to_string(p.triangles) + ',' +
               std::to_string(p.triangles) + ",1000," + std::to_string(p.ticks) + ",,,,,,,";
        appendPercentiles(out, p.time_us);
        out += std::string(46, ',') + origin("");
    }
    return out;
}

std::string hardCasesCsv(const Evaluation& evaluation)
{
    std::string out = "case,required,measured,bound,passed,worst_tick,triangles,ticks\n";
    for (const HardCaseResult& r : evaluation.hardCases) {
        for (const HardCaseFigure& f : r.figures) {
            out += core::csvCell(r.name) + ',' + core::csvCell(f.what) + ',';
            core::appendNumber(out, f.measured);
            out += ',';
            core::appendNumber(out, f.bound);
            out += std::string(f.passed() ? ",1," : ",0,") + std::to_string(f.worstTick) + ',' +
                   std::to_string(r.triangles) + ',' + std::to_string(r.ticks) + '\n';
        }
    }
    return out;
}

std::string resultsJson(const Evaluation& evaluation)
{
    QJsonArray subjects, trials, paperBody, corners, smooth, moving, sizes, tissues, cases, advice, ratios, operations;
    for (const SubjectInfo& s : evaluation.subjects) {
        QJsonArray structures;
        for (const SubjectStructure& structure : s.structures) {
            structures.append(QJsonObject{{"name", text(structure.name)},
                                          {"layer", qint64(structure.layer)},
                                          {"stiffness_n_per_mm", structure.stiffness_N_per_mm}});
        }
        subjects.append(QJsonObject{{"name", text(s.name)},
                                    {"structures", structures},
                                    {"paths", array(s.paths)},
                                    {"sha256", text(s.hash)},
                                    {"triangles", qint64(s.triangles)},
                                    {"extent_mm", s.extent_mm},
                                    {"haptic_bytes", qint64(s.bytes)},
                                    {"index_ms", s.build_ms}});
    }
    for (const Trial& t : evaluation.trials) {
        trials.append(object(t));
    }
    for (const Trial& t : evaluation.paperBody) {
        paperBody.append(object(t));
    }
    for (const CornerForce& c : evaluation.corners) {
        corners.append(QJsonObject{{"angle_deg", c.angle_deg},
                                   {"vector_field_over_right", c.vectorField},
                                   {"god_object_over_right", c.godObject}});
    }
    for (const MotionRow& r : evaluation.moving) {
        moving.append(QJsonObject{{"motion", text(r.motion)},
                                  {"way", text(r.way)},
                                  {"ticks", qint64(r.ticks)},
                                  {"touched", qint64(r.touched)},
                                  {"passes", qint64(r.passes)},
                                  {"share_behind", r.share}});
    }
    for (const SmoothRow& r : evaluation.smooth) {
        smooth.append(QJsonObject{{"shape", text(r.shape)},
                                  {"way", text(r.way)},
                                  {"triangles", qint64(r.triangles)},
                                  {"extent_mm", r.extent_mm},
                                  {"position_mm", r.position_mm},
                                  {"direction_deg", r.direction_deg},
                                  {"step_n", r.step_N},
                                  {"work_mj", r.work_mJ},
                                  {"press_mj", r.press_mJ}});
    }
    for (const SizePoint& p : evaluation.sizes) {
        sizes.append(object(p));
    }
    for (const SizePoint& p : evaluation.tissues) {
        tissues.append(object(p));
    }
    for (const HardCaseResult& r : evaluation.hardCases) {
        cases.append(object(r));
    }
    for (const Advice& a : evaluation.advice) {
        advice.append(QJsonObject{{"subject", text(a.subject)},
                                  {"setting", text(a.setting)},
                                  {"why", array(a.why)},
                                  {"warning", text(a.warning)}});
    }
    for (const Ratio& r : evaluation.ratios) {
        ratios.append(QJsonObject{{"solver", text(r.solver)},
                                  {"triangles", qint64(r.triangles)},
                                  {"times_the_median", r.times},
                                  {"wanted_at_least", r.wanted}});
    }
    for (const int n : evaluation.eliminationOperations) {
        operations.append(n);
    }
    const VectorFieldFigures& v = evaluation.vectorField;
    const QJsonObject all{{"format", "palpate evaluation"},
                          {"version", 2},
                          {"machine", QJsonObject{{"cpu", text(evaluation.machine.cpu)},
                                                  {"cores", evaluation.machine.cores},
                                                  {"load", evaluation.machine.load},
                                                  {"compiler", text(evaluation.machine.compiler)},
                                                  {"build", text(evaluation.machine.build)},
                                                  {"started_utc", text(evaluation.machine.startedUtc)}}},
                          {"seed", qint64(evaluation.seed)},
                          {"is_quick", evaluation.isQuick},
                          {"is_cancelled", evaluation.isCancelled},
                          {"left_out", array(evaluation.skippedItems)},
                          {"duration_s", evaluation.duration_s},
                          {"motions", array(evaluation.motions)},
                          {"subjects", subjects},
                          {"trials", trials},
                          {"paper_body", paperBody},
                          {"corner_force", corners},
                          {"smooth_surfaces", smooth},
                          {"moving_surfaces", moving},
                          {"cost_by_size", sizes},
                          {"cost_of_tissue", tissues},
                          {"ratios", ratios},
                          {"hard_cases", cases},
                          {"advice", advice},
                          {"vector_field", QJsonObject{{"plate_mm", v.plate_mm},
                                                       {"pop_through_depth_mm", v.popThroughDepth_mm},
                                                       {"jump_at_the_middle_n", v.jumpAtTheMiddle_N},
                                                       {"stiffness_alone_n_per_mm", v.stiffnessAlone},
                                                       {"stiffness_overlapped_n_per_mm", v.stiffnessOverlapped}}},
                          {"elimination_operations", operations}};
    return QJsonDocument(all).toJson(QJsonDocument::Indented).toStdString();
}

core::Status writeReport(const std::filesystem::path& folder, const Evaluation& evaluation)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder)) {
        return {core::StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be made: %2"), folder,
                core::systemError(error.value())};
    }
    const std::vector<std::filesystem::path> files = reportFiles(folder);
    std::size_t next = 0;
    for (const auto make : {resultsCsv, hardCasesCsv, resultsJson, chartSvg, reportHtml}) {
        if (core::Status status = core::writeAtomically(files[next++], make(evaluation)); !status.isOk()) {
            return status;
        }
    }
    return {};
}

std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder)
{
    return {folder / "results.csv", folder / "hard_cases.csv", folder / "results.json", folder / "chart.svg",
            folder / "report.html"};
}

} // namespace palpate::evaluation
