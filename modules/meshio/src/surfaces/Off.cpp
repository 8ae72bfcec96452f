// SPDX-License-Identifier: BSD-3-Clause
// OFF (Object File Format of Geomview), as text: three counts, vertices, and faces with the number of their corners.
// http://www.geomview.org/docs/html/OFF.html
#include "formats/MeshFormat.h"

#include "surfaces/PolygonSoup.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <array>
#include <optional>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

/// @return the first word if it is one of OFF: "OFF" with ST, C, N, 4 and n for further numbers of a vertex
std::string_view offWord(std::string_view text)
{
    const std::string_view word = takeWord(text);
    const bool isOff = word.size() <= 7 && word.ends_with("OFF") &&
                       word.substr(0, word.size() - 3).find_first_not_of("STCN4n") == std::string_view::npos;
    return isOff ? word : std::string_view();
}

class OffReader
{
  public:
    OffReader(std::string_view text, const ScanContext& context)
        : m_context(context)
        , m_text(text)
        , m_lines(text)
        , m_soup(context)
    {
    }
    Result<TriangleSoup> run(PreScan& scan);

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, onLine(m_lines.number()), found, expected);
    }
    Status readHead();
    Status readVertices();
    Status readFaces();
    Status nextLine();

    const ScanContext& m_context;
    std::string_view m_text;
    LineReader m_lines;
    std::string_view m_rest; ///< of the line, without a comment
    PolygonSoup m_soup;
    std::int64_t m_vertices = 0, m_faces = 0;
    bool m_hasColours = false;
};

/// Goes to the next line that is neither blank nor a comment.
Status OffReader::nextLine()
{
    while (m_lines.next()) {
        m_rest = trimmed(m_lines.line().substr(0, m_lines.line().find('#')));
        if (!m_rest.empty()) {
            return m_soup.progress(m_lines.begin(), m_text.size());
        }
    }
    return fault(StatusCode::BadFormat, m_context.file, onLine(m_lines.number()), {PALPATE_TEXT("the file ends")},
                 {PALPATE_TEXT("the declared vertices and faces")});
}

Status OffReader::readHead()
{
    if (Status status = nextLine(); !status.isOk()) {
        return status;
    }
    const std::string_view word = takeWord(m_rest);
    if (word.find_first_of("4n") != std::string_view::npos || trimmed(m_rest).starts_with("BINARY")) {
        return wrong(StatusCode::Unsupported, {PALPATE_TEXT("%1: four dimensions, or binary"), inQuotes(word)},
                     {PALPATE_TEXT("OFF as text with three coordinates for each vertex (MeshLab converts it)")});
    }
    std::array<std::int64_t, 3> counts = {};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (trimmed(m_rest).empty() && i < 2) {
            if (Status status = nextLine(); !status.isOk()) {
                return status;
            }
        }
        const std::string_view number = takeWord(m_rest);
        const std::optional<std::int64_t> count = wordToInteger(number);
        if ((!count || *count < 0) && !(i == 2 && number.empty())) { // some programs leave out the edges
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 is not a count"), inQuotes(number)},
                         {PALPATE_TEXT("the numbers of vertices, faces and edges")});
        }
        counts[i] = count.value_or(0);
    }
    m_vertices = counts[0];
    m_faces = counts[1];
    constexpr std::uint64_t kLeastVertex = 6, kLeastFace = 2; // "0 0 0" and "0", each with the end of the line
    const std::uint64_t bytes = m_text.size() + 1;
    if (static_cast<std::uint64_t>(m_vertices) > bytes / kLeastVertex ||
        static_cast<std::uint64_t>(m_faces) > bytes / kLeastFace) {
        return wrong(
            StatusCode::BadFormat,
            {PALPATE_TEXT("the OFF file declares %1 vertices and %2 faces"), Count(m_vertices), Count(m_faces)},
            {PALPATE_TEXT("as many as its %1 bytes can hold"), Count(m_text.size())});
    }
    return {};
}

