// SPDX-License-Identifier: BSD-3-Clause
#include "formats/GridSurface.h"
#include "formats/MeshFormat.h"
#include "formats/VtpBlocks.h"
#include "formats/VtpHeader.h"
#include "formats/VtpText.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <palpate/core/TissueMapping.h>

#include <vtkDataArraySelection.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

/// Checks each array that VTK will read against the counts that size VTK's memory.
class VtpScan
{
  public:
    VtpScan(const VtpHeader& header, const ScanContext& context, PreScan& scan)
        : m_header(header)
        , m_context(context)
        , m_scan(scan)
    {
    }
    Status run();
    /// Checks an unstructured grid. @param plain  receives the surface as a legacy VTK file
    Status runGrid(std::string& plain);

  private:
    Status wrong(const VtpDataArray& array, StatusCode code, const core::Message& found,
                 const core::Message& expected) const
    {
        return fault(code, m_context.file, onLine(array.line),
                     {PALPATE_TEXT("array %1: %2"), inQuotes(array.name), found}, expected);
    }
    [[nodiscard]] std::string_view textOf(const VtpDataArray& array) const
    {
        return {array.text.constData(), static_cast<std::size_t>(array.text.size())};
    }
    /// Returns the number of values in the array, each of the declared type.
    Result<std::uint64_t> countValues(const VtpDataArray& array) const;
    Status checkCount(const VtpDataArray& array, std::uint64_t expected) const;
    Status checkPiece(const VtpPiece& piece);
    Status checkPoints(const VtpPiece& piece) const;
    Status checkCells(const VtpCells& cells, const char* name, const VtpPiece& piece) const;
    /// Decodes the bytes of a binary or appended array.
    Result<std::vector<unsigned char>> unpacked(const VtpDataArray& array) const;
    Result<std::vector<std::int64_t>> integers(const VtpDataArray& array) const;
    /// Number of strings in the array; each ends with a zero byte.
    Result<std::uint64_t> countStrings(const VtpDataArray& array) const;
    Result<std::vector<double>> numbers(const VtpDataArray& array) const;
    /// Appends the points and cells of a piece of an unstructured grid.
    Status takeGrid(const VtpPiece& piece, std::vector<double>& coordinates, GridSurface& surface);
    /// Cells that VTK's ghost array hides; empty without a valid one.
    [[nodiscard]] std::vector<bool> hiddenCells(const VtpPiece& piece) const;
    Status checkFieldData() const;
    Status takeArrays(const std::vector<VtpDataArray>& arrays, std::uint64_t tuples, bool isOfPoints,
                      std::vector<std::string>& usable);

    const VtpHeader& m_header;
    const ScanContext& m_context;
    PreScan& m_scan;
    std::uint64_t m_hidden = 0; ///< cells
};

/// VTK's reader extracts numbers from a stream, which fails if the type cannot represent a number, and searches after
/// "nan" and "inf" for further letters, which fails at the end of the array's text.
/// @param word  a number; @param isAtEnd  nothing follows, not even a blank
/// @return the expected form; empty if VTK reads the word correctly
core::Message unreadable(std::string_view word, const std::string& type, bool isAtEnd)
{
    if (isVtpIntegerType(type)) {
        const std::int64_t value = wordToInteger(word).value_or(0);
        const bool isWide = type == "Int32" && (value < std::numeric_limits<std::int32_t>::min() ||
                                                value > std::numeric_limits<std::int32_t>::max());
        return isWide ? core::Message(PALPATE_TEXT("a number in the range of %1"), type) : core::Message();
    }
    const double value = wordToNumber(word).value_or(0.0);
    const bool isWord = word.find_first_of("nN") != std::string_view::npos; // both nan and inf contain an n
    if (isWord) {
        return isAtEnd ? core::Message(PALPATE_TEXT("a blank or a line end after it")) : core::Message();
    }
    const double most =
        type == "Float32" ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    return std::abs(value) > most ? core::Message(PALPATE_TEXT("a number in the range of %1"), type) : core::Message();
}

