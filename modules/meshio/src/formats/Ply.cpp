// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"
#include "formats/PlyHeader.h"

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
    PlyBody(std::string_view bytes, const PlyHeader& header)
        : m_bytes(bytes)
        , m_rest(bytes.substr(header.bodyBegin))
        , m_encoding(header.encoding)
        , m_line(header.bodyLine + 1)
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
        return m_encoding == PlyEncoding::Ascii ? trimmed(m_rest).empty() : m_rest.empty();
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
        m_line += static_cast<std::uint64_t>(std::count(m_rest.data(), word.data(), '\n'));
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
};

/// Reads the body and writes the vertices and faces as minimal PLY: VTK reads list counts as bytes, supports
/// one name for the face list, and loses its position at unknown elements.
class PlyScan
{
  public:
    PlyScan(std::string_view bytes, const PlyHeader& header, const ScanContext& context)
        : m_bytes(bytes)
        , m_header(header)
        , m_context(context)
        , m_body(bytes, header)
    {
    }

    Status run(PreScan& scan);
    /// Number of complete faces if `run` failed because the file is truncated.
    [[nodiscard]] std::uint64_t wholeFaces() const noexcept { return m_wholeFaces; }
    [[nodiscard]] const std::string& plain() const noexcept { return m_plain; }

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, m_body.place(), found, expected);
    }
    Status readElement(const PlyElement& element, PreScan& scan);
    Status keepVertex(std::uint64_t i, const std::array<double, 3>& p, PreScan& scan);
    Status keepFace(std::uint64_t i, std::uint64_t vertices);

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
    bool m_isExact = false; ///< a coordinate has a type with more precision than float
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
    for (const double x : p) {
        if (const core::Message bad = coordinateFault(x, m_context.unit_mm); !bad.isEmpty()) {
            return wrong(StatusCode::NonFinite, {PALPATE_TEXT("vertex %1: %2"), i, bad},
                         {PALPATE_TEXT("finite coordinates within 10 km")});
        }
        append(static_cast<float>(x));
    }
    if (m_isExact) {
        scan.exactPoints.emplace_back(p[0], p[1], p[2]);
    }
    return {};
}

Status PlyScan::keepFace(std::uint64_t i, std::uint64_t vertices)
{
    if (m_list.size() < 3 || m_list.size() > kMostFaceCorners) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("number of corners of face %1: %2"), i, m_list.size()},
                     {PALPATE_TEXT("%1 to %2"), 3, kMostFaceCorners});
    }
    append(static_cast<std::uint8_t>(m_list.size()));
    for (const double corner : m_list) {
        if (!(corner >= 0.0 && corner < static_cast<double>(vertices)) || corner != std::floor(corner)) {
            const core::MessageArgument vertex = std::abs(corner) < 1e15
                                                     ? core::MessageArgument(static_cast<std::int64_t>(corner))
                                                     : core::MessageArgument(corner);
            return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("face %1 uses vertex %2"), i, vertex},
                         {PALPATE_TEXT("%1 to %2"), 0, static_cast<std::int64_t>(vertices) - 1});
        }
        append(static_cast<std::int32_t>(corner));
    }
    return {};
}

Status PlyScan::readElement(const PlyElement& element, PreScan& scan)
{
    const bool isVertex = element.name == "vertex";
    const bool isFace = element.name == "face";
    for (std::uint64_t i = 0; i < element.count; ++i) {
        std::array<double, 3> p = {};
        for (const PlyProperty& property : element.properties) {
            const std::optional<double> value = m_body.next(property.isList ? property.countType : property.type);
            const auto cut = [&] {
                m_wholeFaces = isFace && m_body.isAtEnd() ? i : 0;
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
                if (Status status = keepFace(i, scan.points); !status.isOk()) {
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
    const PlyElement* face = nullptr;
    for (const PlyElement& element : m_header.elements) {
        if (element.name == "vertex" && vertex == nullptr) {
            vertex = &element;
        } else if (element.name == "face" && face == nullptr && vertex != nullptr) {
            face = &element;
        } else if (element.name == "vertex" || element.name == "face" || element.name == "tristrips") {
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
    if (face == nullptr || std::count_if(face->properties.begin(), face->properties.end(), isFaceList) != 1) {
        return fault(StatusCode::BadFormat, m_context.file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("no faces with a list of vertex indices")},
                     {PALPATE_TEXT("the property %1"), "\"list vertex_indices\""});
    }
    if (face->count == 0) {
        return fault(StatusCode::Empty, m_context.file, onLine(face->line), {PALPATE_TEXT("0 faces")},
                     {PALPATE_TEXT("at least one face")});
    }
    constexpr std::uint64_t kMostVertices = std::numeric_limits<std::int32_t>::max();
    if (vertex->count > kMostVertices || face->count > kMostVertices) {
        return fault(StatusCode::Unsupported, m_context.file, onLine(vertex->line),
                     {PALPATE_TEXT("number of vertices: %1, of faces: %2"), Count(vertex->count), Count(face->count)},
                     {PALPATE_TEXT("at most %1 of each"), Count(kMostVertices)});
    }
    scan.points = vertex->count;
    scan.cells = face->count;
    // VTK stores coordinates as floats, regardless of the type in the file.
    m_isExact = std::ranges::any_of(vertex->properties, [](const PlyProperty& p) {
        return isCoordinate(p) && (p.type == PlyType::Float64 || p.type == PlyType::Int32 || p.type == PlyType::UInt32);
    });
    scan.exactPoints.clear();
    scan.exactPoints.reserve(m_isExact ? vertex->count : 0);
    m_plain = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertex->count) +
              "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(face->count) +
              "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const PlyElement& element : m_header.elements) {
        if (Status status = readElement(element, scan); !status.isOk()) {
            return status;
        }
    }
    if (scan.loss.isEmpty() && !m_body.isAtEnd()) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("more data after the last element")},
                     {PALPATE_TEXT("the end of the file")});
    }
    return {};
}

bool looksLikePly(std::string_view bytes)
{
    const std::string_view head = startOf(bytes);
    return head.starts_with("ply\n") || head.starts_with("ply\r\n");
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
    std::optional<PlyScan> body(std::in_place, image.bytes(), header.value(), context);
    Status status = body->run(scan);
    if (!status.isOk() && context.isPartial && body->wholeFaces() > 0) {
        std::vector<PlyElement>& elements = header.value().elements;
        const auto face = std::find_if(elements.begin(), elements.end(),
                                       [](const PlyElement& element) { return element.name == "face"; });
        scan.loss = core::Message(PALPATE_TEXT("%1: %2"), onByte(image.bytes().size()),
                                  core::Message(PALPATE_TEXT("the file ends there: %1 of %2 faces lost"),
                                                Count(face->count - body->wholeFaces()), Count(face->count)));
        face->count = body->wholeFaces();
        elements.erase(face + 1, elements.end());
        body.emplace(image.bytes(), header.value(), context);
        status = body->run(scan);
    }
    if (!status.isOk()) {
        return status;
    }
    Result<FileImage> plain = FileImage::copy(body->plain(), context.file);
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
