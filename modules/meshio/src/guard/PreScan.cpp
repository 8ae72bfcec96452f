// SPDX-License-Identifier: BSD-3-Clause
#include "guard/PreScan.h"

#include "text/Fault.h"

#include <palpate/core/Numbers.h>

#include <cctype>
#include <cmath>

namespace palpate::meshio::internal {

void noteSpace(std::string_view value, PreScan& scan)
{
    if (value == "LPS") {
        scan.frame = FileFrame::Lps;
    } else if (value == "RAS") {
        scan.frame = FileFrame::Ras;
    } else {
        scan.notes.push_back({PALPATE_TEXT("the frame SPACE=%1 is not used: expected LPS or RAS"), inQuotes(value)});
    }
}

void noteSpaceTag(std::string_view text, PreScan& scan)
{
    constexpr std::string_view kTag = "SPACE=";
    const std::size_t at = text.find(kTag);
    if (at == std::string_view::npos) {
        return;
    }
    std::string_view value = text.substr(at + kTag.size());
    std::size_t length = 0;
    while (length < value.size() && std::isalpha(static_cast<unsigned char>(value[length])) != 0) {
        ++length;
    }
    noteSpace(value.substr(0, length), scan);
}

void noteScaleTag(std::string_view text, PreScan& scan)
{
    constexpr std::string_view kTag = ";SCALE=";
    constexpr double kLeast = 1e-6, kMost = 1e6;
    const std::size_t at = text.find(kTag);
    if (at == std::string_view::npos) {
        return;
    }
    const std::string_view rest = text.substr(at + kTag.size());
    const std::string_view word = rest.substr(0, rest.find_first_not_of("0123456789+-.eE"));
    const std::optional<double> scale = core::parseNumber(word);
    if (scale && *scale >= kLeast && *scale <= kMost) {
        scan.scale = scale;
    } else {
        scan.notes.push_back(
            {PALPATE_TEXT("SCALE=%1 in the header is not used: expected %2 to %3"), inQuotes(word), kLeast, kMost});
    }
}

void noteBadVertices(std::uint64_t count, PreScan& scan)
{
    if (count == 1) {
        scan.note({PALPATE_TEXT("1 vertex without finite coordinates left out: no face uses it")});
    } else if (count > 1) {
        scan.note({PALPATE_TEXT("%1 vertices without finite coordinates left out: no face uses them"), Count(count)});
    }
}

void noteThinFaces(std::uint64_t count, PreScan& scan)
{
    if (count == 1) {
        scan.note({PALPATE_TEXT("1 face of fewer than 3 corners left out")});
    } else if (count > 1) {
        scan.note({PALPATE_TEXT("%1 faces of fewer than 3 corners left out"), Count(count)});
    }
}

void noteCrossing(std::uint64_t count, PreScan& scan)
{
    if (count == 1) {
        scan.note({PALPATE_TEXT("one polygon has no simple outline")});
    } else if (count > 1) {
        scan.note({PALPATE_TEXT("%1 polygons have no simple outline"), Count(count)});
    }
}

void noteHiddenCells(std::uint64_t count, PreScan& scan)
{
    if (count == 1) {
        scan.note({PALPATE_TEXT("1 hidden cell left out")});
    } else if (count > 1) {
        scan.note({PALPATE_TEXT("%1 hidden cells left out"), Count(count)});
    }
}

void noteTrailingBytes(std::uint64_t count, PreScan& scan)
{
    if (count == 1) {
        scan.note({PALPATE_TEXT("1 byte behind the last face left out")});
    } else if (count > 1) {
        scan.note({PALPATE_TEXT("%1 bytes behind the last face left out"), Count(count)});
    }
}

core::Status noFaces(std::uint64_t points, const core::Message& place, const ScanContext& context)
{
    return points == 0 ? fault(core::StatusCode::Empty, context.file, place, {PALPATE_TEXT("0 faces")},
                               {PALPATE_TEXT("at least one face")})
                       : fault(core::StatusCode::Empty, context.file, place,
                               {PALPATE_TEXT("0 faces, but %1 points: a point cloud"), Count(points)},
                               {PALPATE_TEXT("a surface: reconstruct one first (MeshLab: Screened Poisson)")});
}

core::Message coordinateFault(double value, double unit_mm)
{
    if (!std::isfinite(value)) {
        return {PALPATE_TEXT("a coordinate is not a finite number (%1)"), value};
    }
    if (std::abs(value) * unit_mm > kMostMm) {
        return {PALPATE_TEXT("a coordinate is farther than 10 km from the origin (%1)"), value};
    }
    return {};
}

} // namespace palpate::meshio::internal
