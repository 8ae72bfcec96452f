// SPDX-License-Identifier: BSD-3-Clause
#include "formats/MeshFormat.h"

#include "formats/ObjMaterials.h"
#include "guard/BadVertices.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <palpate/core/Numbers.h>
#include <palpate/geometry/PolygonCutter.h>

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

constexpr std::size_t kLongestName = 256;  ///< [bytes]
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
    /// Assigns a new index to a name that may be in use already.
    std::uint32_t newIdOf(std::string_view name)
    {
        m_names.emplace_back(name);
        return m_ids.insert_or_assign(std::string(name), static_cast<std::uint32_t>(m_names.size() - 1)).first->second;
    }
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return m_names; }

  private:
    std::map<std::string, std::uint32_t, std::less<>> m_ids;
    std::vector<std::string> m_names;
};

/// Groups the faces of a file by object, group or material.
struct FaceGroups
{
    NameList names;
    std::optional<std::uint32_t> current; ///< empty before the first statement
    std::optional<std::string> started;   ///< name in a statement since the last face
    std::vector<std::uint32_t> ofFace;

    /// Adds a face. A repeated name continues the group, unless new vertices came in between: then two parts of the
    /// file have the same name.
    void addFace(bool hasNewVertices)
    {
        if (started) {
            current = hasNewVertices ? names.newIdOf(*started) : names.idOf(*started);
            started.reset();
        }
        current = current ? current : names.idOf("");
        ofFace.push_back(*current);
    }
    /// @return number of groups with faces
    [[nodiscard]] std::size_t used() const { return std::set(ofFace.begin(), ofFace.end()).size(); }
    /// @return true for several groups with faces, of which one has a name
    [[nodiscard]] bool areNamed() const
    {
        const std::set<std::uint32_t> groups(ofFace.begin(), ofFace.end());
        return groups.size() > 1 && std::any_of(groups.begin(), groups.end(),
                                                [this](std::uint32_t id) { return !names.names()[id].empty(); });
    }
};

/// Reads the text and writes the parts that VTK needs: the vertices unchanged and the faces with plain indices from 1.
class ObjScan
{
  public:
    /// @param isCut  the last line has no end, so that a face there may be incomplete
    ObjScan(std::string_view text, const ScanContext& context, bool isCut)
        : m_text(text)
        , m_isCut(isCut)
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
    Status readLine(std::string_view word, std::string_view rest);
    void takeColours(const FaceGroups& parts);
    /// Joins lines that end in a backslash.
    std::string_view wholeLine();

    std::string_view m_text;
    bool m_isCut;
    const ScanContext& m_context;
    LineReader m_lines;
    std::string m_joined;
    std::string m_plain;
    std::uint64_t m_line = 0;
    std::int64_t m_points = 0;
    std::int64_t m_highest = 0; ///< largest vertex index used by a face, and the line of the face
    std::uint64_t m_highestLine = 0;
    BadVertices m_bad;
    std::vector<std::int64_t> m_forward; ///< indices of vertices that were used before they were read
    std::uint64_t m_thinFaces = 0;
    FaceGroups m_objects, m_groups, m_materials;
    bool m_hasNewVertices = false; ///< since the last face
    std::uint64_t m_ignored = 0;   ///< lines, points and free-form elements
    std::string m_library;         ///< of the materials
    bool m_isOfSlicer = false;     ///< written by 3D Slicer
    bool m_hasVertexColours = false;
    PreScan m_scan;
};

