// SPDX-License-Identifier: BSD-3-Clause
// Source of the format: https://teem.sourceforge.net/nrrd/format.html
#include "text/TextScan.h"
#include "voxels/VolumeLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::FileFrame;
using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::size_t kMostNrrdHeader = std::size_t{1} << 20; ///< [bytes]
constexpr std::size_t kMostAxes = 4;
constexpr const char* kDataFile = "datafile"; ///< a plain name

/// Fields of a header; the end of the header is the first voxel, or the file's end if there is a data file.
struct NrrdFields
{
    std::map<std::string, std::string> fields; ///< by `plain` names
    std::map<std::string, std::string> pairs;
    std::vector<std::string> dataFiles; ///< lines after "data file: LIST"
    std::uint64_t size = 0;             ///< of the header [bytes]
};

/// @return a name without case, blanks and hyphens: Teem's reader takes "space directions", "Space Directions" and
/// "spacedirections" for the same field, and likewise the names of spaces, types and encodings
/// @par Source Teem, enumsNrrd.c
std::string plain(std::string_view name)
{
    std::string out = lowerCase(name);
    std::erase_if(out, [](char c) { return c == ' ' || c == '\t' || c == '-'; });
    return out;
}

Result<NrrdFields> fieldsOf(std::string_view bytes, const std::string& file)
{
    NrrdFields out;
    LineReader lines(bytes.substr(0, kMostNrrdHeader));
    const auto wrong = [&](const Message& found, const Message& expected) {
        return fault(StatusCode::BadFormat, file, onLine(lines.number()), found, expected);
    };
    bool isEnded = false, isList = false;
    (void)lines.next(); // the signature
    while (!isEnded && lines.next()) {
        const std::string_view line = lines.line();
        out.size = lines.end();
        if (line.find('\0') != std::string_view::npos) {
            return wrong(Message(PALPATE_TEXT("a byte of 0 in the header")), Message(PALPATE_TEXT("text")));
        }
        isEnded = line.empty();
        if (isEnded || line.front() == '#') {
            continue;
        }
        if (isList) {
            out.dataFiles.emplace_back(trimmed(line));
            continue;
        }
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) {
            return wrong(Message(PALPATE_TEXT("%1"), inQuotes(line)), Message(PALPATE_TEXT("a field and its value")));
        }
        const bool isPair = line.substr(colon).starts_with(":=");
        const std::string key = isPair ? std::string(line.substr(0, colon)) : plain(line.substr(0, colon));
        const std::string value(trimmed(line.substr(colon + (isPair ? 2 : 1))));
        if (!(isPair ? out.pairs : out.fields).emplace(key, value).second && !isPair) {
            return wrong(Message(PALPATE_TEXT("%1 a second time"), inQuotes(line.substr(0, colon))),
                         Message(PALPATE_TEXT("each field once")));
        }
        isList = key == kDataFile && value.starts_with("LIST");
    }
    const bool hasData = out.fields.contains(kDataFile);
    if (!isEnded && !(hasData && out.size == bytes.size())) {
        return wrong(Message(PALPATE_TEXT("the header does not end")),
                     Message(PALPATE_TEXT("an empty line after it, within %1 bytes"), core::Count(kMostNrrdHeader)));
    }
    return out;
}

