// SPDX-License-Identifier: BSD-3-Clause
#include "FileKind.h"

#include "Fault.h"
#include "TextScan.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::string_view kExpected = "an STL, VTP, OBJ or PLY mesh";

std::string lowered(std::string_view text)
{
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

bool isExactBinaryStl(std::string_view bytes)
{
    if (bytes.size() < 84) {
        return false;
    }
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof(count));
    return count > 0 && 84 + std::uint64_t{count} * 50 == bytes.size();
}

/// True when the first lines of text read like an OBJ's.
bool looksLikeObj(std::string_view head)
{
    static constexpr std::array<std::string_view, 12> kWords{"v", "vn",     "vt",     "f", "o", "g",
                                                             "s", "mtllib", "usemtl", "l", "p", "vp"};
    LineReader lines(head);
    while (lines.next()) {
        std::string_view rest = lines.line();
        const std::string_view word = takeWord(rest);
        if (word.empty() || word.front() == '#') {
            continue;
        }
        return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    }
    return false;
}

/// Names a file that is something else.
std::string_view otherFormat(std::string_view head)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kMagic{{
        {"# vtk DataFile", "a legacy VTK file (.vtk)"},
        {"glTF", "a glTF file"},
        {"PK\x03\x04", "a ZIP archive"},
        {"\x1f\x8b", "a gzip file"},
        {"NRRD", "an NRRD image"},
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

Result<FileKind> fileKind(std::string_view bytes, const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    const std::string extension = lowered(path.extension().string());
    const auto refused = [&](StatusCode code, std::string_view found) {
        return fault(code, file, "byte 0", found, kExpected);
    };
    if (bytes.empty()) {
        return refused(StatusCode::Empty, "the file is empty");
    }
    std::string_view head = bytes.substr(0, 4096);
    if (head.starts_with("\xef\xbb\xbf")) { // byte order mark
        head.remove_prefix(3);
    }
    if (head.starts_with("version https://git-lfs")) {
        return refused(StatusCode::BadFormat,
                       "a Git LFS pointer, not the file itself (fetch it with \"git lfs pull\")");
    }
    if (head.starts_with("ply\n") || head.starts_with("ply\r\n")) {
        return FileKind::Ply;
    }
    if (isExactBinaryStl(bytes)) {
        return FileKind::StlBinary;
    }
    const std::string_view text = head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    if (text.starts_with('<') || text.starts_with(std::string_view("\xff\xfe", 2)) ||
        text.starts_with(std::string_view("\xfe\xff", 2))) {
        const std::string lower = lowered(text);
        if (lower.find("<html") != std::string::npos || lower.starts_with("<!doctype html")) {
            return refused(StatusCode::BadFormat, "a web page (HTML), perhaps a failed download");
        }
        return FileKind::Vtp;
    }
    std::string_view rest = text;
    if (sameWord(takeWord(rest), "solid")) {
        // A binary file whose header says "solid" has a zero byte in its count, and no line before it.
        const std::size_t nul = text.substr(0, 84).find('\0');
        return nul != std::string_view::npos && text.find('\n') > nul ? FileKind::StlBinary : FileKind::StlAscii;
    }
    if (const std::string_view other = otherFormat(head); !other.empty()) {
        return refused(StatusCode::Unsupported, other);
    }
    if (looksLikeObj(head)) {
        return FileKind::Obj;
    }
    // Damaged ones: let the format's own check say how.
    if (extension == ".stl") {
        return FileKind::StlBinary;
    }
    if (extension == ".obj") {
        return FileKind::Obj;
    }
    return refused(StatusCode::BadFormat, "the content is no known mesh format");
}

bool hasMeshExtension(const std::filesystem::path& path)
{
    const std::string extension = lowered(path.extension().string());
    return extension == ".stl" || extension == ".vtp" || extension == ".obj" || extension == ".ply";
}

} // namespace palpate::meshio::internal
