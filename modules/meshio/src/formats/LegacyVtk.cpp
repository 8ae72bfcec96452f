// SPDX-License-Identifier: BSD-3-Clause
// VTK's legacy file format, `.vtk`: text keywords, numbers as text or big-endian.
// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include "formats/GridSurface.h"
#include "formats/MeshFormat.h"

#include "guard/BadVertices.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <vtkDataSetAttributes.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::string_view kMark = "# vtk DataFile Version";

/// How a number is stored in a binary file.
struct NumberType
{
    std::string_view name; ///< in the file, in lower case
    std::size_t size;      ///< [bytes]
    bool isFloating;
    bool isSigned;
};

constexpr std::array<NumberType, 14> kNumberTypes{{{"unsigned_char", 1, false, false},
                                                   {"char", 1, false, true},
                                                   {"signed_char", 1, false, true},
                                                   {"unsigned_short", 2, false, false},
                                                   {"short", 2, false, true},
                                                   {"unsigned_int", 4, false, false},
                                                   {"int", 4, false, true},
                                                   {"unsigned_long", sizeof(long), false, false},
                                                   {"long", sizeof(long), false, true},
                                                   {"vtktypeuint64", 8, false, false},
                                                   {"vtktypeint64", 8, false, true},
                                                   {"vtkidtype", 4, false, true},
                                                   {"float", 4, true, true},
                                                   {"double", 8, true, true}}};

const NumberType* typeOf(std::string_view word)
{
    const auto found =
        std::find_if(kNumberTypes.begin(), kNumberTypes.end(), [&](const auto& t) { return sameWord(t.name, word); });
    return found == kNumberTypes.end() ? nullptr : &*found;
}

/// Reads words and numbers from the file in sequence.
class LegacyBody
{
  public:
    explicit LegacyBody(std::string_view bytes)
        : m_bytes(bytes)
    {
    }
    bool isBinary = false;

    [[nodiscard]] std::size_t at() const noexcept { return m_at; }
    [[nodiscard]] std::string_view rest() const noexcept { return m_bytes.substr(m_at); }
    [[nodiscard]] core::Message place()
    {
        if (isBinary) {
            return onByte(m_at);
        }
        m_line += static_cast<std::uint64_t>(std::ranges::count(m_bytes.substr(m_lineAt, m_at - m_lineAt), '\n'));
        m_lineAt = m_at;
        return onLine(m_line);
    }
    /// @return the next word, empty at the end
    std::string_view word()
    {
        std::string_view rest = m_bytes.substr(m_at);
        const std::string_view found = takeWord(rest);
        m_at = m_bytes.size() - rest.size();
        return found;
    }
    /// @return the rest of the line without the line end
    std::string_view line()
    {
        LineReader lines(m_bytes.substr(m_at));
        (void)lines.next();
        m_at += lines.end();
        return lines.line();
    }
    /// Skips `count` numbers. @return false if the file contains fewer
    bool skip(std::uint64_t count, const NumberType& type)
    {
        if (isBinary) {
            const bool isThere = count <= rest().size() / type.size;
            m_at += isThere ? count * type.size : 0;
            return isThere;
        }
        for (; count > 0; --count) {
            if (!wordToNumber(word())) {
                return false;
            }
        }
        return true;
    }
    std::optional<double> number(const NumberType& type)
    {
        if (!isBinary) {
            return wordToNumber(word());
        }
        const std::optional<std::uint64_t> raw = take(type.size);
        if (!raw) {
            return std::nullopt;
        }
        if (!type.isFloating) {
            return type.isSigned ? static_cast<double>(extended(*raw, type.size)) : static_cast<double>(*raw);
        }
        if (type.size == sizeof(float)) {
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(*raw)));
        }
        return std::bit_cast<double>(*raw);
    }
    /// @param type  an integer type
    std::optional<std::int64_t> integer(const NumberType& type)
    {
        if (!isBinary) {
            return wordToInteger(word());
        }
        const std::optional<std::uint64_t> raw = take(type.size);
        return raw ? std::optional(extended(*raw, type.size)) : std::nullopt;
    }

  private:
    std::optional<std::uint64_t> take(std::size_t size)
    {
        if (rest().size() < size) {
            return std::nullopt;
        }
        std::uint64_t value = 0;
        for (const char c : rest().substr(0, size)) {
            value = value << 8 | static_cast<unsigned char>(c);
        }
        m_at += size;
        return value;
    }
    static std::int64_t extended(std::uint64_t value, std::size_t size)
    {
        const std::size_t unused = 64 - 8 * size;
        return static_cast<std::int64_t>(value << unused) >> unused;
    }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    std::size_t m_lineAt = 0; ///< byte up to which m_line counts
    std::uint64_t m_line = 1;
};