Result<std::uint64_t> VtpScan::countValues(const VtpDataArray& array) const
{
    const std::size_t size = vtpTypeSize(array.type);
    if (size == 0) {
        return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("its type is %1"), inQuotes(array.type)},
                     {PALPATE_TEXT("a number type")});
    }
    if (array.format != VtpFormat::Ascii) {
        const Result<VtpBlocks> blocks = VtpBlocks::find(array, m_header, m_context);
        if (!blocks.isOk()) {
            return blocks.status();
        }
        if (blocks.value().size() % size != 0) {
            return wrong(array, StatusCode::BadFormat,
                         {PALPATE_TEXT("size of its data: %1 bytes"), Count(blocks.value().size())},
                         {PALPATE_TEXT("a multiple of %1 bytes"), size});
        }
        return blocks.value().size() / size;
    }
    std::uint64_t count = 0;
    std::string_view rest = textOf(array);
    const bool isInteger = isVtpIntegerType(array.type);
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        if (isInteger ? !wordToInteger(word) : !wordToNumber(word)) {
            return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("value %1 is %2"), count, inQuotes(word)},
                         {PALPATE_TEXT("a number of type %1"), array.type});
        }
        const core::Message readable = unreadable(word, array.type, rest.empty());
        if (!readable.isEmpty()) {
            return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("value %1 is %2"), count, inQuotes(word)},
                         readable);
        }
        ++count;
    }
    return count;
}

Status VtpScan::checkCount(const VtpDataArray& array, std::uint64_t expected) const
{
    const Result<std::uint64_t> count = countValues(array);
    if (!count.isOk()) {
        return count.status();
    }
    if (count.value() != expected) {
        return wrong(array, StatusCode::OutOfRange, {PALPATE_TEXT("number of values: %1"), Count(count.value())},
                     {PALPATE_TEXT("exactly %1"), Count(expected)});
    }
    return {};
}

Status VtpScan::checkPoints(const VtpPiece& piece) const
{
    if (!piece.coordinates && piece.points == 0) {
        return {};
    }
    if (!piece.coordinates) {
        return fault(
            StatusCode::BadFormat, m_context.file, onLine(piece.line),
            {PALPATE_TEXT("number of points: declared %1, but there is no array of points"), Count(piece.points)},
            {PALPATE_TEXT("an array of points")});
    }
    const VtpDataArray& array = *piece.coordinates;
    if (array.components != 3) {
        return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("number of components: %1"), array.components},
                     {PALPATE_TEXT("exactly %1"), 3});
    }
    if (Status status = checkCount(array, piece.points * 3); !status.isOk()) {
        return status;
    }
    return {}; // coordinates are checked where a triangle uses the point
}

Result<std::vector<unsigned char>> VtpScan::unpacked(const VtpDataArray& array) const
{
    const Result<VtpBlocks> blocks = VtpBlocks::find(array, m_header, m_context);
    if (!blocks.isOk()) {
        return blocks.status();
    }
    auto bytes = blocks.value().unpack();
    if (!bytes) {
        return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("its compressed data are damaged")},
                     {PALPATE_TEXT("data that can be decompressed")});
    }
    return std::move(*bytes);
}

Result<std::vector<std::int64_t>> VtpScan::integers(const VtpDataArray& array) const
{
    if (array.format == VtpFormat::Ascii) {
        std::vector<std::int64_t> out;
        std::string_view rest = textOf(array);
        for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            out.push_back(wordToInteger(word).value_or(-1));
        }
        return out;
    }
    const Result<std::vector<unsigned char>> bytes = unpacked(array);
    if (!bytes.isOk()) {
        return bytes.status();
    }
    return vtpIntegers(bytes.value(), array.type, m_header.isBigEndian);
}

