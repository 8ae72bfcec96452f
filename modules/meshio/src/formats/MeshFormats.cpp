// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFormats.h"

#include "formats/MeshFormat.h"
#include "text/Fault.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::meshio {

namespace internal {

namespace {

using core::Result;
using core::StatusCode;

std::string lowered(std::string_view text)
{
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

bool hasExtension(const MeshFormat& format, const std::filesystem::path& path)
{
    const std::string name = lowered(path.filename().string());
    return std::ranges::any_of(format.extensions, [&name](std::string_view extension) {
        return name.size() > extension.size() && name.ends_with(extension);
    });
}

bool isWebPage(std::string_view bytes)
{
    const std::string text = lowered(startOfText(bytes));
    return text.starts_with('<') && (text.find("<html") != std::string::npos || text.starts_with("<!doctype html"));
}

/// Identifies files of other kinds for the error message.
std::string_view otherFormat(std::string_view head)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kMagic{{
        {"glTF", "a glTF file"},
        {"PK\x03\x04", "a ZIP archive"},
        {"\x1f\x8b", "a gzip file"},
        {"\x89PNG", "a PNG image"},
        {"%PDF", "a PDF document"},
        {"SQLite format 3", "an SQLite database (a recording?)"},
    }};
    for (const auto& [magic, name] : kMagic) {
        if (head.starts_with(magic)) {
            return name;
        }
    }
    return head.size() > 132 && head.substr(128, 4) == "DICM" ? "a DICOM file" : "";
}

} // namespace

std::span<const MeshFormat* const> formatTable()
{
    // OBJ last: the format has no signature, only words that may begin a line.
    static constexpr std::array<const MeshFormat*, 8> kTable{&kStl,  &kVtp,   &kPly,       &kLegacyVtk,
                                                             &kNrrd, &kNifti, &kMetaImage, &kObj};
    return kTable;
}

std::string_view startOf(std::string_view bytes)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    std::string_view head = bytes.substr(0, 4096);
    if (head.starts_with(kByteOrderMark)) {
        head.remove_prefix(kByteOrderMark.size());
    }
    return head;
}

std::string_view startOfText(std::string_view bytes)
{
    const std::string_view head = startOf(bytes);
    return head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
}

Result<const MeshFormat*> formatOf(std::string_view bytes, const std::filesystem::path& path)
{
    const auto refused = [&](StatusCode code, std::string_view found) {
        return fault(code, path.filename().string(), "byte 0", found, "an " + meshFormatNames("or") + " mesh");
    };
    if (bytes.empty()) {
        return refused(StatusCode::Empty, "the file is empty");
    }
    if (isWebPage(bytes)) {
        return refused(StatusCode::BadFormat, "a web page (HTML), perhaps a failed download");
    }
    for (const MeshFormat* format : formatTable()) {
        if (format->looksLike(bytes)) {
            return format;
        }
    }
    if (startOf(bytes).starts_with("version https://git-lfs")) {
        return refused(StatusCode::BadFormat,
                       "a Git LFS pointer, not the file itself (fetch it with \"git lfs pull\")");
    }
    if (const std::string_view other = otherFormat(startOf(bytes)); !other.empty()) {
        return fault(StatusCode::Unsupported, path.filename().string(), "",
                     "is " + std::string(other) + ", which Palpate does not read",
                     "an " + meshFormatNames("or") + " mesh: save it as one of these");
    }
    // Damaged files: the check of the format reports the error.
    for (const MeshFormat* format : formatTable()) {
        if (format->isToldByExtension && hasExtension(*format, path)) {
            return format;
        }
    }
    return refused(StatusCode::BadFormat, "the content is no known mesh format");
}

} // namespace internal

std::vector<std::string> meshExtensions()
{
    std::vector<std::string> all;
    for (const internal::MeshFormat* format : internal::formatTable()) {
        all.insert(all.end(), format->extensions.begin(), format->extensions.end());
    }
    return all;
}

bool hasMeshExtension(const std::filesystem::path& path)
{
    return std::ranges::any_of(internal::formatTable(), [&](const internal::MeshFormat* format) {
        return internal::hasExtension(*format, path);
    });
}

bool hasLabelMapExtension(const std::filesystem::path& path)
{
    return std::ranges::any_of(internal::formatTable(), [&](const internal::MeshFormat* format) {
        return format->surfaces != nullptr && internal::hasExtension(*format, path);
    });
}

std::string meshFormatNames(std::string_view conjunction)
{
    const std::span<const internal::MeshFormat* const> table = internal::formatTable();
    std::string names;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const bool isLast = i + 1 == table.size();
        if (i > 0) {
            names.append(isLast ? " " : ", ").append(isLast ? conjunction : "").append(isLast ? " " : "");
        }
        names += table[i]->name;
    }
    return names;
}

} // namespace palpate::meshio