std::string_view ObjScan::wholeLine()
{
    std::string_view line = m_lines.line();
    m_line = m_lines.number();
    if (!line.ends_with('\\') || trimmed(line).front() == '#') { // a comment may end in a path of Windows
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
    std::string numbers;
    Status bad;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = takeWord(rest);
        const std::optional<double> value = wordToNumber(word);
        if (!value) {
            return wrong(StatusCode::BadFormat,
                         word.empty() ? core::Message(PALPATE_TEXT("the vertex has fewer than three coordinates"))
                                      : core::Message(PALPATE_TEXT("%1 is not a number"), inQuotes(word)),
                         {PALPATE_TEXT("three numbers after %1"), "\"v\""});
        }
        if (const core::Message why = coordinateFault(*value, m_context.unit_mm); !why.isEmpty() && bad.isOk()) {
            bad = wrong(StatusCode::NonFinite, why, {PALPATE_TEXT("finite coordinates within 10 km")});
        }
        numbers += ' ';
        if (word.size() > kLongestNumber || word.front() == '+') { // some versions of VTK do not accept a plus sign
            core::appendNumber(numbers, *value);
        } else {
            numbers.append(word);
        }
    }
    if (!bad.isOk()) {
        m_bad.add(m_points, bad);
        numbers = " 0 0 0";
    }
    m_plain.append("v").append(numbers);
    m_hasNewVertices = true;
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
    const std::size_t before = m_plain.size();
    m_plain += 'f';
    for (std::string_view word = takeWord(rest); !word.empty() && word.front() != '#'; word = takeWord(rest)) {
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
        if (index > m_points) {
            m_forward.push_back(index - 1);
        } else if (Status status = m_bad.check(index - 1); !status.isOk()) {
            return status;
        }
        m_plain.append(" ").append(std::to_string(index));
        ++corners;
    }
    if (corners < 3 && m_isCut && m_lines.end() == m_text.size()) {
        return wrong(StatusCode::BadFormat,
                     corners == 1 ? core::Message(PALPATE_TEXT("a face with one corner"))
                                  : core::Message(PALPATE_TEXT("a face with %1 corners"), Count(corners)),
                     {PALPATE_TEXT("at least %1"), 3});
    }
    if (corners < 3) {
        m_plain.resize(before);
        ++m_thinFaces;
        return {};
    }
    m_plain += '\n';
    if (corners > geometry::PolygonCutter::kMostCorners) {
        return wrong(StatusCode::BadFormat, {PALPATE_TEXT("a face with %1 corners"), Count(corners)},
                     {PALPATE_TEXT("at most %1"), Count(geometry::PolygonCutter::kMostCorners)});
    }
    for (FaceGroups* groups : {&m_objects, &m_groups, &m_materials}) {
        groups->addFace(m_hasNewVertices && groups != &m_materials);
    }
    m_hasNewVertices = false;
    return {};
}

/// @return the name in a statement; empty for "default", which is the name of no group (specification of OBJ, "g")
std::string_view groupName(std::string_view rest)
{
    const std::string_view name = trimmed(rest.substr(0, kLongestName));
    return sameWord(name, "default") ? std::string_view() : name;
}

/// A line that is no comment.
Status ObjScan::readLine(std::string_view word, std::string_view rest)
{
    if (word == "v") {
        return readVertex(rest);
    }
    if (word == "f" || word == "fo") {
        return readFace(rest);
    }
    if (word == "o") {
        m_objects.started = groupName(rest);
    } else if (word == "g") {
        m_groups.started = groupName(rest);
    } else if (word == "usemtl") {
        m_materials.started = trimmed(rest.substr(0, kLongestName));
    } else if (word == "mtllib" && m_library.empty()) {
        m_library = trimmed(rest.substr(0, kLongestName));
    } else if (word == "l" || word == "p" || word == "curv" || word == "curv2" || word == "surf") {
        ++m_ignored;
    }
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
            m_isOfSlicer = m_isOfSlicer || m_lines.line().find("3D Slicer") != std::string_view::npos;
        } else {
            status = readLine(word, rest);
        }
        if (!status.isOk()) {
            return status;
        }
    }
    if (m_objects.ofFace.empty()) {
        m_line = m_lines.number();
        return noFaces(m_thinFaces > 0 ? 0 : static_cast<std::uint64_t>(m_points), onLine(m_line), m_context);
    }
    if (m_highest > m_points) {
        m_line = m_highestLine;
        return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("vertex index %1"), m_highest},
                     {PALPATE_TEXT("at most %1, the number of vertices"), m_points});
    }
    for (const std::int64_t vertex : m_forward) {
        if (Status status = m_bad.check(vertex); !status.isOk()) {
            return status;
        }
    }
    return {};
}

/// @return "part 3" for a group "grp3", which VTK's exporter, and so 3D Slicer, writes instead of a name
std::string partName(const std::string& group)
{
    constexpr std::string_view kPrefix = "grp";
    const bool isNumbered = group.size() > kPrefix.size() && group.starts_with(kPrefix) &&
                            group.find_first_not_of("0123456789", kPrefix.size()) == std::string::npos;
    return isNumbered ? "part " + group.substr(kPrefix.size()) : group;
}