Status VtpScan::checkCells(const VtpCells& cells, const char* name, const VtpPiece& piece) const
{
    if (!cells.connectivity || !cells.offsets) {
        if (cells.count == 0 && !cells.connectivity && !cells.offsets) {
            return {};
        }
        return fault(StatusCode::BadFormat, m_context.file, onLine(piece.line),
                     {PALPATE_TEXT("%1: declared %2 cells, but an array is missing"), name, Count(cells.count)},
                     {PALPATE_TEXT("the arrays %1 and %2"), "\"connectivity\"", "\"offsets\""});
    }
    for (const VtpDataArray* array : {&*cells.connectivity, &*cells.offsets}) {
        if (!isVtpIntegerType(array->type) || array->components != 1) {
            return wrong(
                *array, StatusCode::BadFormat,
                {PALPATE_TEXT("its type is %1, its number of components %2"), inQuotes(array->type), array->components},
                {PALPATE_TEXT("whole numbers with one component")});
        }
    }
    const Result<std::uint64_t> corners = countValues(*cells.connectivity);
    if (!corners.isOk()) {
        return corners.status();
    }
    if (corners.value() > kMostElements) {
        return wrong(*cells.connectivity, StatusCode::Unsupported,
                     {PALPATE_TEXT("number of values: %1"), Count(corners.value())},
                     {PALPATE_TEXT("at most %1"), Count(kMostElements)});
    }
    if (Status status = checkCount(*cells.offsets, cells.count); !status.isOk()) {
        return status;
    }
    const Result<std::vector<std::int64_t>> offsets = integers(*cells.offsets);
    if (!offsets.isOk()) {
        return offsets.status();
    }
    std::int64_t before = 0;
    for (std::size_t i = 0; i < offsets.value().size(); ++i) {
        const std::int64_t offset = offsets.value()[i];
        if (offset < before || offset > static_cast<std::int64_t>(corners.value())) {
            return wrong(*cells.offsets, StatusCode::OutOfRange, {PALPATE_TEXT("value %1 is %2"), i, offset},
                         {PALPATE_TEXT("%1 to %2"), before, corners.value()});
        }
        before = offset;
    }
    if (before != static_cast<std::int64_t>(corners.value())) {
        return wrong(*cells.connectivity, StatusCode::OutOfRange,
                     {PALPATE_TEXT("number of values: %1"), Count(corners.value())},
                     {PALPATE_TEXT("%1, the last offset"), Count(before)});
    }
    if (cells.connectivity->format == VtpFormat::Ascii) {
        const Result<std::vector<std::int64_t>> indices = integers(*cells.connectivity);
        for (std::size_t i = 0; i < indices.value().size(); ++i) {
            const std::int64_t index = indices.value()[i];
            if (index < 0 || index >= static_cast<std::int64_t>(piece.points)) {
                return wrong(*cells.connectivity, StatusCode::OutOfRange,
                             {PALPATE_TEXT("value %1 is point %2"), i, index},
                             piece.points == 0 ? core::Message(PALPATE_TEXT("no index, because there are no points"))
                                               : core::Message(PALPATE_TEXT("%1 to %2"), 0, piece.points - 1));
            }
        }
    }
    return {};
}

Result<std::uint64_t> VtpScan::countStrings(const VtpDataArray& array) const
{
    std::string characters;
    if (array.format == VtpFormat::Ascii) { // each character is stored as a number
        std::string_view rest = textOf(array);
        for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            const std::optional<std::int64_t> code = wordToInteger(word);
            if (!code || *code < -128 || *code > 255) {
                return wrong(array, StatusCode::BadFormat,
                             {PALPATE_TEXT("character %1 is %2"), characters.size(), inQuotes(word)},
                             {PALPATE_TEXT("a number from %1 to %2"), 0, 255});
            }
            characters.push_back(static_cast<char>(*code));
        }
    } else {
        const Result<std::vector<unsigned char>> bytes = unpacked(array);
        if (!bytes.isOk()) {
            return bytes.status();
        }
        characters.assign(bytes.value().begin(), bytes.value().end());
    }
    if (!characters.empty() && characters.back() != '\0') {
        return wrong(array, StatusCode::BadFormat, {PALPATE_TEXT("its last string has no end")},
                     {PALPATE_TEXT("a zero after each string")});
    }
    return static_cast<std::uint64_t>(std::ranges::count(characters, '\0'));
}

