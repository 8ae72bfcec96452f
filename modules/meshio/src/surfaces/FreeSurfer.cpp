// SPDX-License-Identifier: BSD-3-Clause
// Triangle surfaces of FreeSurfer ("lh.pial"): a text, two counts, coordinates and corners, all numbers big-endian.
// https://surfer.nmr.mgh.harvard.edu/fswiki/FreeSurferWiki/SurfaceFormat
#include "formats/MeshFormat.h"

#include "surfaces/PolygonSoup.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::string_view kMagic = "\xff\xff\xfe";
constexpr std::size_t kWord = 4; ///< all numbers [bytes]

std::uint32_t wordAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < kWord; ++i) {
        word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
    }
    return word;
}

/// @return the centre of the volume in scanner coordinates (c_ras) [mm], from the description behind the corners. The
/// coordinates of the surface are relative to it.
std::optional<Vec3> volumeCentre(std::string_view behind)
{
    constexpr std::uint32_t kOldGeometry = 20; // the tag alone, or after the tags 2 and 0
    std::size_t at = 0;
    while (at + kWord <= behind.size() && at < 3 * kWord && wordAt(behind, at) != kOldGeometry) {
        at += kWord;
    }
    if (at + kWord > behind.size() || wordAt(behind, at) != kOldGeometry) {
        return std::nullopt;
    }
    bool isValid = false;
    std::optional<Vec3> centre;
    LineReader lines(behind.substr(at + kWord));
    for (int i = 0; i < 8 && lines.next(); ++i) {
        std::string_view rest = lines.line();
        const std::string_view key = takeWord(rest);
        if (takeWord(rest) != "=") {
            break;
        }
        isValid = isValid || (key == "valid" && takeWord(rest) == "1");
        if (key == "cras") {
            Vec3& p = centre.emplace(Vec3::Zero());
            for (double& coordinate : p) {
                const std::optional<double> value = wordToNumber(takeWord(rest));
                if (!value || !coordinateFault(*value, 1.0).isEmpty()) {
                    return std::nullopt;
                }
                coordinate = *value;
            }
        }
    }
    return isValid ? centre : std::nullopt;
}

bool looksLikeFreeSurfer(std::string_view bytes)
{
    return bytes.starts_with(kMagic);
}

Result<TriangleSoup> readFreeSurfer(const FileImage& image, const ScanContext& context, PreScan& scan)
{
    const std::string_view bytes = image.bytes();
    const auto wrong = [&context](std::size_t at, const core::Message& found, const core::Message& expected) {
        return fault(StatusCode::BadFormat, context.file, onByte(at), found, expected);
    };
    constexpr std::size_t kLongestText = 4096;
    const std::size_t text = bytes.substr(0, kLongestText).find("\n\n");
    const std::size_t head = text == std::string_view::npos ? bytes.size() : text + 2;
    if (head + 2 * kWord > bytes.size()) {
        return wrong(bytes.size(), {PALPATE_TEXT("the FreeSurfer surface ends in its header")},
                     {PALPATE_TEXT("a text with an empty line after it, and the numbers of vertices and triangles")});
    }
    const std::uint64_t points = wordAt(bytes, head), triangles = wordAt(bytes, head + kWord);
    const std::size_t body = head + 2 * kWord;
    if (points > kMostElements || triangles > kMostElements || (points + triangles) * 3 * kWord > bytes.size() - body) {
        return wrong(head,
                     {PALPATE_TEXT("%1 vertices and %2 triangles declared, %3 bytes behind them"), Count(points),
                      Count(triangles), Count(bytes.size() - body)},
                     {PALPATE_TEXT("%1 bytes"), Count((points + triangles) * 3 * kWord)});
    }
    PolygonSoup soup(context);
    soup.points().resize(points);
    std::size_t at = body;
    for (Vec3& p : soup.points()) {
        for (double& coordinate : p) {
            coordinate = std::bit_cast<float>(wordAt(bytes, at));
            at += kWord;
        }
    }
    for (std::uint64_t i = 0; i < triangles; ++i) {
        std::array<std::int64_t, 3> corners = {};
        for (std::int64_t& corner : corners) {
            corner = static_cast<std::int32_t>(wordAt(bytes, at));
            at += kWord;
        }
        if (Status status = soup.add(corners); !status.isOk()) {
            return status;
        }
        if (Status status = soup.progress(i, triangles); !status.isOk()) {
            return status;
        }
    }
    if (const std::optional<Vec3> centre = volumeCentre(bytes.substr(at)); centre && !centre->isZero()) {
        for (Vec3& p : soup.points()) {
            p += *centre;
        }
        scan.note(
            {PALPATE_TEXT("moved by the centre of its volume, (%1, %2, %3) mm, to the coordinates of the scanner"),
             core::Rounded{centre->x(), 4}, core::Rounded{centre->y(), 4}, core::Rounded{centre->z(), 4}});
    }
    scan.format = "FreeSurfer";
    scan.frame = FileFrame::Ras;
    return soup.finish(scan, utf8Of(context.file));
}

constexpr std::array<std::string_view, 2> kFreeSurferExtensions{".pial", ".white"};

} // namespace

const MeshFormat kFreeSurferSurface{"FreeSurfer", kFreeSurferExtensions, false, looksLikeFreeSurfer, nullptr,
                                    nullptr,      readFreeSurfer};

} // namespace palpate::meshio::internal
