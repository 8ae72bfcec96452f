// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/FileImage.h"

#include "palpate/meshio/MeshFile.h"

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/Staircase.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// Facts about a mesh file that the guard determines before VTK reads the file, so that VTK cannot fail unexpectedly or
/// skip content silently.
struct PreScan
{
    std::string format;
    FileFrame frame = FileFrame::Untagged; ///< the user's choice, regardless of the tag
    std::optional<double> scale;           ///< file units per mm, if stated in the file
    std::uint64_t points = 0;              ///< expected from the reader
    std::uint64_t cells = 0;               ///< polygons and strips expected from the reader
    /// Points in double precision where VTK's reader would round to floats; otherwise empty.
    std::vector<core::Vec3> exactPoints;
    /// Names of the parts, and the part of each polygon. Both empty without parts, or when VTK's own arrays contain the
    /// parts (VTP).
    std::vector<std::string> partNames;
    std::vector<std::uint32_t> partOfCell;
    /// Colours of the parts (0 to 1), or of the whole file if it has no parts; may be empty.
    std::vector<std::optional<std::array<double, 3>>> partColours;
    std::vector<double> partOpacities; ///< as partColours, 0 to 1
    std::vector<bool> hiddenCells;     ///< of the polygons and strips, if the guard has dropped VTK's array; or empty
    /// Scalar point and polygon arrays expected from the reader (VTP).
    std::vector<std::string> pointArrays, cellArrays;
    std::vector<core::Message> notes; ///< ignored or assumed content, one sentence per entry
    core::Message loss;               ///< truncated part, "place: missing content"
    /// Voxels of a label map, in the axes and units of the file.
    std::optional<geometry::Staircase> voxels;

    void note(const core::Message& sentence) { notes.push_back(sentence); }
};

struct TriangleSoup;

/// File name for messages and number conventions of a pre-scan.
struct ScanContext
{
    std::string file;                      ///< name in messages
    std::filesystem::path path{};          ///< of the file, for files beside it
    double unit_mm = 1.0;                  ///< for the limit on coordinates
    FileFrame frame = FileFrame::Untagged; ///< chosen by the user, overrides the tag
    bool isPartial = false;                ///< keep the complete elements of a truncated file
    /// Progress callback (0 to 1, by bytes). Return false to cancel. May be empty.
    std::function<bool(double)> progress;
    /// Takes the structures of a label map one by one, each as a soup of one part with its final name; format, frame
    /// and voxels in the pre-scan are set before the first. An error ends the reading.
    std::function<core::Status(const TriangleSoup& one)> takeStructure;
};

/// Limit per kind (point or polygon arrays); further arrays are skipped with a note.
inline constexpr std::size_t kMostArrays = 16;
inline constexpr double kMostMm = 1e7; ///< largest coordinate [mm]
/// Points and cells of a file: indices are 32-bit inside.
inline constexpr std::uint64_t kMostElements = std::numeric_limits<std::int32_t>::max();

/// Stores 3D Slicer's `SPACE=LPS` or `SPACE=RAS` from a header or comment in `scan`.
void noteSpaceTag(std::string_view text, PreScan& scan);
/// Stores 3D Slicer's `SCALE=` from the header of an STL, the factor applied to the millimetres on writing.
void noteScaleTag(std::string_view text, PreScan& scan);
/// Notes vertices without usable coordinates that no face uses.
void noteBadVertices(std::uint64_t count, PreScan& scan);
/// Notes polygons with fewer than three corners, which are left out.
void noteThinFaces(std::uint64_t count, PreScan& scan);
/// Notes polygons whose outline crosses itself.
void noteCrossing(std::uint64_t count, PreScan& scan);
/// Notes cells that VTK's ghost array hides, which are left out.
void noteHiddenCells(std::uint64_t count, PreScan& scan);
/// Notes bytes behind the last element, which are left out.
void noteTrailingBytes(std::uint64_t count, PreScan& scan);
/// Same as `noteSpaceTag` for the value of the tag.
void noteSpace(std::string_view value, PreScan& scan);

/// @return the error of a file without faces, which names a point cloud as one
[[nodiscard]] core::Status noFaces(std::uint64_t points, const core::Message& place, const ScanContext& context);

/// @return empty for a valid coordinate, or else the error
[[nodiscard]] core::Message coordinateFault(double value, double unit_mm);

} // namespace palpate::meshio::internal