/// Takes colour and opacity of each part whose faces all have the same material.
void ObjScan::takeColours(const FaceGroups& parts)
{
    if (m_materials.names.names().empty()) {
        return;
    }
    const Materials materials = readMaterials(m_context.path.parent_path(), m_library);
    constexpr std::uint32_t kNone = 0xffffffff, kSeveral = 0xfffffffe;
    std::vector<std::uint32_t> materialOf(parts.names.names().size(), kNone);
    for (std::size_t face = 0; face < parts.ofFace.size(); ++face) {
        std::uint32_t& material = materialOf[parts.ofFace[face]];
        material = material == kNone || material == m_materials.ofFace[face] ? m_materials.ofFace[face] : kSeveral;
    }
    std::set<std::uint32_t> lost(m_materials.ofFace.begin(), m_materials.ofFace.end());
    m_scan.partColours.resize(materialOf.size());
    m_scan.partOpacities.resize(materialOf.size(), 1.0);
    for (std::size_t part = 0; part < materialOf.size(); ++part) {
        if (materialOf[part] >= kSeveral) {
            continue;
        }
        const auto found = materials.find(m_materials.names.names()[materialOf[part]]);
        if (found == materials.end()) {
            continue;
        }
        m_scan.partOpacities[part] = found->second.opacity;
        if (found->second.colour) {
            std::array<double, 3> colour = *found->second.colour;
            // 3D Slicer's exporter spreads a colour over the ambient, diffuse and specular terms, a third each.
            for (double& component : colour) {
                component = m_isOfSlicer ? std::min(1.0, 3.0 * component) : component;
            }
            m_scan.partColours[part] = colour;
            lost.erase(materialOf[part]);
        }
    }
    std::erase_if(lost, [this](std::uint32_t id) { return m_materials.names.names()[id].empty(); });
    if (!lost.empty()) {
        m_scan.note(lost.size() == 1 ? core::Message(PALPATE_TEXT("colours not read: those of its material"))
                                     : core::Message(PALPATE_TEXT("colours not read: those of its %1 materials"),
                                                     Count(lost.size())));
    }
}

PreScan ObjScan::finish()
{
    m_scan.format = "OBJ";
    m_scan.points = static_cast<std::uint64_t>(m_points);
    m_scan.cells = m_objects.ofFace.size();
    // Several objects are the structures; else the groups are: modelling programs also use groups to split one object
    // by material. Without either, or if none has a name, the materials are.
    const FaceGroups& parts = m_objects.areNamed()     ? m_objects
                              : m_groups.areNamed()    ? m_groups
                              : m_materials.used() > 1 ? m_materials
                              : m_objects.used() > 1   ? m_objects
                                                       : m_groups;
    m_scan.partNames = parts.names.names();
    std::ranges::transform(m_scan.partNames, m_scan.partNames.begin(), partName);
    m_scan.partOfCell = parts.ofFace;
    if (m_scan.partNames.size() == 1 && m_scan.partNames.front().empty()) {
        m_scan.partNames.front() = m_objects.names.names()[m_objects.ofFace.front()];
    }
    takeColours(parts);
    noteThinFaces(m_thinFaces, m_scan);
    m_bad.note(m_scan);
    if (m_ignored > 0) {
        m_scan.notes.push_back(
            {PALPATE_TEXT("number of line, point and curve elements that are ignored: %1"), Count(m_ignored)});
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
    std::string_view text = withoutPadding(image.bytes());
    if (text.starts_with("\xef\xbb\xbf")) { // byte order mark
        text.remove_prefix(3);
    }
    const bool isCut =
        image.bytes().substr(withoutPadding(image.bytes()).size()).find_first_of("\r\n") == std::string_view::npos;
    std::optional<ObjScan> scan(std::in_place, text, context, isCut);
    Status status = scan->run();
    core::Message loss;
    if (!status.isOk() && context.isPartial && status.code() != StatusCode::Cancelled && isCut) {
        const std::string_view whole = text.substr(0, text.find_last_of("\r\n") + 1); // without the truncated last line
        scan.emplace(whole, context, false);
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
