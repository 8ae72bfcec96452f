// SPDX-License-Identifier: BSD-3-Clause
#include "report/ReportSections.h"

#include "palpate/study/ReadableName.h"
#include "palpate/study/StiffnessRatio.h"

#include <cmath>
#include <optional>
#include <utility>

namespace palpate::study::internal {

namespace {

using core::Message;
using core::MessageArgument;
using core::Rounded;

Message textOf(buried::Verdict verdict)
{
    switch (verdict) {
    case buried::Verdict::NotByHand:
        return {PALPATE_TEXT("not by hand")};
    case buried::Verdict::ByTrainedHand:
        return {PALPATE_TEXT("by a trained hand")};
    case buried::Verdict::Plainly:
        return {PALPATE_TEXT("plainly")};
    case buried::Verdict::NotJudged:
        return {PALPATE_TEXT("not judged")};
    case buried::Verdict::NotKnown:
        break;
    }
    return {PALPATE_TEXT("stiffness ratio not known")};
}

/// As buried::verdictText, translatable.
Message verdictOf(const buried::FeltSurface::LumpPress& press, const std::optional<buried::RatioRange>& ratio)
{
    if (!ratio || (press.verdictAtLow == press.verdict && press.verdictAtHigh == press.verdict)) {
        return textOf(press.verdict);
    }
    return {PALPATE_TEXT("%1 (at %2: %3; at %4: %5)"),
            textOf(press.verdict),
            ratio->low,
            textOf(press.verdictAtLow),
            ratio->high,
            textOf(press.verdictAtHigh)};
}

Message textOf(RatioSource source)
{
    switch (source) {
    case RatioSource::Typed:
        return {PALPATE_TEXT("as typed")};
    case RatioSource::Moduli:
        return {PALPATE_TEXT("from the moduli")};
    case RatioSource::Tissue:
        return {PALPATE_TEXT("from the tissues' stiffness")};
    case RatioSource::Published:
        break;
    }
    return {PALPATE_TEXT("published for such lumps")};
}

/// As study::ratioText, translatable.
Message textOf(const std::optional<StiffnessRatio>& ratio)
{
    if (!ratio) {
        return {PALPATE_TEXT("stiffness ratio not known")};
    }
    const Rounded typical{ratio->typical, 3};
    return ratio->isRange() ? Message(PALPATE_TEXT("%1 (%2 to %3) times as stiff, %4"), typical, ratio->low,
                                      ratio->high, textOf(ratio->source))
                            : Message(PALPATE_TEXT("%1 times as stiff, %2"), typical, textOf(ratio->source));
}

/// Verdicts with the ratio that they rest on.
ReportTable verdictTable(const ReportFacts& facts)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("Which lumps a hand can find, as predicted by the model of buried lumps (an "
                                  "estimate), with the stiffness ratio to the organ that this rests on")};
    table.columns = {column(PALPATE_TEXT("Lump")), column(PALPATE_TEXT("Organ")),
                     column(PALPATE_TEXT("Stiffness ratio"))};
    for (const buried::FeltSurface::Press& press : facts.lumps.front().felt.press) {
        table.columns.push_back({press.press_mm > 0.0 ? Message(PALPATE_TEXT("Pressed %1 mm"), press.press_mm)
                                                      : Message(PALPATE_TEXT("Touched lightly"))});
    }
    for (const OrganPalpability& one : facts.lumps) {
        for (const buried::FeltSurface::Lump& lump : one.felt.lumps) {
            const std::optional<StiffnessRatio>& ratio = one.organ.lumps[lump.given].ratio;
            std::vector<MessageArgument> row{readableName(lump.name),
                                             readableName(facts.scene->structures[one.organ.organ].description.name),
                                             textOf(ratio)};
            for (const buried::FeltSurface::LumpPress& press : lump.press) {
                row.emplace_back(ratio ? MessageArgument(verdictOf(press, lump.ratio)) : dash());
            }
            row.resize(table.columns.size(), dash());
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

/// Formats a change; below a twentieth of a percent it is rounding and shown as 0 %.
core::MessageArgument changeText(const std::optional<double>& change_percent)
{
    constexpr double kRounding_percent = 0.05;
    return change_percent && std::abs(*change_percent) < kRounding_percent
               ? core::MessageArgument(Message(PALPATE_TEXT("%1 %"), 0))
               : percent(change_percent);
}

ReportTable searchTable(const ReportFacts& facts)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("How thoroughly each lump was searched for: recorded change of the force, and "
                                  "estimates of the model")};
    table.columns = {column(PALPATE_TEXT("Lump")),
                     column(PALPATE_TEXT("Organ")),
                     column(PALPATE_TEXT("Largest recorded change under the hand"), true),
                     column(PALPATE_TEXT("Predicted change"), true),
                     column(PALPATE_TEXT("Area where a trained hand can feel it [cm²]"), true),
                     column(PALPATE_TEXT("Pressed hard enough [%]"), true)};
    for (const session::LumpSearch& one : facts.measures.lumps) {
        table.rows.push_back({readableName(one.lump), readableName(one.organ), changeText(one.recorded_percent),
                              changeText(one.predicted_percent), Rounded{0.01 * one.detectable_mm2, 3},
                              one.share() ? MessageArgument(Rounded{100.0 * *one.share(), 3}) : dash()});
    }
    return table;
}

} // namespace

ReportSection lumpSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Lumps")}, {}};
    if (facts.scene == nullptr) {
        section.blocks.emplace_back(paragraph(PALPATE_TEXT("Lumps were not evaluated, because the scene is missing.")));
        return section;
    }
    if (facts.lumps.empty()) {
        section.blocks.emplace_back(paragraph(PALPATE_TEXT("No lump in an organ could be evaluated.")));
    } else {
        section.blocks.emplace_back(verdictTable(facts));
        section.blocks.emplace_back(searchTable(facts));
    }
    for (const Message& note : facts.lumpNotes) {
        section.blocks.emplace_back(ReportText{note});
    }
    return section;
}

} // namespace palpate::study::internal
