// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ReadableName.h"
#include "report/ReportSections.h"

#include <palpate/core/Finding.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate::study::internal {

namespace {

using core::Count;
using core::Message;
using core::Rounded;

Message typeText(core::FindingType type)
{
    switch (type) {
    case core::FindingType::Lump:
        return {PALPATE_TEXT("lump")};
    case core::FindingType::HardArea:
        return {PALPATE_TEXT("hard area")};
    case core::FindingType::SoftArea:
        return {PALPATE_TEXT("soft area")};
    case core::FindingType::Landmark:
        return {PALPATE_TEXT("landmark")};
    case core::FindingType::KeepAway:
        return {PALPATE_TEXT("keep away")};
    case core::FindingType::Other:
        break;
    }
    return {PALPATE_TEXT("other")};
}

/// Findings of the recording with a place, by number.
std::vector<const session::FindingMeasures*> recordedPlaces(const ReportFacts& facts)
{
    std::vector<const session::FindingMeasures*> places;
    for (const session::FindingMeasures& one : facts.measures.findings) {
        if (one.finding.hasPlace) {
            places.push_back(&one);
        }
    }
    return places;
}

/// Makes a table of findings without rows.
ReportTable tableOf(const Message& caption, const ReportTable::Column& marked)
{
    return {caption,
            {column(PALPATE_TEXT("No.")), column(PALPATE_TEXT("Name")), column(PALPATE_TEXT("Type")),
             column(PALPATE_TEXT("On")), column(PALPATE_TEXT("Place (x y z) [mm]"), true),
             column(PALPATE_TEXT("Size [mm]"), true), column(PALPATE_TEXT("Force [N]"), true),
             column(PALPATE_TEXT("Depth [mm]"), true), marked},
            {}};
}

void addRow(ReportTable& table, std::size_t number, const core::Finding& one, core::MessageArgument marked)
{
    table.rows.push_back({Count(number), nameOrDash(one.name), typeText(one.type), structureOrDash(one.structure),
                          placeText(one.p_W), lengthText(one.size_mm), forceText(one.force_N), lengthText(one.depth_mm),
                          std::move(marked)});
}

} // namespace

ReportTable findingTable(const ReportFacts& facts)
{
    ReportTable table =
        tableOf({PALPATE_TEXT("Findings as marked by the examiner; force and depth at the time of marking")},
                column(PALPATE_TEXT("Marked at [s]"), true));
    for (const session::FindingMeasures* one : recordedPlaces(facts)) {
        addRow(table, table.rows.size() + 1, one->finding, fixed(one->marked_s, 1));
    }
    return table;
}

ReportTable outsideTable(const ReportFacts& facts)
{
    ReportTable table = tableOf({PALPATE_TEXT("Findings marked outside of this recording: before it, after its end or "
                                              "in another one. This recording says nothing about their examination.")},
                                column(PALPATE_TEXT("Marked"), true));
    const std::size_t recorded = recordedPlaces(facts).size();
    for (const core::Finding& one : facts.outside) {
        addRow(table, recorded + table.rows.size() + 1, one, nameOrDash(readableTime(one.marked_utc)));
    }
    return table;
}

ReportTable visitTable(const ReportFacts& facts)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("How the findings were examined: contact within %1 mm of the place"),
                     Rounded{facts.measures.distance_mm, 3}};
    table.columns = {column(PALPATE_TEXT("No.")),
                     column(PALPATE_TEXT("Name")),
                     column(PALPATE_TEXT("Time in contact [s]"), true),
                     column(PALPATE_TEXT("Visits"), true),
                     column(PALPATE_TEXT("Mean force [N]"), true),
                     column(PALPATE_TEXT("Peak force [N]"), true)};
    const std::vector<const session::FindingMeasures*> places = recordedPlaces(facts);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const session::FindingMeasures& one = *places[i];
        table.rows.push_back({Count(i + 1), nameOrDash(one.finding.name), timeText(one.dwell_s), Count(one.visits),
                              forceText(one.meanForce_N), forceText(one.peakForce_N)});
    }
    return table;
}

ReportTable layerTable(const ReportFacts& facts)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("Findings felt through several layers, at the time of marking")};
    table.columns = {column(PALPATE_TEXT("No.")), column(PALPATE_TEXT("Structure")),
                     column(PALPATE_TEXT("Force [N]"), true), column(PALPATE_TEXT("Depth [mm]"), true)};
    std::size_t number = 0;
    const auto add = [&](const core::Finding& finding) {
        ++number;
        for (const core::FindingLayer& layer : finding.layers) {
            table.rows.push_back(
                {Count(number), readableName(layer.structure), forceText(layer.force_N), lengthText(layer.depth_mm)});
        }
    };
    for (const session::FindingMeasures* one : recordedPlaces(facts)) {
        add(one->finding);
    }
    for (const core::Finding& one : facts.outside) {
        add(one);
    }
    return table;
}

} // namespace palpate::study::internal