Status VtpScan::checkFieldData() const
{
    for (const VtpDataArray& array : m_header.fieldData) {
        const bool isText = array.type == "String";
        const Result<std::uint64_t> held = isText ? countStrings(array) : countValues(array);
        if (!held.isOk()) {
            return held.status();
        }
        const std::uint64_t most = held.value();
        const std::uint64_t tuples = array.tuples.value_or(0);
        const bool isTooMany =
            array.components == 0 || tuples > most || array.components > most + 1 || tuples * array.components > most;
        // VTK copies every string without a bounds check.
        if (isTooMany || (isText && tuples * array.components != most)) {
            return wrong(array, StatusCode::OutOfRange,
                         {PALPATE_TEXT("number of tuples: declared %1, of components in each: %2"), Count(tuples),
                          Count(array.components)},
                         isText
                             ? core::Message(PALPATE_TEXT("exactly %1 values, as many as it contains"), Count(most))
                             : core::Message(PALPATE_TEXT("at most %1 values, as many as it contains"), Count(most)));
        }
    }
    return {};
}

/// Lists the arrays of a piece with one number per point or polygon. An array with the name of a known map
/// must be intact; any other damaged array is reported and ignored.
Status VtpScan::takeArrays(const std::vector<VtpDataArray>& arrays, std::uint64_t tuples, bool isOfPoints,
                           std::vector<std::string>& usable)
{
    std::vector<std::string> here;
    for (const VtpDataArray& array : arrays) {
        if (array.name == "StructureId") {
            continue;
        }
        const bool isKnown = std::any_of(core::kKnownMaps.begin(), core::kKnownMaps.end(),
                                         [&](const core::KnownMap& map) { return map.array == array.name; });
        if (isKnown && array.components != 1) {
            return wrong(array, StatusCode::BadFormat,
                         {PALPATE_TEXT("number of components: %1"), Count(array.components)},
                         {PALPATE_TEXT("exactly %1"), 1});
        }
        if (array.components > kMostElements) {
            continue;
        }
        if (array.type == "UInt8" && (array.components == 3 || array.components == 4)) { // VTK's colours
            const std::string name = inQuotes(array.name);
            const core::Message note =
                isOfPoints ? core::Message(PALPATE_TEXT("colours not read: the array %1 of its points"), name)
                           : core::Message(PALPATE_TEXT("colours not read: the array %1 of its polygons"), name);
            const bool isReported = std::ranges::any_of(
                m_scan.notes, [&](const core::Message& other) { return other.english() == note.english(); });
            if (!isReported) { // report once for all pieces
                m_scan.notes.push_back(note);
            }
        }
        const bool isText = array.type == "String";
        const Result<std::uint64_t> held = isText ? countStrings(array) : countValues(array);
        if (isKnown && (!held.isOk() || held.value() != tuples)) {
            return !held.isOk()
                       ? held.status()
                       : wrong(array, StatusCode::OutOfRange,
                               {PALPATE_TEXT("number of values: %1"), Count(held.value())},
                               isOfPoints ? core::Message(PALPATE_TEXT("%1, one for each point"), Count(tuples))
                                          : core::Message(PALPATE_TEXT("%1, one for each polygon"), Count(tuples)));
        }
        // VTK dereferences a null pointer if cell data fail to decompress and point data are absent.
        const bool isWhole =
            held.isOk() && held.value() == tuples * array.components &&
            (isText || array.components != 1 || array.format == VtpFormat::Ascii || unpacked(array).isOk());
        if (isKnown && !isWhole) {
            return unpacked(array).status();
        }
        if (!isWhole) {
            m_scan.notes.push_back({PALPATE_TEXT("the array %1 is damaged and not used"), inQuotes(array.name)});
        } else if (!isText && array.components == 1 && !array.name.empty()) {
            here.push_back(array.name);
        }
    }
    // Keep the arrays present in all pieces.
    if (m_scan.points == 0 && m_scan.cells == 0) {
        usable = std::move(here);
    } else {
        std::erase_if(usable, [&](const std::string& name) { return std::ranges::count(here, name) == 0; });
    }
    return {};
}

