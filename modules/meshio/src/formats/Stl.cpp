// SPDX-License-Identifier: BSD-3-Clause
#include "formats/AsciiStl.h"
#include "formats/MeshFormat.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFirstFacet = 84;
constexpr std::size_t kFacet = 50;
constexpr std::size_t kProgressStep = std::size_t{1} << 16;

Status cancelled(const ScanContext& context)
{
    return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), context.file};
}

/// File size that the triangle count of a binary file implies.
bool isExactBinary(std::string_view bytes)
{
    if (bytes.size() < kFirstFacet) {
        return false;
    }
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeader, sizeof(count));
    return count > 0 && kFirstFacet + std::uint64_t{count} * kFacet == bytes.size();
}

/// Gives the image the size and the count of `facets`; bytes beyond the end of the file are zero.
Status keepFacets(FileImage& image, std::uint32_t facets, const ScanContext& context)
{
    std::string bytes(image.bytes().substr(0, kFirstFacet + std::uint64_t{facets} * kFacet));
    bytes.resize(kFirstFacet + std::uint64_t{facets} * kFacet, '\0');
    std::memcpy(bytes.data() + kHeader, &facets, sizeof(facets));
    Result<FileImage> whole = FileImage::copy(bytes, context.file);
    if (whole.isOk()) {
        image = std::move(whole).value();
    }
    return whole.status();
}

/// Checks every vertex of a binary file.
Status checkFacets(std::string_view bytes, std::uint64_t declared, const ScanContext& context)
{
    std::uint64_t notNumbers = 0;
    std::uint64_t tooFar = 0;
    std::uint64_t firstBad = declared;
    for (std::uint64_t i = 0; i < declared; ++i) {
        std::array<float, 12> facet; // normal, then three corners
        std::memcpy(facet.data(), bytes.data() + kFirstFacet + i * kFacet, sizeof(facet));
        float most = 0.0F;
        float sum = 0.0F; // x - x is 0 only if x is finite
        for (std::size_t k = 3; k < facet.size(); ++k) {
            most = std::max(most, std::abs(facet[k]));
            sum += facet[k] - facet[k];
        }
        const bool isFinite = sum == 0.0F;
        if (!isFinite || static_cast<double>(most) * context.unit_mm > kMostMm) {
            ++(isFinite ? tooFar : notNumbers);
            firstBad = std::min(firstBad, i);
        }
        if (i % kProgressStep == 0 && context.progress && !context.progress(double(i) / double(declared))) {
            return cancelled(context);
        }
    }
    if (firstBad < declared) {
        const Count bad(notNumbers + tooFar);
        const Count all(declared);
        const core::Message found =
            tooFar == 0
                ? core::Message(PALPATE_TEXT("coordinates are not numbers in %1 of %2 triangles (first: triangle %3)"),
                                bad, all, firstBad)
            : notNumbers == 0
                ? core::Message(PALPATE_TEXT("coordinates are farther than 10 km from the origin in %1 of %2 triangles "
                                             "(first: triangle %3)"),
                                bad, all, firstBad)
                : core::Message(
                      PALPATE_TEXT("coordinates are not numbers, or farther than 10 km from the origin, in %1 "
                                   "of %2 triangles (first: triangle %3)"),
                      bad, all, firstBad);
        return fault(StatusCode::NonFinite, context.file, onByte(kFirstFacet + firstBad * kFacet), found,
                     {PALPATE_TEXT("finite coordinates within 10 km")});
    }
    return {};
}

/// Counts the facets of a binary file by its size, without those of zeros or of text alone, which fill the last block
/// of a file or are its signature.
std::uint64_t heldFacets(std::string_view bytes)
{
    std::uint64_t held = (bytes.size() - kFirstFacet) / kFacet;
    for (; held > 0; --held) {
        const std::string_view last = bytes.substr(kFirstFacet + (held - 1) * kFacet, kFacet);
        const bool isText = last.find('\0') == std::string_view::npos && isFiller(last);
        if (!isText && last.find_first_not_of('\0') != std::string_view::npos) {
            break;
        }
    }
    return held;
}