/// Finds VTK's array of hidden cells, behind the geometry: in a FIELD, or as SCALARS. All other arrays are dropped.
/// @return for each cell, in VTK's order: vertices, lines, polygons, strips; empty without a valid array
std::vector<bool> hiddenCells(std::string_view bytes, bool isBinary)
{
    constexpr NumberType kByte{"unsigned_char", 1, false, false};
    constexpr unsigned kNotDrawn =
        vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
    const std::size_t data = bytes.rfind("CELL_DATA");
    const std::string_view ofCells = bytes.substr(std::min(data, bytes.size()));
    const std::size_t name = ofCells.substr(0, ofCells.find("POINT_DATA")).find(vtkDataSetAttributes::GhostArrayName());
    if (name == std::string_view::npos) {
        return {};
    }
    LegacyBody head(ofCells), body(ofCells.substr(name));
    body.isBinary = isBinary;
    (void)head.word();
    const std::optional<std::int64_t> cells = wordToInteger(head.word());
    (void)body.word();
    const std::string_view line = trimmed(body.line());
    if (sameWord(line, kByte.name) || sameWord(line, "unsigned_char 1")) {
        (void)body.line(); // LOOKUP_TABLE
    } else if (!cells || line != "1 " + std::to_string(*cells) + " unsigned_char") {
        return {};
    }
    std::vector<bool> hidden;
    for (std::int64_t i = 0; i < cells.value_or(0); ++i) {
        const std::optional<std::int64_t> kind = body.integer(kByte);
        if (!kind) {
            return {};
        }
        hidden.push_back((static_cast<unsigned>(*kind) & kNotDrawn) != 0);
    }
    return hidden;
}

/// Checks points and cells and rewrites them as a minimal binary file of version 3. VTK's reader checks nothing: cell
/// lists can lead outside the buffer, an unknown version is read as an older layout, memory is allocated by declared
/// counts, and malformed array information causes an endless loop. Fields, attributes and information keys are dropped.
class LegacyScan
{
  public:
    LegacyScan(FileImage& image, const ScanContext& context)
        : m_image(image)
        , m_context(context)
        , m_body(image.bytes())
    {
        m_scan.format = "VTK";
    }
    Result<PreScan> run();

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected)
    {
        return fault(code, m_context.file, m_body.place(), found, expected);
    }
    Status readHeader();
    Status readSection(std::string_view keyword);
    Status readPoints();
    Status readCells(std::string_view keyword);
    /// Reads the types of the cells of an unstructured grid, and takes the cells that belong to a surface.
    Status readCellTypes();
    Status readCellLists(std::uint64_t cells, std::uint64_t numbers, std::string_view keyword);
    Status readCellOffsets(std::uint64_t offsets, std::uint64_t corners, std::string_view keyword);
    Status skipField();
    Status skipText(std::uint64_t count);
    Status takeIndex(std::optional<std::int64_t> index, std::string_view keyword);
    /// Reads a count >= 0; at most kMostElements, and at most one item per remaining byte of the file.
    /// @param what  "number of points", for messages
    Result<std::uint64_t> count(const core::Message& what);
    /// Skips the line end, after which the numbers of a binary file begin.
    Status endLine();
    /// Reads the keyword of an array, OFFSETS or CONNECTIVITY, and an integer type.
    Result<const NumberType*> arrayType(std::string_view word);
    Status reportProgress();
    /// Skips the METADATA block after an array, up to an empty line. @param components  of the array
    void skipMetadata(std::uint64_t components);
    template<class T>
    void append(T value)
    {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), &value, sizeof(T));
        std::reverse(raw.begin(), raw.end());
        m_plain.append(raw.data(), raw.size());
    }
    void appendCorner(std::int64_t value)
    {
        if (m_isGrid) {
            m_cells.push_back(static_cast<std::int32_t>(value));
        } else if (m_isKept) {
            append(static_cast<std::int32_t>(value));
        }
    }

    FileImage& m_image;
    const ScanContext& m_context;
    LegacyBody m_body;
    bool m_hasOffsets = false; ///< cells as offsets and corners, since version 5
    std::optional<std::uint64_t> m_points;
    std::vector<std::string> m_seen; ///< keywords of the sections read so far
    std::string m_plain = "# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\n";
    std::uint64_t m_steps = 0;         ///< numbers checked so far
    bool m_isKept = false;             ///< the current cells are polygons or strips
    bool m_isGrid = false;             ///< an unstructured grid
    std::vector<std::int32_t> m_cells; ///< of the grid: for each the number of corners, then the corners
    std::uint64_t m_cellCount = 0;
    std::uint64_t m_thinCells = 0;   ///< vertices and lines, which VTK counts before the polygons
    std::vector<bool> m_hidden;      ///< of all cells, or empty
    std::uint64_t m_hiddenCells = 0; ///< of a grid, left out
    BadVertices m_bad;
    PreScan m_scan;
};

