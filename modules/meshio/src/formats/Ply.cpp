// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"
#include "formats/PlyHeader.h"

#include "guard/BadVertices.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <vtkPLYReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::uint64_t kMostFaceCorners = 255; ///< limit of VTK's reader per face

/// Reads the numbers of the body in sequence, as text or binary.
class PlyBody
{
  public:
    /// @param isByLine  each element of a text has a line of its own, and further numbers on the line are surplus
    PlyBody(std::string_view bytes, const PlyHeader& header, bool isByLine)
        : m_bytes(bytes)
        , m_rest(bytes.substr(header.bodyBegin))
        , m_encoding(header.encoding)
        , m_line(header.bodyLine + 1)
        , m_isByLine(isByLine && header.encoding == PlyEncoding::Ascii)
    {
    }

    /// @return nothing at the end of the file or if the next token is not a number
    std::optional<double> next(PlyType type)
    {
        return m_encoding == PlyEncoding::Ascii ? nextWord() : nextBinary(type);
    }
    /// @return true if only blanks (text) or no bytes (binary) remain.
    [[nodiscard]] bool isAtEnd() const
    {
        return m_encoding == PlyEncoding::Ascii ? withoutPadding(m_rest).empty() : m_rest.empty();
    }
    /// Bytes that remain.
    [[nodiscard]] std::string_view rest() const noexcept { return m_rest; }
    /// Begins an element on a new line. @return true if the last line held surplus numbers
    bool beginLine()
    {
        if (!m_isByLine || !m_isLineBegun) {
            return false;
        }
        const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
        const bool isSurplus = !trimmed(m_rest.substr(0, end)).empty();
        m_isLineBegun = false;
        m_rest.remove_prefix(end);
        return isSurplus;
    }
    [[nodiscard]] core::Message place() const
    {
        return m_encoding == PlyEncoding::Ascii ? onLine(m_line) : onByte(offset());
    }
    [[nodiscard]] std::size_t offset() const { return m_bytes.size() - m_rest.size(); }
    /// Describes the failure of `next`.
    /// @param element  name, index and number of the element being read
    [[nodiscard]] core::Message found(const PlyElement& element, std::uint64_t i) const
    {
        std::string_view rest = m_rest;
        const std::string_view word = takeWord(rest);
        const std::string name = inQuotes(element.name);
        return m_encoding == PlyEncoding::Ascii && !word.empty()
                   ? core::Message(PALPATE_TEXT("%1 is not a number, in element %2 %3 of %4"), inQuotes(word), name, i,
                                   Count(element.count))
                   : core::Message(PALPATE_TEXT("the file ends in element %1 %2 of %3"), name, i, Count(element.count));
    }

  private:
    std::optional<double> nextWord()
    {
        std::string_view after = m_rest;
        const std::string_view word = takeWord(after);
        const std::string_view gap = m_rest.substr(0, static_cast<std::size_t>(word.data() - m_rest.data()));
        if (m_isByLine && m_isLineBegun && gap.find_first_of("\r\n") != std::string_view::npos) {
            return std::nullopt;
        }
        m_isLineBegun = true;
        m_line += static_cast<std::uint64_t>(std::ranges::count(gap, '\n'));
        const std::optional<double> value = wordToNumber(word);
        m_rest = value ? after : m_rest.substr(static_cast<std::size_t>(word.data() - m_rest.data()));
        return value;
    }

    template<class T>
    double take()
    {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), m_rest.data(), sizeof(T));
        if ((m_encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big)) {
            std::reverse(raw.begin(), raw.end());
        }
        m_rest.remove_prefix(sizeof(T));
        return static_cast<double>(std::bit_cast<T>(raw));
    }

    std::optional<double> nextBinary(PlyType type)
    {
        if (m_rest.size() < plySize(type)) {
            return std::nullopt;
        }
        switch (type) {
        case PlyType::Int8:
            return take<std::int8_t>();
        case PlyType::UInt8:
            return take<std::uint8_t>();
        case PlyType::Int16:
            return take<std::int16_t>();
        case PlyType::UInt16:
            return take<std::uint16_t>();
        case PlyType::Int32:
            return take<std::int32_t>();
        case PlyType::UInt32:
            return take<std::uint32_t>();
        case PlyType::Float32:
            return take<float>();
        case PlyType::Float64:
            break;
        }
        return take<double>();
    }

    std::string_view m_bytes;
    std::string_view m_rest;
    PlyEncoding m_encoding;
    std::uint64_t m_line;
    bool m_isByLine;
    bool m_isLineBegun = false; ///< a number of the current element has been read
};

