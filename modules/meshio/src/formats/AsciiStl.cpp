// SPDX-License-Identifier: BSD-3-Clause
#include "formats/AsciiStl.h"

#include "formats/MeshFormat.h"
#include "formats/StlLines.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kLongestSolidName = 256; ///< [bytes]

/// @param keyword  in lower case, without blanks
/// @return true if the line begins with the keyword in any case, even with blanks inside ("end solid") or glued to the
/// next word ("endsolidCube"); then `rest` is the remainder of the line
bool takeKeyword(std::string_view line, std::string_view keyword, std::string_view& rest)
{
    line = trimmed(line);
    std::size_t at = 0;
    for (const char letter : keyword) {
        while (at > 0 && at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
            ++at;
        }
        if (at == line.size() || !sameWord(line.substr(at, 1), std::string_view(&letter, 1))) {
            return false;
        }
        ++at;
    }
    rest = line.substr(at);
    return true;
}

/// The value as VTK's reader would store it.
float toFloat(std::string_view word, double value)
{
    word.remove_prefix(word.starts_with('+') ? 1 : 0);
    float exact = 0.0F; // converted directly: by way of double, a value between two floats may be rounded twice
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), exact);
    return error == std::errc() && end == word.data() + word.size() ? exact : static_cast<float>(value);
}

/// @return true if the words contain the begin of a facet
bool hasFacet(std::string_view words)
{
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words)) {
        std::string_view rest = words;
        const std::string_view next = takeWord(rest);
        if (sameWord(word, "facet") &&
            (next.empty() || sameWord(next, "normal") || sameWord(next, "outer") || sameWord(next, "outerloop"))) {
            return true;
        }
    }
    return false;
}

class AsciiStl
{
  public:
    /// @param isSplit  a line may contain several keywords
    AsciiStl(std::string_view text, const ScanContext& context, bool isSplit)
        : m_context(context)
        , m_size(text.size())
        , m_reader(text, isSplit)
        , m_facets(80, '\x80') // a header that VTK takes for binary
    {
        m_scan.format = "STL ASCII";
        append(std::uint32_t{0});
    }
    Status run();
    /// Number of complete facets and the line of the last one.
    [[nodiscard]] std::uint64_t facets() const noexcept { return m_scan.partOfCell.size(); }
    [[nodiscard]] std::uint64_t lastFacet() const noexcept { return m_lastFacet; }
    /// @return true if `run` has skipped what may be parts of a facet behind other words.
    [[nodiscard]] bool hasSkipped() const noexcept { return m_hasSkipped; }
    /// @return true if no facet ends behind the line at which `run` stopped: the file is cut off there.
    [[nodiscard]] bool isCutOff();
    /// Writes the facets read so far to the image.
    Result<PreScan> finish(FileImage& image);

  private:
    /// Notes a facet behind the name of a solid or behind the keyword of an end.
    void skip(std::string_view rest) { m_hasSkipped = m_hasSkipped || hasFacet(rest); }
    /// Expected kind of the next non-blank line.
    enum class Expect : std::uint8_t
    {
        Facet, ///< or the begin or end of a solid
        Loop,
        Vertex,
        EndLoop,
        EndFacet
    };