Status LegacyScan::reportProgress()
{
    if (m_steps++ % 65536 == 0 && m_context.progress &&
        !m_context.progress(double(m_body.at()) / double(m_image.bytes().size()))) {
        return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
    }
    return {};
}

Result<std::uint64_t> LegacyScan::count(const core::Message& what)
{
    const std::string_view word = m_body.word();
    const std::optional<std::int64_t> value = wordToInteger(word);
    if (!value || *value < 0) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1: found %2"), what, inQuotes(word)},
                     {PALPATE_TEXT("a whole number from 0")});
    }
    const auto found = static_cast<std::uint64_t>(*value);
    if (const auto most = std::min<std::uint64_t>(m_body.rest().size(), kMostElements); found > most) {
        return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("%1: declared %2"), what, Count(found)},
                     {PALPATE_TEXT("at most %1, one for each byte that follows"), Count(most)});
    }
    return found;
}

Status LegacyScan::endLine()
{
    if (!m_body.isBinary) {
        return {};
    }
    const std::string_view rest = m_body.line();
    return trimmed(rest).empty() ? Status()
                                 : wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1"), inQuotes(trimmed(rest))},
                                         {PALPATE_TEXT("the end of the line")});
}

Status LegacyScan::readHeader()
{
    const std::string_view first = m_body.line();
    const std::string_view title = m_body.line();
    const std::string_view encoding = m_body.word();
    std::string_view number = first.substr(std::min(kMark.size(), first.size()));
    number = takeWord(number);
    const std::optional<std::int64_t> version = wordToInteger(number.substr(0, number.find('.')));
    if (!version) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1"), inQuotes(trimmed(first))},
                     {PALPATE_TEXT("the line %1"), inQuotes(std::string(kMark) + " 3.0")});
    }
    if (*version < 1 || *version > 5) {
        return wrong(StatusCode::Unsupported, {PALPATE_TEXT("version %1"), *version}, {PALPATE_TEXT("%1 to %2"), 1, 5});
    }
    m_hasOffsets = *version == 5;
    noteSpaceTag(title, m_scan);
    m_body.isBinary = sameWord(encoding, "binary");
    if (!m_body.isBinary && !sameWord(encoding, "ascii")) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1"), inQuotes(encoding)},
                     {PALPATE_TEXT("the keyword %1 or %2"), "\"ASCII\"", "\"BINARY\""});
    }
    return {};
}

