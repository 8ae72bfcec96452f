// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"

#include "formats/PolygonCutter.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <palpate/core/Numbers.h>

#include <vtkOBJReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kLongestNumber = 64; ///< VTK reads lines of a bounded length

/// Assigns indices to names in the order of first use.
class NameList
{
  public:
    std::uint32_t idOf(std::string_view name)
    {
        const auto [found, isNew] = m_ids.emplace(name, static_cast<std::uint32_t>(m_names.size()));
        if (isNew) {
            m_names.push_back(found->first);
        }
        return found->second;
    }
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return m_names; }

  private:
    std::map<std::string, std::uint32_t, std::less<>> m_ids;
    std::vector<std::string> m_names;
};

/// Reads the text and writes the parts that VTK needs: the vertices unchanged and the faces with plain indices from 1.
class ObjScan
{
  public:
    ObjScan(std::string_view text, const ScanContext& context)
        : m_text(text)
        , m_context(context)
        , m_lines(text)
    {
    }

    Status run();
    PreScan finish();
    [[nodiscard]] const std::string& plain() const noexcept { return m_plain; }

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_context.file, onLine(m_line), found, expected);
    }
    Status readVertex(std::string_view rest);
    Status readFace(std::string_view rest);
    /// Joins lines that end in a backslash.
    std::string_view wholeLine();

    std::string_view m_text;
    const ScanContext& m_context;
    LineReader m_lines;
    std::string m_joined;
    std::string m_plain;
    std::uint64_t m_line = 0;
    std::int64_t m_points = 0;
    std::int64_t m_highest = 0; ///< largest vertex index used by a face, and the line of the face
    std::uint64_t m_highestLine = 0;
    NameList m_objects;
    NameList m_groups;
    std::optional<std::uint32_t> m_object; ///< empty before the first "o"
    std::optional<std::uint32_t> m_group;  ///< empty before the first "g"
    std::vector<std::uint32_t> m_objectOfFace;
    std::vector<std::uint32_t> m_groupOfFace;
    std::uint64_t m_ignored = 0; ///< lines, points and free-form elements
    NameList m_materials;
    bool m_hasVertexColours = false;
    PreScan m_scan;
};

std::string_view ObjScan::wholeLine()
{
    std::string_view line = m_lines.line();
    m_line = m_lines.number();
    if (!line.ends_with('\\')) {
        return line;
    }
    m_joined.clear();
    while (line.ends_with('\\')) {
        m_joined.append(line.substr(0, line.size() - 1)).append(" ");
        if (!m_lines.next()) {
            return m_joined;
        }
        line = m_lines.line();
    }
    m_joined.append(line);
    return m_joined;
}

Status ObjScan::readVertex(std::string_view rest)
{
    m_plain += 'v';
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = takeWord(rest);
        const std::optional<double> value = wordToNumber(word);
        if (!value) {
            return wrong(StatusCode::BadFormat,
                         word.empty() ? core::Message(PALPATE_TEXT("the vertex has fewer than three coordinates"))
                                      : core::Message(PALPATE_TEXT("%1 is not a number"), inQuotes(word)),
                         {PALPATE_TEXT("three numbers after %1"), "\"v\""});
        }
        if (const core::Message bad = coordinateFault(*value, m_context.unit_mm); !bad.isEmpty()) {
            return wrong(StatusCode::NonFinite, bad, {PALPATE_TEXT("finite coordinates within 10 km")});
        }
        m_plain += ' ';
        if (word.size() > kLongestNumber || word.front() == '+') { // some versions of VTK do not accept a plus sign
            core::appendNumber(m_plain, *value);
        } else {
            m_plain.append(word);
        }
    }
    m_plain += '\n';
    ++m_points;
    constexpr int kColour = 3; // a single additional number is a weight
    int more = 0;
    while (more < kColour && !takeWord(rest).empty()) {
        ++more;
    }
    m_hasVertexColours = m_hasVertexColours || more == kColour;
    return {};
}

Status ObjScan::readFace(std::string_view rest)
{
    std::size_t corners = 0;
    m_plain += 'f';
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        const std::string_view first = word.substr(0, word.find('/'));
        const std::optional<std::int64_t> given = wordToInteger(first);
        if (!given) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("%1 is not a vertex index"), inQuotes(word)},
                         {PALPATE_TEXT("whole numbers after %1"), "\"f\""});
        }
        const std::int64_t index = *given < 0 ? m_points + 1 + *given : *given;
        if (*given == 0 || index < 1) {
            return wrong(StatusCode::OutOfRange,
                         {PALPATE_TEXT("vertex index %1 (number of vertices so far: %2)"), *given, Count(m_points)},
                         {PALPATE_TEXT("indices from 1, or negative indices that count back from the last vertex")});
        }
        if (index > m_highest) {
            m_highest = index;
            m_highestLine = m_line;
        }
        m_plain.append(" ").append(std::to_string(index));
        ++corners;
    }
    m_plain += '\n';
    if (corners < 3 || corners > PolygonCutter::kMostCorners) {
        return wrong(StatusCode::BadFormat,
                     corners == 1 ? core::Message(PALPATE_TEXT("a face with one corner"))
                                  : core::Message(PALPATE_TEXT("a face with %1 corners"), Count(corners)),
                     corners < 3 ? core::Message(PALPATE_TEXT("at least %1"), 3)
                                 : core::Message(PALPATE_TEXT("at most %1"), Count(PolygonCutter::kMostCorners)));
    }
    m_object = m_object ? m_object : m_objects.idOf("");
    m_group = m_group ? m_group : m_groups.idOf("");
    m_objectOfFace.push_back(*m_object);
    m_groupOfFace.push_back(*m_group);
    return {};
}

