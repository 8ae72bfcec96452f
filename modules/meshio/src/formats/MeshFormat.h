// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"
#include "guard/TriangleSoup.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

class vtkAlgorithm;
template<class T>
class vtkSmartPointer;

namespace palpate::meshio::internal {

/// Interface of a mesh format to the rest of meshio; one source file in this folder per format.
struct MeshFormat
{
    std::string_view name;                        ///< for users, "STL"
    std::span<const std::string_view> extensions; ///< in lower case, ".stl"; the first is the usual one
    /// The extension decides when the content is ambiguous.
    bool isToldByExtension;
    /// @param bytes  content of the whole file, not empty
    /// @return true if the content is of this format, valid or damaged
    bool (*looksLike)(std::string_view bytes);
    /// Checks all bytes before VTK reads them: counts against the available bytes, and every number and index that
    /// VTK's reader would trust. Where VTK misreads valid content, the image is rewritten, with the reason at that
    /// place.
    core::Result<PreScan> (*guard)(FileImage& image, const ScanContext& context);
    /// @return VTK's reader, configured for the file at `path` by the results of `scan`
    vtkSmartPointer<vtkAlgorithm> (*reader)(const std::string& path, const PreScan& scan);
    /// Instead of the previous two, for formats that meshio reads itself: checks the bytes and makes the surfaces, in
    /// the axes and units of the file. A label map hands its surfaces to `context.takeStructure` instead and returns an
    /// empty soup. @param scan  receives format, frame, voxels and notes
    core::Result<TriangleSoup> (*surfaces)(const FileImage& image, const ScanContext& context, PreScan& scan) = nullptr;
    bool isLabelMap = false; ///< a volume
};

extern const MeshFormat kStl;
extern const MeshFormat kVtp;
extern const MeshFormat kVtu;
extern const MeshFormat kPly;
extern const MeshFormat kLegacyVtk;
extern const MeshFormat kOff;
extern const MeshFormat kFreeSurferSurface;
extern const MeshFormat kGifti;
extern const MeshFormat kMniObject;
extern const MeshFormat kNrrd;
extern const MeshFormat kNifti;
extern const MeshFormat kMetaImage;
extern const MeshFormat kObj;

/// All formats that can be opened, in the order of detection.
[[nodiscard]] std::span<const MeshFormat* const> formatTable();

/// Detects the format of a file from the content; the extension decides only if the content is ambiguous.
/// @return an error that names the actual content: empty, a web page, a Git LFS pointer, another known format
[[nodiscard]] core::Result<const MeshFormat*> formatOf(std::string_view bytes, const std::filesystem::path& path);

/// The first bytes of a file, as many as format detection needs, without a byte order mark.
[[nodiscard]] std::string_view startOf(std::string_view bytes);
/// Same without leading blanks and empty lines.
[[nodiscard]] std::string_view startOfText(std::string_view bytes);

} // namespace palpate::meshio::internal