Status LegacyScan::readPoints()
{
    const Result<std::uint64_t> points = count({PALPATE_TEXT("number of points")});
    if (!points.isOk()) {
        return points.status();
    }
    const std::string_view word = m_body.word();
    const NumberType* type = typeOf(word);
    if (type == nullptr) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("points of type %1"), inQuotes(word)},
                     {PALPATE_TEXT("a number type")});
    }
    if (Status status = endLine(); !status.isOk()) {
        return status;
    }
    const bool isFloat = type->isFloating && type->size == sizeof(float);
    m_plain.append("POINTS ").append(std::to_string(points.value())).append(isFloat ? " float\n" : " double\n");
    for (std::uint64_t i = 0; i < 3 * points.value(); ++i) {
        const std::optional<double> value = m_body.number(*type);
        if (!value) {
            return wrong(StatusCode::BadFormat,
                         {PALPATE_TEXT("a coordinate of point %1 of %2 is missing or not a number"), i / 3,
                          Count(points.value())},
                         {PALPATE_TEXT("three numbers for each point")});
        }
        if (const core::Message bad = coordinateFault(*value, m_context.unit_mm); !bad.isEmpty()) {
            m_bad.add(static_cast<std::int64_t>(i / 3),
                      wrong(StatusCode::NonFinite, {PALPATE_TEXT("point %1: %2"), i / 3, bad},
                            {PALPATE_TEXT("finite coordinates within 10 km")}));
        }
        if (isFloat) {
            append(static_cast<float>(*value));
        } else {
            append(*value);
        }
        if (Status status = reportProgress(); !status.isOk()) {
            return status;
        }
    }
    m_points = m_scan.points = points.value();
    return {};
}

Status LegacyScan::takeIndex(std::optional<std::int64_t> index, std::string_view keyword)
{
    if (!index) {
        return wrong(StatusCode::BadFormat,
                     {PALPATE_TEXT("%1: a point index is missing or not a whole number"), keyword},
                     {PALPATE_TEXT("as many whole numbers as are declared")});
    }
    if (!m_points || *index < 0 || *index >= static_cast<std::int64_t>(*m_points)) {
        return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("%1 use point %2"), keyword, *index},
                     !m_points       ? core::Message(PALPATE_TEXT("%1 before this section"), "POINTS")
                     : *m_points > 0 ? core::Message(PALPATE_TEXT("%1 to %2"), 0, *m_points - 1)
                                     : core::Message(PALPATE_TEXT("no index, because there are no points")));
    }
    if (Status status = m_isKept || m_isGrid ? m_bad.check(*index) : Status(); !status.isOk()) {
        return status;
    }
    appendCorner(*index);
    return reportProgress();
}

Status LegacyScan::readCellLists(std::uint64_t cells, std::uint64_t numbers, std::string_view keyword)
{
    constexpr NumberType kInt{"int", 4, false, true};
    if (Status status = endLine(); !status.isOk()) {
        return status;
    }
    std::uint64_t left = numbers;
    for (std::uint64_t i = 0; i < cells; ++i) {
        const std::optional<std::int64_t> corners = m_body.integer(kInt);
        if (!corners || *corners < 0 || static_cast<std::uint64_t>(*corners) + 1 > left) {
            return wrong(
                StatusCode::OutOfRange,
                corners
                    ? core::Message(PALPATE_TEXT("%1: number of corners of cell %2: %3"), keyword, i, Count(*corners))
                    : core::Message(PALPATE_TEXT("%1: the number of corners of cell %2 is missing"), keyword, i),
                {PALPATE_TEXT("%1 to %2, as many as the declared values allow"), 0, Count(left == 0 ? 0 : left - 1)});
        }
        left -= static_cast<std::uint64_t>(*corners) + 1;
        appendCorner(*corners);
        for (std::int64_t k = 0; k < *corners; ++k) {
            if (Status status = takeIndex(m_body.integer(kInt), keyword); !status.isOk()) {
                return status;
            }
        }
    }
    return left == 0 ? Status()
                     : wrong(StatusCode::OutOfRange,
                             {PALPATE_TEXT("%1: number of values: declared %2"), keyword, Count(numbers)},
                             {PALPATE_TEXT("%1, as many as the cells use"), Count(numbers - left)});
}

Result<const NumberType*> LegacyScan::arrayType(std::string_view word)
{
    const std::string_view found = m_body.word();
    const std::string_view name = m_body.word();
    const NumberType* type = typeOf(name);
    if (!sameWord(found, word) || type == nullptr || type->isFloating) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1 and %2"), inQuotes(found), inQuotes(name)},
                     {PALPATE_TEXT("the keyword %1 and an integer type"), inQuotes(word)});
    }
    if (Status status = endLine(); !status.isOk()) {
        return status;
    }
    return type;
}