/// Reads the body and writes the vertices and faces as minimal PLY: VTK reads list counts as bytes, supports
/// one name for the face list, and loses its position at unknown elements.
class PlyScan
{
  public:
    PlyScan(std::string_view bytes, const PlyHeader& header, const ScanContext& context, bool isByLine)
        : m_bytes(bytes)
        , m_header(header)
        , m_context(context)
        , m_body(bytes, header, isByLine)
    {
    }

    Status run(PreScan& scan);
    /// Number of complete faces if `run` failed because the file is truncated.
    [[nodiscard]] std::uint64_t wholeFaces() const noexcept { return m_wholeFaces; }
    /// @return true if `run` failed because the numbers do not match the elements that the header declares.
    [[nodiscard]] bool isOtherLayout() const noexcept { return m_isOtherLayout; }
    /// Notes what was left out, and writes the vertices and faces as the content of a PLY file.
    [[nodiscard]] std::string finish(PreScan& scan) const;

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, m_body.place(), found, expected);
    }
    Status readElement(const PlyElement& element, PreScan& scan);
    Status keepVertex(std::uint64_t i, const std::array<double, 3>& p, PreScan& scan);
    Status keepFace(std::uint64_t i, std::span<const double> corners, std::uint64_t vertices);
    Status keepStrips(std::uint64_t i, std::uint64_t vertices);
    Status checkEnd(const PreScan& scan);

    template<class T>
    void append(T value)
    {
        m_plain.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }

    std::string_view m_bytes;
    const PlyHeader& m_header;
    const ScanContext& m_context;
    PlyBody m_body;
    std::vector<double> m_list;
    std::uint64_t m_wholeFaces = 0;
    bool m_isOtherLayout = false;
    bool m_isExact = false; ///< a coordinate has a type with more precision than float
    std::uint64_t m_faces = 0, m_thinFaces = 0, m_surplusLines = 0, m_trailing = 0;
    BadVertices m_bad;
    std::string m_plain;
};

bool isFaceList(const PlyProperty& p)
{
    return p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
}

bool isCoordinate(const PlyProperty& p)
{
    return !p.isList && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z';
}

Status PlyScan::keepVertex(std::uint64_t i, const std::array<double, 3>& p, PreScan& scan)
{
    core::Message bad;
    for (const double x : p) {
        bad = bad.isEmpty() ? coordinateFault(x, m_context.unit_mm) : bad;
    }
    if (!bad.isEmpty()) {
        m_bad.add(static_cast<std::int64_t>(i), wrong(StatusCode::NonFinite, {PALPATE_TEXT("vertex %1: %2"), i, bad},
                                                      {PALPATE_TEXT("finite coordinates within 10 km")}));
    }
    const core::Vec3 kept = bad.isEmpty() ? core::Vec3(p[0], p[1], p[2]) : core::Vec3::Zero();
    for (const double x : kept) {
        append(static_cast<float>(x));
    }
    if (m_isExact) {
        scan.exactPoints.push_back(kept);
    }
    return {};
}

