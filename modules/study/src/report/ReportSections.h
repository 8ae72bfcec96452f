// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Report.h"

#include <optional>
#include <string>

namespace palpate::study::internal {

// Sections of the report and their number formats, which are those of `session measure` and `info`.

/// Formats with a fixed number of decimals, as "%.3f".
[[nodiscard]] core::MessageArgument fixed(double value, int decimals);
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

[[nodiscard]] core::MessageArgument roundedOrDash(const std::optional<double>& value, int digits);
[[nodiscard]] core::MessageArgument nameOrDash(const std::string& name);
/// Formats a time: "2026-11-28T05:18:01Z" as "2026-11-28 05:18:01 UTC"; other texts unchanged.
[[nodiscard]] std::string readableTime(const std::string& utc);

// Tables of the findings with a place, by number; without rows if there is nothing to list.
[[nodiscard]] ReportTable findingTable(const ReportFacts& facts);
/// Findings of the scene that are not in the recording, numbered on.
[[nodiscard]] ReportTable outsideTable(const ReportFacts& facts);
[[nodiscard]] ReportTable visitTable(const ReportFacts& facts);
/// Force of each layer at the findings that were felt through several.
[[nodiscard]] ReportTable layerTable(const ReportFacts& facts);

[[nodiscard]] ReportSection lumpSection(const ReportFacts& facts);
[[nodiscard]] ReportSection methodSection(const ReportFacts& facts);
[[nodiscard]] ReportSection dataSection(const ReportFacts& facts);

} // namespace palpate::study::internal