std::optional<VoxelType> typeNamed(const std::string& name)
{
    static constexpr auto kNames =
        std::to_array<std::pair<std::string_view, VoxelType>>({{"signed char", VoxelType::Int8},
                                                               {"int8", VoxelType::Int8},
                                                               {"int8_t", VoxelType::Int8},
                                                               {"uchar", VoxelType::UInt8},
                                                               {"unsigned char", VoxelType::UInt8},
                                                               {"uint8", VoxelType::UInt8},
                                                               {"uint8_t", VoxelType::UInt8},
                                                               {"short", VoxelType::Int16},
                                                               {"short int", VoxelType::Int16},
                                                               {"signed short", VoxelType::Int16},
                                                               {"signed short int", VoxelType::Int16},
                                                               {"int16", VoxelType::Int16},
                                                               {"int16_t", VoxelType::Int16},
                                                               {"ushort", VoxelType::UInt16},
                                                               {"unsigned short", VoxelType::UInt16},
                                                               {"unsigned short int", VoxelType::UInt16},
                                                               {"uint16", VoxelType::UInt16},
                                                               {"uint16_t", VoxelType::UInt16},
                                                               {"int", VoxelType::Int32},
                                                               {"signed int", VoxelType::Int32},
                                                               {"int32", VoxelType::Int32},
                                                               {"int32_t", VoxelType::Int32},
                                                               {"uint", VoxelType::UInt32},
                                                               {"unsigned int", VoxelType::UInt32},
                                                               {"uint32", VoxelType::UInt32},
                                                               {"uint32_t", VoxelType::UInt32},
                                                               {"longlong", VoxelType::Int64},
                                                               {"long long", VoxelType::Int64},
                                                               {"long long int", VoxelType::Int64},
                                                               {"signed long long", VoxelType::Int64},
                                                               {"signed long long int", VoxelType::Int64},
                                                               {"int64", VoxelType::Int64},
                                                               {"int64_t", VoxelType::Int64},
                                                               {"ulonglong", VoxelType::UInt64},
                                                               {"unsigned long long", VoxelType::UInt64},
                                                               {"unsigned long long int", VoxelType::UInt64},
                                                               {"uint64", VoxelType::UInt64},
                                                               {"uint64_t", VoxelType::UInt64},
                                                               {"float", VoxelType::Float32},
                                                               {"double", VoxelType::Float64}});
    const std::string wanted = plain(name);
    const auto* const found =
        std::find_if(kNames.begin(), kNames.end(), [&](const auto& one) { return plain(one.first) == wanted; });
    return found == kNames.end() ? std::nullopt : std::optional(found->second);
}

/// Axes of the space of the file, and what to multiply its coordinates with for these axes.
struct Space
{
    FileFrame frame = FileFrame::Untagged;
    Vec3 sign = Vec3::Ones();
};

/// @return nothing for an unknown name
std::optional<Space> spaceNamed(const std::string& name)
{
    std::string known = plain(name);
    constexpr std::string_view kTime = "time";
    if (known.ends_with(kTime)) {
        known.resize(known.size() - kTime.size());
    }
    if (known == "leftposteriorsuperior" || known == "lps" || known == "lpst") {
        return Space{FileFrame::Lps, Vec3::Ones()};
    }
    if (known == "rightanteriorsuperior" || known == "ras" || known == "rast") {
        return Space{FileFrame::Ras, Vec3::Ones()};
    }
    if (known == "leftanteriorsuperior" || known == "las" || known == "last") {
        return Space{FileFrame::Lps, Vec3(1, -1, 1)};
    }
    constexpr std::array<std::string_view, 4> kNotAnatomical{"", "scannerxyz", "3drighthanded", "3dlefthanded"};
    return std::find(kNotAnatomical.begin(), kNotAnatomical.end(), known) != kNotAnatomical.end()
               ? std::optional(Space())
               : std::nullopt;
}

/// @return millimetres per unit; nothing for an unknown one
std::optional<double> unitNamed(std::string_view word)
{
    static constexpr auto kUnits = std::to_array<std::pair<std::string_view, double>>(
        {{"\"mm\"", 1.0}, {"\"m\"", 1000.0}, {"\"cm\"", 10.0}, {"\"um\"", 1e-3}});
    const auto* const known =
        std::find_if(kUnits.begin(), kUnits.end(), [word](const auto& one) { return one.first == word; });
    return known == kUnits.end() ? std::nullopt : std::optional(known->second);
}

/// Reads "(1,0,0)". @return NaN for "none"; nothing if unreadable
std::optional<Vec3> takeVector(std::string_view& rest)
{
    rest = rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()));
    constexpr std::string_view kNone = "none";
    if (rest.starts_with(kNone)) {
        rest.remove_prefix(kNone.size());
        return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    const std::size_t close = rest.find(')');
    if (!rest.starts_with('(') || close == std::string_view::npos) {
        return std::nullopt;
    }
    std::string inside(rest.substr(1, close - 1));
    rest.remove_prefix(close + 1);
    std::replace(inside.begin(), inside.end(), ',', ' ');
    const std::vector<double> numbers = numbersIn(inside, 3);
    return numbers.size() == 3 ? std::optional(Vec3(numbers[0], numbers[1], numbers[2])) : std::nullopt;
}

/// Parses one header.
class NrrdParser
{
  public:
    NrrdParser(NrrdFields fields, const std::string& file)
        : m_fields(std::move(fields))
        , m_file(file)
    {
    }

