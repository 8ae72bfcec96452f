// SPDX-License-Identifier: BSD-3-Clause
#include "formats/VtpHeader.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <limits>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr int kDeepest = 32;

class HeaderReader
{
  public:
    HeaderReader(const QByteArray& xml, std::string_view type, const ScanContext& context)
        : m_type(type)
        , m_xml(xml)
        , m_context(context)
    {
    }

    Status run(VtpHeader& header);

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, onLine(static_cast<std::uint64_t>(m_xml.lineNumber())), found, expected);
    }
    Status fail(StatusCode code, const core::Message& found, const core::Message& expected)
    {
        if (m_status.isOk()) {
            m_status = wrong(code, found, expected);
        }
        return m_status;
    }
    [[nodiscard]] std::string attribute(const char* name) const
    {
        return m_xml.attributes().value(QLatin1String(name)).toString().toStdString();
    }
    /// Reads a count >= 0; nothing if absent. Invalid values are stored as the error.
    std::optional<std::uint64_t> count(const char* name);
    void startElement(VtpHeader& header);
    void startFile(VtpHeader& header);
    void startPiece(VtpHeader& header);
    void startArray(VtpHeader& header, const std::string& parent);
    /// Returns the role of an array declared under `parent`; nothing if arrays are not allowed there.
    VtpDataArray* place(VtpHeader& header, const std::string& parent, const std::string& name);

    std::string_view m_type; ///< expected type of the file
    QXmlStreamReader m_xml;
    const ScanContext& m_context;
    std::vector<std::string> m_path;
    VtpDataArray* m_array = nullptr; ///< array whose content is being read
    Status m_status;
};

std::optional<std::uint64_t> HeaderReader::count(const char* name)
{
    const std::string text = attribute(name);
    if (text.empty()) {
        return std::nullopt;
    }
    const std::optional<std::int64_t> value = wordToInteger(trimmed(text));
    if (!value || *value < 0) {
        (void)fail(StatusCode::OutOfRange, {PALPATE_TEXT("found %1=%2"), name, inQuotes(text)},
                   {PALPATE_TEXT("a whole number from 0")});
        return 0;
    }
    return static_cast<std::uint64_t>(*value);
}

void HeaderReader::startFile(VtpHeader& header)
{
    if (const std::string type = attribute("type"); type != m_type) {
        (void)fail(StatusCode::Unsupported, {PALPATE_TEXT("a VTK file of type %1"), inQuotes(type)},
                   {PALPATE_TEXT("the type %1"), inQuotes(m_type)});
    }
    const std::string order = attribute("byte_order");
    header.isBigEndian = order == "BigEndian";
    const std::string width = attribute("header_type");
    header.hasWideHeaders = width == "UInt64";
    if (!width.empty() && width != "UInt32" && width != "UInt64") {
        (void)fail(StatusCode::BadFormat, {PALPATE_TEXT("found %1=%2"), "header_type", inQuotes(width)},
                   {PALPATE_TEXT("%1 or %2"), "\"UInt32\"", "\"UInt64\""});
    }
    const std::string compressor = attribute("compressor");
    if (compressor == "vtkZLibDataCompressor") {
        header.compressor = VtpCompressor::ZLib;
    } else if (compressor == "vtkLZ4DataCompressor") {
        header.compressor = VtpCompressor::Lz4;
    } else if (compressor == "vtkLZMADataCompressor") {
        header.compressor = VtpCompressor::Lzma;
    } else if (!compressor.empty()) {
        (void)fail(StatusCode::Unsupported, {PALPATE_TEXT("the compressor %1"), inQuotes(compressor)},
                   {PALPATE_TEXT("%1, %2 or %3"), "zlib", "LZ4", "LZMA"});
    }
}

void HeaderReader::startPiece(VtpHeader& header)
{
    VtpPiece& piece = header.pieces.emplace_back();
    piece.line = static_cast<std::uint64_t>(m_xml.lineNumber());
    piece.points = count("NumberOfPoints").value_or(0);
    piece.verts.count = count("NumberOfVerts").value_or(0);
    piece.lines.count = count("NumberOfLines").value_or(0);
    piece.strips.count = count("NumberOfStrips").value_or(0);
    piece.polys.count = count("NumberOfPolys").value_or(0);
    piece.cells.count = count("NumberOfCells").value_or(0);
    piece.extent = attribute("Extent");
}

