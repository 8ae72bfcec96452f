// SPDX-License-Identifier: BSD-3-Clause
// GIFTI surfaces: XML with an array of points and an array of triangles. https://www.nitrc.org/projects/gifti
#include "formats/MeshFormat.h"
#include "formats/OtherFormats.h"
#include "surfaces/PolygonSoup.h"
#include "text/Fault.h"
#include "text/TextScan.h"
#include "voxels/Unpack.h"

#include <QByteArray>
#include <QXmlStreamReader>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::uint64_t kGiftiPacked = 1100; ///< most bytes from one byte of zlib [1]
constexpr std::uint64_t kGiftiNumber = 4;    ///< size of a number [bytes]

/// An array of three numbers for each point or triangle.
struct GiftiArray
{
    std::string type, encoding, endian;
    bool isColumnMajor = false;
    std::uint64_t tuples = 0;
    std::vector<double> numbers; ///< three for each tuple, tuple by tuple
};

class GiftiReader
{
  public:
    GiftiReader(const FileImage& image, const ScanContext& context)
        : m_context(context)
        , m_bytes(image.bytes().size())
        , m_xml(QByteArray::fromRawData(image.bytes().data(), static_cast<qsizetype>(image.bytes().size())))
    {
    }
    Result<TriangleSoup> run(PreScan& scan);

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, onLine(static_cast<std::uint64_t>(m_xml.lineNumber())), found, expected);
    }
    [[nodiscard]] std::string attribute(const char* name) const
    {
        return m_xml.attributes().value(QLatin1String(name)).toString().toStdString();
    }
    Status startArray();
    Status readArray(GiftiArray& array, const char* type);
    Status readText(const std::string& text, GiftiArray& array) const;
    Status readBytes(const QByteArray& text, GiftiArray& array) const;
    Status readTransform();
    Result<TriangleSoup> surface(PreScan& scan) const;

    const ScanContext& m_context;
    std::size_t m_bytes;
    QXmlStreamReader m_xml;
    std::optional<GiftiArray> m_points, m_triangles;
    std::optional<Eigen::Matrix<double, 3, 4>> m_toScanner; ///< if the points are in no coordinates of a scanner
};

Status GiftiReader::readText(const std::string& text, GiftiArray& array) const
{
    std::string_view rest = text;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        const std::optional<double> value = wordToNumber(word);
        if (!value) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 is not a number"), inQuotes(word)},
                         {PALPATE_TEXT("a number")});
        }
        array.numbers.push_back(*value);
    }
    return array.numbers.size() == 3 * array.tuples
               ? Status()
               : wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 numbers"), Count(array.numbers.size())},
                       {PALPATE_TEXT("%1, as declared"), Count(3 * array.tuples)});
}

/// Decodes base64, unpacks zlib, and takes the numbers.
Status GiftiReader::readBytes(const QByteArray& text, GiftiArray& array) const
{
    const auto decoded =
        QByteArray::fromBase64Encoding(text.simplified().replace(' ', ""), QByteArray::AbortOnBase64DecodingErrors);
    if (!decoded) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("the data are not base64")},
                     {PALPATE_TEXT("base64, as declared")});
    }
    std::string_view rest((*decoded).data(), static_cast<std::size_t>((*decoded).size()));
    ByteStream stream([&rest] { return std::exchange(rest, std::string_view()); }, array.encoding[0] == 'G');
    std::string bytes(3 * array.tuples * kGiftiNumber, '\0');
    char more = 0;
    if (stream.read(bytes) != bytes.size() || stream.read({&more, 1}) != 0 || stream.isDamaged()) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("the data are cut off, damaged or too long")},
                     {PALPATE_TEXT("%1 bytes, as declared"), Count(bytes.size())});
    }
    array.numbers.resize(3 * array.tuples);
    const bool areFloats = array.type == "NIFTI_TYPE_FLOAT32", isBig = array.endian == "BigEndian";
    for (std::size_t i = 0; i < array.numbers.size(); ++i) {
        std::uint32_t word = 0;
        std::memcpy(&word, bytes.data() + i * kGiftiNumber, kGiftiNumber);
        word = isBig ? __builtin_bswap32(word) : word; // this program runs on little-endian machines only
        array.numbers[i] =
            areFloats ? double{std::bit_cast<float>(word)} : static_cast<double>(std::bit_cast<std::int32_t>(word));
    }
    return {};
}

