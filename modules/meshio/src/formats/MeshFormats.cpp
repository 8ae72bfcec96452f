// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFormats.h"

#include "formats/MeshFormat.h"
#include "formats/OtherFormats.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <algorithm>
#include <array>

namespace palpate::meshio {

namespace internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::string_view kPacked = ".gz";

bool hasExtension(const MeshFormat& format, const std::filesystem::path& path)
{
    std::string name = lowerCase(path.filename().string());
    if (!format.isLabelMap && name.ends_with(kPacked)) {
        name.resize(name.size() - kPacked.size());
    }
    return std::ranges::any_of(format.extensions, [&name](std::string_view extension) {
        return name.size() > extension.size() && name.ends_with(extension);
    });
}

bool isWebPage(std::string_view bytes)
{
    const std::string text = lowerCase(startOfText(bytes));
    return text.starts_with('<') && (text.find("<html") != std::string::npos || text.starts_with("<!doctype html"));
}

/// Identifies files of other kinds for the error message.
core::Message otherFormat(std::string_view head)
{
    struct Magic
    {
        std::string_view begin;
        core::MessageText<> name;
    };
    static constexpr std::array<Magic, 4> kMagic{{
        {"PK\x03\x04", PALPATE_TEXT("a ZIP archive")},
        {"\x89PNG", PALPATE_TEXT("a PNG image")},
        {"%PDF", PALPATE_TEXT("a PDF document")},
        {"SQLite format 3", PALPATE_TEXT("an SQLite database (a recording?)")},
    }};
    for (const auto& [begin, name] : kMagic) {
        if (head.starts_with(begin)) {
            return {name};
        }
    }
    return {};
}

/// @return "STL, VTP, PLY"
std::string listOfFormats()
{
    std::string names;
    for (const MeshFormat* format : formatTable()) {
        names.append(names.empty() ? "" : ", ").append(format->name);
    }
    return names;
}

} // namespace

std::span<const MeshFormat* const> formatTable()
{
    // GIFTI and VTU before VTP, which takes any XML to name the error. OBJ last: the format has no signature, only
    // words that may begin a line.
    static constexpr std::array<const MeshFormat*, 13> kTable{
        &kStl,  &kVtu,   &kGifti,     &kVtp,       &kPly, &kLegacyVtk, &kOff, &kFreeSurferSurface,
        &kNrrd, &kNifti, &kMetaImage, &kMniObject, &kObj};
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
    const auto refused = [&](StatusCode code, const core::Message& found) {
        return fault(code, utf8Of(path.filename().string()), onByte(0), found,
                     {PALPATE_TEXT("a mesh in one of the formats %1"), listOfFormats()});
    };
    if (bytes.empty()) {
        return refused(StatusCode::Empty, {PALPATE_TEXT("the file is empty")});
    }
    if (isWebPage(bytes)) {
        return refused(StatusCode::BadFormat, {PALPATE_TEXT("a web page (HTML), perhaps a failed download")});
    }
    // The header of a binary STL may contain anything, and label maps may be compressed by gzip.
    const Status unread = kStl.looksLike(bytes) || hasLabelMapExtension(path)
                              ? Status()
                              : otherMeshFormat(bytes, utf8Of(path.filename().string()));
    if (!unread.isOk()) {
        return unread;
    }
    for (const MeshFormat* format : formatTable()) {
        if (format->looksLike(bytes)) {
            return format;
        }
    }
    if (startOf(bytes).starts_with("version https://git-lfs")) {
        return refused(StatusCode::BadFormat,
                       {PALPATE_TEXT("a Git LFS pointer, not the file itself (fetch it with `git lfs pull`)")});
    }
    if (const core::Message other = otherFormat(startOf(bytes)); !other.isEmpty()) {
        return fault(StatusCode::Unsupported, utf8Of(path.filename().string()), {},
                     {PALPATE_TEXT("is %1, which Palpate does not read"), other},
                     {PALPATE_TEXT("a mesh saved in one of the formats %1"), listOfFormats()});
    }
    // Damaged files: the check of the format reports the error.
    for (const MeshFormat* format : formatTable()) {
        if (format->isToldByExtension && hasExtension(*format, path)) {
            return format;
        }
    }
    return refused(StatusCode::BadFormat, {PALPATE_TEXT("the content is no known mesh format")});
}

} // namespace internal

std::vector<std::string> meshExtensions()
{
    std::vector<std::string> all;
    for (const internal::MeshFormat* format : internal::formatTable()) {
        all.insert(all.end(), format->extensions.begin(), format->extensions.end());
    }
    for (const internal::MeshFormat* format : internal::formatTable()) {
        for (const std::string_view extension :
             format->isLabelMap ? std::span<const std::string_view>() : format->extensions) {
            all.push_back(std::string(extension) + std::string(internal::kPacked));
        }
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
        return format->isLabelMap && internal::hasExtension(*format, path);
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