Status PlyScan::keepFace(std::uint64_t i, std::span<const double> corners, std::uint64_t vertices)
{
    if (corners.size() > kMostFaceCorners) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("number of corners of face %1: %2"), i, corners.size()},
                     {PALPATE_TEXT("at most %1"), kMostFaceCorners});
    }
    if (corners.size() < 3) {
        ++m_thinFaces;
        return {};
    }
    ++m_faces;
    append(static_cast<std::uint8_t>(corners.size()));
    for (const double corner : corners) {
        if (!(corner >= 0.0 && corner < static_cast<double>(vertices)) || corner != std::floor(corner)) {
            const core::MessageArgument vertex = std::abs(corner) < 1e15
                                                     ? core::MessageArgument(static_cast<std::int64_t>(corner))
                                                     : core::MessageArgument(corner);
            return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("face %1 uses vertex %2"), i, vertex},
                         {PALPATE_TEXT("%1 to %2"), 0, static_cast<std::int64_t>(vertices) - 1});
        }
        if (Status status = m_bad.check(static_cast<std::int64_t>(corner)); !status.isOk()) {
            return status;
        }
        append(static_cast<std::int32_t>(corner));
    }
    return {};
}

/// Cuts triangle strips, which -1 separates, into triangles. The winding alternates along a strip. A triangle with two
/// equal corners only connects two parts of a strip.
Status PlyScan::keepStrips(std::uint64_t i, std::uint64_t vertices)
{
    std::size_t begin = 0;
    for (std::size_t k = 0; k < m_list.size(); ++k) {
        if (m_list[k] == -1.0) {
            begin = k + 1;
        } else if (k >= begin + 2) {
            const bool isOdd = (k - begin) % 2 != 0;
            const std::array<double, 3> corners{m_list[k - 2], m_list[isOdd ? k : k - 1], m_list[isOdd ? k - 1 : k]};
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
                continue;
            }
            if (Status status = keepFace(i, corners, vertices); !status.isOk()) {
                return status;
            }
        }
    }
    return {};
}

Status PlyScan::readElement(const PlyElement& element, PreScan& scan)
{
    const bool isVertex = element.name == "vertex";
    const bool isStrips = element.name == "tristrips";
    const bool isFace = element.name == "face" || isStrips;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        std::array<double, 3> p = {};
        m_surplusLines += m_body.beginLine() ? 1 : 0;
        for (const PlyProperty& property : element.properties) {
            const std::optional<double> value = m_body.next(property.isList ? property.countType : property.type);
            const auto cut = [&] {
                m_wholeFaces = isFace && !isStrips && m_body.isAtEnd() ? i : 0;
                m_isOtherLayout = true;
                return wrong(StatusCode::BadFormat, m_body.found(element, i),
                             {PALPATE_TEXT("the property %1"), inQuotes(property.name)});
            };
            if (!value) {
                return cut();
            }
            if (!property.isList) {
                if (isCoordinate(property)) {
                    p[static_cast<std::size_t>(property.name[0] - 'x')] = *value;
                }
                continue;
            }
            if (!(*value >= 0.0) || *value > static_cast<double>(m_bytes.size())) {
                m_isOtherLayout = true;
                return wrong(StatusCode::OutOfRange,
                             {PALPATE_TEXT("element %1 %2: length of a list: %3"), inQuotes(element.name), i, *value},
                             {PALPATE_TEXT("%1 to %2"), 0, m_bytes.size()});
            }
            const bool isKept = isFace && isFaceList(property);
            m_list.clear();
            for (auto left = static_cast<std::uint64_t>(*value); left > 0; --left) {
                const std::optional<double> entry = m_body.next(property.type);
                if (!entry) {
                    return cut();
                }
                if (isKept) {
                    m_list.push_back(*entry);
                }
            }
            if (isKept) {
                if (Status status = isStrips ? keepStrips(i, scan.points) : keepFace(i, m_list, scan.points);
                    !status.isOk()) {
                    return status;
                }
            }
        }
        if (isVertex) {
            if (Status status = keepVertex(i, p, scan); !status.isOk()) {
                return status;
            }
        }
        if (i % 65536 == 0 && m_context.progress &&
            !m_context.progress(double(m_body.offset()) / double(m_bytes.size()))) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
        }
    }
    return {};
}

