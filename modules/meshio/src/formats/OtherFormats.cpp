// SPDX-License-Identifier: BSD-3-Clause
#include "formats/OtherFormats.h"

#include "formats/MeshFormat.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace palpate::meshio::internal {

namespace {

using core::MessageText;

/// A format recognised by the begin of a file.
struct OtherFormat
{
    std::string_view begin;
    MessageText<> name;
    MessageText<> next;
};

constexpr MessageText<> kConvert = PALPATE_TEXT("a mesh saved as STL, PLY, OBJ or VTK (MeshLab or Blender convert it)");
constexpr MessageText<> kToFreeSurfer =
    PALPATE_TEXT("a mesh in VTK format: convert it with FreeSurfer's mris_convert to a name that ends in .vtk");

using namespace std::string_view_literals;

constexpr auto kBinary = std::to_array<OtherFormat>({
    {"\x00\x05\x16\x07"sv, PALPATE_TEXT("an AppleDouble file, in which macOS keeps the attributes of another file"),
     PALPATE_TEXT("the file of the same name without \"._\"")},
    {"\xff\xff\xff"sv, PALPATE_TEXT("a FreeSurfer surface of quadrangles, or its values"), kToFreeSurfer},
    {"\xff\xff\xfd"sv, PALPATE_TEXT("a FreeSurfer surface of quadrangles, or its values"), kToFreeSurfer},
    {"glTF"sv, PALPATE_TEXT("a glTF file"), kConvert},
    {"Kaydara FBX"sv, PALPATE_TEXT("an FBX file"), kConvert},
    {"BLENDER"sv, PALPATE_TEXT("a Blender file"), PALPATE_TEXT("a mesh exported from Blender as STL, PLY or OBJ")},
});

constexpr auto kText = std::to_array<OtherFormat>({
    {"$MeshFormat", PALPATE_TEXT("a Gmsh mesh"), PALPATE_TEXT("its surface saved as VTK or STL (Gmsh: Export)")},
    {"#VRML", PALPATE_TEXT("a VRML file"), kConvert},
    {"ISO-10303-21", PALPATE_TEXT("a STEP model"), PALPATE_TEXT("a mesh made of it (FreeCAD: Export as STL)")},
});

constexpr MessageText<> kToVolume =
    PALPATE_TEXT("a surface. As a map of stiffness, a volume is named in a scene (maps.md)");
constexpr MessageText<> kToParts = PALPATE_TEXT("the files that it names, or a name that ends in .vtm");

/// VTK files by the type of the root element.
constexpr auto kVtk = std::to_array<OtherFormat>({
    {"ImageData", PALPATE_TEXT("a volume of VTK"), kToVolume},
    {"PImageData", PALPATE_TEXT("a volume of VTK"), kToVolume},
    {"RectilinearGrid", PALPATE_TEXT("a volume of VTK"), kToVolume},
    {"PPolyData", PALPATE_TEXT("a VTK file that names the parts of a surface (.pvtp)"),
     PALPATE_TEXT("the .vtp files that it names, in a folder")},
    {"PUnstructuredGrid", PALPATE_TEXT("a VTK file that names the parts of a grid (.pvtu)"),
     PALPATE_TEXT("the .vtu files that it names, in a folder")},
    {"vtkPartitionedDataSet", PALPATE_TEXT("a VTK file that names other files (.vtpd)"), kToParts},
    {"vtkPartitionedDataSetCollection", PALPATE_TEXT("a VTK file that names other files (.vtpc)"), kToParts},
});

/// XML documents by the name of the root element.
constexpr auto kXml = std::to_array<OtherFormat>({
    {"MRML", PALPATE_TEXT("a 3D Slicer scene (MRML)"),
     PALPATE_TEXT("the files of its models, or the scene with a name that ends in .mrml")},
    {"amf", PALPATE_TEXT("an AMF file"), kConvert},
    {"COLLADA", PALPATE_TEXT("a COLLADA file"), kConvert},
    {"X3D", PALPATE_TEXT("an X3D file"), kConvert},
});

} // namespace

std::string_view rootElement(std::string_view text)
{
    while (text.starts_with('<')) {
        const bool isRoot = text.size() > 1 && text[1] != '?' && text[1] != '!';
        if (isRoot) {
            const std::size_t end = text.find_first_of(" \t\r\n/>", 1);
            return text.substr(1, end == std::string_view::npos ? end : end - 1);
        }
        const bool isComment = text.starts_with("<!--");
        const std::size_t end = isComment ? text.find("-->") : text.find('>');
        if (end == std::string_view::npos) {
            return {};
        }
        text = text.substr(end + (isComment ? 3 : 1));
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    }
    return {};
}

