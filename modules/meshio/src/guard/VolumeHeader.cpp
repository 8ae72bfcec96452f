// SPDX-License-Identifier: BSD-3-Clause
#include "guard/VolumeHeader.h"

#include "text/Fault.h"
#include "text/TextScan.h"

#include <QByteArray>
#include <QXmlStreamReader>

#include <Eigen/LU>

#include <vtk_zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kMostHeader = 65536; ///< of text [bytes]

core::Message inHeader(std::string_view field)
{
    return {PALPATE_TEXT("header: %1"), field};
}

std::optional<Eigen::Matrix3d> threeByThree(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    Eigen::Matrix3d m;
    for (int i = 0; i < 9; ++i) {
        if (!(in >> m(i % 3, i / 3))) {
            return std::nullopt;
        }
    }
    m.colwise().normalize();
    return std::abs(m.determinant()) > 1e-3 ? std::optional(m) : std::nullopt;
}

bool isMetaImage(const std::filesystem::path& path)
{
    return path.extension() == ".mha" || path.extension() == ".mhd";
}

/// @return false for an unreadable direction
bool takeField(TextHeader& header, bool isMeta, std::string_view key, const std::string& value)
{
    const auto has = [&value](std::string_view word) { return value.find(word) != std::string::npos; };
    const bool isTrue = !value.empty() && std::string_view("Tt1").find(value[0]) != std::string_view::npos; // to MetaIO
    if (key == (isMeta ? "TransformMatrix" : "space directions")) {
        const auto matrix = threeByThree(value);
        header.directions = matrix.value_or(header.directions);
        return matrix.has_value();
    }
    if (key == "space") {
        header.hasSpace = true;
        header.isRas = has("right-anterior-superior") || has("RAS");
    } else if (key == "NDims") {
        header.dimensions = value.size() == 1 && value[0] >= '0' && value[0] <= '9' ? value[0] - '0' : 0;
    } else if (key == "CompressedData") {
        header.isPacked = header.isPacked || isTrue;
    } else if (key == "BinaryData") {
        header.isText = !isTrue;
    } else if (key == "encoding") {
        header.isPacked = header.isPacked || !has("raw");
        header.isText = header.isText || (!has("raw") && !has("gz"));
    } else if (isMeta ? key == "ElementDataFile" : key == "data file" || key == "datafile") {
        header.isList = value == "LIST";
        if (!header.isList && !(isMeta && (value == "LOCAL" || value == "Local" || value == "local"))) {
            header.dataFiles.push_back(value);
        }
    }
    return true;
}

/// VTK's readers trust the names of the voxel files: they use the names as printf patterns and continue without the
/// file.
Status checkDataFiles(const std::filesystem::path& path, const TextHeader& header)
{
    const std::string file = path.filename().string();
    const auto refuse = [&file](StatusCode code, const core::Message& found, const core::Message& expected) {
        return fault(code, file, {PALPATE_TEXT("header: the file of its voxels")}, found, expected);
    };
    if (header.isList && header.dataFiles.empty()) {
        return refuse(StatusCode::BadFormat, {PALPATE_TEXT("an empty LIST")},
                      {PALPATE_TEXT("a file name on each line below it")});
    }
    if (header.isList && header.isPacked) {
        return refuse(StatusCode::Unsupported, {PALPATE_TEXT("a LIST of compressed files")},
                      {PALPATE_TEXT("a single file, or uncompressed files")});
    }
    for (const std::string& name : header.dataFiles) {
        std::error_code error;
        if (name.find('%') != std::string::npos) { // a printf pattern
            return refuse(StatusCode::Unsupported, {PALPATE_TEXT("%1"), inQuotes(name)},
                          {PALPATE_TEXT("the name of one file, or LIST and one file name on each line")});
        }
        if (!std::filesystem::is_regular_file(path.parent_path() / name, error)) {
            return refuse(StatusCode::NotFound, {PALPATE_TEXT("no file %1"), inQuotes(name)},
                          {PALPATE_TEXT("this file in the folder of the header")});
        }
    }
    return {};
}