VtpDataArray* HeaderReader::place(VtpHeader& header, const std::string& parent, const std::string& name)
{
    if (parent == "FieldData") {
        return &header.fieldData.emplace_back();
    }
    if (header.pieces.empty()) {
        return nullptr;
    }
    VtpPiece& piece = header.pieces.back();
    if (parent == "PointData") {
        return &piece.pointData.emplace_back();
    }
    if (parent == "CellData") {
        return &piece.cellData.emplace_back();
    }
    if (parent == "Points") {
        return piece.coordinates ? nullptr : &piece.coordinates.emplace();
    }
    VtpCells* cells = parent == "Verts"    ? &piece.verts
                      : parent == "Lines"  ? &piece.lines
                      : parent == "Strips" ? &piece.strips
                      : parent == "Polys"  ? &piece.polys
                      : parent == "Cells"  ? &piece.cells
                                           : nullptr;
    if (cells == nullptr) {
        return nullptr;
    }
    if (parent == "Cells" && name == "types" && !piece.types) {
        return &piece.types.emplace();
    }
    std::optional<VtpDataArray>& slot = name == "connectivity" ? cells->connectivity : cells->offsets;
    return (name == "connectivity" || name == "offsets") && !slot ? &slot.emplace() : nullptr;
}

void HeaderReader::startArray(VtpHeader& header, const std::string& parent)
{
    const std::string name = attribute("Name");
    VtpDataArray* array = place(header, parent, name);
    if (array == nullptr) {
        (void)fail(
            StatusCode::BadFormat, {PALPATE_TEXT("found an array %1 under %2"), inQuotes(name), inQuotes(parent)},
            {PALPATE_TEXT("one array of points, one array %1 and one array %2"), "\"connectivity\"", "\"offsets\""});
        return;
    }
    array->name = name.empty() ? parent : name;
    array->type = attribute("type");
    array->components = count("NumberOfComponents").value_or(1);
    array->tuples = count("NumberOfTuples");
    array->offset = count("offset").value_or(0);
    array->line = static_cast<std::uint64_t>(m_xml.lineNumber());
    const std::string format = attribute("format");
    if (format == "appended") {
        array->format = VtpFormat::Appended;
    } else if (format == "binary") {
        array->format = VtpFormat::Binary;
    } else if (!format.empty() && format != "ascii") {
        (void)fail(StatusCode::BadFormat, {PALPATE_TEXT("found %1=%2"), "format", inQuotes(format)},
                   {PALPATE_TEXT("%1, %2 or %3"), "\"ascii\"", "\"binary\"", "\"appended\""});
    }
    m_array = array;
}

void HeaderReader::startElement(VtpHeader& header)
{
    static constexpr std::array<std::string_view, 9> kOfArrays{"FieldData", "PointData", "CellData", "Points", "Verts",
                                                               "Lines",     "Strips",    "Polys",    "Cells"};
    const std::string& name = m_path.back();
    const std::string parent = m_path.size() > 1 ? m_path[m_path.size() - 2] : std::string();
    const bool isArray = name == "DataArray" || name == "Array";
    if (!isArray && std::ranges::find(kOfArrays, parent) != kOfArrays.end()) { // VTK would treat this as an array
        (void)fail(StatusCode::BadFormat,
                   {PALPATE_TEXT("found an element %1 under %2"), inQuotes(name), inQuotes(parent)},
                   {PALPATE_TEXT("%1 or %2"), "\"DataArray\"", "\"Array\""});
    } else if (m_path.size() == 1 && name != "VTKFile") {
        (void)fail(StatusCode::BadFormat, {PALPATE_TEXT("an XML document of type %1"), inQuotes(name)},
                   {PALPATE_TEXT("the type %1"), "\"VTKFile\""});
    } else if (name == "VTKFile") {
        startFile(header);
    } else if (name == "Piece") {
        startPiece(header);
    } else if (name == kImageType && m_path.size() == 2) {
        header.image = {attribute("WholeExtent"), attribute("Origin"), attribute("Spacing"), attribute("Direction")};
    } else if (name == "PointData" && parent == "Piece") {
        header.pieces.back().scalars = attribute("Scalars");
    } else if (isArray) {
        startArray(header, parent);
    } else if (name == "AppendedData") {
        const std::string encoding = attribute("encoding");
        if (!encoding.empty() && encoding != "raw" && encoding != "base64") {
            (void)fail(StatusCode::BadFormat, {PALPATE_TEXT("found %1=%2"), "encoding", inQuotes(encoding)},
                       {PALPATE_TEXT("%1 or %2"), "\"raw\"", "\"base64\""});
        }
        header.isAppendedBase64 = encoding != "raw"; // VTK's default
    }
}