/// @return true if the facets form a closed surface: for each edge from one corner to the next, another facet has the
/// edge back. The sum of a hash of the edges that changes its sign with the direction is then 0.
bool isClosed(std::string_view bytes, std::uint64_t facets)
{
    constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15ULL; // of splitmix64 (Steele, Lea, Flood: OOPSLA 2014)
    const auto mix = [](std::uint64_t x) {
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ x >> 27) * 0x94d049bb133111ebULL;
        return x ^ x >> 31;
    };
    std::uint64_t sum = 0;
    bool hasEdge = false;
    for (std::uint64_t i = 0; i < facets; ++i) {
        std::array<float, 12> facet; // normal, then three corners
        std::memcpy(facet.data(), bytes.data() + kFirstFacet + i * kFacet, sizeof(facet));
        std::array<std::uint64_t, 3> corners = {};
        for (std::size_t k = 0; k < 9; ++k) {
            const float x = facet[3 + k] + 0.0F; // -0 becomes 0
            corners[k / 3] = mix(corners[k / 3] + kFactor + std::bit_cast<std::uint32_t>(x));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corners[k], b = corners[(k + 1) % 3];
            const std::uint64_t edge = mix(std::min(a, b) + mix(std::max(a, b)));
            sum += a < b ? edge : a > b ? ~edge + 1 : 0;
            hasEdge = hasEdge || a != b;
        }
    }
    return hasEdge && sum == 0;
}

/// Decides how many facets a binary file holds, and notes or refuses a size that differs from the count of the header.
/// Streaming writers leave the count 0 or -1, and some programs fill the last block of a file or append a text. A count
/// of more facets than are there says that some are lost, so the file is refused. A count of fewer, or of -1, is
/// refused unless the facets form a closed surface.
/// @param declared  in: the count of the header; out: the number of facets
Status settleCount(std::string_view bytes, std::uint32_t& declared, const ScanContext& context, PreScan& scan)
{
    const std::uint64_t body = bytes.size() - kFirstFacet;
    const std::uint64_t wanted = std::uint64_t{declared} * kFacet;
    constexpr std::uint64_t kAttribute = sizeof(std::uint16_t); // behind the corners of a facet
    if (body == wanted && declared > 0) {
        return {};
    }
    const std::uint64_t facets = heldFacets(bytes);
    const std::string_view tail = bytes.substr(kFirstFacet + facets * kFacet);
    const bool isEnd = body > wanted && facets <= declared && declared > 0; // only filler behind the facets
    const bool isCutAttribute = body < wanted && wanted - body <= kAttribute;
    constexpr std::uint32_t kMinusOne = 0xffffffffU;
    const bool isCertain = declared == 0 ? withoutPadding(tail).empty() || isClosed(bytes, facets)
                                         : (declared < facets || declared == kMinusOne) && isClosed(bytes, facets);
    if (facets > 0 && facets <= kMostElements && !isEnd && !isCutAttribute && isFiller(tail) && isCertain) {
        scan.note({PALPATE_TEXT("the count of triangles in the header, %1, is wrong: the size of the file says %2"),
                   Count(declared), Count(facets)});
        noteTrailingBytes(tail.size(), scan);
        declared = static_cast<std::uint32_t>(facets);
        return {};
    }
    const std::uint64_t held = body / kFacet;
    if (isCutAttribute) {
        scan.note({PALPATE_TEXT("the last triangle is whole, but the attribute behind it is cut off")});
    } else if (context.isPartial && held > 0 && body < wanted) {
        scan.loss = core::Message(PALPATE_TEXT("%1: %2"), onByte(bytes.size()),
                                  core::Message(PALPATE_TEXT("the file ends there: %1 of %2 triangles lost"),
                                                Count(declared - held), Count(declared)));
        declared = static_cast<std::uint32_t>(held);
    } else if (body < wanted) {
        return fault(StatusCode::BadFormat, context.file, onByte(bytes.size()),
                     {PALPATE_TEXT("cut off: the binary STL declares %1 triangles, but the %2 bytes hold %3"),
                      Count(declared), Count(bytes.size()), Count(held)},
                     held == 0 ? core::Message(PALPATE_TEXT("%1 bytes"), Count(kFirstFacet + wanted))
                               : core::Message(PALPATE_TEXT("%1 bytes; --partial opens the first %2 of %3 triangles"),
                                               Count(kFirstFacet + wanted), Count(held), Count(declared)));
    } else if (body > wanted && declared > 0) {
        const std::string_view behind = bytes.substr(kFirstFacet + wanted);
        if (!isEnd || (behind.size() >= kFacet && !isFiller(behind))) {
            return fault(StatusCode::BadFormat, context.file, onByte(kHeader),
                         {PALPATE_TEXT("number of triangles of the binary STL: declared %1, but the %2 bytes hold %3"),
                          Count(declared), Count(bytes.size()), Count(held)},
                         {PALPATE_TEXT("%1 bytes"), Count(kFirstFacet + wanted)});
        }
        noteTrailingBytes(behind.size(), scan);
    }
    return declared > 0 ? Status()
                        : fault(StatusCode::Empty, context.file, onByte(kHeader), {PALPATE_TEXT("0 triangles")},
                                {PALPATE_TEXT("at least one triangle")});
}

