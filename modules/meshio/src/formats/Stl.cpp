// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
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

/// Truncates the image to `size` bytes and appends `end`.
Status keepWhole(FileImage& image, std::size_t size, std::string_view end, const ScanContext& context)
{
    std::string bytes(image.bytes().substr(0, size));
    Result<FileImage> whole = FileImage::copy(bytes.append(end), context.file);
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
    const std::uint64_t held = (bytes.size() - kFirstFacet) / kFacet;
    PreScan scan;
    if (context.isPartial && held > 0 && held < declared) {
        scan.loss = core::Message(PALPATE_TEXT("%1: %2"), onByte(bytes.size()),
                                  core::Message(PALPATE_TEXT("the file ends there: %1 of %2 triangles lost"),
                                                Count(declared - held), Count(declared)));
        declared = static_cast<std::uint32_t>(held);
        if (Status status = keepWhole(image, kFirstFacet + held * kFacet, "", context); !status.isOk()) {
            return status;
        }
        std::memcpy(image.writable().data() + kHeader, &declared, sizeof(declared));
        bytes = image.bytes();
    }
    if (kFirstFacet + std::uint64_t{declared} * kFacet != bytes.size()) {
        return fault(StatusCode::BadFormat, context.file, onByte(kHeader),
                     {PALPATE_TEXT("number of triangles of the binary STL: declared %1, but the %2 bytes hold %3"),
                      Count(declared), Count(bytes.size()), Count(held)},
                     {PALPATE_TEXT("%1 bytes"), Count(kFirstFacet + std::uint64_t{declared} * kFacet)});
    }
    if (declared == 0) {
        return fault(StatusCode::Empty, context.file, onByte(kHeader), {PALPATE_TEXT("0 triangles")},
                     {PALPATE_TEXT("at least one triangle")});
    }

    scan.format = "STL binary";
    scan.cells = declared;
    scan.points = std::uint64_t{declared} * 3;
    noteSpaceTag(bytes.substr(0, kHeader), scan);
    noteScaleTag(bytes.substr(0, kHeader), scan);

    if (Status status = checkFacets(bytes, declared, context); !status.isOk()) {
        return status;
    }
    // VTK distinguishes binary from ASCII by the share of printable characters among the first bytes: make this
    // unambiguous.
    std::fill_n(image.writable().begin(), kHeader, '\x80');
    return scan;
}

/// Checks an ASCII file line by line and removes content that VTK's reader cannot handle.
class AsciiStl
{
  public:
    AsciiStl(FileImage& image, const ScanContext& context)
        : m_image(image)
        , m_context(context)
        , m_reader(image.bytes())
    {
        m_scan.format = "STL ASCII";
    }
    Result<PreScan> scan();

  private:
    /// Expected kind of the next non-blank line.
    enum class Expect : std::uint8_t
    {
        Solid,
        Facet,
        Loop,
        Vertex,
        EndLoop,
        EndFacet
    };

    Status wrong(const core::Message& found, const core::Message& expected) const
    {
        return fault(StatusCode::BadFormat, m_context.file, onLine(m_reader.number()), found, expected);
    }
    /// Parameters: the first word of a line and the rest.
    Status takeLine(std::string_view word, std::string_view rest);
    Status takeSolid(std::string_view word, std::string_view rest);
    Status takeFacet(std::string_view word);
    Status takeLoop(std::string_view word, std::string_view rest);
    Status takeVertex(std::string_view word, std::string_view rest);
    Status takeEndLoop(std::string_view word);
    Status takeEndFacet(std::string_view word);
    Result<PreScan> finish();

    FileImage& m_image;
    const ScanContext& m_context;
    LineReader m_reader;
    PreScan m_scan;
    std::map<std::string, std::uint32_t, std::less<>> m_parts;
    std::uint32_t m_part = 0;
    Expect m_expect = Expect::Solid;
    unsigned m_corners = 0;
};

Status AsciiStl::takeSolid(std::string_view word, std::string_view rest)
{
    if (!sameWord(word, "solid")) {
        return wrong({PALPATE_TEXT("found %1"), inQuotes(word)}, {PALPATE_TEXT("the keyword %1"), "\"solid\""});
    }
    noteSpaceTag(rest, m_scan);
    noteScaleTag(rest, m_scan);
    const auto [found, isNew] =
        m_parts.emplace(trimmed(rest.substr(0, 256)), static_cast<std::uint32_t>(m_parts.size()));
    if (isNew) {
        m_scan.partNames.push_back(found->first);
    }
    m_part = found->second;
    m_expect = Expect::Facet;
    return {};
}

