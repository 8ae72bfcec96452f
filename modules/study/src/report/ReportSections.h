// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Report.h"

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

[[nodiscard]] ReportSection lumpSection(const ReportFacts& facts);
[[nodiscard]] ReportSection methodSection(const ReportFacts& facts);
[[nodiscard]] ReportSection dataSection(const ReportFacts& facts);

} // namespace palpate::study::internal