Status VtpScan::checkPiece(const VtpPiece& piece)
{
    for (const std::uint64_t count :
         {piece.points, piece.verts.count, piece.lines.count, piece.strips.count, piece.polys.count}) {
        if (count > kMostElements) {
            return fault(StatusCode::OutOfRange, m_context.file, onLine(piece.line),
                         {PALPATE_TEXT("number of elements: declared %1"), Count(count)},
                         {PALPATE_TEXT("at most %1"), Count(kMostElements)});
        }
    }
    if (Status status = checkPoints(piece); !status.isOk()) {
        return status;
    }
    const std::array<std::pair<const VtpCells*, const char*>, 4> kinds{
        {{&piece.verts, "Verts"}, {&piece.lines, "Lines"}, {&piece.strips, "Strips"}, {&piece.polys, "Polys"}}};
    std::uint64_t cells = 0;
    for (const auto& [kind, name] : kinds) {
        if (Status status = checkCells(*kind, name, piece); !status.isOk()) {
            return status;
        }
        cells += kind->count;
    }
    for (const VtpDataArray& array : piece.cellData) {
        if (array.name == "StructureId") {
            if (!isVtpIntegerType(array.type) || array.components != 1) {
                return wrong(array, StatusCode::BadFormat,
                             {PALPATE_TEXT("its type is %1, its number of components %2"), inQuotes(array.type),
                              array.components},
                             {PALPATE_TEXT("whole numbers with one component")});
            }
            if (Status status = checkCount(array, cells); !status.isOk()) {
                return status;
            }
            // VTK dereferences a null pointer if cell data fail to decompress and point data are absent.
            if (const Result<std::vector<std::int64_t>> numbers = integers(array); !numbers.isOk()) {
                return numbers.status();
            }
        }
    }
    if (piece.points == 0 && cells == 0) {
        return {}; // an empty piece may lack the arrays of the others
    }
    if (Status status = takeArrays(piece.pointData, piece.points, true, m_scan.pointArrays); !status.isOk()) {
        return status;
    }
    if (Status status = takeArrays(piece.cellData, cells, false, m_scan.cellArrays); !status.isOk()) {
        return status;
    }
    m_scan.points += piece.points;
    m_scan.cells += piece.strips.count + piece.polys.count;
    return {};
}

Status VtpScan::run()
{
    if (Status status = checkFieldData(); !status.isOk()) {
        return status;
    }
    double done = 0.0;
    for (const VtpPiece& piece : m_header.pieces) {
        if (Status status = checkPiece(piece); !status.isOk()) {
            return status;
        }
        done += 1.0 / static_cast<double>(m_header.pieces.size());
        if (m_context.progress && !m_context.progress(done)) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
        }
    }
    if (m_scan.cells == 0) {
        return noFaces(m_scan.points, {}, m_context);
    }
    if (m_scan.points > kMostElements || m_scan.cells > kMostElements) {
        return fault(StatusCode::Unsupported, m_context.file, {},
                     {PALPATE_TEXT("number of points: %1, of polygons and strips: %2"), Count(m_scan.points),
                      Count(m_scan.cells)},
                     {PALPATE_TEXT("at most %1 of each"), Count(kMostElements)});
    }
    return {};
}

Result<std::vector<double>> VtpScan::numbers(const VtpDataArray& array) const
{
    if (array.format == VtpFormat::Ascii) {
        std::vector<double> out;
        std::string_view rest = textOf(array);
        for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            out.push_back(wordToNumber(word).value_or(0.0));
        }
        return out;
    }
    const Result<std::vector<unsigned char>> bytes = unpacked(array);
    if (!bytes.isOk()) {
        return bytes.status();
    }
    return vtpNumbers(bytes.value(), array.type, m_header.isBigEndian);
}