Status LegacyScan::readCellOffsets(std::uint64_t offsets, std::uint64_t corners, std::string_view keyword)
{
    Result<const NumberType*> type = arrayType("OFFSETS");
    std::vector<std::int64_t> starts;
    starts.reserve(offsets);
    std::int64_t before = 0;
    for (std::uint64_t i = 0; type.isOk() && i < offsets; ++i) {
        const std::optional<std::int64_t> offset = m_body.integer(*type.value());
        if (!offset || *offset < before || (i == 0 && *offset != 0) || *offset > static_cast<std::int64_t>(corners)) {
            return wrong(
                StatusCode::OutOfRange,
                offset ? core::Message(PALPATE_TEXT("%1: offset %2 is %3"), keyword, i, *offset)
                       : core::Message(PALPATE_TEXT("%1: offset %2 is missing or not a whole number"), keyword, i),
                i == 0 ? core::Message(PALPATE_TEXT("exactly %1"), 0)
                       : core::Message(PALPATE_TEXT("%1 to %2"), before, corners));
        }
        before = *offset;
        starts.push_back(before);
    }
    if (type.isOk() && before != static_cast<std::int64_t>(corners)) {
        return wrong(StatusCode::OutOfRange,
                     {PALPATE_TEXT("%1: number of corners: declared %2"), keyword, Count(corners)},
                     {PALPATE_TEXT("%1, the last offset"), Count(before)});
    }
    if (type.isOk()) {
        type = arrayType("CONNECTIVITY");
    }
    for (std::size_t cell = 0; type.isOk() && cell + 1 < starts.size(); ++cell) {
        appendCorner(starts[cell + 1] - starts[cell]);
        for (std::int64_t i = starts[cell]; i < starts[cell + 1]; ++i) {
            if (Status status = takeIndex(m_body.integer(*type.value()), keyword); !status.isOk()) {
                return status;
            }
        }
    }
    return type.status();
}

Status LegacyScan::readCells(std::string_view keyword)
{
    const Result<std::uint64_t> first = count({PALPATE_TEXT("number of cells")});
    if (!first.isOk()) {
        return first.status();
    }
    const Result<std::uint64_t> second = count({PALPATE_TEXT("number of values")});
    if (!second.isOk()) {
        return second.status();
    }
    const std::uint64_t cells = first.value() - (m_hasOffsets && first.value() > 0 ? 1 : 0);
    const std::uint64_t numbers = second.value() + (m_hasOffsets ? cells : 0);
    m_isKept = sameWord(keyword, "POLYGONS") || sameWord(keyword, "TRIANGLE_STRIPS");
    m_cellCount = cells;
    m_thinCells += m_isKept ? 0 : cells;
    if (m_isKept) {
        m_scan.cells += cells;
        m_plain.append("\n").append(keyword).append(" ");
        m_plain.append(std::to_string(cells)).append(" ").append(std::to_string(numbers)).append("\n");
    }
    return m_hasOffsets ? readCellOffsets(first.value(), second.value(), keyword)
                        : readCellLists(first.value(), second.value(), keyword);
}

Status LegacyScan::readCellTypes()
{
    constexpr NumberType kInt{"int", 4, false, true};
    const Result<std::uint64_t> types = count({PALPATE_TEXT("number of cell types")});
    if (!types.isOk()) {
        return types.status();
    }
    if (types.value() != m_cellCount) {
        return wrong(StatusCode::OutOfRange,
                     {PALPATE_TEXT("%1: number of values: declared %2"), "CELL_TYPES", Count(types.value())},
                     {PALPATE_TEXT("%1, one for each cell"), Count(m_cellCount)});
    }
    if (Status status = endLine(); !status.isOk()) {
        return status;
    }
    GridSurface surface;
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < types.value(); ++i) {
        const std::optional<std::int64_t> type = m_body.integer(kInt);
        if (!type) {
            return wrong(StatusCode::BadFormat,
                         {PALPATE_TEXT("%1: a value is missing or not a whole number"), "CELL_TYPES"},
                         {PALPATE_TEXT("as many whole numbers as are declared")});
        }
        const auto corners = static_cast<std::size_t>(m_cells[at]);
        if (i < m_hidden.size() && m_hidden[i]) {
            ++m_hiddenCells;
            at += corners + 1;
            continue;
        }
        if (const core::Message why = surface.add(*type, std::span(m_cells).subspan(at + 1, corners)); !why.isEmpty()) {
            return wrong(StatusCode::Unsupported, why, GridSurface::expected());
        }
        at += corners + 1;
    }
    surface.write(m_plain, m_scan);
    return {};
}

