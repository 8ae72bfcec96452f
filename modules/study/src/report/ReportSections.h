// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Report.h"

#include <optional>
#include <string>

namespace palpate::study::internal {

// Sections of the report and their number formats: as many digits as mean something to a reader. The numbers are those
// of `session measure` and `info`, which print more digits.

/// Formats with a fixed number of decimals, as "%.3f".
[[nodiscard]] core::MessageArgument fixed(double value, int decimals);
/// Formats a length with one decimal: "12.3"; "< 0.1" for a shorter one. [mm]
[[nodiscard]] core::MessageArgument lengthText(double length_mm);
[[nodiscard]] core::MessageArgument lengthText(const std::optional<double>& length_mm); ///< a dash without a value
/// Formats a force with two significant digits, zeros included, and no decimals from 10 N on: "0.64", "4.0", "12". [N]
[[nodiscard]] core::MessageArgument forceText(double force_N);
[[nodiscard]] core::MessageArgument forceText(const std::optional<double>& force_N); ///< a dash without a value
/// Formats a time with one decimal. [s]
[[nodiscard]] core::MessageArgument timeText(double time_s);
/// Formats a place: "84.7 33.0 373.3". [mm]
[[nodiscard]] core::Message placeText(const core::Vec3& p_W);
/// Lists the readable names of structures, the first `most` of them: "liver, tumour and 3 more".
[[nodiscard]] core::MessageArgument namesText(const std::vector<std::string>& names, std::size_t most = 40);
/// Formats a percentage with its sign, as "%+.3g %%"; a dash without a value.
[[nodiscard]] core::MessageArgument percent(const std::optional<double>& value);
/// Makes a column. @param isNumber  right-aligned
[[nodiscard]] inline ReportTable::Column column(core::MessageText<> heading, bool isNumber = false)
{
    return {core::Message(heading), isNumber};
}
/// Makes a paragraph.
[[nodiscard]] inline ReportText paragraph(core::MessageText<> text)
{
    return {core::Message(text), false};
}
/// Placeholder for a missing value.
[[nodiscard]] core::MessageArgument dash();

[[nodiscard]] core::MessageArgument nameOrDash(const std::string& name);
[[nodiscard]] core::MessageArgument structureOrDash(const std::string& name); ///< readable
/// Formats a time: "2026-11-28T05:18:01Z" as "2026-11-28 05:18:01 UTC"; other texts unchanged.
[[nodiscard]] std::string readableTime(const std::string& utc);

// Tables of the findings with a place, by number; without rows if there is nothing to list.
[[nodiscard]] ReportTable findingTable(const ReportFacts& facts);
/// Findings of the scene that are not in the recording, numbered on.
[[nodiscard]] ReportTable outsideTable(const ReportFacts& facts);
[[nodiscard]] ReportTable visitTable(const ReportFacts& facts);
/// Force of each layer at the findings that were felt through several.
[[nodiscard]] ReportTable layerTable(const ReportFacts& facts);

/// Distances that the user measured; without blocks if there are none.
[[nodiscard]] ReportSection tapeSection(const ReportFacts& facts);
/// Least distances and margins of the structures that matter for what was done.
[[nodiscard]] ReportSection distanceSection(const ReportFacts& facts);
[[nodiscard]] ReportSection sizeSection(const ReportFacts& facts);
[[nodiscard]] ReportSection lumpSection(const ReportFacts& facts);
[[nodiscard]] ReportSection methodSection(const ReportFacts& facts);
[[nodiscard]] ReportSection dataSection(const ReportFacts& facts);

} // namespace palpate::study::internal