namespace {

/// glTF as text and other JSON documents.
bool isGltfText(std::string_view text)
{
    return text.starts_with('{') && text.find("\"asset\"") != std::string_view::npos;
}

/// A volume of FreeSurfer: the numbers 1, width, height, depth, frames and a type, each of four bytes, big-endian.
bool isMgh(std::string_view head)
{
    const auto number = [head](std::size_t i) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            value = value << 8U | static_cast<unsigned char>(head[4 * i + k]);
        }
        return value;
    };
    constexpr std::uint32_t kMostVoxels = 65536, kHighestType = 10; // along an axis
    const auto isSize = [&](std::size_t i) { return number(i) > 0 && number(i) <= kMostVoxels; };
    return head.size() >= 24 && number(0) == 1 && isSize(1) && isSize(2) && isSize(3) && isSize(4) &&
           number(5) <= kHighestType;
}

/// @return the type of a VTK file as XML; empty for other content
std::string_view rootType(std::string_view text)
{
    constexpr std::string_view kType = "type=";
    const std::string_view file = text.substr(std::min(text.find("<VTKFile"), text.size()));
    const std::string_view tag = file.substr(0, file.find('>'));
    for (std::size_t at = tag.find(kType); at != std::string_view::npos; at = tag.find(kType, at + 1)) {
        const std::size_t open = at + kType.size();
        if (tag[at - 1] != '_' && open < tag.size()) { // not of "header_type"
            return tag.substr(open + 1, tag.find(tag[open], open + 1) - open - 1);
        }
    }
    return {};
}

std::optional<OtherFormat> found(std::string_view bytes)
{
    const std::string_view head = startOf(bytes), text = startOfText(bytes), root = rootElement(text);
    for (const OtherFormat& format : kBinary) {
        if (head.starts_with(format.begin)) {
            return format;
        }
    }
    if (isMgh(head)) {
        return OtherFormat{
            {},
            PALPATE_TEXT("a volume of FreeSurfer (.mgz, .mgh)"),
            PALPATE_TEXT("a label map as NIfTI (FreeSurfer: mri_convert to a name that ends in .nii.gz)")};
    }
    const std::string_view type = root == "VTKFile" ? rootType(text) : std::string_view();
    for (const OtherFormat& format : kVtk) {
        if (type == format.begin) {
            return format;
        }
    }
    for (const OtherFormat& format : kText) {
        if (text.starts_with(format.begin)) {
            return format;
        }
    }
    for (const OtherFormat& format : kXml) {
        if (root == format.begin) {
            return format;
        }
    }
    if (isGltfText(text)) {
        return OtherFormat{{}, PALPATE_TEXT("a glTF file"), kConvert};
    }
    if (text.starts_with('{')) {
        return OtherFormat{{},
                           PALPATE_TEXT("a JSON document"),
                           PALPATE_TEXT("a mesh, or a scene of Palpate with a name that ends in .json")};
    }
    return std::nullopt;
}

} // namespace

/// DICOM begins with 128 free bytes and "DICM" (PS3.10, section 7.1). Some programs drop the free bytes, old files have
/// neither.
bool isDicom(std::string_view head, std::string_view file)
{
    constexpr std::string_view kMark = "DICM";
    constexpr std::size_t kPreamble = 128;
    constexpr std::string_view kExtension = ".dcm";
    const bool isNamed =
        file.size() > kExtension.size() && sameWord(file.substr(file.size() - kExtension.size()), kExtension);
    return isNamed || head.starts_with(kMark) ||
           (head.size() >= kPreamble && head.substr(kPreamble).starts_with(kMark));
}

core::Status dicomFault(const std::string& file, const core::Message& found)
{
    return fault(core::StatusCode::Unsupported, file, {}, found,
                 {PALPATE_TEXT("a segmentation: load the DICOM images in 3D Slicer, segment the organs and save the "
                               "segmentation as .seg.nrrd, or let TotalSegmentator make one; then open that file")});
}

core::Status otherMeshFormat(std::string_view bytes, const std::string& file)
{
    if (isDicom(bytes, file)) {
        return dicomFault(file, {PALPATE_TEXT("is a DICOM image, which Palpate does not read")});
    }
    const std::optional<OtherFormat> other = found(bytes);
    return other ? fault(core::StatusCode::Unsupported, file, {},
                         {PALPATE_TEXT("is %1, which Palpate does not read"), core::Message(other->name)},
                         core::Message(other->next))
                 : core::Status();
}

} // namespace palpate::meshio::internal
