// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/Surface.h"

#include "palpate/igtl/Messages.h"

#include <algorithm>
#include <cmath>

namespace palpate::igtl {

using core::Result;
using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kCounts = 10;
constexpr std::size_t kWord_bytes = 4;
constexpr std::size_t kPoint_bytes = 3 * kWord_bytes;

/// Cells of one kind: each is a number of corners, followed by the corners.
struct Cells
{
    std::uint64_t count = 0;
    std::uint64_t size_bytes = 0;
};

Status badCells(const char* kind, std::uint64_t found_bytes, std::uint64_t cells)
{
    return {StatusCode::BadFormat, PALPATE_TEXT("POLYDATA: %1: found %2 bytes for %3 cells"), kind,
            core::Count(found_bytes), core::Count(cells)};
}

/// Reads cells and calls `take(corners)` for each, after all their indices were checked.
template<class Take>
Status readCells(ByteView bytes, std::uint64_t count, std::size_t points, const char* kind, Take take)
{
    FieldReader fields(bytes);
    std::vector<std::uint32_t> corners;
    for (std::uint64_t cell = 0; cell < count; ++cell) {
        if (fields.left() < kWord_bytes) {
            return badCells(kind, bytes.size(), count);
        }
        const auto length = static_cast<std::size_t>(fields.number(kWord_bytes));
        if (length > fields.left() / kWord_bytes) {
            return badCells(kind, bytes.size(), count);
        }
        corners.resize(length);
        for (std::uint32_t& corner : corners) {
            corner = static_cast<std::uint32_t>(fields.number(kWord_bytes));
            if (corner >= points) {
                return {StatusCode::BadFormat,
                        PALPATE_TEXT("POLYDATA: %1: cell %2 has point %3, expected less than %4"),
                        kind,
                        core::Count(cell + 1),
                        core::Count(corner),
                        core::Count(points)};
            }
        }
        take(corners);
    }
    return fields.left() == 0 ? Status() : badCells(kind, bytes.size(), count);
}

} // namespace

Result<Surface> decodeSurface(ByteView content)
{
    if (content.size() < kCounts * kWord_bytes) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: found %2 bytes, expected %3"), "POLYDATA",
                      core::Count(content.size()), core::Count(kCounts * kWord_bytes));
    }
    FieldReader fields(content);
    const std::uint64_t points = fields.number(kWord_bytes);
    std::array<Cells, 4> kinds; // vertices, lines, polygons, strips
    std::uint64_t needed_bytes = kCounts * kWord_bytes + points * kPoint_bytes;
    for (Cells& cells : kinds) {
        cells.count = fields.number(kWord_bytes);
        cells.size_bytes = fields.number(kWord_bytes);
        needed_bytes += cells.size_bytes;
        if (cells.count > cells.size_bytes / kWord_bytes) {
            return badCells("counts", cells.size_bytes, cells.count);
        }
    }
    fields.skip(kWord_bytes); // number of attributes, which follow the cells
    if (needed_bytes > content.size()) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: found %2 bytes, expected %3"), "POLYDATA",
                      core::Count(content.size()), core::Count(needed_bytes));
    }

    Surface surface;
    surface.points.resize(static_cast<std::size_t>(points));
    for (std::array<float, 3>& point : surface.points) {
        for (float& number : point) {
            number = fields.real32();
            if (!(std::abs(number) <= static_cast<float>(kMaxCoordinate_mm))) {
                return Status(StatusCode::BadFormat,
                              PALPATE_TEXT("POLYDATA: point %1: expected numbers within 1,000,000 mm"),
                              core::Count(&point - surface.points.data() + 1));
            }
        }
    }
    surface.vertices = static_cast<std::uint32_t>(kinds[0].count);
    surface.lines = static_cast<std::uint32_t>(kinds[1].count);
    fields.skip(static_cast<std::size_t>(kinds[0].size_bytes + kinds[1].size_bytes));

    const auto begin = content.size() - fields.left();
    const auto polygon_bytes = static_cast<std::size_t>(kinds[2].size_bytes);
    Status status = readCells(content.subspan(begin, polygon_bytes), kinds[2].count, surface.points.size(), "polygons",
                              [&surface](const std::vector<std::uint32_t>& corners) {
                                  for (std::size_t i = 2; i < corners.size(); ++i) {
                                      surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
                                  }
                              });
    if (status.isOk()) {
        status = readCells(
            content.subspan(begin + polygon_bytes, static_cast<std::size_t>(kinds[3].size_bytes)), kinds[3].count,
            surface.points.size(), "triangle strips", [&surface](const std::vector<std::uint32_t>& corners) {
                for (std::size_t i = 2; i < corners.size(); ++i) { // every second one runs backwards
                    const std::size_t odd = i % 2;
                    surface.triangles.push_back({corners[i - 2 + odd], corners[i - 1 - odd], corners[i]});
                }
            });
    }
    if (!status.isOk()) {
        return status;
    }
    if (surface.triangles.empty()) {
        return Status(StatusCode::Empty, PALPATE_TEXT("POLYDATA: found no triangle"));
    }
    return surface;
}

Bytes encodeSurface(const Surface& surface)
{
    FieldWriter fields;
    fields.number(surface.points.size(), kWord_bytes);
    fields.zeros(4 * kWord_bytes); // vertices and lines
    fields.number(surface.triangles.size(), kWord_bytes);
    fields.number(surface.triangles.size() * 4 * kWord_bytes, kWord_bytes);
    fields.zeros(3 * kWord_bytes); // strips and attributes
    for (const std::array<float, 3>& point : surface.points) {
        for (const float number : point) {
            fields.real32(static_cast<double>(number));
        }
    }
    for (const std::array<std::uint32_t, 3>& triangle : surface.triangles) {
        fields.number(triangle.size(), kWord_bytes);
        for (const std::uint32_t corner : triangle) {
            fields.number(corner, kWord_bytes);
        }
    }
    return std::move(fields).bytes();
}

} // namespace palpate::igtl