/// Skips strings. ASCII files have one per line; in binary files a length field precedes each string, and the first two
/// bits of the field encode the field's size (00: 8 bytes, 01: 4, 10: 2, 11: 1).
Status LegacyScan::skipText(std::uint64_t count)
{
    for (std::uint64_t i = 0; i < count; ++i) {
        if (!m_body.isBinary) {
            (void)m_body.line();
            continue;
        }
        const std::string_view rest = m_body.rest();
        const std::size_t width = rest.empty() ? 0 : std::size_t{8} >> (static_cast<unsigned char>(rest.front()) >> 6);
        constexpr NumberType kByte{"unsigned_char", 1, false, false};
        std::uint64_t length = 0;
        for (std::size_t k = 0; k < std::min(width, rest.size()); ++k) {
            length = length << 8 | (static_cast<unsigned char>(rest[k]) & (k == 0 ? 0x3fU : 0xffU));
        }
        if (width == 0 || length > rest.size() || !m_body.skip(width + length, kByte)) {
            return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("length of a text: %1 bytes"), Count(length)},
                         {PALPATE_TEXT("at most %1, the number of bytes that follow"), Count(rest.size())});
        }
    }
    return {};
}

void LegacyScan::skipMetadata(std::uint64_t components)
{
    (void)m_body.line();
    while (!m_body.rest().empty()) {
        const std::string_view line = trimmed(m_body.line());
        if (line.empty()) {
            return;
        }
        if (sameWord(line, "COMPONENT_NAMES")) { // each name may be empty
            for (std::uint64_t i = 0; i < components && !m_body.rest().empty(); ++i) {
                (void)m_body.line();
            }
        }
    }
}

Status LegacyScan::skipField()
{
    (void)m_body.word(); // name of the field
    const Result<std::uint64_t> arrays = count({PALPATE_TEXT("number of arrays")});
    if (!arrays.isOk()) {
        return arrays.status();
    }
    for (std::uint64_t i = 0; i < arrays.value(); ++i) {
        const std::string_view name = m_body.word();
        const Result<std::uint64_t> components = count({PALPATE_TEXT("number of components")});
        if (!components.isOk()) {
            return components.status();
        }
        const Result<std::uint64_t> tuples = count({PALPATE_TEXT("number of tuples")});
        if (!tuples.isOk()) {
            return tuples.status();
        }
        const std::string_view typeName = m_body.word();
        const NumberType* type = typeOf(typeName);
        if (m_body.isBinary || type == nullptr) {
            (void)m_body.line();
        }
        const std::uint64_t values = components.value() * tuples.value(); // each below 2^31
        if (sameWord(typeName, "string") || sameWord(typeName, "utf8_string")) {
            if (Status status = skipText(std::min<std::uint64_t>(values, m_body.rest().size() + 1)); !status.isOk()) {
                return status;
            }
        } else if (type == nullptr || !m_body.skip(values, *type)) {
            return wrong(StatusCode::BadFormat,
                         {PALPATE_TEXT("array %1: %2"), inQuotes(name),
                          core::Message(PALPATE_TEXT("number of values: declared %1, of type %2"), Count(values),
                                        inQuotes(typeName))},
                         {PALPATE_TEXT("a known type and as many numbers as are declared")});
        }
        std::string_view after = m_body.rest();
        if (sameWord(takeWord(after), "METADATA")) {
            (void)m_body.word();
            skipMetadata(components.value());
        }
    }
    return {};
}