/// Reads the content of an array, from its first element on. @param type  expected
Status GiftiReader::readArray(GiftiArray& array, const char* type)
{
    array.type = attribute("DataType");
    array.encoding = attribute("Encoding");
    array.endian = attribute("Endian");
    array.isColumnMajor = attribute("ArrayIndexingOrder") == "ColumnMajorOrder";
    const std::optional<std::int64_t> tuples = wordToInteger(attribute("Dim0"));
    if (attribute("Dimensionality") != "2" || attribute("Dim1") != "3" || !tuples || *tuples < 0 ||
        static_cast<std::uint64_t>(*tuples) > kGiftiPacked * m_bytes / (3 * kGiftiNumber)) {
        return wrong(StatusCode::BadFormat,
                     {PALPATE_TEXT("an array of %1 × %2 numbers"), attribute("Dim0"), attribute("Dim1")},
                     {PALPATE_TEXT("three numbers for each point or triangle, as many as its %1 bytes can hold"),
                      Count(m_bytes)});
    }
    array.tuples = static_cast<std::uint64_t>(*tuples);
    static constexpr std::array<std::string_view, 3> kEncodings{"ASCII", "Base64Binary", "GZipBase64Binary"};
    if (array.type != type || std::ranges::find(kEncodings, array.encoding) == kEncodings.end()) {
        return wrong(
            StatusCode::Unsupported,
            {PALPATE_TEXT("numbers of the type %1 in the encoding %2"), inQuotes(array.type), inQuotes(array.encoding)},
            {PALPATE_TEXT("%1 in ASCII, Base64Binary or GZipBase64Binary (wb_command -gifti-convert)"), type});
    }
    while (m_xml.readNextStartElement()) {
        Status status;
        if (m_xml.name() == QLatin1String("CoordinateSystemTransformMatrix")) {
            status = readTransform();
        } else if (m_xml.name() == QLatin1String("Data") && array.numbers.empty()) {
            const QString text = m_xml.readElementText();
            status = m_xml.hasError()            ? Status() // reported at the end
                     : array.encoding == "ASCII" ? readText(text.toStdString(), array)
                                                 : readBytes(text.toLatin1(), array);
        } else {
            m_xml.skipCurrentElement();
        }
        if (!status.isOk()) {
            return status;
        }
    }
    if (!m_xml.hasError() && array.numbers.size() != 3 * array.tuples) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("an array without data")},
                     {PALPATE_TEXT("%1 numbers"), Count(3 * array.tuples)});
    }
    if (array.isColumnMajor) {
        std::vector<double> turned(array.numbers.size());
        for (std::size_t i = 0; i < turned.size(); ++i) {
            turned[i] = array.numbers[i % 3 * array.tuples + i / 3];
        }
        array.numbers = std::move(turned);
    }
    return {};
}

/// FreeSurfer writes points relative to the centre of the volume, and the way to the scanner in this matrix.
Status GiftiReader::readTransform()
{
    QString from, to, numbers;
    while (m_xml.readNextStartElement()) {
        const QString name = m_xml.name().toString(), text = m_xml.readElementText();
        (name == QLatin1String("DataSpace") ? from : name == QLatin1String("TransformedSpace") ? to : numbers) = text;
    }
    if (from.trimmed() != QLatin1String("NIFTI_XFORM_UNKNOWN") ||
        to.trimmed() != QLatin1String("NIFTI_XFORM_SCANNER_ANAT")) {
        return {};
    }
    const std::string words = numbers.toStdString();
    std::string_view rest = words;
    Eigen::Matrix<double, 3, 4>& matrix = m_toScanner.emplace();
    for (Eigen::Index i = 0; i < matrix.size(); ++i) {
        const std::optional<double> value = wordToNumber(takeWord(rest));
        if (!value || !coordinateFault(*value, 1.0).isEmpty()) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("a coordinate transform without 16 finite numbers")},
                         {PALPATE_TEXT("4 × 4 numbers")});
        }
        matrix(i / 4, i % 4) = *value;
    }
    return {};
}