    Status wrong(const Message& found, const Message& expected) const
    {
        return fault(StatusCode::BadFormat, m_context.file, onLine(m_reader.number()), found, expected);
    }
    template<class T>
    void append(T value)
    {
        m_facets.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    Status takeLine(std::string_view line);
    Status takeOutside(std::string_view line);
    void beginSolid(std::string_view rest);
    void endSolid(std::string_view rest);
    Status takeVertex(std::string_view line);
    Status endFacet();

    const ScanContext& m_context;
    std::size_t m_size;
    StlLines m_reader;
    PreScan m_scan;
    std::string m_facets;           ///< as a binary file
    std::string m_solid;            ///< name of the current solid
    std::uint64_t m_solidBegin = 0; ///< facets before the current solid
    std::uint64_t m_lastFacet = 0;
    bool m_hasSkipped = false;
    bool m_isOpen = false; ///< after "solid", before "endsolid"
    Expect m_expect = Expect::Facet;
    unsigned m_corners = 0;
};

/// Each solid with facets is a part, even if two solids have the same name. A repeated line "solid" before the first
/// facet only repeats the name.
void AsciiStl::beginSolid(std::string_view rest)
{
    skip(rest);
    noteSpaceTag(rest, m_scan);
    noteScaleTag(rest, m_scan);
    m_solid = trimmed(rest.substr(0, kLongestSolidName));
    m_solidBegin = facets();
    m_isOpen = true;
}

void AsciiStl::endSolid(std::string_view rest)
{
    skip(rest);
    const bool hasFacets = facets() > m_solidBegin;
    if (hasFacets && m_scan.partNames.back().empty()) {
        m_scan.partNames.back() = trimmed(rest.substr(0, kLongestSolidName));
    }
    m_isOpen = false;
}

/// A line between two facets.
Status AsciiStl::takeOutside(std::string_view line)
{
    std::string_view rest;
    if (takeKeyword(line, "endsolid", rest)) {
        endSolid(rest);
    } else if (takeKeyword(line, "facet", rest)) {
        m_expect = Expect::Loop;
    } else if (takeKeyword(line, "solid", rest)) {
        beginSolid(rest);
    } else {
        std::string_view after = line;
        const std::string_view word = takeWord(after);
        noteSpaceTag(line, m_scan);
        noteScaleTag(line, m_scan);
        if (isStlComment(word)) {
            return {};
        }
        if (!sameWord(word, "color") && facets() > 0) {
            return wrong({PALPATE_TEXT("found %1"), inQuotes(word)},
                         {PALPATE_TEXT("the keyword %1 or %2"), "\"facet\"", "\"endsolid\""});
        }
        skip(line);
    }
    return {};
}

Status AsciiStl::takeVertex(std::string_view line)
{
    std::string_view rest = line;
    const std::string_view word = takeWord(rest);
    if (!sameWord(word, "vertex")) {
        return wrong({PALPATE_TEXT("found %1 as corner %2 of a facet"), inQuotes(word), m_corners + 1},
                     {PALPATE_TEXT("the keyword %1, three times in each facet"), "\"vertex\""});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view text = takeWord(rest);
        const std::optional<double> value = wordToNumber(text);
        if (!value) {
            return wrong(text.empty() ? Message(PALPATE_TEXT("the vertex has fewer than three coordinates"))
                                      : Message(PALPATE_TEXT("%1 is not a number"), inQuotes(text)),
                         {PALPATE_TEXT("three numbers")});
        }
        if (const Message bad = coordinateFault(*value, m_context.unit_mm); !bad.isEmpty()) {
            return fault(StatusCode::NonFinite, m_context.file, onLine(m_reader.number()), bad,
                         {PALPATE_TEXT("finite coordinates within 10 km")});
        }
        append(toFloat(text, *value));
    }
    if (!trimmed(rest).empty()) {
        return wrong({PALPATE_TEXT("found %1 after the third coordinate"), inQuotes(trimmed(rest))},
                     {PALPATE_TEXT("the end of the line")});
    }
    m_expect = ++m_corners == 3 ? Expect::EndLoop : Expect::Vertex;
    return {};
}

Status AsciiStl::endFacet()
{
    append(std::uint16_t{0});
    if (facets() == m_solidBegin) {
        m_scan.partNames.push_back(m_solid);
    }
    m_scan.partOfCell.push_back(static_cast<std::uint32_t>(m_scan.partNames.size() - 1));
    m_lastFacet = m_reader.number();
    m_expect = Expect::Facet;
    if (facets() % 65536 == 0 && m_context.progress && !m_context.progress(double(m_reader.begin()) / double(m_size))) {
        return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
    }
    return {};
}

Status AsciiStl::takeLine(std::string_view line)
{
    std::string_view rest;
    const auto missing = [&](std::string_view keyword) {
        return wrong({PALPATE_TEXT("found %1"), inQuotes(trimmed(line))}, {PALPATE_TEXT("the keyword %1"), keyword});
    };
    switch (m_expect) {
    case Expect::Facet:
        return takeOutside(line);
    case Expect::Loop:
        if (!takeKeyword(line, "outerloop", rest) || !trimmed(rest).empty()) {
            return missing("\"outer loop\"");
        }
        m_expect = Expect::Vertex;
        m_corners = 0;
        append(std::array<float, 3>{}); // the normal, which VTK's reader does not use
        return {};
    case Expect::Vertex:
        return takeVertex(line);
    case Expect::EndLoop:
        if (!takeKeyword(line, "endloop", rest)) {
            return wrong({PALPATE_TEXT("found %1 after three corners"), inQuotes(trimmed(line))},
                         {PALPATE_TEXT("the keyword %1"), "\"endloop\""});
        }
        m_expect = Expect::EndFacet;
        return {};
    case Expect::EndFacet:
        break;
    }
    if (!takeKeyword(line, "endfacet", rest)) {
        return missing("\"endfacet\"");
    }
    skip(rest);
    return endFacet();
}

Status AsciiStl::run()
{
    while (m_reader.next()) {
        const std::string_view line = m_reader.line();
        if (const std::size_t nul = line.find('\0'); nul != std::string_view::npos) {
            return fault(StatusCode::BadFormat, m_context.file, onByte(m_reader.begin() + nul),
                         {PALPATE_TEXT("found a zero byte")}, {PALPATE_TEXT("text")});
        }
        if (trimmed(line).empty()) {
            continue;
        }
        if (Status status = takeLine(line); !status.isOk()) {
            return status;
        }
    }
    if (m_expect != Expect::Facet) {
        const Message found = facets() == 1
                                  ? Message(PALPATE_TEXT("the file ends after one complete triangle"))
                                  : Message(PALPATE_TEXT("the file ends after %1 complete triangles"), Count(facets()));
        const Message expected(PALPATE_TEXT("the rest of a facet, then the keyword %1"), "\"endsolid\"");
        return wrong(found, facets() == 0
                                ? expected
                                : Message(PALPATE_TEXT("%1; --partial opens the complete triangles"), expected));
    }
    if (facets() == 0) {
        return fault(StatusCode::Empty, m_context.file, onLine(m_reader.number()), {PALPATE_TEXT("0 triangles")},
                     {PALPATE_TEXT("at least one triangle")});
    }
    if (m_isOpen) {
        m_scan.note({PALPATE_TEXT(
            "the last line, \"endsolid\", is missing: if the file was cut off there, triangles are missing")});
    }
    return {};
}

bool AsciiStl::isCutOff()
{
    std::string_view rest;
    while (m_reader.next()) {
        if (takeKeyword(m_reader.line(), "endfacet", rest)) {
            return false;
        }
    }
    return true;
}

Result<PreScan> AsciiStl::finish(FileImage& image)
{
    constexpr std::size_t kHeader = 80, kFacet = 50;
    m_facets.resize(kHeader + sizeof(std::uint32_t) + facets() * kFacet);
    const auto count = static_cast<std::uint32_t>(facets());
    std::memcpy(m_facets.data() + kHeader, &count, sizeof(count));
    Result<FileImage> binary = FileImage::copy(m_facets, m_context.file);
    if (!binary.isOk()) {
        return binary.status();
    }
    image = std::move(binary).value();
    m_scan.cells = count;
    m_scan.points = std::uint64_t{count} * 3;
    return std::move(m_scan);
}

} // namespace

