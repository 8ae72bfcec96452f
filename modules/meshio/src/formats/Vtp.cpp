// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"
#include "formats/VtpBlocks.h"
#include "formats/VtpHeader.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <palpate/core/TissueMapping.h>

#include <vtkDataArraySelection.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

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

  private:
    Status wrong(const VtpDataArray& array, StatusCode code, std::string_view found, std::string_view expected) const
    {
        return fault(code, m_context.file, atLine(array.line),
                     "array " + inQuotes(array.name) + ": " + std::string(found), expected);
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
    Status checkFieldData() const;
    Status takeArrays(const std::vector<VtpDataArray>& arrays, std::uint64_t tuples, const char* each,
                      std::vector<std::string>& usable);

    const VtpHeader& m_header;
    const ScanContext& m_context;
    PreScan& m_scan;
};

/// VTK's reader extracts numbers from a stream, which fails if the type cannot represent a number, and searches after
/// "nan" and "inf" for further letters, which fails at the end of the array's text.
/// @param word  a number; @param isAtEnd  nothing follows, not even a blank
/// @return the expected form; empty if VTK reads the word correctly
std::string unreadable(std::string_view word, const std::string& type, bool isAtEnd)
{
    if (isVtpIntegerType(type)) {
        const std::int64_t value = wordToInteger(word).value_or(0);
        const bool isWide = type == "Int32" && (value < std::numeric_limits<std::int32_t>::min() ||
                                                value > std::numeric_limits<std::int32_t>::max());
        return isWide ? "a number that an Int32 can hold" : "";
    }
    const double value = wordToNumber(word).value_or(0.0);
    const bool isWord = word.find_first_of("nN") != std::string_view::npos; // both nan and inf contain an n
    if (isWord) {
        return isAtEnd ? "a blank or a new line behind it" : "";
    }
    const double most =
        type == "Float32" ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    return std::abs(value) > most ? "a number that a " + type + " can hold" : "";
}

Result<std::uint64_t> VtpScan::countValues(const VtpDataArray& array) const
{
    const std::size_t size = vtpTypeSize(array.type);
    if (size == 0) {
        return wrong(array, StatusCode::BadFormat, "its type is " + inQuotes(array.type), "a type of numbers");
    }
    if (array.format != VtpFormat::Ascii) {
        const Result<VtpBlocks> blocks = VtpBlocks::find(array, m_header, m_context);
        if (!blocks.isOk()) {
            return blocks.status();
        }
        if (blocks.value().size() % size != 0) {
            return wrong(array, StatusCode::BadFormat, counted(blocks.value().size(), "byte"),
                         "a multiple of " + std::to_string(size));
        }
        return blocks.value().size() / size;
    }
    std::uint64_t count = 0;
    std::string_view rest = textOf(array);
    const bool isInteger = isVtpIntegerType(array.type);
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        if (isInteger ? !wordToInteger(word) : !wordToNumber(word)) {
            return wrong(array, StatusCode::BadFormat, "value " + std::to_string(count) + " is " + inQuotes(word),
                         "a number of type " + array.type);
        }
        const std::string faulty = unreadable(word, array.type, rest.empty());
        if (!faulty.empty()) {
            return wrong(array, StatusCode::BadFormat, "value " + std::to_string(count) + " is " + inQuotes(word),
                         faulty);
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
        return wrong(array, StatusCode::OutOfRange, counted(count.value(), "value"), grouped(expected));
    }
    return {};
}

Status VtpScan::checkPoints(const VtpPiece& piece) const
{
    if (!piece.coordinates) {
        return fault(StatusCode::BadFormat, m_context.file, atLine(piece.line),
                     grouped(piece.points) + " points declared but none given", "an array of points");
    }
    const VtpDataArray& array = *piece.coordinates;
    if (array.components != 3) {
        return wrong(array, StatusCode::BadFormat, counted(array.components, "component") + " for each point", "3");
    }
    if (Status status = checkCount(array, piece.points * 3); !status.isOk()) {
        return status;
    }
    if (array.format == VtpFormat::Ascii) {
        std::string_view rest = textOf(array);
        for (std::uint64_t i = 0; i < piece.points * 3; ++i) {
            const std::string_view word = takeWord(rest);
            if (const std::string bad = coordinateFault(*wordToNumber(word), m_context.unit_mm); !bad.empty()) {
                return wrong(array, StatusCode::NonFinite,
                             "point " + std::to_string(i / 3) + ": " + bad + " (" + inQuotes(word) + ")",
                             "finite coordinates within 10 km");
            }
        }
    }
    return {};
}

