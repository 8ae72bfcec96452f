// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SelfTestPage.h"

#include "palpate/study/HtmlStyle.h"
#include "palpate/study/SvgChart.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/Numbers.h>
#include <palpate/device/DevicePresets.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>

namespace palpate::study {

namespace {

using core::Count;
using core::Message;
using core::Rounded;

constexpr const char* kPlainColour = "#c2542d";
constexpr const char* kControlledColour = "#0b7a75";
constexpr const char* kOtherColour = "#7457a6";

struct SelfTestRow
{
    Message name, value, remark;
};

Rounded digits3(double value)
{
    return {value, 3};
}

Message heldValue(const std::optional<double>& held)
{
    constexpr double kSoftest_N_per_mm = 0.1;
    return !held         ? Message(PALPATE_TEXT("not measured"))
           : *held > 0.0 ? Message(PALPATE_TEXT("%1 N/mm"), digits3(*held))
                         : Message(PALPATE_TEXT("less than %1 N/mm"), kSoftest_N_per_mm);
}

void addTimes(std::vector<SelfTestRow>& rows, const servo::SelfTestResult& r)
{
    if (r.roundTrip) {
        rows.push_back(
            {Message(PALPATE_TEXT("Round trip")),
             Message(PALPATE_TEXT("%1 ms median, %2 ms 99th percentile"), digits3(r.roundTrip->median_ms),
                     digits3(r.roundTrip->p99_ms)),
             Message(PALPATE_TEXT("%1 pulses; from sending a force to seeing it act"), r.roundTrip->pulses)});
        rows.push_back({Message(PALPATE_TEXT("Mass at the handle")),
                        Message(PALPATE_TEXT("%1 g"), digits3(1000.0 * r.roundTrip->mass_kg)),
                        Message(PALPATE_TEXT("with the hand, if it was held during the pulses"))});
    } else {
        rows.push_back({Message(PALPATE_TEXT("Round trip")), Message(PALPATE_TEXT("not measured")), {}});
    }
    if (r.driverLatency.count > 0) {
        rows.push_back({Message(PALPATE_TEXT("Answer of the driver")),
                        Message(PALPATE_TEXT("%1 ms median, %2 ms 99th percentile"),
                                digits3(1e-6 * static_cast<double>(r.driverLatency.p50_ns)),
                                digits3(1e-6 * static_cast<double>(r.driverLatency.p99_ns))),
                        Message(PALPATE_TEXT("from receiving a position to sending its force; ticks of the loop: %1"),
                                r.delayTicks)});
    }
    rows.push_back({Message(PALPATE_TEXT("Rate")),
                    r.rest ? Message(PALPATE_TEXT("%1 new positions per second"), Rounded{r.rest->states_per_s, 4})
                           : Message(PALPATE_TEXT("not measured")),
                    Message(PALPATE_TEXT("loop %1 Hz of %2 Hz, late ticks: %3"), Rounded{r.ticks_per_s, 4}, r.rate_Hz,
                            Count(r.overruns))});
}

std::vector<SelfTestRow> selfTestRows(const servo::SelfTestResult& r)
{
    std::vector<SelfTestRow> rows;
    addTimes(rows, r);
    const Message nothing(PALPATE_TEXT("not measured"));
    const bool isResolved = r.rest && r.rest->resolution_mm > 0.0;
    rows.push_back({Message(PALPATE_TEXT("Resolution")),
                    isResolved ? Message(PALPATE_TEXT("%1 mm"), digits3(r.rest->resolution_mm)) : nothing,
                    r.device.resolution_mm > 0.0
                        ? Message(PALPATE_TEXT("the driver states %1 mm"), digits3(r.device.resolution_mm))
                        : Message()});
    rows.push_back({Message(PALPATE_TEXT("Noise at rest")),
                    r.rest ? Message(PALPATE_TEXT("%1 mm root mean square, %2 mm peak to peak"),
                                     digits3(r.rest->noise_mm), digits3(r.rest->noisePeak_mm))
                           : nothing,
                    Message(PALPATE_TEXT("deviation from a line over 50 ms"))});
    rows.push_back({Message(PALPATE_TEXT("Friction")),
                    r.friction_N
                        ? Message(PALPATE_TEXT("%1 ± %2 N"), Rounded{*r.friction_N, 2}, Rounded{r.frictionSpread_N, 2})
                        : nothing,
                    r.friction_N ? Message(PALPATE_TEXT("force at which the handle breaks away, in both directions"))
                                 : Message()});
    rows.push_back({Message(PALPATE_TEXT("Held stiffness, without the controller")), heldValue(r.held_N_per_mm), {}});
    rows.push_back(
        {Message(PALPATE_TEXT("Held stiffness, with the controller")), heldValue(r.heldControlled_N_per_mm),
         std::isfinite(r.limit_N_per_mm)
             ? Message(PALPATE_TEXT("Palpate renders at most %1 N/mm on this device"), digits3(r.limit_N_per_mm))
             : Message()});
    if (r.device.maxStiffness_N_per_mm > 0.0) {
        rows.push_back({Message(PALPATE_TEXT("Stiffness stated for the device")),
                        Message(PALPATE_TEXT("%1 N/mm"), digits3(r.device.maxStiffness_N_per_mm)),
                        {}});
    }
    return rows;
}

/// The page is in English.
std::string cell(const Message& text)
{
    return escaped(text.english());
}

std::string card(const std::string& title, const std::string& content, const std::string& below)
{
    return "<div class='card'><h3>" + escaped(title) + "</h3>" + content + "<p class='small soft'>" + escaped(below) +
           "</p></div>";
}

ChartAxis axisAround(const std::vector<double>& values, std::string title)
{
    const double low = values.empty() ? 0.0 : std::min(0.0, *std::min_element(values.begin(), values.end()));
    ChartAxis axis = ChartAxis::linear(values, std::move(title));
    if (low < 0.0) {
        const double step = axis.ticks().size() > 1 ? axis.ticks()[1] - axis.ticks()[0] : axis.high;
        axis.low = step > 0.0 ? step * std::floor(low / step) : low;
    }
    return axis;
}

std::string pulseCard(const servo::RoundTripMeasure& trip)
{
    std::vector<double> xs, ys;
    for (const auto& [t, x] : trip.response_mm) {
        xs.push_back(t);
        ys.push_back(x);
    }
    SvgChart chart(560, 340, ChartAxis::linear(xs, "time after the force was sent [ms]"), axisAround(ys, "way [mm]"));
    chart.addLine(trip.response_mm, kControlledColour, 2.0, false, "mean of the pulses");
    chart.addVerticalRule(trip.median_ms, "round trip");
    return card("Response to a pulse of the force", chart.svg("Mean way of the handle after a force pulse"),
                "16 ms forward, 16 ms backward; the round trip is the delay of the mass that fits the response best.");
}

std::string wallsCard(const servo::SelfTestResult& r)
{
    std::vector<double> ks, times;
    for (const servo::SelfTestWall& wall : r.walls) {
        ks.push_back(wall.stiffness_N_per_mm);
        times.push_back(wall.settled_s);
    }
    if (std::isfinite(r.limit_N_per_mm)) {
        ks.push_back(r.limit_N_per_mm);
    }
    SvgChart chart(560, 340, ChartAxis::decades(ks, "stiffness of the wall [N/mm]"),
                   ChartAxis::linear(times, "time until the handle rested [s]"));
    for (const servo::SelfTestWall& wall : r.walls) {
        SvgChart::Mark mark;
        mark.x = wall.stiffness_N_per_mm;
        mark.y = wall.settled_s;
        mark.colour = wall.isControlled ? kControlledColour : kPlainColour;
        mark.isHollow = wall.isHeld;
        mark.shape = wall.isHeld ? MarkShape::Circle : MarkShape::Diamond;
        mark.tooltip = core::shortNumber(wall.stiffness_N_per_mm, 3) + " N/mm, " + (wall.isHeld ? "held" : "not held") +
                       ", swing " + core::shortNumber(wall.swing_mm, 2) + " mm";
        chart.add(mark);
    }
    if (std::isfinite(r.limit_N_per_mm)) {
        chart.addVerticalRule(r.limit_N_per_mm, "Palpate's limit");
    }
    return card(
        "Walls", chart.svg("Time until the handle rested against the stiffness of the wall"),
        "Red: without the passivity controller, green: with it. Circles: held, diamonds: not held; the wall was "
        "withdrawn at the first sign of instability.");
}

std::string traceCard(const servo::SelfTestResult& r, bool isControlled)
{
    std::vector<double> xs, ys;
    for (const servo::WallTrace& trace : r.traces) {
        if (trace.wall.isControlled == isControlled) {
            for (const auto& [t, x] : trace.way_mm) {
                xs.push_back(t);
                ys.push_back(x);
            }
        }
    }
    if (xs.empty()) {
        return {};
    }
    SvgChart chart(560, 340, ChartAxis::linear(xs, "time [ms]"), axisAround(ys, "way of the handle [mm]"));
    for (const servo::WallTrace& trace : r.traces) {
        if (trace.wall.isControlled == isControlled) {
            const std::string name = core::shortNumber(trace.wall.stiffness_N_per_mm, 3) + " N/mm, " +
                                     (trace.wall.isHeld ? "held" : "not held");
            chart.addLine(trace.way_mm, trace.wall.isHeld ? kControlledColour : kPlainColour, 1.3, false, name);
        }
    }
    return card(isControlled ? "The limit with the controller" : "The limit without the controller",
                chart.svg("Way of the handle at the stiffest held and the softest lost wall"),
                "The stiffest wall that was held and the softest that was not, from its fall on.");
}

std::string delaysCard(const servo::RoundTripMeasure& trip)
{
    std::vector<double> xs, ys;
    for (std::size_t i = 0; i < trip.each_ms.size(); ++i) {
        xs.push_back(static_cast<double>(i + 1));
        ys.push_back(trip.each_ms[i]);
    }
    SvgChart chart(560, 340, ChartAxis::linear(xs, "number of the pulse"), ChartAxis::linear(ys, "round trip [ms]"));
    for (std::size_t i = 0; i < xs.size(); ++i) {
        SvgChart::Mark mark;
        mark.x = xs[i];
        mark.y = ys[i];
        mark.colour = kOtherColour;
        chart.add(mark);
    }
    chart.addHorizontalRule(trip.median_ms, "all pulses");
    chart.addHorizontalRule(trip.p99_ms, "99th percentile");
    return card(
        "Round trip of each pulse", chart.svg("Round trip of each pulse"),
        "The round trip is that of all pulses together. A single pulse is known less well, the coarser the sensor "
        "and the heavier the hand.");
}

QJsonValue selfTestNumber(const std::optional<double>& value)
{
    return value && std::isfinite(*value) ? QJsonValue(*value) : QJsonValue();
}

} // namespace

std::string predictionCommand(const servo::SelfTestResult& result)
{
    const std::string name = result.device.name;
    for (const device::DevicePreset& preset : device::devicePresets()) {
        const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
        const bool isNamed =
            std::search(name.begin(), name.end(), preset.id.begin(), preset.id.end(), same) != name.end();
        if (isNamed || result.device.id == preset.id) {
            return "palpate stability --device " + std::string(preset.id) + " --rate " +
                   core::shortNumber(result.rate_Hz) + " --delay " + std::to_string(result.delayTicks);
        }
    }
    return {};
}

std::vector<Message> selfTestLines(const servo::SelfTestResult& result)
{
    std::vector<Message> lines;
    for (const SelfTestRow& row : selfTestRows(result)) {
        lines.push_back(row.remark.english().empty()
                            ? Message(PALPATE_TEXT("%1: %2"), row.name, row.value)
                            : Message(PALPATE_TEXT("%1: %2 (%3)"), row.name, row.value, row.remark));
    }
    return lines;
}

std::string selfTestHtml(const servo::SelfTestResult& r)
{
    std::string out =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width, initial-scale=1'><title>Palpate: test of " +
        escaped(r.device.name) + "</title><style>" + std::string(kReportStyle) + kChartStyle +
        "td.wide{white-space:normal;text-align:left}table{font-size:14px}</style></head><body><main><h1>Test of " +
        escaped(r.device.name) + "</h1><p class='soft'>" + core::shortNumber(r.duration_s, 2) +
        " s of small forces and of virtual walls of rising stiffness. The force was at most " +
        core::shortNumber(servo::mostTestForce_N(r.device), 3) + " N.</p>";
    const std::vector<core::Message> missing = servo::unmeasured(r);
    if (!missing.empty()) {
        out += "<div class='card warning'><b>Not everything was measured</b><ul>";
        for (const auto& line : missing) {
            out += "<li>" + cell(line) + "</li>";
        }
        out += "</ul></div>";
    }
    out += "<div class='card' style='overflow-x:auto;margin:14px 0'><table><tbody>";
    for (const SelfTestRow& row : selfTestRows(r)) {
        out += "<tr><td class='left'>" + cell(row.name) + "</td><td class='wide'><b>" + cell(row.value) +
               "</b></td><td class='wide soft'>" + cell(row.remark) + "</td></tr>";
    }
    out += "</tbody></table></div><div class='pair'>";
    if (!r.walls.empty()) {
        out += wallsCard(r) + traceCard(r, false) + traceCard(r, true);
    }
    if (r.roundTrip) {
        out += pulseCard(*r.roundTrip) + delaysCard(*r.roundTrip);
    }
    out += "</div>";
    if (const std::string command = predictionCommand(r); !command.empty()) {
        out += "<p>Prediction to compare with: <code>" + escaped(command) +
               "</code>, shape <i>wall</i>. It takes the lower of two simulated grips; another hand holds more or "
               "less.</p>";
    }
    out += "<p class='small soft'>The hand rests at " + core::shortNumber(r.press_N, 3) +
           " N on a wall that falls back by up to 3 mm, so that the hand falls onto it. Held: the handle comes to rest "
           "within 1.3 s.</p></main></body></html>\n";
    return out;
}

std::string selfTestJson(const servo::SelfTestResult& r)
{
    QJsonArray walls, missing;
    for (const servo::SelfTestWall& wall : r.walls) {
        walls.append(QJsonObject{{"stiffness_N_per_mm", wall.stiffness_N_per_mm},
                                 {"controlled", wall.isControlled},
                                 {"held", wall.isHeld},
                                 {"press_N", wall.press_N},
                                 {"swing_mm", wall.swing_mm},
                                 {"settled_s", wall.settled_s}});
    }
    for (const core::Message& line : servo::unmeasured(r)) {
        missing.append(QString::fromStdString(line.english()));
    }
    const auto trip = [&](double servo::RoundTripMeasure::*member) {
        return r.roundTrip ? QJsonValue((*r.roundTrip).*member) : QJsonValue();
    };
    const auto rest = [&](double servo::RestMeasure::*member) {
        return r.rest ? QJsonValue((*r.rest).*member) : QJsonValue();
    };
    const auto driver = [&](std::int64_t ns) {
        return r.driverLatency.count > 0 ? QJsonValue(1e-6 * static_cast<double>(ns)) : QJsonValue();
    };
    const QJsonObject json{
        {"format", "palpate-selftest"},
        {"version", 1},
        {"device", QString::fromStdString(r.device.name)},
        {"device_id", QString::fromStdString(r.device.id)},
        {"complete", r.isComplete()},
        {"not_measured", missing},
        {"duration_s", r.duration_s},
        {"rate_Hz", r.rate_Hz},
        {"ticks_per_s", r.ticks_per_s},
        {"late_ticks", static_cast<double>(r.overruns)},
        {"delay_ticks", r.delayTicks},
        {"round_trip_median_ms", trip(&servo::RoundTripMeasure::median_ms)},
        {"round_trip_p99_ms", trip(&servo::RoundTripMeasure::p99_ms)},
        {"pulses", r.roundTrip ? r.roundTrip->pulses : 0},
        {"mass_kg", trip(&servo::RoundTripMeasure::mass_kg)},
        {"driver_median_ms", driver(r.driverLatency.p50_ns)},
        {"driver_p99_ms", driver(r.driverLatency.p99_ns)},
        {"states_per_s", rest(&servo::RestMeasure::states_per_s)},
        {"resolution_mm", rest(&servo::RestMeasure::resolution_mm)},
        {"noise_rms_mm", rest(&servo::RestMeasure::noise_mm)},
        {"noise_peak_to_peak_mm", rest(&servo::RestMeasure::noisePeak_mm)},
        {"friction_N", selfTestNumber(r.friction_N)},
        {"friction_spread_N", r.friction_N ? QJsonValue(r.frictionSpread_N) : QJsonValue()},
        {"press_N", r.press_N},
        {"held_without_n_per_mm", selfTestNumber(r.held_N_per_mm)},
        {"held_with_n_per_mm", selfTestNumber(r.heldControlled_N_per_mm)},
        {"stated_n_per_mm", r.device.maxStiffness_N_per_mm},
        {"window_n_per_mm", selfTestNumber(r.limit_N_per_mm)},
        {"prediction", QString::fromStdString(predictionCommand(r))},
        {"walls", walls},
    };
    return QJsonDocument(json).toJson().toStdString();
}

std::vector<std::filesystem::path> selfTestFiles(const std::filesystem::path& folder)
{
    return {folder / "selftest.json", folder / "selftest.html"};
}

core::Status writeSelfTest(const std::filesystem::path& folder, const servo::SelfTestResult& result)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto files = selfTestFiles(folder);
    if (core::Status status = core::writeAtomically(files[0], selfTestJson(result)); !status.isOk()) {
        return status;
    }
    return core::writeAtomically(files[1], selfTestHtml(result));
}

} // namespace palpate::study