/// Checks input that VTK's NRRD reader trusts: the reader takes non-numbers for 0, merges repeated fields, and
/// interprets the name of a data file followed by numbers as a printf pattern.
Status checkNrrd(const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::map<std::string, std::string> fields;
    std::getline(in, line);
    for (std::size_t read = line.size(); read < kMostHeader && std::getline(in, line) && !line.empty() && line != "\r";
         read += line.size() + 1) {
        const std::size_t colon = line.find(": ");
        if (line[0] == '#' || colon == std::string::npos) {
            continue;
        }
        const std::string field = line.substr(0, colon);
        if (!fields.emplace(field, trimmed(std::string_view(line).substr(colon + 2))).second) {
            return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                         {PALPATE_TEXT("%1 twice"), inQuotes(field)}, {PALPATE_TEXT("each field once")});
        }
        if (field == "sizes" && fields.count("dimension") == 0) {
            return fault(StatusCode::BadFormat, file, inHeader("sizes"),
                         {PALPATE_TEXT("no field `dimension` before `sizes`")}, {PALPATE_TEXT("`dimension` first")});
        }
    }
    const auto wordsOf = [&fields](const char* field) {
        std::istringstream words(fields[field]);
        return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
    };
    if (fields["dimension"] != "3") {
        return fault(StatusCode::Unsupported, file, inHeader("dimension"),
                     {PALPATE_TEXT("%1"), inQuotes(fields["dimension"])}, {PALPATE_TEXT("%1"), 3});
    }
    const std::vector<std::string> sizes = wordsOf("sizes");
    constexpr std::size_t kMostDigits = 9;
    if (sizes.size() != 3 || !std::all_of(sizes.begin(), sizes.end(), [](const std::string& size) {
            return size.size() <= kMostDigits && size.find_first_not_of("0123456789") == std::string::npos;
        })) {
        return fault(StatusCode::BadFormat, file, inHeader("sizes"), {PALPATE_TEXT("%1"), inQuotes(fields["sizes"])},
                     {PALPATE_TEXT("three numbers of voxels")});
    }
    if (fields.count("data file") != 0 && fields.count("datafile") != 0) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("both \"data file\" and \"datafile\"")}, {PALPATE_TEXT("one of the two")});
    }
    for (const char* field : {"data file", "datafile"}) {
        if (wordsOf(field).size() > 1) {
            return fault(StatusCode::Unsupported, file, inHeader(field), {PALPATE_TEXT("%1"), inQuotes(fields[field])},
                         {PALPATE_TEXT("the name of one file")});
        }
    }
    return {};
}

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

std::optional<TextHeader> textHeader(const std::filesystem::path& path)
{
    const bool isMeta = isMetaImage(path);
    TextHeader header;
    std::ifstream in(path, std::ios::binary);
    std::string line;
    bool wasCarriageReturn = false;
    header.isText = isMeta; // default
    while (header.size < kMostHeader && std::getline(in, line)) {
        header.size += line.size() + 1;
        header.isPlain = header.isPlain && line.find('\0') == std::string::npos;
        header.longest = std::max(header.longest, line.size());
        const std::string_view words = trimmed(line);
        const std::size_t separator = words.find_first_of(isMeta ? "=:" : ":");
        if (!isMeta && (line.empty() || (line == "\r" && wasCarriageReturn))) { // as in VTK's NRRD reader
            header.isEnded = !in.eof();
            break;
        }
        wasCarriageReturn = line.ends_with('\r');
        if (words.empty()) {
            continue;
        }
        if (header.isList) {
            header.dataFiles.emplace_back(words);
        } else if (separator != std::string_view::npos) {
            const std::string_view key = trimmed(words.substr(0, separator));
            if (!takeField(header, isMeta, key, std::string(trimmed(words.substr(separator + 1))))) {
                return std::nullopt;
            }
            if (isMeta && key == "ElementDataFile") { // the last field
                header.isEnded = !in.eof();
                if (!header.isList) {
                    break;
                }
            }
        }
    }
    header.isEnded = header.isEnded && header.size < kMostHeader;
    return header;
}