std::vector<bool> VtpScan::hiddenCells(const VtpPiece& piece) const
{
    constexpr std::int64_t kNotDrawn =
        vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
    std::vector<bool> hidden;
    for (const VtpDataArray& array : piece.cellData) {
        if (array.name != vtkDataSetAttributes::GhostArrayName() || !isVtpIntegerType(array.type) ||
            !checkCount(array, piece.cells.count).isOk()) {
            continue;
        }
        if (const Result<std::vector<std::int64_t>> types = integers(array); types.isOk()) {
            hidden.clear();
            for (const std::int64_t type : types.value()) {
                hidden.push_back((type & kNotDrawn) != 0);
            }
        }
    }
    return hidden;
}

Status VtpScan::takeGrid(const VtpPiece& piece, std::vector<double>& coordinates, GridSurface& surface)
{
    if (piece.points > kMostElements || piece.cells.count > kMostElements) {
        return fault(
            StatusCode::OutOfRange, m_context.file, onLine(piece.line),
            {PALPATE_TEXT("number of elements: declared %1"), Count(std::max(piece.points, piece.cells.count))},
            {PALPATE_TEXT("at most %1"), Count(kMostElements)});
    }
    Status status = checkPoints(piece);
    status = status.isOk() ? checkCells(piece.cells, "Cells", piece) : status;
    if (!status.isOk() || piece.cells.count == 0 || !piece.coordinates) {
        return status;
    }
    if (!piece.types || !isVtpIntegerType(piece.types->type)) {
        return fault(StatusCode::BadFormat, m_context.file, onLine(piece.line),
                     {PALPATE_TEXT("the cells have no types")}, {PALPATE_TEXT("the array %1"), "\"types\""});
    }
    if (Status count = checkCount(*piece.types, piece.cells.count); !count.isOk()) {
        return count;
    }
    const Result<std::vector<double>> points = numbers(*piece.coordinates);
    const Result<std::vector<std::int64_t>> types = integers(*piece.types);
    const Result<std::vector<std::int64_t>> offsets = integers(*piece.cells.offsets);
    const Result<std::vector<std::int64_t>> corners = integers(*piece.cells.connectivity);
    for (const Status& read : {points.status(), types.status(), offsets.status(), corners.status()}) {
        if (!read.isOk()) {
            return read;
        }
    }
    const std::size_t before = coordinates.size() / 3;
    coordinates.insert(coordinates.end(), points.value().begin(), points.value().end());
    const std::vector<bool> hidden = hiddenCells(piece);
    std::vector<std::int32_t> cell;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < types.value().size(); ++i) {
        const auto end = static_cast<std::size_t>(offsets.value()[i]);
        cell.clear();
        for (std::size_t k = begin; k < end; ++k) {
            const std::int64_t corner = corners.value()[k];
            if (corner < 0 || corner >= static_cast<std::int64_t>(piece.points)) {
                return wrong(*piece.cells.connectivity, StatusCode::OutOfRange,
                             {PALPATE_TEXT("value %1 is point %2"), k, corner},
                             {PALPATE_TEXT("%1 to %2"), 0, static_cast<std::int64_t>(piece.points) - 1});
            }
            cell.push_back(static_cast<std::int32_t>(before + static_cast<std::size_t>(corner)));
        }
        begin = end;
        if (!hidden.empty() && hidden[i]) {
            ++m_hidden;
        } else if (const core::Message why = surface.add(types.value()[i], cell); !why.isEmpty()) {
            return wrong(*piece.types, StatusCode::Unsupported, why, GridSurface::expected());
        }
    }
    return {};
}

