// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileImage.h"

#include "palpate/meshio/MeshFile.h"

#include <palpate/core/Types.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// What is known of a mesh file before VTK sees it, so that VTK cannot be surprised and cannot silently leave
/// something out.
struct PreScan
{
    std::string format;
    FileFrame frame = FileFrame::Untagged;
    std::optional<double> scale; ///< units of the file for a mm, where it says so
    std::uint64_t points = 0;    ///< that the reader must give back
    std::uint64_t cells = 0;     ///< polygons and strips that the reader must give back
    /// The points as the file has them, where VTK's reader would round them to floats; empty where it does not.
    std::vector<core::Vec3> exactPoints;
    /// Names of the parts, and one entry a polygon: its part. Both empty when the content has no parts, or when VTK's
    /// own arrays say them (VTP).
    std::vector<std::string> partNames;
    std::vector<std::uint32_t> partOfCell;
    /// Arrays of one number a point, or a polygon, that the reader shall give (VTP).
    std::vector<std::string> pointArrays, cellArrays;
    std::vector<std::string> notes; ///< what was ignored or assumed, one sentence an entry
    std::string loss;               ///< what was cut off, "place: what is missing"
};

/// How a pre-scan names the file and reads its numbers.
struct ScanContext
{
    std::string file;                      ///< name in messages
    double unit_mm = 1.0;                  ///< for the limit on coordinates
    FileFrame frame = FileFrame::Untagged; ///< chosen, whatever the tag says
    bool isPartial = false;                ///< keep what is whole of a file that was cut off
    /// Told the share of the bytes done; false cancels. May be empty.
    std::function<bool(double)> progress;
};

/// Arrays of one kind, points' or polygons', that come with a mesh: more are left out and noted.
inline constexpr std::size_t kMostArrays = 16;
inline constexpr double kMostMm = 1e7; ///< largest coordinate [mm]
/// Points and cells of a file: indices are 32-bit inside.
inline constexpr std::uint64_t kMostElements = std::numeric_limits<std::int32_t>::max();

/// Looks for 3D Slicer's `SPACE=LPS` or `SPACE=RAS` in a header or comment and keeps it in `scan`.
void noteSpaceTag(std::string_view text, PreScan& scan);
/// Looks for 3D Slicer's `SCALE=` in the header of an STL, the factor that it wrote the millimetres with.
void noteScaleTag(std::string_view text, PreScan& scan);
/// As `noteSpaceTag`, for the tag's value alone.
void noteSpace(std::string_view value, PreScan& scan);

/// @return an empty text when `value` may be a coordinate, else what is wrong with it
[[nodiscard]] std::string coordinateFault(double value, double unit_mm);

} // namespace palpate::meshio::internal