Status HeaderReader::run(VtpHeader& header)
{
    while (m_status.isOk()) {
        switch (m_xml.readNext()) {
        case QXmlStreamReader::DTD:
        case QXmlStreamReader::EntityReference:
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found a document type or an entity")},
                         {PALPATE_TEXT("a file without them")});
        case QXmlStreamReader::StartElement:
            m_array = nullptr; // VTK's reader takes an array's text up to the first tag: information keys do not belong
                               // to the text
            m_path.push_back(m_xml.name().toString().toStdString());
            if (m_path.size() > kDeepest) {
                return wrong(StatusCode::BadFormat, {PALPATE_TEXT("elements nested in more than %1 levels"), kDeepest},
                             {PALPATE_TEXT("at most %1 levels"), kDeepest});
            }
            startElement(header);
            if (m_path.back() == "AppendedData") {
                return m_status; // the rest need not be XML
            }
            break;
        case QXmlStreamReader::Characters:
            if (m_xml.isCDATA()) {
                m_array = nullptr;
            } else if (m_array != nullptr) {
                m_array->text.append(m_xml.text().toLatin1());
            }
            break;
        case QXmlStreamReader::Comment:
        case QXmlStreamReader::ProcessingInstruction:
            m_array = nullptr;
            break;
        case QXmlStreamReader::EndElement:
            m_path.pop_back();
            m_array = nullptr;
            break;
        case QXmlStreamReader::Invalid:
            return wrong(StatusCode::BadFormat,
                         {PALPATE_TEXT("invalid XML: %1"), inQuotes(m_xml.errorString().toStdString())},
                         {PALPATE_TEXT("well-formed XML to the end of the file")});
        case QXmlStreamReader::EndDocument:
            return m_status;
        default:
            break;
        }
    }
    return m_status;
}

} // namespace

Result<VtpHeader> readVtpHeader(std::string_view bytes, const ScanContext& context, std::string_view type)
{
    VtpHeader header;
    constexpr std::string_view kAppended = "<AppendedData";
    std::string_view xml = bytes;
    if (const std::size_t tag = bytes.find(kAppended); tag != std::string_view::npos) {
        const std::size_t close = bytes.find('>', tag);
        std::size_t mark = close == std::string_view::npos ? close : close + 1;
        while (mark < bytes.size() && std::string_view(" \t\r\n").find(bytes[mark]) != std::string_view::npos) {
            ++mark;
        }
        if (mark >= bytes.size() || bytes[mark] != '_') {
            return fault(StatusCode::BadFormat, context.file, onByte(tag),
                         {PALPATE_TEXT("the appended data do not begin with %1"), "\"_\""},
                         {PALPATE_TEXT("%1 and the data"), "\"_\""});
        }
        xml = bytes.substr(0, close + 1);
        header.appendedBegin = mark + 1;
        header.appended = bytes.substr(mark + 1);
    }
    if (xml.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return fault(StatusCode::Unsupported, context.file, {}, {PALPATE_TEXT("more than 2 GiB of XML")},
                     {PALPATE_TEXT("arrays as appended data")});
    }
    HeaderReader reader(QByteArray::fromRawData(xml.data(), static_cast<qsizetype>(xml.size())), type, context);
    if (Status status = reader.run(header); !status.isOk()) {
        return status;
    }
    if (header.pieces.empty()) {
        return fault(StatusCode::Empty, context.file, {}, {PALPATE_TEXT("no element %1"), "\"Piece\""},
                     {PALPATE_TEXT("at least one such element")});
    }
    return header;
}

} // namespace palpate::meshio::internal
