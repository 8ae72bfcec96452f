// SPDX-License-Identifier: BSD-3-Clause
#include "report/ReportSections.h"

#include "palpate/study/ReadableName.h"
#include "palpate/study/RecordedScene.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace palpate::study::internal {

namespace {

using core::Count;
using core::Message;
using core::MessageArgument;
using core::Rounded;

constexpr std::size_t kShownFaults = 10;
constexpr int kTissueDigits = 3; // of stiffness and damping

Message fingertipText(const session::RecordingReader& reader)
{
    return hasFingertip(reader) ? Message(PALPATE_TEXT("ball of %1 mm radius"), reader.scenes().front().fingertip_mm)
                                : Message(PALPATE_TEXT("point"));
}

ReportTable conditionTable(const ReportFacts& facts)
{
    const session::RecordingReader& reader = *facts.recording;
    const session::RecordingInfo& info = reader.info();
    const session::RecordingExtent& extent = reader.extent();
    ReportTable table;
    table.caption = {PALPATE_TEXT("Device and recording conditions")};
    const auto add = [&table](core::MessageText<> name, MessageArgument value) {
        table.rows.push_back({Message(name), std::move(value)});
    };
    const MessageArgument unknown(Message(PALPATE_TEXT("not stated")));
    add(PALPATE_TEXT("Device"), info.device.name.empty() ? unknown : info.device.name);
    add(PALPATE_TEXT("Force limit of the device"), Message(PALPATE_TEXT("%1 N"), info.device.maxForce_N));
    add(PALPATE_TEXT("Rate"), Message(PALPATE_TEXT("%1 Hz"), info.rate_Hz));
    add(PALPATE_TEXT("Ticks"), Count(extent.ticks));
    add(PALPATE_TEXT("Late ticks"), extent.late ? MessageArgument(Count(*extent.late)) : unknown);
    add(PALPATE_TEXT("Lost ticks"), Count(extent.dropped));
    add(PALPATE_TEXT("Fingertip"), fingertipText(reader));
    add(PALPATE_TEXT("Distance that counts as touched"),
        Message(PALPATE_TEXT("%1 mm"), Rounded{facts.measures.distance_mm, 3}));
    return table;
}

Message lawOf(const session::StructureRecord& structure)
{
    const Message law =
        structure.lawTable.empty() ? Message(PALPATE_TEXT("linear")) : Message(PALPATE_TEXT("nonlinear"));
    std::vector<Message> all{law};
    if (structure.tissue.hasFriction()) {
        all.push_back({PALPATE_TEXT("with friction")});
    }
    if (!structure.maps.empty()) {
        all.push_back({PALPATE_TEXT("with maps or motion")});
    }
    return core::joined(all);
}

/// One row for all structures of the same tissue; palpable structures come first.
ReportTable tissueTable(const session::RecordingReader& reader)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("Tissue at the start of the recording")};
    table.columns = {column(PALPATE_TEXT("Structure")),
                     column(PALPATE_TEXT("Stiffness [N/mm]"), true),
                     column(PALPATE_TEXT("Damping [N·s/mm]"), true),
                     column(PALPATE_TEXT("Force law")),
                     column(PALPATE_TEXT("Layer"), true),
                     column(PALPATE_TEXT("Own surface palpable"))};
    std::vector<std::vector<std::string>> names; // of each row
    for (const bool isPalpable : {true, false}) {
        for (const session::StructureRecord& one : reader.scenes().front().structures) {
            if (one.palpable != isPalpable) {
                continue;
            }
            const std::vector<MessageArgument> row{std::string(), // names
                                                   Rounded{one.tissue.stiffness_N_per_mm, kTissueDigits},
                                                   Rounded{one.tissue.damping_Ns_per_mm, kTissueDigits},
                                                   lawOf(one),
                                                   one.layer,
                                                   isPalpable ? Message(PALPATE_TEXT("yes"))
                                                              : Message(PALPATE_TEXT("no"))};
            const auto same = std::find_if(table.rows.begin(), table.rows.end(), [&row](const auto& other) {
                return std::equal(row.begin() + 1, row.end(), other.begin() + 1,
                                  [](const auto& a, const auto& b) { return a.english == b.english; });
            });
            const auto place = static_cast<std::size_t>(same - table.rows.begin());
            if (same == table.rows.end()) {
                table.rows.push_back(row);
                names.emplace_back();
            }
            names[place].push_back(one.name);
        }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.rows[i][0] = namesText(names[i]);
    }
    return table;
}

/// Result of computing the recording again, as `session verify` prints it.
Message resimulationText(const Verification& verification)
{
    if (!verification.resimulated) {
        return {PALPATE_TEXT("Not computed again: %1."), verification.notResimulated};
    }
    const session::Resimulation& again = *verification.resimulated;
    const Count compared(again.compared);
    if (again.isSame()) {
        return {PALPATE_TEXT("Ticks computed again: %1. Every position and force is the same, bit for bit."), compared};
    }
    if (again.isWithinRounding()) {
        return {PALPATE_TEXT("Ticks computed again: %1. Of these, %2 differ by rounding: by at most %3 mm and %4 N."),
                compared, Count(again.differing), Rounded{again.farthest_mm, 2}, Rounded{again.farthest_N, 2}};
    }
    return {PALPATE_TEXT("Ticks computed again: %1. The forces differ by more than rounding: %2."), compared,
            again.beyond};
}