Status VtpScan::runGrid(std::string& plain)
{
    Status status = checkFieldData();
    std::vector<double> coordinates;
    GridSurface surface;
    for (const VtpPiece& piece : m_header.pieces) {
        status = status.isOk() ? takeGrid(piece, coordinates, surface) : status;
        if (status.isOk() && m_context.progress && !m_context.progress(0.5)) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
        }
    }
    m_scan.points = coordinates.size() / 3;
    if (status.isOk() && m_scan.points > kMostElements) {
        status = fault(StatusCode::Unsupported, m_context.file, {},
                       {PALPATE_TEXT("number of points: %1"), Count(m_scan.points)},
                       {PALPATE_TEXT("at most %1"), Count(kMostElements)});
    }
    if (!status.isOk()) {
        return status;
    }
    plain =
        "# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS " + std::to_string(m_scan.points) + " double\n";
    for (const double x : coordinates) {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        for (unsigned shift = 64; shift > 0; shift -= 8) {
            plain += static_cast<char>(bits >> (shift - 8U) & 0xffU);
        }
    }
    surface.write(plain, m_scan);
    noteHiddenCells(m_hidden, m_scan);
    return m_scan.cells > 0 ? Status() : noFaces(m_scan.points, {}, m_context);
}

/// True for any XML; the header check reports other kinds of VTK files.
bool looksLikeVtp(std::string_view bytes)
{
    const std::string_view text = startOfText(bytes);
    return text.starts_with('<') || text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

bool looksLikeVtu(std::string_view bytes)
{
    const std::string_view text = startOfText(bytes);
    return text.starts_with('<') && text.find("\"UnstructuredGrid\"") != std::string_view::npos;
}

Result<PreScan> guardVtp(FileImage& image, const ScanContext& context)
{
    if (Status status = removePadding(image, context); !status.isOk()) {
        return status;
    }
    if (Status status = makeNumbersReadable(image, context); !status.isOk()) {
        return status;
    }
    PreScan scan;
    scan.format = "VTP";
    const Result<VtpHeader> header = readVtpHeader(image.bytes(), context);
    if (!header.isOk()) {
        return header.status();
    }
    if (Status status = VtpScan(header.value(), context, scan).run(); !status.isOk()) {
        return status;
    }
    removeEmptyPieces(image, header.value());
    return scan;
}

/// VTK's surface reader does not read grids: the image becomes the surface alone.
Result<PreScan> guardVtu(FileImage& image, const ScanContext& context)
{
    if (Status status = removePadding(image, context); !status.isOk()) {
        return status;
    }
    if (Status status = makeNumbersReadable(image, context); !status.isOk()) {
        return status;
    }
    PreScan scan;
    scan.format = "VTU";
    std::string plain;
    {
        const Result<VtpHeader> header = readVtpHeader(image.bytes(), context, kGridType);
        if (!header.isOk()) {
            return header.status();
        }
        if (Status status = VtpScan(header.value(), context, scan).runGrid(plain); !status.isOk()) {
            return status;
        }
    }
    Result<FileImage> surface = FileImage::copy(plain, context.file);
    if (!surface.isOk()) {
        return surface.status();
    }
    image = std::move(surface).value();
    return scan;
}

vtkSmartPointer<vtkAlgorithm> vtpReader(const std::string& path, const PreScan& scan)
{
    auto made = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    made->SetFileName(path.c_str());
    made->UpdateInformation();
    made->GetPointDataArraySelection()->DisableAllArrays();
    made->GetCellDataArraySelection()->DisableAllArrays();
    made->GetCellDataArraySelection()->EnableArray("StructureId");
    for (const std::string& name : scan.pointArrays) {
        made->GetPointDataArraySelection()->EnableArray(name.c_str());
    }
    for (const std::string& name : scan.cellArrays) {
        made->GetCellDataArraySelection()->EnableArray(name.c_str());
    }
    return made;
}

vtkSmartPointer<vtkAlgorithm> vtuReader(const std::string& path, const PreScan& /*scan*/)
{
    auto made = vtkSmartPointer<vtkPolyDataReader>::New();
    made->SetFileName(path.c_str());
    return made;
}

constexpr std::array<std::string_view, 1> kVtpExtensions{".vtp"};
constexpr std::array<std::string_view, 1> kVtuExtensions{".vtu"};

} // namespace

const MeshFormat kVtp{"VTP", kVtpExtensions, false, looksLikeVtp, guardVtp, vtpReader};
const MeshFormat kVtu{"VTU", kVtuExtensions, false, looksLikeVtu, guardVtu, vtuReader};

} // namespace palpate::meshio::internal