Result<std::vector<unsigned char>> VtpScan::unpacked(const VtpDataArray& array) const
{
    const Result<VtpBlocks> blocks = VtpBlocks::find(array, m_header, m_context);
    if (!blocks.isOk()) {
        return blocks.status();
    }
    auto bytes = blocks.value().unpack();
    if (!bytes) {
        return wrong(array, StatusCode::BadFormat, "its compressed data are damaged", "data that unpack");
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
        return fault(StatusCode::BadFormat, m_context.file, atLine(piece.line),
                     grouped(cells.count) + " " + name + " declared, but not both their arrays given",
                     "arrays \"connectivity\" and \"offsets\"");
    }
    for (const VtpDataArray* array : {&*cells.connectivity, &*cells.offsets}) {
        if (!isVtpIntegerType(array->type) || array->components != 1) {
            return wrong(*array, StatusCode::BadFormat,
                         "its type is " + inQuotes(array->type) + " with " + counted(array->components, "component"),
                         "whole numbers, one component");
        }
    }
    const Result<std::uint64_t> corners = countValues(*cells.connectivity);
    if (!corners.isOk()) {
        return corners.status();
    }
    if (corners.value() > kMostElements) {
        return wrong(*cells.connectivity, StatusCode::Unsupported, counted(corners.value(), "index"),
                     "at most " + grouped(kMostElements));
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
            return wrong(*cells.offsets, StatusCode::OutOfRange,
                         "value " + std::to_string(i) + " is " + std::to_string(offset),
                         std::to_string(before) + " to " + std::to_string(corners.value()));
        }
        before = offset;
    }
    if (before != static_cast<std::int64_t>(corners.value())) {
        return wrong(*cells.connectivity, StatusCode::OutOfRange, counted(corners.value(), "value"),
                     std::to_string(before) + ", the last offset");
    }
    if (cells.connectivity->format == VtpFormat::Ascii) {
        const Result<std::vector<std::int64_t>> indices = integers(*cells.connectivity);
        for (std::size_t i = 0; i < indices.value().size(); ++i) {
            const std::int64_t index = indices.value()[i];
            if (index < 0 || index >= static_cast<std::int64_t>(piece.points)) {
                return wrong(*cells.connectivity, StatusCode::OutOfRange,
                             "value " + std::to_string(i) + " is point " + std::to_string(index),
                             piece.points == 0 ? "no index: there are no points"
                                               : "0 to " + std::to_string(piece.points - 1));
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
                             "character " + std::to_string(characters.size()) + " is " + inQuotes(word),
                             "a number from 0 to 255");
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
        return wrong(array, StatusCode::BadFormat, "its last string has no end", "a zero after each string");
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
                         counted(tuples, "tuple") + " of " + counted(array.components, "component") + " declared",
                         (isText ? "" : "at most ") + grouped(most) + ", which is what is there");
        }
    }
    return {};
}

/// Lists the arrays of a piece with one number per point or polygon. An array with the name of a known map
/// must be intact; any other damaged array is reported and ignored.
Status VtpScan::takeArrays(const std::vector<VtpDataArray>& arrays, std::uint64_t tuples, const char* each,
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
            return wrong(array, StatusCode::BadFormat, counted(array.components, "component") + " for each " + each,
                         "1");
        }
        if (array.components > kMostElements) {
            continue;
        }
        if (array.type == "UInt8" && (array.components == 3 || array.components == 4)) { // VTK's colours
            std::string note = "colours not read: the array " + inQuotes(array.name) + " of its " + each + "s";
            if (std::ranges::count(m_scan.notes, note) == 0) { // report once for all pieces
                m_scan.notes.push_back(std::move(note));
            }
        }
        const bool isText = array.type == "String";
        const Result<std::uint64_t> held = isText ? countStrings(array) : countValues(array);
        if (isKnown && (!held.isOk() || held.value() != tuples)) {
            return !held.isOk() ? held.status()
                                : wrong(array, StatusCode::OutOfRange, counted(held.value(), "value"),
                                        grouped(tuples) + ", one for each " + each);
        }
        // VTK dereferences a null pointer if cell data fail to decompress and point data are absent.
        const bool isWhole =
            held.isOk() && held.value() == tuples * array.components &&
            (isText || array.components != 1 || array.format == VtpFormat::Ascii || unpacked(array).isOk());
        if (isKnown && !isWhole) {
            return unpacked(array).status();
        }
        if (!isWhole) {
            m_scan.notes.push_back("the array " + inQuotes(array.name) + " is damaged; it is not used");
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
            return fault(StatusCode::OutOfRange, m_context.file, atLine(piece.line),
                         grouped(count) + " elements declared", "at most " + grouped(kMostElements));
        }
    }
    if (Status status = checkPoints(piece); !status.isOk()) {
        return status;
    }
    const std::array<std::pair<const VtpCells*, const char*>, 4> kinds{
        {{&piece.verts, "verts"}, {&piece.lines, "lines"}, {&piece.strips, "strips"}, {&piece.polys, "polygons"}}};
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
                return wrong(array, StatusCode::BadFormat, "its type is " + inQuotes(array.type),
                             "whole numbers, one a cell");
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
    if (Status status = takeArrays(piece.pointData, piece.points, "point", m_scan.pointArrays); !status.isOk()) {
        return status;
    }
    if (Status status = takeArrays(piece.cellData, cells, "polygon", m_scan.cellArrays); !status.isOk()) {
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
        return fault(StatusCode::Empty, m_context.file, "", "0 polygons and strips", "at least one");
    }
    if (m_scan.points > kMostElements || m_scan.cells > kMostElements) {
        return fault(StatusCode::Unsupported, m_context.file, "", counted(m_scan.points, "point"),
                     "at most " + grouped(kMostElements));
    }
    return {};
}

/// True for any XML; the header check reports other kinds of VTK files.
bool looksLikeVtp(std::string_view bytes)
{
    const std::string_view text = startOfText(bytes);
    return text.starts_with('<') || text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

Result<PreScan> guardVtp(FileImage& image, const ScanContext& context)
{
    PreScan scan;
    scan.format = "VTP";
    const Result<VtpHeader> header = readVtpHeader(image.bytes(), context);
    if (!header.isOk()) {
        return header.status();
    }
    if (Status status = VtpScan(header.value(), context, scan).run(); !status.isOk()) {
        return status;
    }
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

constexpr std::array<std::string_view, 1> kVtpExtensions{".vtp"};

} // namespace

const MeshFormat kVtp{"VTP", kVtpExtensions, false, looksLikeVtp, guardVtp, vtpReader};

} // namespace palpate::meshio::internal