ReportTable fileTable(const ReportFacts& facts)
{
    const session::RecordingReader& reader = *facts.recording;
    const session::RecordingInfo& info = reader.info();
    ReportTable table;
    table.isSmall = true;
    table.caption = {PALPATE_TEXT("Recording")};
    const auto add = [&table](core::MessageText<> name, MessageArgument value) {
        table.rows.push_back({Message(name), std::move(value)});
    };
    add(PALPATE_TEXT("File"), reader.path().filename());
    add(PALPATE_TEXT("SHA-256"), facts.sha256);
    add(PALPATE_TEXT("Scene"), info.scene.empty() ? MessageArgument(Message(PALPATE_TEXT("not stated")))
                                                  : MessageArgument(std::filesystem::path(info.scene).filename()));
    if (!info.sceneSha256.empty()) {
        add(PALPATE_TEXT("SHA-256 of the scene"), info.sceneSha256);
    }
    add(PALPATE_TEXT("State"), session::endingText(reader.extent()));
    add(PALPATE_TEXT("Recorded by"), Message(PALPATE_TEXT("Palpate %1 (%2)"), info.palpate, info.build));
    add(PALPATE_TEXT("Report made by"),
        Message(PALPATE_TEXT("Palpate %1 (%2)"), session::palpateVersion(), session::buildId()));
    return table;
}

/// Surfaces with a checksum. The recording keeps those of the palpable surfaces.
ReportTable meshTable(const session::RecordingReader& reader)
{
    ReportTable table;
    table.isSmall = true;
    table.caption = {PALPATE_TEXT("Surfaces")};
    table.columns = {column(PALPATE_TEXT("Structure")), column(PALPATE_TEXT("File")),
                     column(PALPATE_TEXT("SHA-256 of the geometry, as palpated"))};
    for (const session::StructureRecord& one : reader.scenes().front().structures) {
        if (!one.source.sha256.empty()) {
            const std::string file = std::filesystem::path(one.source.mesh).filename().string();
            table.rows.push_back({readableName(one.name), nameOrDash(file), one.source.sha256});
        }
    }
    return table;
}

/// Names the surfaces without a checksum, in small print.
std::vector<std::string> unhashedNames(const session::RecordingReader& reader)
{
    std::vector<std::string> names;
    for (const session::StructureRecord& one : reader.scenes().front().structures) {
        if (one.source.sha256.empty()) {
            names.push_back(one.name);
        }
    }
    return names;
}

} // namespace

ReportSection methodSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Method")}, {}};
    section.blocks.emplace_back(paragraph(PALPATE_TEXT(
        "A hand with a haptic device, a mouse or a script palpated surface models of segmented anatomy. Forces are "
        "those of the model before any limit of the device; depths are distances between the hand and the surface. "
        "Positions and lengths are in mm in the frame LPS (x to the patient's left, y to the back, z to the head). "
        "Surfaces, and therefore distances, are as uncertain as the segmentation, about one voxel.")));
    section.blocks.emplace_back(conditionTable(facts));
    if (facts.recording->scenes().empty()) {
        section.blocks.emplace_back(paragraph(PALPATE_TEXT("The recording describes no scene.")));
    } else {
        section.blocks.emplace_back(tissueTable(*facts.recording));
    }
    return section;
}

ReportSection dataSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Data and verification")}, {}};
    const Verification& verification = facts.verification;
    section.blocks.emplace_back(verification.checksums.isOk()
                                    ? ReportText{{PALPATE_TEXT("Database intact, checksums of %1 ticks correct."),
                                                  Count(facts.recording->extent().ticks)}}
                                    : ReportText{{PALPATE_TEXT("Damaged, or changed after it was recorded: %1."),
                                                  verification.checksums.text()},
                                                 true});
    const bool isVerified = verification.resimulated && verification.resimulated->isWithinRounding();
    section.blocks.emplace_back(ReportText{resimulationText(verification), !isVerified});
    const std::vector<Message>& damaged = facts.measures.damaged;
    for (std::size_t i = 0; i < damaged.size() && i < kShownFaults; ++i) {
        section.blocks.emplace_back(ReportText{damaged[i]});
    }
    if (damaged.size() > kShownFaults) {
        section.blocks.emplace_back(
            ReportText{{PALPATE_TEXT("More damaged places: %1."), Count(damaged.size() - kShownFaults)}});
    }
    section.blocks.emplace_back(fileTable(facts));
    if (!facts.recording->scenes().empty()) {
        if (ReportTable table = meshTable(*facts.recording); !table.rows.empty()) {
            section.blocks.emplace_back(std::move(table));
        }
        if (const auto names = unhashedNames(*facts.recording); !names.empty()) {
            section.blocks.emplace_back(ReportText{
                {PALPATE_TEXT("Surfaces without a checksum, because they were not palpable: %1."), namesText(names)},
                false,
                true});
        }
    }
    return section;
}

} // namespace palpate::study::internal