Status AsciiStl::takeFacet(std::string_view word)
{
    if (sameWord(word, "color")) {
        return {};
    }
    if (sameWord(word, "endsolid")) {
        m_expect = Expect::Solid;
    } else if (sameWord(word, "facet")) {
        m_expect = Expect::Loop;
    } else {
        return wrong({PALPATE_TEXT("found %1"), inQuotes(word)},
                     {PALPATE_TEXT("the keyword %1 or %2"), "\"facet\"", "\"endsolid\""});
    }
    return {};
}

Status AsciiStl::takeLoop(std::string_view word, std::string_view rest)
{
    if (!sameWord(word, "outer") || !sameWord(trimmed(rest), "loop")) {
        return wrong({PALPATE_TEXT("found %1"), inQuotes(trimmed(m_reader.line()))},
                     {PALPATE_TEXT("the keyword %1"), "\"outer loop\""});
    }
    m_expect = Expect::Vertex;
    m_corners = 0;
    return {};
}

Status AsciiStl::takeVertex(std::string_view word, std::string_view rest)
{
    if (!sameWord(word, "vertex")) {
        return wrong({PALPATE_TEXT("found %1 as corner %2 of a facet"), inQuotes(word), m_corners + 1},
                     {PALPATE_TEXT("the keyword %1, three times in each facet"), "\"vertex\""});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view text = takeWord(rest);
        const std::optional<double> value = wordToNumber(text);
        if (!value) {
            return wrong(text.empty() ? core::Message(PALPATE_TEXT("the vertex has fewer than three coordinates"))
                                      : core::Message(PALPATE_TEXT("%1 is not a number"), inQuotes(text)),
                         {PALPATE_TEXT("three numbers")});
        }
        if (const core::Message bad = coordinateFault(*value, m_context.unit_mm); !bad.isEmpty()) {
            return fault(StatusCode::NonFinite, m_context.file, onLine(m_reader.number()), bad,
                         {PALPATE_TEXT("finite coordinates within 10 km")});
        }
    }
    if (!trimmed(rest).empty()) {
        return wrong({PALPATE_TEXT("found %1 after the third coordinate"), inQuotes(trimmed(rest))},
                     {PALPATE_TEXT("the end of the line")});
    }
    if (++m_corners == 3) {
        m_expect = Expect::EndLoop;
        m_scan.partOfCell.push_back(m_part);
    }
    return {};
}

Status AsciiStl::takeEndLoop(std::string_view word)
{
    if (!sameWord(word, "endloop")) {
        return wrong({PALPATE_TEXT("found %1 after three corners"), inQuotes(word)},
                     {PALPATE_TEXT("the keyword %1"), "\"endloop\""});
    }
    m_expect = Expect::EndFacet;
    return {};
}

Status AsciiStl::takeEndFacet(std::string_view word)
{
    if (!sameWord(word, "endfacet")) {
        return wrong({PALPATE_TEXT("found %1"), inQuotes(word)}, {PALPATE_TEXT("the keyword %1"), "\"endfacet\""});
    }
    m_expect = Expect::Facet;
    if (m_scan.partOfCell.size() % kProgressStep == 0 && m_context.progress &&
        !m_context.progress(double(m_reader.begin()) / double(m_image.bytes().size()))) {
        return cancelled(m_context);
    }
    return {};
}

Status AsciiStl::takeLine(std::string_view word, std::string_view rest)
{
    switch (m_expect) {
    case Expect::Solid:
        return takeSolid(word, rest);
    case Expect::Facet:
        return takeFacet(word);
    case Expect::Loop:
        return takeLoop(word, rest);
    case Expect::Vertex:
        return takeVertex(word, rest);
    case Expect::EndLoop:
        return takeEndLoop(word);
    case Expect::EndFacet:
        break;
    }
    return takeEndFacet(word);
}

