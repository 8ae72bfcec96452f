// SPDX-License-Identifier: BSD-3-Clause
#include "formats/PlyHeader.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kMostProperties = 256; ///< limit per element; far above that of real files

std::optional<PlyType> typeNamed(std::string_view name)
{
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{
        {"char", PlyType::Int8},
        {"int8", PlyType::Int8},
        {"uchar", PlyType::UInt8},
        {"uint8", PlyType::UInt8},
        {"short", PlyType::Int16},
        {"int16", PlyType::Int16},
        {"ushort", PlyType::UInt16},
        {"uint16", PlyType::UInt16},
        {"int", PlyType::Int32},
        {"int32", PlyType::Int32},
        {"uint", PlyType::UInt32},
        {"uint32", PlyType::UInt32},
        {"float", PlyType::Float32},
        {"float32", PlyType::Float32},
        {"double", PlyType::Float64},
        {"float64", PlyType::Float64},
    }};
    const auto found = std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) { return t.first == name; });
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

/// @return a property; nothing if the words are invalid
std::optional<PlyProperty> readProperty(std::string_view rest)
{
    PlyProperty property;
    std::string_view word = takeWord(rest);
    if (word == "list") {
        const std::optional<PlyType> count = typeNamed(takeWord(rest));
        if (!count || *count == PlyType::Float32 || *count == PlyType::Float64) {
            return std::nullopt;
        }
        property.isList = true;
        property.countType = *count;
        word = takeWord(rest);
    }
    const std::optional<PlyType> type = typeNamed(word);
    property.name = takeWord(rest);
    if (!type || property.name.empty() || !trimmed(rest).empty()) {
        return std::nullopt;
    }
    property.type = *type;
    return property;
}

bool isColour(const PlyProperty& property)
{
    return property.name == "red" || property.name == "diffuse_red" || property.name == "r";
}

/// Minimum size of one instance of the element [bytes].
std::uint64_t leastBytes(const PlyElement& element, PlyEncoding encoding)
{
    std::uint64_t bytes = 0;
    for (const PlyProperty& p : element.properties) {
        bytes += encoding == PlyEncoding::Ascii ? 2 : plySize(p.isList ? p.countType : p.type);
    }
    return std::max<std::uint64_t>(bytes, 1);
}

} // namespace

std::size_t plySize(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
        return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
        return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
        return 4;
    case PlyType::Float64:
        break;
    }
    return 8;
}

Result<PlyHeader> readPlyHeader(std::string_view bytes, const ScanContext& context, PreScan& scan)
{
    PlyHeader header;
    bool hasFormat = false;
    bool isDone = false;
    LineReader lines(bytes);
    const auto wrong = [&](StatusCode code, const core::Message& found, const core::Message& expected) {
        return fault(code, context.file, onLine(lines.number()), found, expected);
    };
    (void)lines.next(); // "ply"
    while (!isDone && lines.next()) {
        std::string_view rest = lines.line();
        const std::string_view word = takeWord(rest);
        if (word == "format") {
            const std::string_view encoding = takeWord(rest);
            if (encoding == "ascii") {
                header.encoding = PlyEncoding::Ascii;
            } else if (encoding == "binary_little_endian") {
                header.encoding = PlyEncoding::LittleEndian;
            } else if (encoding == "binary_big_endian") {
                header.encoding = PlyEncoding::BigEndian;
            } else {
                return wrong(StatusCode::Unsupported, {PALPATE_TEXT("the format %1"), inQuotes(encoding)},
                             {PALPATE_TEXT("%1, %2 or %3"), "ascii", "binary_little_endian", "binary_big_endian"});
            }
            hasFormat = true;
        } else if (word == "comment" || word == "obj_info") {
            noteSpaceTag(rest, scan);
        } else if (word == "element") {
            PlyElement element;
            element.name = takeWord(rest);
            element.line = lines.number();
            const std::string_view text = takeWord(rest);
            const std::optional<std::int64_t> count = wordToInteger(text);
            if (element.name.empty() || !count || *count < 0) {
                return wrong(StatusCode::BadFormat, {PALPATE_TEXT("the element count %1"), inQuotes(text)},
                             {PALPATE_TEXT("a whole number from 0")});
            }
            element.count = static_cast<std::uint64_t>(*count);
            header.elements.push_back(std::move(element));
        } else if (word == "property") {
            const std::optional<PlyProperty> property = readProperty(rest);
            if (!property || header.elements.empty() || header.elements.back().properties.size() >= kMostProperties) {
                return wrong(StatusCode::BadFormat, {PALPATE_TEXT("the property %1"), inQuotes(trimmed(rest))},
                             {PALPATE_TEXT("a type and a name, below an element")});
            }
            header.elements.back().properties.push_back(*property);
        } else if (word == "end_header") {
            isDone = true;
        } else if (!word.empty()) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found %1 in the header"), inQuotes(word)},
                         {PALPATE_TEXT("a line of a PLY header")});
        }
    }
    if (!isDone || !hasFormat) {
        return isDone ? wrong(StatusCode::BadFormat, {PALPATE_TEXT("the header has no line %1"), "\"format\""},
                              {PALPATE_TEXT("one such line")})
                      : wrong(StatusCode::BadFormat, {PALPATE_TEXT("the file ends in the header")},
                              {PALPATE_TEXT("the keyword %1"), "\"end_header\""});
    }
    for (const PlyElement& element : header.elements) {
        if (std::any_of(element.properties.begin(), element.properties.end(), isColour)) {
            scan.notes.push_back({PALPATE_TEXT("colours not read: those of its elements %1"), inQuotes(element.name)});
        }
    }
    header.bodyBegin = lines.end();
    header.bodyLine = lines.number();
    const std::uint64_t left = bytes.size() - header.bodyBegin;
    for (const PlyElement& element : header.elements) {
        const std::uint64_t most = (left + 1) / leastBytes(element, header.encoding);
        if (element.count > most) {
            return fault(
                StatusCode::OutOfRange, context.file, onLine(element.line),
                {PALPATE_TEXT("number of elements %1: declared %2"), inQuotes(element.name), Count(element.count)},
                {PALPATE_TEXT("at most %1, as many as the %2 bytes that follow can hold"), Count(most), Count(left)});
        }
    }
    return header;
}

} // namespace palpate::meshio::internal