Status PlyScan::run(PreScan& scan)
{
    const PlyElement* vertex = nullptr;
    const PlyElement* face = nullptr; // faces, strips or both
    std::uint64_t faces = 0;
    for (const PlyElement& element : m_header.elements) {
        const bool isFace = element.name == "face" || element.name == "tristrips";
        if (element.name == "vertex" && vertex == nullptr) {
            vertex = &element;
        } else if (isFace && (face == nullptr || face->name != element.name) && vertex != nullptr) {
            face = &element;
            faces += element.count;
            if (std::count_if(element.properties.begin(), element.properties.end(), isFaceList) != 1) {
                return fault(StatusCode::BadFormat, m_context.file, {PALPATE_TEXT("header")},
                             {PALPATE_TEXT("no faces with a list of vertex indices")},
                             {PALPATE_TEXT("the property %1"), "\"list vertex_indices\""});
            }
        } else if (element.name == "vertex" || isFace) {
            return fault(StatusCode::Unsupported, m_context.file, onLine(element.line),
                         {PALPATE_TEXT("found the element %1"), inQuotes(element.name)},
                         {PALPATE_TEXT("%1, then %2, once each"), "\"vertex\"", "\"face\""});
        }
    }
    const auto has = [](const PlyElement& element, std::string_view name) {
        return std::count_if(element.properties.begin(), element.properties.end(),
                             [&](const PlyProperty& p) { return p.name == name && !p.isList; }) == 1;
    };
    if (vertex == nullptr || !has(*vertex, "x") || !has(*vertex, "y") || !has(*vertex, "z")) {
        return fault(StatusCode::BadFormat, m_context.file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("no vertices with x, y and z")}, {PALPATE_TEXT("one of each")});
    }
    if (faces == 0) {
        return noFaces(vertex->count, face != nullptr ? onLine(face->line) : core::Message(PALPATE_TEXT("header")),
                       m_context);
    }
    constexpr std::uint64_t kMostVertices = std::numeric_limits<std::int32_t>::max();
    if (vertex->count > kMostVertices || faces > kMostVertices) {
        return fault(StatusCode::Unsupported, m_context.file, onLine(vertex->line),
                     {PALPATE_TEXT("number of vertices: %1, of faces: %2"), Count(vertex->count), Count(faces)},
                     {PALPATE_TEXT("at most %1 of each"), Count(kMostVertices)});
    }
    scan.points = vertex->count;
    // VTK stores coordinates as floats, regardless of the type in the file.
    m_isExact = std::ranges::any_of(vertex->properties, [](const PlyProperty& p) {
        return isCoordinate(p) && (p.type == PlyType::Float64 || p.type == PlyType::Int32 || p.type == PlyType::UInt32);
    });
    scan.exactPoints.clear();
    scan.exactPoints.reserve(m_isExact ? vertex->count : 0);
    for (const PlyElement& element : m_header.elements) {
        if (Status status = readElement(element, scan); !status.isOk()) {
            return status;
        }
    }
    return checkEnd(scan);
}

/// Accepts filler behind the last element, such as a line feed, zeros up to the end of a block, or a text. Behind the
/// elements of a text nothing else may follow: a further line would be another element.
Status PlyScan::checkEnd(const PreScan& scan)
{
    m_surplusLines += m_body.beginLine() ? 1 : 0;
    if (scan.loss.isEmpty() && !m_body.isAtEnd()) {
        if (m_header.encoding == PlyEncoding::Ascii || !isFiller(m_body.rest())) {
            m_isOtherLayout = true;
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("more data after the last element")},
                         {PALPATE_TEXT("the end of the file")});
        }
        m_trailing = withoutPadding(m_body.rest()).empty() && m_body.rest().size() <= 2 ? 0 : m_body.rest().size();
    }
    if (m_faces == 0) {
        return wrong(StatusCode::Empty, {PALPATE_TEXT("0 faces")}, {PALPATE_TEXT("at least one face")});
    }
    return {};
}

std::string PlyScan::finish(PreScan& scan) const
{
    scan.cells = m_faces;
    noteThinFaces(m_thinFaces, scan);
    m_bad.note(scan);
    noteTrailingBytes(m_trailing, scan);
    if (m_surplusLines > 0) {
        scan.note({PALPATE_TEXT("lines with more numbers than the header declares: %1; the surplus is left out"),
                   Count(m_surplusLines)});
    }
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scan.points) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(m_faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n" + m_plain;
}

