// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ExerciseReport.h"

#include "report/ReportSections.h"

#include <utility>

namespace palpate::study {

namespace {

using core::Count;
using core::Message;
using core::MessageArgument;
using core::Rounded;
using internal::column;
using internal::dash;
using internal::fixed;

Message verdictText(FindingVerdict verdict)
{
    switch (verdict) {
    case FindingVerdict::Found:
        return {PALPATE_TEXT("found")};
    case FindingVerdict::Again:
        return {PALPATE_TEXT("found before")};
    case FindingVerdict::FalseAlarm:
        return {PALPATE_TEXT("false alarm")};
    case FindingVerdict::Late:
        return {PALPATE_TEXT("after the time limit, not counted")};
    case FindingVerdict::NotCounted:
        break;
    }
    return {PALPATE_TEXT("not counted: a landmark or a place to keep away from")};
}

ReportSection exerciseHead(const ExerciseScore& score, const ExerciseFacts& facts)
{
    ReportSection section;
    ReportTable table;
    const auto row = [&table](core::MessageText<> name, const std::string& value) {
        if (!value.empty()) {
            table.rows.push_back({Message(name), value});
        }
    };
    row(PALPATE_TEXT("Case"), facts.caseText);
    row(PALPATE_TEXT("Examinee"), facts.examinee);
    row(PALPATE_TEXT("Recording"), facts.recording);
    row(PALPATE_TEXT("Recorded"), facts.startedUtc);
    section.blocks.emplace_back(std::move(table));
    section.blocks.emplace_back(
        ReportText{{PALPATE_TEXT("Targets found: %1 of %2. Missed: %3. False alarms: %4."), Count(score.found()),
                    Count(score.targets.size()), Count(score.targets.size() - score.found()),
                    Count(score.count(FindingVerdict::FalseAlarm))},
                   false});
    for (const core::Message& one : score.damaged) {
        section.blocks.emplace_back(ReportText{one, true});
    }
    for (const std::string& name : score.unmeasured) {
        section.blocks.emplace_back(
            ReportText{{PALPATE_TEXT("No coverage of %1: its surface is missing or another one now."), name}, true});
    }
    if (score.lostTicks > 0) {
        section.blocks.emplace_back(
            ReportText{{PALPATE_TEXT("Ticks lost while recording: %1."), Count(score.lostTicks)}, true});
    }
    return section;
}

ReportSection targetSection(const ExerciseScore& score)
{
    ReportSection section{{PALPATE_TEXT("Targets")}, {}};
    ReportTable table;
    table.caption = {PALPATE_TEXT("A target is found by a finding within %1 mm of the ball around it"),
                     Rounded{score.within_mm, 3}};
    table.columns = {column(PALPATE_TEXT("Target")), column(PALPATE_TEXT("Result")),
                     column(PALPATE_TEXT("Found after [s]"), true),
                     column(PALPATE_TEXT("Distance from the ball [mm]"), true)};
    for (const ScoredTarget& one : score.targets) {
        const bool isFound = one.found_s.has_value();
        table.rows.push_back({one.name, isFound ? Message(PALPATE_TEXT("found")) : Message(PALPATE_TEXT("missed")),
                              isFound ? fixed(*one.found_s, 1) : dash(),
                              isFound ? MessageArgument(Rounded{*one.distance_mm, 3}) : dash()});
    }
    section.blocks.emplace_back(std::move(table));
    return section;
}

ReportSection markedSection(const ExerciseScore& score)
{
    ReportSection section{{PALPATE_TEXT("Findings")}, {}};
    if (score.findings.empty()) {
        section.blocks.emplace_back(internal::paragraph(PALPATE_TEXT("No findings were marked.")));
        return section;
    }
    ReportTable table;
    table.caption = {PALPATE_TEXT("Findings as they were at the end of the recording")};
    table.columns = {column(PALPATE_TEXT("Finding")), column(PALPATE_TEXT("Marked at [s]"), true),
                     column(PALPATE_TEXT("Result")), column(PALPATE_TEXT("Target"))};
    for (const ScoredFinding& one : score.findings) {
        table.rows.push_back({one.finding.name, fixed(one.marked_s, 1), verdictText(one.verdict),
                              one.target ? MessageArgument(score.targets[*one.target].name) : dash()});
    }
    section.blocks.emplace_back(std::move(table));
    return section;
}

ReportSection searchSection(const ExerciseScore& score)
{
    ReportSection section{{PALPATE_TEXT("Search and force")}, {}};
    ReportTable table;
    const auto row = [&table](core::MessageText<> name, MessageArgument value) {
        table.rows.push_back({Message(name), std::move(value)});
    };
    const meshio::Exercise& asked = score.exercise;
    row(PALPATE_TEXT("Time [s]"), fixed(score.duration_s, 3));
    if (asked.time_s) {
        row(PALPATE_TEXT("Time limit [s]"), *asked.time_s);
    }
    if (const auto coverage = score.coverage()) {
        row(PALPATE_TEXT("Searched share of the surface [%]"), Rounded{100.0 * *coverage, 3});
        row(PALPATE_TEXT("Surface to be searched [cm²]"), Rounded{0.01 * score.searched_mm2, 4});
        row(PALPATE_TEXT("Distance that counts as touched [mm]"), Rounded{score.coverageDistance_mm, 3});
    }
    if (asked.coverage_goal) {
        row(PALPATE_TEXT("Goal of the exercise [%]"), Rounded{100.0 * *asked.coverage_goal, 3});
    }
    row(PALPATE_TEXT("Peak force [N]"), Rounded{score.peakForce_N, 4});
    if (score.above) {
        row(PALPATE_TEXT("Force ceiling [N]"), *asked.force_ceiling_N);
        row(PALPATE_TEXT("Time above the ceiling [s]"), fixed(score.above->time_s, 3));
        row(PALPATE_TEXT("Impulse above the ceiling [N s]"), Rounded{score.above->impulse_Ns, 4});
    }
    section.blocks.emplace_back(std::move(table));
    return section;
}

} // namespace

Report composeExercise(const ExerciseScore& score, const ExerciseFacts& facts)
{
    Report report;
    report.title = {PALPATE_TEXT("Search exercise")};
    report.notice = {PALPATE_TEXT("Research, training and planning rehearsal. Not a medical device.")};
    report.subject = facts.caseText.empty() ? facts.recording : facts.caseText;
    report.sections.push_back(exerciseHead(score, facts));
    if (facts.isPictured) {
        report.views.push_back({ReportView::From::Front, 0, {}});
        ReportPictures pictures;
        pictures.pictures.push_back(
            {0,
             {PALPATE_TEXT("The targets, as seen at the end of the exercise")},
             {PALPATE_TEXT("The scene with a ring above each target and the findings as numbered discs.")}});
        report.sections.push_back({{PALPATE_TEXT("Places")}, {std::move(pictures)}});
    }
    report.sections.push_back(targetSection(score));
    report.sections.push_back(markedSection(score));
    report.sections.push_back(searchSection(score));
    report.sections.push_back(
        {{PALPATE_TEXT("Definitions")},
         {internal::paragraph(PALPATE_TEXT(
             "The ball around a target has its centre in the centroid of the surface and reaches to the farthest "
             "vertex. Landmarks and places to keep away from do not count. Times are counted from the first tick of "
             "the recording. The same numbers are printed by: palpate session exercise. No grade is given."))}});
    return report;
}

} // namespace palpate::study