Status GiftiReader::startArray()
{
    const std::string intent = attribute("Intent");
    const bool arePoints = intent == "NIFTI_INTENT_POINTSET";
    if (!arePoints && intent != "NIFTI_INTENT_TRIANGLE") {
        m_xml.skipCurrentElement(); // values of the points
        return {};
    }
    std::optional<GiftiArray>& array = arePoints ? m_points : m_triangles;
    if (array) {
        return wrong(StatusCode::Unsupported, {PALPATE_TEXT("a second array of %1"), inQuotes(intent)},
                     {PALPATE_TEXT("one surface in a file")});
    }
    return readArray(array.emplace(), arePoints ? "NIFTI_TYPE_FLOAT32" : "NIFTI_TYPE_INT32");
}

Result<TriangleSoup> GiftiReader::surface(PreScan& scan) const
{
    PolygonSoup soup(m_context);
    soup.points().reserve(m_points->tuples);
    for (std::size_t i = 0; i < m_points->numbers.size(); i += 3) {
        const Vec3 p(m_points->numbers[i], m_points->numbers[i + 1], m_points->numbers[i + 2]);
        soup.points().push_back(m_toScanner ? Vec3(*m_toScanner * p.homogeneous()) : p);
    }
    if (m_toScanner) {
        scan.note({PALPATE_TEXT("moved to the coordinates of the scanner, as the file states")});
    }
    std::array<std::int64_t, 3> corners = {};
    for (std::size_t i = 0; i < m_triangles->numbers.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double corner = m_triangles->numbers[i + k];
            const bool isIndex = corner >= 0.0 && corner <= double{kMostElements};
            corners[k] = isIndex ? static_cast<std::int64_t>(corner) : -1;
        }
        if (Status status = soup.add(corners); !status.isOk()) {
            return status;
        }
        if (Status status = soup.progress(i, m_triangles->numbers.size()); !status.isOk()) {
            return status;
        }
    }
    return soup.finish(scan);
}

Result<TriangleSoup> GiftiReader::run(PreScan& scan)
{
    if (m_xml.readNextStartElement()) {
        while (m_xml.readNextStartElement()) {
            Status status;
            if (m_xml.name() == QLatin1String("DataArray")) {
                status = startArray();
            } else {
                m_xml.skipCurrentElement();
            }
            if (!status.isOk()) {
                return status;
            }
        }
    }
    while (!m_xml.atEnd()) {
        (void)m_xml.readNext();
    }
    if (m_xml.hasError()) {
        return wrong(StatusCode::BadFormat,
                     {PALPATE_TEXT("the XML is broken: %1"), inQuotes(m_xml.errorString().toStdString())},
                     {PALPATE_TEXT("well-formed XML to the end of the file")});
    }
    if (!m_points || !m_triangles) {
        return fault(StatusCode::Unsupported, m_context.file, {},
                     {PALPATE_TEXT("a GIFTI file of values, without a surface")},
                     {PALPATE_TEXT("arrays of points and triangles: open the surface file (.surf.gii)")});
    }
    scan.format = "GIFTI";
    scan.frame = FileFrame::Ras;
    return surface(scan);
}

bool looksLikeGifti(std::string_view bytes)
{
    return rootElement(startOfText(bytes)) == "GIFTI";
}

Result<TriangleSoup> readGifti(const FileImage& image, const ScanContext& context, PreScan& scan)
{
    return GiftiReader(image, context).run(scan);
}

constexpr std::array<std::string_view, 1> kGiftiExtensions{".gii"};

} // namespace

const MeshFormat kGifti{"GIFTI", kGiftiExtensions, true, looksLikeGifti, nullptr, nullptr, readGifti};

} // namespace palpate::meshio::internal