Status LegacyScan::readSection(std::string_view keyword)
{
    const auto is = [&keyword](std::string_view word) { return sameWord(keyword, word); };
    if (is("FIELD")) {
        return skipField();
    }
    if (is("METADATA")) {
        constexpr std::uint64_t kOfPoint = 3; // components of a point; cells have no component names
        skipMetadata(kOfPoint);
        return {};
    }
    if (std::ranges::any_of(m_seen, is)) {
        return wrong(StatusCode::Unsupported, {PALPATE_TEXT("a second section %1"), inQuotes(keyword)},
                     {PALPATE_TEXT("each section once")});
    }
    m_seen.emplace_back(keyword);
    if (is("DATASET")) {
        const std::string_view kind = m_body.word();
        m_isGrid = sameWord(kind, "UNSTRUCTURED_GRID");
        if (sameWord(kind, "STRUCTURED_POINTS") || sameWord(kind, "RECTILINEAR_GRID")) {
            return wrong(StatusCode::Unsupported, {PALPATE_TEXT("a VTK file of type %1"), inQuotes(kind)},
                         {PALPATE_TEXT("a surface. As a map of stiffness, a volume is named in a scene (maps.md)")});
        }
        return m_isGrid || sameWord(kind, "POLYDATA")
                   ? Status()
                   : wrong(StatusCode::Unsupported, {PALPATE_TEXT("a VTK file of type %1"), inQuotes(kind)},
                           {PALPATE_TEXT("the type %1"), "\"POLYDATA\""});
    }
    if (is("POINTS")) {
        return readPoints();
    }
    if (m_isGrid && is("CELLS")) {
        return readCells(keyword);
    }
    if (m_isGrid && is("CELL_TYPES")) {
        return readCellTypes();
    }
    if (!m_isGrid && (is("VERTICES") || is("LINES") || is("POLYGONS") || is("TRIANGLE_STRIPS"))) {
        return readCells(keyword);
    }
    return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1"), inQuotes(keyword)},
                 {PALPATE_TEXT("one of the keywords %1"),
                  m_isGrid
                      ? "DATASET, FIELD, POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA"
                      : "DATASET, FIELD, POINTS, VERTICES, LINES, POLYGONS, TRIANGLE_STRIPS, POINT_DATA, CELL_DATA"});
}

Result<PreScan> LegacyScan::run()
{
    Status status = readHeader();
    m_hidden = hiddenCells(m_body.rest(), m_body.isBinary);
    while (status.isOk()) {
        const std::string_view word = m_body.word();
        if (withoutPadding(word).empty() || sameWord(word, "POINT_DATA") || sameWord(word, "CELL_DATA")) {
            break;
        }
        status = readSection(word);
    }
    if (m_body.rest().find("COLOR_SCALARS") != std::string_view::npos) {
        m_scan.notes.push_back({PALPATE_TEXT("colours not read: those of %1"), "COLOR_SCALARS"});
    }
    noteHiddenCells(m_hiddenCells, m_scan);
    if (!m_isGrid && m_thinCells < m_hidden.size()) {
        m_scan.hiddenCells.assign(m_hidden.begin() + static_cast<std::ptrdiff_t>(m_thinCells), m_hidden.end());
    }
    if (status.isOk() && m_scan.cells == 0) {
        status = noFaces(m_scan.points, m_body.place(), m_context);
    }
    if (!status.isOk()) {
        return status;
    }
    Result<FileImage> plain = FileImage::copy(m_plain, m_context.file);
    if (!plain.isOk()) {
        return plain.status();
    }
    m_image = std::move(plain).value();
    return std::move(m_scan);
}

bool looksLikeLegacyVtk(std::string_view bytes)
{
    return bytes.starts_with("# vtk DataFile");
}

Result<PreScan> guardLegacyVtk(FileImage& image, const ScanContext& context)
{
    return LegacyScan(image, context).run();
}

vtkSmartPointer<vtkAlgorithm> legacyVtkReader(const std::string& path, const PreScan& /*scan*/)
{
    auto made = vtkSmartPointer<vtkPolyDataReader>::New();
    made->SetFileName(path.c_str());
    return made;
}

constexpr std::array<std::string_view, 1> kLegacyVtkExtensions{".vtk"};

} // namespace

const MeshFormat kLegacyVtk{"VTK", kLegacyVtkExtensions, false, looksLikeLegacyVtk, guardLegacyVtk, legacyVtkReader};

} // namespace palpate::meshio::internal