Result<PreScan> AsciiStl::scan()
{
    // VTK reads lines of up to 254 characters and treats the rest as the next line.
    constexpr std::size_t kLongest = 254;
    const std::span<char> writable = m_image.writable();
    if (m_image.bytes().starts_with("\xef\xbb\xbf")) { // byte order mark
        std::fill_n(writable.begin(), 3, ' ');
    }
    while (m_reader.next()) {
        if (const std::size_t nul = m_reader.line().find('\0'); nul != std::string_view::npos) {
            return fault(StatusCode::BadFormat, m_context.file, onByte(m_reader.begin() + nul),
                         {PALPATE_TEXT("found a zero byte")}, {PALPATE_TEXT("text")});
        }
        std::string_view rest = m_reader.line();
        const std::string_view word = takeWord(rest);
        const std::span<char> line = writable.subspan(m_reader.begin(), m_reader.line().size());
        if (word.empty()) {
            std::ranges::fill(line, ' ');
            continue;
        }
        const bool isName = sameWord(word, "solid") || sameWord(word, "endsolid");
        if (!isName && m_reader.line().size() > kLongest) {
            return wrong({PALPATE_TEXT("a line of %1 characters"), Count(m_reader.line().size())},
                         {PALPATE_TEXT("at most %1 characters"), kLongest});
        }
        if (Status status = takeLine(word, rest); !status.isOk()) {
            return status;
        }
        // With a few non-text characters, even in a blank line, VTK takes the file for binary and
        // interprets text as a count. Names may contain any characters in any number, so names are hidden from VTK.
        const std::size_t textEnd =
            isName ? static_cast<std::size_t>(word.data() + word.size() - line.data()) : line.size();
        for (char& c : line.first(textEnd)) {
            const bool isText = (c >= ' ' && c < '\x7f') || c == '\t' || c == '\r';
            c = isText ? c : c == '\v' || c == '\f' ? ' ' : '?';
        }
        std::ranges::fill(line.subspan(textEnd), ' ');
    }
    return finish();
}

Result<PreScan> AsciiStl::finish()
{
    const std::size_t triangles = m_scan.partOfCell.size();
    if (m_expect != Expect::Solid) {
        const core::Message found =
            triangles == 1 ? core::Message(PALPATE_TEXT("the file ends after one complete triangle"))
                           : core::Message(PALPATE_TEXT("the file ends after %1 complete triangles"), Count(triangles));
        return wrong(found,
                     m_expect == Expect::Facet
                         ? core::Message(PALPATE_TEXT("the keyword %1 or %2"), "\"facet\"", "\"endsolid\"")
                         : core::Message(PALPATE_TEXT("the rest of a facet, then the keyword %1"), "\"endsolid\""));
    }
    if (triangles == 0) {
        return fault(StatusCode::Empty, m_context.file, onLine(m_reader.number()), {PALPATE_TEXT("0 triangles")},
                     {PALPATE_TEXT("at least one triangle")});
    }
    m_scan.cells = triangles;
    m_scan.points = m_scan.cells * 3;
    return std::move(m_scan);
}

Result<PreScan> guardAscii(FileImage& image, const ScanContext& context)
{
    Result<PreScan> whole = AsciiStl(image, context).scan();
    if (whole.isOk() || !context.isPartial || whole.status().code() == StatusCode::Cancelled) {
        return whole;
    }
    // Keep up to the last complete facet.
    LineReader reader(image.bytes());
    std::size_t end = 0;
    std::uint64_t lastLine = 0;
    while (reader.next()) {
        std::string_view rest = reader.line();
        if (sameWord(takeWord(rest), "endfacet")) {
            end = reader.end();
            lastLine = reader.number();
        }
    }
    if (end == 0) {
        return whole;
    }
    if (Status status = keepWhole(image, end, "\nendsolid\n", context); !status.isOk()) {
        return status;
    }
    Result<PreScan> part = AsciiStl(image, context).scan();
    if (!part.isOk()) { // the file is damaged elsewhere
        return whole;
    }
    const std::uint64_t kept = part.value().cells;
    part.value().loss = core::Message(
        PALPATE_TEXT("%1: %2"), onLine(lastLine),
        kept == 1 ? core::Message(PALPATE_TEXT("everything after the first triangle is lost"))
                  : core::Message(PALPATE_TEXT("everything after the first %1 triangles is lost"), Count(kept)));
    return part;
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

bool startsWithSolid(std::string_view bytes)
{
    std::string_view rest = startOfText(bytes);
    return sameWord(takeWord(rest), "solid");
}

bool looksLikeStl(std::string_view bytes)
{
    return isExactBinary(bytes) || startsWithSolid(bytes);
}

Result<PreScan> guardStl(FileImage& image, const ScanContext& context)
{
    const std::string_view bytes = image.bytes();
    if (isExactBinary(bytes) || !startsWithSolid(bytes)) {
        return guardBinary(image, context);
    }
    // A binary file with a header that begins with "solid" has a zero byte in the count, and no line before that.
    const std::string_view text = startOfText(bytes);
    const std::size_t nul = text.substr(0, kFirstFacet).find('\0');
    const bool isBinary = nul != std::string_view::npos && text.find('\n') > nul;
    return isBinary ? guardBinary(image, context) : guardAscii(image, context);
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