Status checkTextHeader(const std::filesystem::path& path, const std::optional<TextHeader>& header)
{
    const std::string file = path.filename().string();
    if (!header) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("unreadable directions of its axes")},
                     {PALPATE_TEXT("three vectors that are not in one plane")});
    }
    if (!header->isEnded) { // VTK's NRRD reader can loop forever without an empty line
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")}, {PALPATE_TEXT("it has no end")},
                     {PALPATE_TEXT("a header that ends before the voxels, or with the name of their file")});
    }
    if (!header->isPlain) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")}, {PALPATE_TEXT("a byte of 0 in its text")},
                     {PALPATE_TEXT("a header that consists of text only")});
    }
    if (header->dimensions < 1 || header->dimensions > 4) { // VTK's MetaImage reader accepts any number
        return fault(StatusCode::BadFormat, file, inHeader("NDims"),
                     header->dimensions == 0 ? core::Message(PALPATE_TEXT("not a digit"))
                                             : core::Message(PALPATE_TEXT("%1"), header->dimensions),
                     {PALPATE_TEXT("%1 to %2"), 1, 4});
    }
    constexpr std::size_t kLongest = 254; // size of MetaIO's buffer
    if (isMetaImage(path) && header->longest > kLongest) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("a line of %1 characters"), Count(header->longest)},
                     {PALPATE_TEXT("at most %1"), kLongest});
    }
    if (Status status = isMetaImage(path) ? Status() : checkNrrd(path); !status.isOk()) {
        return status;
    }
    if (header->isText) { // VTK 9.1 returns uninitialised memory (NRRD) or never ends (MetaImage)
        return fault(StatusCode::Unsupported, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("voxels in another encoding")},
                     isMetaImage(path) ? core::Message(PALPATE_TEXT("%1"), "`BinaryData = True`")
                                       : core::Message(PALPATE_TEXT("%1 or %2"), "`raw`", "`gzip`"));
    }
    return checkDataFiles(path, *header);
}

Status checkNifti(const std::filesystem::path& path)
{
    constexpr std::array<std::int16_t, 16> kKinds{2,   4,   8,    16,   32,   64,   128,  256,
                                                  512, 768, 1024, 1280, 1536, 1792, 2048, 2304};
    constexpr std::int32_t kFirst = 348, kSecond = 540; // bytes of the header: NIfTI-1, NIfTI-2
    const std::string file = path.filename().string();
    std::array<unsigned char, kSecond> head{};
    gzFile in = gzopen(path.c_str(), "rb"); // also reads uncompressed files
    const int read = in == nullptr ? 0 : gzread(in, head.data(), static_cast<unsigned>(head.size()));
    if (in != nullptr) {
        (void)gzclose(in);
    }
    const auto numberAt = [&head](std::size_t at, std::size_t bytes, bool isSwapped) {
        std::int64_t number = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            number |= static_cast<std::int64_t>(head[at + (isSwapped ? bytes - 1 - i : i)]) << (8 * i);
        }
        return number;
    };
    const bool isSwapped = head[0] == 0;
    const std::int64_t size = numberAt(0, 4, isSwapped);
    if (read < kFirst || (size != kFirst && size != kSecond) || read < size) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")}, {PALPATE_TEXT("no NIfTI header")},
                     {PALPATE_TEXT("a header of %1 or %2 bytes"), kFirst, kSecond});
    }
    const auto kind = static_cast<std::int16_t>(numberAt(size == kFirst ? 70 : 12, 2, isSwapped));
    if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("voxels of type %1"), static_cast<int>(kind)},
                     {PALPATE_TEXT("a type of the NIfTI format, e.g. 16 for float")});
    }
    const std::int64_t axes = numberAt(size == kFirst ? 40 : 16, size == kFirst ? 2 : 8, isSwapped);
    if (axes < 1 || axes > 7) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")}, {PALPATE_TEXT("%1 axes"), axes},
                     {PALPATE_TEXT("%1 to %2"), 1, 7});
    }
    // NIfTI-2 stores 64-bit counts; VTK's reader keeps 32 bits.
    for (std::int64_t axis = 1; axis <= axes && size == kSecond; ++axis) {
        const std::int64_t count = numberAt(static_cast<std::size_t>(16 + 8 * axis), 8, isSwapped);
        if (count < 1 || count > std::numeric_limits<std::int32_t>::max()) {
            return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                         {PALPATE_TEXT("%1 voxels along axis %2"), count, axis},
                         {PALPATE_TEXT("%1 to %2"), 1, std::numeric_limits<std::int32_t>::max()});
        }
    }
    return {};
}

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
