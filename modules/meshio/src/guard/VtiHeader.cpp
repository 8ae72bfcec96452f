// SPDX-License-Identifier: BSD-3-Clause
#include "guard/VtiHeader.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <QByteArray>
#include <QXmlStreamReader>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::StatusCode;

/// Reads a count from an element. @return 1 if absent, nothing if invalid
std::optional<std::uint64_t> countOf(const QXmlStreamReader& xml, const char* attribute)
{
    const QStringView text = xml.attributes().value(QLatin1String(attribute));
    if (text.isEmpty()) {
        return 1;
    }
    const std::optional<std::int64_t> value = wordToInteger(trimmed(text.toString().toStdString()));
    return value && *value >= 0 ? std::optional(static_cast<std::uint64_t>(*value)) : std::nullopt;
}

/// The XML of a VTI file, without appended data.
QByteArray xmlOf(const std::string& bytes)
{
    const std::size_t tag = bytes.find("<AppendedData");
    const std::size_t close = tag == std::string::npos ? tag : bytes.find('>', tag);
    const std::size_t size = close == std::string::npos ? bytes.size() : close + 1;
    return QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(size));
}

} // namespace

Result<std::uint64_t> checkVti(const std::filesystem::path& source, std::uint64_t most)
{
    const std::string file = source.filename().string();
    std::ifstream in(source, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    constexpr std::size_t kTail = 256;
    if (!trimmed(std::string_view(bytes).substr(bytes.size() - std::min(bytes.size(), kTail)))
             .ends_with("</VTKFile>")) {
        return fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("it does not end with its last tag")},
                     {PALPATE_TEXT("`</VTKFile>` at the end")});
    }
    QXmlStreamReader xml(xmlOf(bytes));
    std::vector<QString> path; // of the current element
    std::uint64_t numbers = 0, components = 0;
    while (!xml.atEnd() && (path.empty() || path.back() != QLatin1String("AppendedData"))) { // the rest need not be XML
        const QXmlStreamReader::TokenType token = xml.readNext();
        const core::Message line = onLine(static_cast<std::uint64_t>(xml.lineNumber()));
        if (token == QXmlStreamReader::DTD || token == QXmlStreamReader::EntityReference) {
            return fault(StatusCode::BadFormat, file, line, {PALPATE_TEXT("a document type or an entity")},
                         {PALPATE_TEXT("a VTI file without these")});
        }
        if (token == QXmlStreamReader::EndElement) {
            path.pop_back();
        }
        if (token != QXmlStreamReader::StartElement) {
            continue;
        }
        const auto each = countOf(xml, "NumberOfComponents"), tuples = countOf(xml, "NumberOfTuples");
        if (!each || !tuples || *each > most || *tuples > most || *each * *tuples > most - numbers) {
            return fault(StatusCode::OutOfRange, file, line,
                         {PALPATE_TEXT("an array with more numbers than its file can hold")},
                         {PALPATE_TEXT("values of NumberOfComponents and NumberOfTuples that match the data")});
        }
        numbers += *each * *tuples;
        const bool isArray = !path.empty() && xml.attributes().hasAttribute(QLatin1String("type"));
        components += isArray && path.back() != QLatin1String("FieldData") ? *each : 0;
        path.push_back(xml.name().toString());
    }
    if (xml.hasError()) {
        return fault(StatusCode::BadFormat, file, onLine(static_cast<std::uint64_t>(xml.lineNumber())),
                     {PALPATE_TEXT("the XML is broken: %1"), inQuotes(xml.errorString().toStdString())},
                     {PALPATE_TEXT("well-formed XML to the end")});
    }
    return components;
}

} // namespace palpate::meshio::internal
