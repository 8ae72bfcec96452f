// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/study/Report.h>

#include <QByteArray>
#include <QImage>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace palpate::ui {

/// File format of a report.
enum class ReportFormat : std::uint8_t
{
    Pdf, ///< for printing and archives; PDF/A-1b
    Html ///< one self-contained file with headings, tables and descriptions of the pictures, for screen readers
};
/// Returns the format of a file name: *.pdf, *.html or *.htm. @return std::nullopt for another name
[[nodiscard]] PALPATE_EXPORT std::optional<ReportFormat> reportFormatOf(const std::filesystem::path& path);

/// Formats a report in the language of the window. Names are escaped; control characters are shown as escapes.
/// @param pictures  from `ReportViews`, in the order of `Report::views`; a null picture leaves its caption alone
/// @par Thread Any thread with a QGuiApplication.
[[nodiscard]] PALPATE_EXPORT QByteArray reportHtml(const study::Report& report, const std::vector<QImage>& pictures);
[[nodiscard]] PALPATE_EXPORT QByteArray reportPdf(const study::Report& report, const std::vector<QImage>& pictures);

/// Writes a report atomically. @return BadCommandLine for a name without a known extension, or the error of writing
[[nodiscard]] PALPATE_EXPORT core::Status writeReport(const std::filesystem::path& path, const study::Report& report,
                                                      const std::vector<QImage>& pictures);

} // namespace palpate::ui