    Result<VolumeLayout> parse()
    {
        m_layout.format = "NRRD";
        for (const auto step : {&NrrdParser::takeSizes, &NrrdParser::takeNumbers, &NrrdParser::takeAxes,
                                &NrrdParser::takePlace, &NrrdParser::takeComponents, &NrrdParser::takeDataFiles}) {
            if (Status status = (this->*step)(); !status.isOk()) {
                return status;
            }
        }
        m_layout.pairs = std::move(m_fields.pairs);
        m_layout.isStatedLabels = m_layout.pairs.contains("Segment0_ID") || m_layout.pairs.contains("Segment0_Name");
        if (Status status = checkLayout(m_layout, m_file); !status.isOk()) {
            return status;
        }
        return std::move(m_layout);
    }

  private:
    [[nodiscard]] std::string value(const char* field) const
    {
        const auto found = m_fields.fields.find(plain(field));
        return found == m_fields.fields.end() ? std::string() : found->second;
    }
    [[nodiscard]] Status wrong(const char* field, const Message& expected,
                               StatusCode code = StatusCode::BadFormat) const
    {
        return fault(code, m_file, Message(PALPATE_TEXT("header: %1"), field),
                     Message(PALPATE_TEXT("%1"), inQuotes(value(field))), expected);
    }
    Status takeSizes();
    Status takeNumbers();
    Status takeAxes();
    Status takeSpacings(std::vector<Vec3>& directions);
    Status takePlace();
    Status takeComponents();
    Status takeDataFiles();
    Status takeSkip();

    NrrdFields m_fields;
    const std::string& m_file;
    VolumeLayout m_layout;
    std::vector<std::int64_t> m_sizes; ///< of all axes
    std::size_t m_listAxis = 0;        ///< the axis of the layers, if there are four
};

Status NrrdParser::takeSizes()
{
    const std::vector<double> dimension = numbersIn(value("dimension"), 1);
    if (dimension.size() != 1 || (dimension[0] != 3.0 && dimension[0] != 4.0)) {
        return wrong("dimension", Message(PALPATE_TEXT("3 or 4")), StatusCode::Unsupported);
    }
    const std::vector<double> sizes = numbersIn(value("sizes"), kMostAxes);
    const bool isGood = sizes.size() == static_cast<std::size_t>(dimension[0]) &&
                        std::all_of(sizes.begin(), sizes.end(), [](double size) {
                            return size >= 1.0 && size <= kMostAlong && size == std::floor(size);
                        });
    if (!isGood) {
        return wrong("sizes", Message(PALPATE_TEXT("a count from 1 to %1 for each of %2 axes"), core::Count(kMostAlong),
                                      dimension[0]));
    }
    m_sizes.assign(sizes.begin(), sizes.end());
    return {};
}

Status NrrdParser::takeNumbers()
{
    const std::optional<VoxelType> type = typeNamed(value("type"));
    if (!type) {
        return wrong("type", Message(PALPATE_TEXT("a type of number, as \"uchar\" or \"short\"")),
                     StatusCode::Unsupported);
    }
    m_layout.type = *type;
    const std::string endian = plain(value("endian"));
    if (bytesOf(*type) > 1 && endian != "little" && endian != "big") {
        return wrong("endian", Message(PALPATE_TEXT("\"little\" or \"big\"")));
    }
    m_layout.isBigEndian = endian == "big";
    const std::string encoding = plain(value("encoding"));
    m_layout.isPacked = encoding == "gzip" || encoding == "gz";
    if (!m_layout.isPacked && encoding != "raw") {
        return wrong("encoding", Message(PALPATE_TEXT("\"raw\" or \"gzip\"")), StatusCode::Unsupported);
    }
    return {};
}