/// Converts five bits of a facet's attribute to a colour component.
double component(std::uint16_t attribute, unsigned shift)
{
    return (attribute >> shift & 0x1fU) / 31.0;
}

/// Takes the colour of the structure. Materialise Magics writes the colour of the object as "COLOR=" and four bytes
/// into the header, and red, green and blue (from the lowest bit) into the attribute of a facet with a colour of its
/// own, whose highest bit is then 0. VisCAM and SolidView write blue, green and red, and set the highest bit for a
/// coloured facet. https://en.wikipedia.org/wiki/STL_(file_format)#Color_in_binary
void takeColour(std::string_view bytes, std::uint32_t facets, PreScan& scan)
{
    constexpr std::string_view kTag = "COLOR=";
    constexpr std::uint16_t kHighest = 0x8000;
    const std::string_view header = bytes.substr(0, kHeader);
    const std::size_t tag = header.find(kTag);
    const bool isMagics = tag != std::string_view::npos && tag + kTag.size() + 4 <= header.size();
    std::map<std::uint16_t, std::uint64_t> own; // facets with each attribute
    for (std::uint32_t i = 0; i < facets; ++i) {
        std::uint16_t attribute = 0;
        std::memcpy(&attribute, bytes.data() + kFirstFacet + (i + std::uint64_t{1}) * kFacet - sizeof(attribute),
                    sizeof(attribute));
        const bool isColoured = isMagics ? attribute != 0 && (attribute & kHighest) == 0 : (attribute & kHighest) != 0;
        if (isColoured) {
            ++own[attribute];
        }
    }
    const auto most =
        std::max_element(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::uint64_t used = 0;
    if (isMagics && (most == own.end() || most->second < facets)) {
        const auto byte = [&](std::size_t k) {
            return static_cast<unsigned char>(header[tag + kTag.size() + k]) / 255.0;
        };
        scan.partColours = {std::array<double, 3>{byte(0), byte(1), byte(2)}};
    } else if (most != own.end()) {
        const std::uint16_t attribute = most->first;
        const double low = component(attribute, 0), middle = component(attribute, 5), high = component(attribute, 10);
        scan.partColours = {isMagics ? std::array<double, 3>{low, middle, high}
                                     : std::array<double, 3>{high, middle, low}};
        used = most->second;
    }
    std::uint64_t coloured = 0;
    for (const auto& [attribute, count] : own) {
        coloured += count;
    }
    if (coloured > used) {
        scan.note({PALPATE_TEXT("colours not read: those of %1 of the triangles, as a structure has one colour"),
                   Count(coloured - used)});
    }
}

Result<PreScan> guardBinary(FileImage& image, const ScanContext& context)
{
    std::string_view bytes = image.bytes();
    if (bytes.size() < kFirstFacet) {
        return fault(StatusCode::BadFormat, context.file, onByte(bytes.size()),
                     {PALPATE_TEXT("the file ends in the STL header")},
                     {PALPATE_TEXT("at least %1 bytes"), kFirstFacet + kFacet});
    }
    std::uint32_t declared = 0;
    std::memcpy(&declared, bytes.data() + kHeader, sizeof(declared));
    PreScan scan;
    if (Status status = settleCount(bytes, declared, context, scan); !status.isOk()) {
        return status;
    }
    if (!isExactBinary(bytes)) {
        if (Status status = keepFacets(image, declared, context); !status.isOk()) {
            return status;
        }
        bytes = image.bytes();
    }
    scan.format = "STL binary";
    scan.cells = declared;
    scan.points = std::uint64_t{declared} * 3;
    noteSpaceTag(bytes.substr(0, kHeader), scan);
    noteScaleTag(bytes.substr(0, kHeader), scan);

    if (Status status = checkFacets(bytes, declared, context); !status.isOk()) {
        return status;
    }
    takeColour(bytes, declared, scan);
    // VTK distinguishes binary from ASCII by the share of printable characters among the first bytes: make this
    // unambiguous.
    std::fill_n(image.writable().begin(), kHeader, '\x80');
    return scan;
}

bool looksLikeStl(std::string_view bytes)
{
    return isExactBinary(bytes) || looksLikeAsciiStl(bytes);
}

Result<PreScan> guardStl(FileImage& image, const ScanContext& context)
{
    const std::string_view bytes = image.bytes();
    if (isExactBinary(bytes)) {
        return guardBinary(image, context);
    }
    if (!startsWithSolid(bytes)) {
        if (!looksLikeText(bytes)) {
            return guardBinary(image, context);
        }
        const bool hasZero = bytes.substr(0, kFirstFacet).find('\0') != std::string_view::npos;
        const char* const before = bytes.data();
        Result<PreScan> scan = guardAsciiStl(image, context); // may replace the image
        if (scan.isOk() || scan.status().code() != StatusCode::Empty) {
            return scan;
        }
        if (hasZero && image.bytes().data() == before) { // a count of 0 behind a text
            return guardBinary(image, context);
        }
        return fault(StatusCode::BadFormat, context.file, onLine(1),
                     {PALPATE_TEXT("a text without the facets of an STL")},
                     {PALPATE_TEXT("the keyword %1"), "\"facet\""});
    }
    // A binary file with a header that begins with "solid" has zero bytes in the count or the first facet, and no facet
    // as text before.
    const std::string_view text = startOfText(bytes);
    const std::size_t nul = text.substr(0, kFirstFacet + kFacet).find('\0');
    const bool isBinary = nul != std::string_view::npos && text.substr(0, nul).find("facet") == std::string_view::npos;
    return isBinary ? guardBinary(image, context) : guardAsciiStl(image, context);
}

vtkSmartPointer<vtkAlgorithm> stlReader(const std::string& path, const PreScan& /*scan*/)
{
    auto made = vtkSmartPointer<vtkSTLReader>::New();
    made->SetFileName(path.c_str());
    made->MergingOff(); // merging would drop triangles silently; `repair` welds and counts
    return made;
}

constexpr std::array<std::string_view, 1> kStlExtensions{".stl"};

} // namespace

const MeshFormat kStl{"STL", kStlExtensions, true, looksLikeStl, guardStl, stlReader};

} // namespace palpate::meshio::internal