Status OffReader::readVertices()
{
    m_soup.points().reserve(static_cast<std::size_t>(m_vertices));
    for (std::int64_t i = 0; i < m_vertices; ++i) {
        if (Status status = nextLine(); !status.isOk()) {
            return status;
        }
        core::Vec3& p = m_soup.points().emplace_back();
        for (double& coordinate : p) {
            const std::string_view word = takeWord(m_rest);
            const std::optional<double> value = wordToNumber(word);
            if (!value) {
                return wrong(StatusCode::BadFormat,
                             word.empty() ? core::Message(PALPATE_TEXT("the vertex has fewer than three coordinates"))
                                          : core::Message(PALPATE_TEXT("%1 is not a number"), inQuotes(word)),
                             {PALPATE_TEXT("three numbers for each vertex")});
            }
            coordinate = *value;
        }
        m_hasColours = m_hasColours || !trimmed(m_rest).empty();
    }
    return {};
}

Status OffReader::readFaces()
{
    std::vector<std::int64_t> corners;
    for (std::int64_t i = 0; i < m_faces; ++i) {
        if (Status status = nextLine(); !status.isOk()) {
            return status;
        }
        const std::string_view word = takeWord(m_rest);
        const std::optional<std::int64_t> count = wordToInteger(word);
        if (!count || *count < 0) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 is not a count"), inQuotes(word)},
                         {PALPATE_TEXT("the number of corners of a face")});
        }
        corners.clear();
        for (std::int64_t k = 0; k < *count; ++k) {
            const std::string_view index = takeWord(m_rest);
            const std::optional<std::int64_t> corner = wordToInteger(index);
            if (!corner) {
                return wrong(StatusCode::BadFormat,
                             index.empty() ? core::Message(PALPATE_TEXT("the face has fewer corners than it declares"))
                                           : core::Message(PALPATE_TEXT("%1 is not a vertex index"), inQuotes(index)),
                             {PALPATE_TEXT("%1 vertex indices"), Count(*count)});
            }
            corners.push_back(*corner);
        }
        m_hasColours = m_hasColours || !trimmed(m_rest).empty();
        if (Status status = m_soup.add(corners); !status.isOk()) {
            return status;
        }
    }
    return {};
}

Result<TriangleSoup> OffReader::run(PreScan& scan)
{
    for (const auto step : {&OffReader::readHead, &OffReader::readVertices, &OffReader::readFaces}) {
        if (Status status = (this->*step)(); !status.isOk()) {
            return status;
        }
    }
    while (m_lines.next()) {
        const std::string_view more = trimmed(m_lines.line().substr(0, m_lines.line().find('#')));
        if (!more.empty()) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 behind the last face"), inQuotes(more)},
                         {PALPATE_TEXT("%1 vertices and %2 faces, as declared"), Count(m_vertices), Count(m_faces)});
        }
    }
    if (m_hasColours) {
        scan.note({PALPATE_TEXT("colours, normals and further numbers of vertices and faces are not read")});
    }
    return m_soup.finish(scan);
}

bool looksLikeOff(std::string_view bytes)
{
    LineReader lines(startOf(bytes));
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line().substr(0, lines.line().find('#')));
        if (!line.empty()) {
            return !offWord(line).empty();
        }
    }
    return false;
}

Result<TriangleSoup> readOff(const FileImage& image, const ScanContext& context, PreScan& scan)
{
    std::string_view text = withoutPadding(image.bytes());
    text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0); // byte order mark
    scan.format = "OFF";
    return OffReader(text, context).run(scan);
}

constexpr std::array<std::string_view, 1> kOffExtensions{".off"};

} // namespace

const MeshFormat kOff{"OFF", kOffExtensions, true, looksLikeOff, nullptr, nullptr, readOff};

} // namespace palpate::meshio::internal