/// @return true if the body of a text has one line for each element, apart from blank lines
bool hasLineForEach(std::string_view bytes, const PlyHeader& header)
{
    std::uint64_t elements = 0;
    for (const PlyElement& element : header.elements) {
        elements += element.properties.empty() ? 0 : element.count;
    }
    std::uint64_t lines = 0;
    LineReader reader(withoutPadding(bytes.substr(header.bodyBegin)));
    while (lines <= elements && reader.next()) {
        lines += trimmed(reader.line()).empty() ? 0 : 1;
    }
    return lines == elements;
}

bool looksLikePly(std::string_view bytes)
{
    constexpr std::string_view kMagic = "ply";
    LineReader lines(startOf(bytes));
    std::string_view rest = lines.next() ? lines.line() : std::string_view();
    return rest.starts_with(kMagic) && takeWord(rest) == kMagic && trimmed(rest).empty();
}

Result<PreScan> guardPly(FileImage& image, const ScanContext& context)
{
    static_assert(std::endian::native == std::endian::little, "the plain PLY is written in the machine's byte order");
    PreScan scan;
    scan.format = "PLY";
    Result<PlyHeader> header = readPlyHeader(image.bytes(), context, scan);
    if (!header.isOk()) {
        return header.status();
    }
    // VCGLIB wrote lines with more numbers than it declared. Read word by word, the surplus of all lines may add up to
    // further elements, with other triangles. So where each element has a line, the lines count, and a text is read
    // word by word only if an element lacks numbers on its line.
    const bool isText = header.value().encoding == PlyEncoding::Ascii;
    bool isByLine = isText && hasLineForEach(image.bytes(), header.value());
    std::optional<PlyScan> body(std::in_place, image.bytes(), header.value(), context, isByLine);
    Status status = body->run(scan);
    if (!status.isOk() && isByLine && body->isOtherLayout() && status.code() != StatusCode::Cancelled) {
        isByLine = false;
        body.emplace(image.bytes(), header.value(), context, isByLine);
        status = body->run(scan);
    }
    std::uint64_t wholeFaces = body->wholeFaces();
    if (!status.isOk() && isText && context.isPartial &&
        status.code() != StatusCode::Cancelled) { // cut off: there are fewer lines than elements
        PlyScan lines(image.bytes(), header.value(), context, true);
        isByLine = !lines.run(scan).isOk() && lines.wholeFaces() >= wholeFaces;
        wholeFaces = isByLine ? lines.wholeFaces() : wholeFaces;
    }
    if (!status.isOk() && context.isPartial && wholeFaces > 0 && status.code() != StatusCode::Cancelled) {
        std::vector<PlyElement>& elements = header.value().elements;
        const auto face = std::find_if(elements.begin(), elements.end(),
                                       [](const PlyElement& element) { return element.name == "face"; });
        scan.loss = core::Message(PALPATE_TEXT("%1: %2"), onByte(image.bytes().size()),
                                  core::Message(PALPATE_TEXT("the file ends there: %1 of %2 faces lost"),
                                                Count(face->count - wholeFaces), Count(face->count)));
        face->count = wholeFaces;
        elements.erase(face + 1, elements.end());
        body.emplace(image.bytes(), header.value(), context, isByLine);
        status = body->run(scan);
    }
    if (!status.isOk()) {
        return status;
    }
    Result<FileImage> plain = FileImage::copy(body->finish(scan), context.file);
    if (!plain.isOk()) {
        return plain.status();
    }
    image = std::move(plain).value();
    return scan;
}

vtkSmartPointer<vtkAlgorithm> plyReader(const std::string& path, const PreScan& /*scan*/)
{
    auto made = vtkSmartPointer<vtkPLYReader>::New();
    made->SetFileName(path.c_str());
    return made;
}

constexpr std::array<std::string_view, 1> kPlyExtensions{".ply"};

} // namespace

const MeshFormat kPly{"PLY", kPlyExtensions, false, looksLikePly, guardPly, plyReader};

} // namespace palpate::meshio::internal