/// Sets the directions of a header without a space: along x, y and z by the spacings, and NaN for the axis of the
/// layers, which is the first of another kind than a domain, or the last. The minimum of an axis is the border of the
/// first voxel unless the voxels are centred on nodes, as in ITK.
Status NrrdParser::takeSpacings(std::vector<Vec3>& directions)
{
    const std::string kinds = lowerCase(value("kinds")), spacings = value("spacings"), units = value("units"),
                      minima = value("axis mins"), centerings = lowerCase(value("centers") + " " + value("centerings"));
    std::string_view kind = kinds, spacing = spacings, unit = units, minimum = minima, centering = centerings;
    bool isLayerMissing = m_sizes.size() == kMostAxes;
    for (std::size_t axis = 0; axis < m_sizes.size(); ++axis) {
        const std::string_view ofKind = takeWord(kind), length = takeWord(spacing), ofUnit = takeWord(unit),
                               first = takeWord(minimum), centre = takeWord(centering);
        if (isLayerMissing && (axis + 1 == kMostAxes || (!ofKind.empty() && ofKind != "domain" && ofKind != "space"))) {
            isLayerMissing = false;
            directions.emplace_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
            continue;
        }
        const double unit_mm = value("space units").empty() ? unitNamed(ofUnit).value_or(1.0) : 1.0; // free text
        const std::optional<double> along = spacings.empty() ? 1.0 : wordToNumber(length);
        if (!along || !std::isfinite(*along)) {
            return wrong("spacings", Message(PALPATE_TEXT("a number for each axis in space")));
        }
        const auto place = static_cast<Eigen::Index>(std::count_if(
            directions.begin(), directions.end(), [](const Vec3& before) { return !std::isnan(before.x()); }));
        directions.emplace_back(unit_mm * *along * Vec3::Unit(std::min<Eigen::Index>(place, 2)));
        const std::optional<double> begin = wordToNumber(first);
        if (begin && std::isfinite(*begin) && value("space origin").empty() && place < 3) {
            m_layout.origin[place] = unit_mm * (*begin + (centre == "node" ? 0.0 : 0.5 * *along));
        }
    }
    return {};
}

/// Finds the axis of the layers, and the directions of the others.
Status NrrdParser::takeAxes()
{
    std::vector<Vec3> directions;
    const std::string text = value("space directions");
    std::string_view rest = text;
    while (!trimmed(rest).empty()) {
        const std::optional<Vec3> direction = takeVector(rest);
        if (!direction || directions.size() == m_sizes.size()) {
            return wrong("space directions", Message(PALPATE_TEXT("a vector of three numbers for each axis, or none")));
        }
        directions.push_back(*direction);
    }
    if (directions.empty()) { // without a space
        if (Status status = takeSpacings(directions); !status.isOk()) {
            return status;
        }
    }
    if (directions.size() != m_sizes.size()) {
        return wrong("space directions", Message(PALPATE_TEXT("a vector of three numbers for each axis, or none")));
    }
    const auto isNone = [](const Vec3& direction) { return std::isnan(direction.x()); };
    const auto nones = std::count_if(directions.begin(), directions.end(), isNone);
    m_listAxis =
        static_cast<std::size_t>(std::find_if(directions.begin(), directions.end(), isNone) - directions.begin());
    const bool isLayered = m_sizes.size() == kMostAxes;
    if (nones != (isLayered ? 1 : 0) || (isLayered && m_listAxis != 0 && m_listAxis != kMostAxes - 1)) {
        return wrong("space directions",
                     Message(PALPATE_TEXT(
                         "three axes in space and, for overlapping segments, one list axis before or after them")));
    }
    for (std::size_t axis = 0, at = 0; axis < m_sizes.size(); ++axis) {
        if (isLayered && axis == m_listAxis) {
            m_layout.layers = static_cast<std::uint32_t>(m_sizes[axis]);
            continue;
        }
        m_layout.size[at] = static_cast<std::uint32_t>(m_sizes[axis]);
        m_layout.steps.col(static_cast<Eigen::Index>(at)) = directions[axis];
        ++at;
    }
    m_layout.isInterleaved = isLayered && m_listAxis == 0;
    return {};
}

Status NrrdParser::takePlace()
{
    const std::optional<Space> space = spaceNamed(value("space"));
    if (!space) {
        return wrong("space",
                     Message(PALPATE_TEXT("%1, %2 or %3"), "left-posterior-superior", "right-anterior-superior",
                             "left-anterior-superior"),
                     StatusCode::Unsupported);
    }
    const std::string origin = value("space origin");
    std::string_view rest = origin;
    const std::optional<Vec3> place = origin.empty() ? Vec3(Vec3::Zero()) : takeVector(rest);
    if (!place || !place->allFinite()) {
        return wrong("space origin", Message(PALPATE_TEXT("a vector of three numbers")));
    }
    Vec3 units_mm = Vec3::Ones(); // along the axes of the space
    if (const std::string units = value("space units"); !units.empty()) {
        std::string_view words = units;
        for (double& unit_mm : units_mm) {
            const std::optional<double> known = unitNamed(takeWord(words));
            if (!known) {
                return wrong("space units",
                             Message(PALPATE_TEXT("a unit for each of three axes: \"mm\", \"cm\", \"m\" or \"um\"")),
                             StatusCode::Unsupported);
            }
            unit_mm = *known;
        }
    }
    const Vec3 scale = units_mm.cwiseProduct(space->sign);
    m_layout.frame = space->frame;
    m_layout.steps = (scale.asDiagonal() * m_layout.steps).eval();
    m_layout.origin = scale.cwiseProduct(origin.empty() ? m_layout.origin : *place);
    return {};
}

