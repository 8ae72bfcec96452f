// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

enum class VtpFormat : std::uint8_t
{
    Ascii,
    Binary,
    Appended
};
enum class VtpCompressor : std::uint8_t
{
    None,
    ZLib,
    Lz4,
    Lzma
};

/// Declaration of a DataArray element.
struct VtpDataArray
{
    std::string name;
    std::string type; ///< "Float32", "Int64", … "String"
    std::uint64_t components = 1;
    std::optional<std::uint64_t> tuples; ///< NumberOfTuples, in field data
    VtpFormat format = VtpFormat::Ascii;
    std::uint64_t offset = 0; ///< into the appended data
    QByteArray text;          ///< inline content
    std::uint64_t line = 0;
};

/// Pair of arrays (connectivity and offsets) that define cells.
struct VtpCells
{
    std::uint64_t count = 0;
    std::optional<VtpDataArray> connectivity;
    std::optional<VtpDataArray> offsets;
};

struct VtpPiece
{
    std::uint64_t points = 0;
    VtpCells verts, lines, strips, polys;
    VtpCells cells;                    ///< of an unstructured grid
    std::optional<VtpDataArray> types; ///< of these cells
    std::optional<VtpDataArray> coordinates;
    std::vector<VtpDataArray> pointData;
    std::vector<VtpDataArray> cellData;
    std::string extent;  ///< attribute of a piece of an image
    std::string scalars; ///< attribute of its point data
    std::uint64_t line = 0;
};

/// Attributes of an image, as text; empty if absent.
struct VtpImage
{
    std::string extent, origin, spacing, direction;
};

/// Content of the XML of a VTP file, without the appended data.
struct VtpHeader
{
    bool isBigEndian = false;
    bool hasWideHeaders = false; ///< block headers are 64-bit
    VtpCompressor compressor = VtpCompressor::None;
    std::vector<VtpDataArray> fieldData;
    std::vector<VtpPiece> pieces;
    VtpImage image;
    bool isAppendedBase64 = false;
    std::string_view appended;       ///< content after the underscore, up to the end of the file
    std::uint64_t appendedBegin = 0; ///< [bytes]
};

/// Type of the VTK files of unstructured grids, `.vtu`.
inline constexpr std::string_view kGridType = "UnstructuredGrid";
/// Type of the VTK files of images, `.vti`.
inline constexpr std::string_view kImageType = "ImageData";

/// Reads the XML; a document type, another kind of VTK file, deep nesting and counts that are not whole numbers are
/// errors.
[[nodiscard]] core::Result<VtpHeader> readVtpHeader(std::string_view bytes, const ScanContext& context,
                                                    std::string_view type = "PolyData");

} // namespace palpate::meshio::internal