bool startsWithSolid(std::string_view bytes)
{
    const std::string_view text = startOfText(bytes);
    std::string_view rest = text;
    const std::string_view word = takeWord(rest);
    if (sameWord(word, "solid")) {
        return true;
    }
    const bool isGlued = word.size() > 5 && sameWord(word.substr(0, 5), "solid");
    return isGlued && (text.find("facet") != std::string_view::npos || text.find("FACET") != std::string_view::npos);
}

bool looksLikeAsciiStl(std::string_view bytes)
{
    return startsWithSolid(bytes) || (looksLikeText(bytes) && hasStlFacet(startOf(bytes)));
}

Result<PreScan> guardAsciiStl(FileImage& image, const ScanContext& context)
{
    std::string_view text = withoutPadding(image.bytes());
    if (text.starts_with("\xef\xbb\xbf")) { // byte order mark
        text.remove_prefix(3);
    }
    AsciiStl lines(text, context, false);
    Status status = lines.run();
    // Line by line first: the name of a solid may contain keywords.
    std::optional<AsciiStl> words;
    if ((!status.isOk() && status.code() != StatusCode::Cancelled) || lines.hasSkipped()) {
        words.emplace(text, context, true);
        const Status byWord = words->run();
        if (byWord.code() == StatusCode::Cancelled || words->facets() > lines.facets() ||
            (byWord.isOk() && !status.isOk())) {
            status = byWord;
        } else {
            words.reset();
        }
    }
    AsciiStl& file = words ? *words : lines;
    if (status.isOk()) {
        return file.finish(image);
    }
    if (!context.isPartial || status.code() == StatusCode::Cancelled || file.facets() == 0 || !file.isCutOff()) {
        return status;
    }
    const Message loss(PALPATE_TEXT("%1: %2"), onLine(file.lastFacet()),
                       file.facets() == 1 ? Message(PALPATE_TEXT("everything after the first triangle is lost"))
                                          : Message(PALPATE_TEXT("everything after the first %1 triangles is lost"),
                                                    Count(file.facets())));
    Result<PreScan> part = file.finish(image);
    if (part.isOk()) {
        part.value().loss = loss;
    }
    return part;
}

} // namespace palpate::meshio::internal