/// Finds out whether the layers are components of a vector: by their kind, or if no kind is given. A measurement frame
/// leads from the components to the space; an unreadable one gives NaN, which only matters to vectors.
Status NrrdParser::takeComponents()
{
    const std::string kinds = lowerCase(value("kinds"));
    std::string_view rest = kinds, kind;
    for (std::size_t axis = 0; axis <= m_listAxis; ++axis) {
        kind = takeWord(rest);
    }
    constexpr std::string_view kUnknown = "???";
    m_layout.isVector =
        m_sizes.size() == kMostAxes && (kind.empty() || kind == kUnknown || kind == "none" || kind.ends_with("vector"));
    const Vec3 sign = spaceNamed(value("space")).value_or(Space()).sign;
    m_layout.components = sign.asDiagonal();
    const std::string frame = value("measurement frame");
    std::string_view vectors = frame;
    for (Eigen::Index column = 0; column < 3 && !frame.empty(); ++column) {
        const Vec3 direction = takeVector(vectors).value_or(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        m_layout.components.col(column) = sign.cwiseProduct(direction);
    }
    return {};
}

Status NrrdParser::takeDataFiles()
{
    m_layout.offset = m_fields.size;
    const char* field = "data file";
    const std::string name = value(field);
    if (name.empty()) {
        return takeSkip();
    }
    const bool isList = name.starts_with("LIST");
    if (isList && m_layout.isPacked) {
        return wrong(field, Message(PALPATE_TEXT("one file, or uncompressed files in a LIST")),
                     StatusCode::Unsupported);
    }
    if (!isList && name.find('%') != std::string::npos) {
        return wrong(field, Message(PALPATE_TEXT("the name of one file, or LIST and one name on each line")),
                     StatusCode::Unsupported);
    }
    m_layout.dataFiles = isList ? m_fields.dataFiles : std::vector<std::string>{name};
    m_layout.offset = 0;
    if (m_layout.dataFiles.empty()) {
        return wrong(field, Message(PALPATE_TEXT("one name on each line after LIST")));
    }
    return takeSkip();
}

/// Finds the bytes between the header, or the beginning of a data file, and the voxels.
Status NrrdParser::takeSkip()
{
    if (const std::string skipped = value("line skip"); !skipped.empty() && skipped != "0") {
        return wrong("line skip", Message(PALPATE_TEXT("0: voxels from the first line on")), StatusCode::Unsupported);
    }
    const std::string skipped = value("byte skip");
    if (skipped.empty() || skipped == "0") {
        return {};
    }
    const std::optional<std::int64_t> bytes = wordToInteger(skipped);
    constexpr std::int64_t kMost = std::int64_t{1} << 40; // far above any file that can be read
    if (m_layout.isPacked || !bytes || *bytes < -1 || *bytes > kMost) {
        return wrong("byte skip",
                     Message(PALPATE_TEXT("0, or the bytes before uncompressed voxels, or -1 if the voxels "
                                          "end with their file")),
                     StatusCode::Unsupported);
    }
    m_layout.isAtEnd = *bytes < 0;
    m_layout.offset += m_layout.isAtEnd ? 0 : static_cast<std::uint64_t>(*bytes);
    return {};
}

} // namespace

bool looksLikeNrrd(std::string_view bytes)
{
    return bytes.starts_with("NRRD000");
}

Result<VolumeLayout> nrrdLayout(std::string_view bytes, const std::string& file)
{
    Result<NrrdFields> fields = fieldsOf(bytes, file);
    return fields.isOk() ? NrrdParser(std::move(fields).value(), file).parse() : fields.status();
}

} // namespace palpate::meshio::internal