Status ObjScan::run()
{
    std::uint64_t step = 0;
    while (m_lines.next()) {
        if (++step % 65536 == 0 && m_context.progress &&
            !m_context.progress(double(m_lines.begin()) / double(m_text.size()))) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
        }
        std::string_view rest = wholeLine();
        if (rest.find('\0') != std::string_view::npos) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found a zero byte")}, {PALPATE_TEXT("text")});
        }
        const std::string_view word = takeWord(rest);
        Status status;
        if (word.empty()) {
            continue;
        }
        if (word.front() == '#') {
            noteSpaceTag(m_lines.line(), m_scan);
        } else if (word == "v") {
            status = readVertex(rest);
        } else if (word == "f" || word == "fo") {
            status = readFace(rest);
        } else if (word == "o") {
            m_object = m_objects.idOf(trimmed(rest.substr(0, 256)));
        } else if (word == "g") {
            m_group = m_groups.idOf(trimmed(rest.substr(0, 256)));
        } else if (word == "usemtl") {
            (void)m_materials.idOf(trimmed(rest.substr(0, 256)));
        } else if (word == "l" || word == "p" || word == "curv" || word == "curv2" || word == "surf") {
            ++m_ignored;
        }
        if (!status.isOk()) {
            return status;
        }
    }
    if (m_objectOfFace.empty()) {
        m_line = m_lines.number();
        return wrong(StatusCode::Empty, {PALPATE_TEXT("0 faces")}, {PALPATE_TEXT("at least one face")});
    }
    if (m_highest > m_points) {
        m_line = m_highestLine;
        return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("vertex index %1"), m_highest},
                     {PALPATE_TEXT("at most %1, the number of vertices"), m_points});
    }
    return {};
}

PreScan ObjScan::finish()
{
    m_scan.format = "OBJ";
    m_scan.points = static_cast<std::uint64_t>(m_points);
    m_scan.cells = m_objectOfFace.size();
    // Several objects are the structures; else the groups are: modelling programs also use groups to split one object
    // by material.
    const bool byObject = std::set(m_objectOfFace.begin(), m_objectOfFace.end()).size() > 1;
    m_scan.partNames = byObject ? m_objects.names() : m_groups.names();
    m_scan.partOfCell = byObject ? m_objectOfFace : m_groupOfFace;
    if (m_scan.partNames.size() == 1 && m_scan.partNames.front().empty()) {
        m_scan.partNames.front() = m_objects.names()[m_objectOfFace.front()];
    }
    if (m_ignored > 0) {
        m_scan.notes.push_back(
            {PALPATE_TEXT("number of line, point and curve elements that are ignored: %1"), Count(m_ignored)});
    }
    if (!m_materials.names().empty()) {
        const std::size_t materials = m_materials.names().size();
        m_scan.notes.push_back(
            materials == 1
                ? core::Message(PALPATE_TEXT("colours not read: those of its material"))
                : core::Message(PALPATE_TEXT("colours not read: those of its %1 materials"), Count(materials)));
    }
    if (m_hasVertexColours) {
        m_scan.notes.push_back({PALPATE_TEXT("colours not read: those of its vertices")});
    }
    return std::move(m_scan);
}

/// True if the first lines look like OBJ.
bool looksLikeObj(std::string_view bytes)
{
    static constexpr std::array<std::string_view, 12> kWords{"v", "vn",     "vt",     "f", "o", "g",
                                                             "s", "mtllib", "usemtl", "l", "p", "vp"};
    LineReader lines(startOf(bytes));
    while (lines.next()) {
        std::string_view rest = lines.line();
        const std::string_view word = takeWord(rest);
        if (word.empty() || word.front() == '#') {
            continue;
        }
        return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    }
    return false;
}

/// VTK interprets group names and materials itself, does not support negative indices, and reads lines of limited
/// length: the image becomes vertices and faces alone.
Result<PreScan> guardObj(FileImage& image, const ScanContext& context)
{
    std::string_view text = image.bytes();
    if (text.starts_with("\xef\xbb\xbf")) { // byte order mark
        text.remove_prefix(3);
    }
    std::optional<ObjScan> scan(std::in_place, text, context);
    Status status = scan->run();
    core::Message loss;
    if (!status.isOk() && context.isPartial && status.code() != StatusCode::Cancelled && !text.ends_with('\n')) {
        const std::string_view whole = text.substr(0, text.rfind('\n') + 1); // without the truncated last line
        scan.emplace(whole, context);
        if (!scan->run().isOk()) {
            return status;
        }
        status = {};
        loss = core::Message(PALPATE_TEXT("%1: %2"), onByte(whole.size()),
                             core::Message(PALPATE_TEXT("the file ends in a line; that line is lost")));
    }
    if (!status.isOk()) {
        return status;
    }
    Result<FileImage> plain = FileImage::copy(scan->plain(), context.file);
    if (!plain.isOk()) {
        return plain.status();
    }
    image = std::move(plain).value();
    PreScan found = scan->finish();
    found.loss = std::move(loss);
    return found;
}

vtkSmartPointer<vtkAlgorithm> objReader(const std::string& path, const PreScan& /*scan*/)
{
    auto made = vtkSmartPointer<vtkOBJReader>::New();
    made->SetFileName(path.c_str());
    return made;
}

constexpr std::array<std::string_view, 1> kObjExtensions{".obj"};

} // namespace

const MeshFormat kObj{"OBJ", kObjExtensions, true, looksLikeObj, guardObj, objReader};

} // namespace palpate::meshio::internal
