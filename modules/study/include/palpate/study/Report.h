// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/ReportFacts.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace palpate::study {

// Content of the report of a session, independent of the file format. Texts are translatable messages; table cells are
// names, numbers or messages. `ui/ReportFile.h` writes it. resources/docs/report.md describes the content.

/// Number of findings that get a picture; the others have a row in the table only.
inline constexpr std::size_t kReportedPictures = 24;

/// Largest number of rows of the tables of distances and of margins, and of the table of sizes: about a third of a page
/// each. What is left out is counted in a sentence.
inline constexpr std::size_t kReportedPairs = 16;

/// Paragraph.
struct ReportText
{
    core::Message text;
    bool isWarning = false; ///< emphasized
    bool isSmall = false;   ///< small print
};

/// Table. The first cell of a row is the heading of the row.
struct ReportTable
{
    struct Column
    {
        core::Message heading;
        bool isNumber = false; ///< right-aligned
    };
    core::Message caption;
    std::vector<Column> columns; ///< empty: two columns without headings, name and value
    std::vector<std::vector<core::MessageArgument>> rows;
    bool isSmall = false; ///< small print
};

/// Colours of the touched surfaces, with a legend in the picture.
struct ReportMap
{
    enum class Quantity
    {
        Dwell,    ///< time spent [s]
        PeakForce ///< [N]
    };
    Quantity quantity = Quantity::Dwell;
    double end = 1.0;                  ///< value of the last colour, see session::mapEnd
    std::vector<core::Message> legend; ///< title with the unit, then further lines
};
/// Returns the values of a map at the vertices of a touched surface; 0: not touched.
[[nodiscard]] PALPATE_EXPORT std::vector<float> mapValues(const session::TouchedSurface& surface,
                                                          ReportMap::Quantity quantity);

/// Direction of a picture of the scene.
struct ReportView
{
    enum class From
    {
        Front,
        Left,
        Finding ///< where the examiner looked from when marking, otherwise from outside onto the place
    };
    From from = From::Front;
    std::size_t finding = 0;          ///< index in `Report::places`
    std::optional<std::size_t> map{}; ///< index in `Report::maps`; empty: the structures in their own colours
};

/// Picture with a caption.
struct ReportPicture
{
    std::size_t view = 0; ///< index in `Report::views`
    core::Message caption;
    core::Message description; ///< content for readers who cannot see the picture
};

/// Pictures of one size, side by side.
struct ReportPictures
{
    std::vector<ReportPicture> pictures;
};

/// Curve of the force.
struct ReportCurve
{
    ForceCurve force;
    core::Message caption;
    core::Message description; ///< as for ReportPicture
};

using ReportBlock = std::variant<ReportText, ReportTable, ReportPictures, ReportCurve>;

struct ReportSection
{
    core::Message heading; ///< empty: the head of the report, below the title
    std::vector<ReportBlock> blocks;
};

struct Report
{
    core::Message title;
    core::Message notice; ///< on every page
    std::string subject;  ///< name of the case, or of the recording; beside the page number
    std::vector<ReportSection> sections;
    std::vector<core::Finding> places; ///< findings with a place, by number
    std::vector<ReportMap> maps;
    std::vector<ReportView> views;
};

/// Composes the report.
/// @param unpictured  why there are no pictures; empty: there are
[[nodiscard]] PALPATE_EXPORT Report composeReport(const ReportFacts& facts, const core::Message& unpictured = {});

} // namespace palpate::study
