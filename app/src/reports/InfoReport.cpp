// SPDX-License-Identifier: BSD-3-Clause
#include "reports/InfoReport.h"

#include "reports/MapReport.h"
#include "shared/Console.h"
#include "shared/QtText.h"

#include <palpate/core/Numbers.h>
#include <palpate/haptics/ForceTable.h>
#include <palpate/study/Distances.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/StructureSources.h>

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace palpate::app {

namespace {

const char* frameName(const meshio::LoadedStructure& structure)
{
    return core::axesOf(core::resolvedFrame(structure.description.frame, structure.frame)).data();
}

const char* frameSource(const meshio::LoadedStructure& structure)
{
    if (structure.description.frame != core::FileFrame::Untagged) {
        return "chosen";
    }
    if (structure.frame == core::FileFrame::Untagged) {
        return "assumed: the file has no SPACE tag";
    }
    constexpr std::array<std::string_view, 6> kTagged{"STL", "PLY", "OBJ", "VTP", "VTU", "VTK"};
    return std::any_of(kTagged.begin(), kTagged.end(),
                       [&](std::string_view format) { return structure.format.starts_with(format); })
               ? "the file's SPACE tag"
               : "the file's format";
}

const char* unitName(double unit_mm)
{
    return unit_mm == 1000.0 ? "m" : "mm";
}

const char* orientation(const geometry::MeshReport& r)
{
    if (r.nonOrientableComponents > 0) {
        return "none";
    }
    if (r.insideOutComponents > 0) {
        return "inside out";
    }
    return r.isClosed() ? "outwards" : r.closedComponents > 0 ? "outwards where closed" : "open";
}

/// Describes what the surface means for contact.
std::string feeling(const geometry::MeshReport& r)
{
    if (r.triangles == 0) {
        return "nothing to touch";
    }
    if (r.isClosed()) {
        return "closed: touched from the side its normals point to";
    }
    return r.closedComponents == 0 ? "open: touched from both sides"
                                   : "partly open: its open components are touched from both sides";
}

std::string crossings(const geometry::SurfaceExamination& e, std::size_t triangles)
{
    std::string line = e.crossingPairs == 0
                           ? "no crossing triangles"
                           : grouped(e.crossingPairs) + " pairs of crossing triangles, where the tip can catch";
    if (e.isPairLimitReached) {
        line +=
            " (examined " + grouped(e.examinedTriangles) + " of " + grouped(triangles) + " triangles, then stopped)";
    }
    return line;
}

/// Describes the wall thickness; empty for a surface without a wall.
std::string wall(const geometry::SurfaceExamination& e)
{
    if (!e.thinnestWall_mm) {
        return {};
    }
    const core::Vec3& p = e.thinnestAt;
    return "thinnest wall found " + core::shortNumber(*e.thinnestWall_mm, 3) + " mm at (" + core::shortNumber(p.x()) +
           ", " + core::shortNumber(p.y()) + ", " + core::shortNumber(p.z()) + "), from " + grouped(e.wallSamples) +
           " rays: a hand that presses deeper passes through the other side";
}

std::vector<std::string> english(const std::vector<core::Message>& messages)
{
    std::vector<std::string> lines;
    for (const core::Message& message : messages) {
        lines.push_back(message.english());
    }
    return lines;
}

/// Describes the findings on a structure's mesh.
std::vector<std::string> sentencesOf(const meshio::LoadedStructure& structure)
{
    std::vector<core::Message> lines = structure.surface->report.sentences();
    for (core::Message& sentence : meshio::shapeSentences(structure.staircase, structure.smoothing)) {
        lines.push_back(std::move(sentence));
    }
    if (structure.closing) {
        lines.push_back(structure.closing->message());
    }
    if (structure.curving) {
        lines.push_back(structure.curving->message());
    }
    return english(lines);
}

std::vector<std::string> notes(const FileReport& report)
{
    std::vector<std::string> out = english(report.scene.warnings);
    for (const std::string& note : english(report.lumpNotes)) {
        if (std::find(out.begin(), out.end(), note) == out.end()) { // already printed with the palpable lumps
            out.push_back(note);
        }
    }
    for (const std::string& question : english(study::ratioQuestions(report.scene, report.lumps))) {
        if (std::find(out.begin(), out.end(), question) == out.end()) {
            out.push_back(question);
        }
    }
    for (const auto& structure : report.scene.structures) {
        for (const std::string& sentence : sentencesOf(structure)) {
            std::erase(out, structure.description.name + ": " + sentence); // already printed with the structure
        }
    }
    return out;
}

/// Describes a structure's force law in one line; empty for a linear law.
std::string lawLine(const core::Tissue& tissue)
{
    const core::ForceLaw& law = tissue.law;
    if (law.kind == core::LawKind::Linear) {
        return {};
    }
    std::string line = std::string(core::lawName(law.kind));
    std::size_t i = 0;
    for (const core::LawParameter& term : core::lawParameters(law.kind)) {
        line += ", " + std::string(term.key) + " " + core::shortNumber(law.numbers[i++]);
    }
    if (!law.points.empty()) {
        const auto [depth_mm, force_N] = law.points.back();
        line += ", " + std::to_string(law.points.size()) + " to " + core::shortNumber(depth_mm) + " mm and " +
                core::shortNumber(force_N) + " N";
    }
    return line + "; at its steepest " + core::shortNumber(haptics::maxStiffness(tissue), 4) + " N/mm";
}

QJsonArray triple(const core::Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

void printRead(const FileReport& report)
{
    print("%s\n", report.path.string().c_str());
    for (const meshio::LoadedStructure& structure : report.scene.structures) {
        const geometry::MeshReport& r = structure.surface->report;
        print("  %s: %s triangles, %s vertices, frame %s (%s)%s\n", structure.description.name.c_str(),
              grouped(r.triangles).c_str(), grouped(r.vertices).c_str(), frameName(structure), frameSource(structure),
              !structure.description.palpable        ? "; not palpable"
              : structure.description.isHiddenTarget ? "; hidden target of an exercise: felt"
              : structure.description.visible        ? ""
                                                     : "; hidden: not felt");
        if (!r.bounds.isEmpty()) {
            const core::Vec3 centre = r.bounds.center();
            print("    %s; centre (%.6g, %.6g, %.6g)\n", study::sizeText(study::sizeOf({}, r)).english().c_str(),
                  centre.x(), centre.y(), centre.z());
        }
        print("    %s; components %zu (closed %zu, open %zu, not orientable %zu, inside out %zu)\n", feeling(r).c_str(),
              r.components, r.closedComponents, r.openComponents, r.nonOrientableComponents, r.insideOutComponents);
        print("    edges: open %zu, non-manifold %zu, inconsistent %zu; triangles: zero-area %zu, duplicate %zu, "
              "reoriented %zu; vertices welded %zu\n",
              r.openEdges, r.nonManifoldEdges, r.inconsistentEdges, r.zeroAreaTriangles, r.duplicateTriangles,
              r.reorientedTriangles, r.weldedVertices);
        if (const std::string law = lawLine(structure.description.tissue); !law.empty()) {
            print("    law: %s\n", law.c_str());
        }
        for (const std::string& line : mapLines(structure)) {
            print("    %s\n", line.c_str());
        }
        for (const std::string& sentence : sentencesOf(structure)) {
            print("    - %s\n", sentence.c_str());
        }
    }
}

void printTouch(const FileReport& report)
{
    for (const core::Message& note : report.surfaceNotes) {
        print("  note: %s\n", note.english().c_str());
    }
    print("  touch: %s triangles in %s bytes (%.1f a triangle), read in %.0f ms, indexed in %.0f ms\n",
          grouped(report.touchTriangles).c_str(), grouped(report.touchBytes).c_str(),
          static_cast<double>(report.touchBytes) / static_cast<double>(std::max<std::size_t>(report.touchTriangles, 1)),
          report.load_s * 1e3, report.index_s * 1e3);
}

void printExamination(const FileReport& report)
{
    for (std::size_t i = 0; i < report.scene.structures.size(); ++i) {
        const meshio::LoadedStructure& structure = report.scene.structures[i];
        if (const auto& e = report.examined[i]) {
            const char* const name = structure.description.name.c_str();
            print("  %s: %s\n", name, crossings(*e, structure.surface->report.triangles).c_str());
            if (const std::string line = wall(*e); !line.empty()) {
                print("  %s: %s\n", name, line.c_str());
            }
        }
    }
    print("  examined in %.0f ms\n", report.examine_s * 1e3);
    for (const std::string& line : study::lumpLines(report.scene, report.lumps)) {
        print("  lump: %s\n", line.c_str());
    }
    for (const std::string& note : notes(report)) {
        print("  note: %s\n", note.c_str());
    }
}

namespace {

qint64 count(std::size_t n)
{
    return static_cast<qint64>(n);
}

QJsonArray texts(const std::vector<std::string>& lines)
{
    QJsonArray array;
    for (const std::string& line : lines) {
        array.append(text(line));
    }
    return array;
}

/// Adds the result of an examination, if any. @param sentences  gets the sentences of the result
void add(const std::optional<geometry::SurfaceExamination>& examined, std::size_t triangles, QJsonObject& object,
         QJsonArray& sentences)
{
    if (!examined) {
        return;
    }
    sentences.append(text(crossings(*examined, triangles)));
    object["crossing_pairs"] = count(examined->crossingPairs);
    object["crossing_examined_triangles"] = count(examined->examinedTriangles);
    object["crossing_bound_hit"] = examined->isPairLimitReached;
    object["wall_samples"] = count(examined->wallSamples);
    object["thinnest_wall_mm"] = examined->thinnestWall_mm ? QJsonValue(*examined->thinnestWall_mm) : QJsonValue();
    if (examined->thinnestWall_mm) {
        object["thinnest_wall_at_mm"] = triple(examined->thinnestAt);
        sentences.append(text(wall(*examined)));
    }
}

/// Adds the voxel staircase and the effects of smoothing and of curved facets.
void addShape(const meshio::LoadedStructure& structure, QJsonObject& object)
{
    if (const auto& stairs = structure.staircase) {
        QJsonObject steps{{"voxel_mm", triple(stairs->voxel_mm)},
                          {"axes", QJsonArray{triple(stairs->axes.col(0)), triple(stairs->axes.col(1)),
                                              triple(stairs->axes.col(2))}}};
        if (!stairs->isStated) {
            steps["area_share"] = stairs->areaShare;
            steps["directions"] = geometry::Staircase::kDirections;
        }
        object[stairs->isStated ? "label_map" : "staircase"] = steps;
    }
    if (const auto& done = structure.smoothing) {
        object["smoothed"] = QJsonObject{{"smoothing", structure.description.smoothing},
                                         {"most_moved_mm", done->most_mm},
                                         {"limit_mm", done->limit_mm},
                                         {"volume_before_mm3", done->volumeBefore_mm3},
                                         {"volume_after_mm3", done->volumeAfter_mm3}};
    }
    if (const auto& closing = structure.closing) {
        object["closed_holes"] = QJsonObject{{"holes", static_cast<qint64>(closing->holes)},
                                             {"largest_mm", closing->largest_mm},
                                             {"area_mm2", closing->area_mm2}};
    }
    if (const auto& curving = structure.curving) {
        object["curved"] = QJsonObject{{"crease_deg", structure.description.crease_deg},
                                       {"triangles_before", static_cast<qint64>(curving->before)},
                                       {"triangles_after", static_cast<qint64>(curving->triangles)},
                                       {"flat_triangles", static_cast<qint64>(curving->flatTriangles)},
                                       {"refused", curving->isRefused}};
    }
}

/// Converts a force law as in a scene file, with its maximum slope.
QJsonObject lawObject(const core::Tissue& tissue)
{
    const core::ForceLaw& law = tissue.law;
    QJsonObject object{{"kind", text(std::string(core::lawName(law.kind)))},
                       {"greatest_slope_N_per_mm", haptics::maxStiffness(tissue)}};
    std::size_t i = 0;
    for (const core::LawParameter& term : core::lawParameters(law.kind)) {
        const double number = law.numbers[i++];
        object[term.key.data()] = term.isSwitch ? QJsonValue(number != 0.0) : QJsonValue(number);
    }
    QJsonArray points;
    for (const auto& [depth_mm, force_N] : law.points) {
        points.append(QJsonArray{depth_mm, force_N});
    }
    if (!points.isEmpty()) {
        object["points"] = points;
    }
    return object;
}

QJsonObject toJson(const meshio::LoadedStructure& structure, const session::StructureSource& source,
                   const std::optional<geometry::SurfaceExamination>& examined)
{
    const geometry::MeshReport& r = structure.surface->report;
    QJsonArray sentences = texts(sentencesOf(structure));
    QJsonObject object{
        {"name", text(structure.description.name)},
        {"mesh", text(source.mesh)},
        {"part", text(source.part)},
        {"unit_mm", source.unit_mm},
        {"frame", frameName(structure)},
        {"frame_from", frameSource(structure)},
        {"palpable", structure.description.palpable},
        {"sha256", text(source.sha256)},
        {"input_vertices", count(r.inputVertices)},
        {"input_triangles", count(r.inputTriangles)},
        {"vertices", count(r.vertices)},
        {"triangles", count(r.triangles)},
        {"welded_vertices", count(r.weldedVertices)},
        {"zero_area_triangles", count(r.zeroAreaTriangles)},
        {"duplicate_triangles", count(r.duplicateTriangles)},
        {"reoriented_triangles", count(r.reorientedTriangles)},
        {"inconsistent_edges", count(r.inconsistentEdges)},
        {"open_edges", count(r.openEdges)},
        {"non_manifold_edges", count(r.nonManifoldEdges)},
        {"components", count(r.components)},
        {"closed_components", count(r.closedComponents)},
        {"open_components", count(r.openComponents)},
        {"non_orientable_components", count(r.nonOrientableComponents)},
        {"inside_out_components", count(r.insideOutComponents)},
        {"is_closed", r.isClosed()},
        {"area_mm2", r.area_mm2},
        {"volume_mm3", r.volume_mm3},
        {"orientation", orientation(r)},
        {"feels", text(feeling(r))},
    };
    if (structure.description.tissue.law.kind != core::LawKind::Linear) {
        object["law"] = lawObject(structure.description.tissue);
    }
    addShape(structure, object);
    addMaps(structure, object);
    add(examined, r.triangles, object, sentences);
    object["findings"] = sentences;
    if (!r.bounds.isEmpty()) {
        object["low_mm"] = triple(r.bounds.min());
        object["high_mm"] = triple(r.bounds.max());
        object["extent_mm"] = triple(r.bounds.sizes());
    }
    return object;
}

} // namespace

QJsonObject toJson(const FileReport& report)
{
    const auto sources = study::sourcesOf(report.scene);
    QJsonArray structures;
    for (std::size_t i = 0; i < report.scene.structures.size(); ++i) {
        QJsonObject one = toJson(report.scene.structures[i], sources[i], report.examined[i]);
        if (report.layers) {
            one["layer"] = static_cast<qint64>(report.scene.structures[i].description.layer);
        }
        structures.append(one);
    }
    std::vector<std::string> allNotes = notes(report);
    for (const auto* more : {&report.surfaceNotes, &report.neighbours}) {
        const std::vector<std::string> lines = english(*more);
        allNotes.insert(allNotes.end(), lines.begin(), lines.end());
    }
    const std::optional<double>& likely = report.scene.likelyUnit_mm;
    QJsonObject object{{"schema", 1},
                       {"file", text(report.path.string())},
                       {"structures", structures},
                       {"unit_guess", likely
                                          ? QJsonValue(QJsonObject{{"unit", unitName(*likely)},
                                                                   {"unit_mm", *likely},
                                                                   {"option", QString("--unit ") + unitName(*likely)}})
                                          : QJsonValue()},
                       {"notes", texts(allNotes)},
                       {"losses", texts(english(report.scene.losses))},
                       {"touch", QJsonObject{{"triangles", count(report.touchTriangles)},
                                             {"bytes", count(report.touchBytes)},
                                             {"load_s", report.load_s},
                                             {"index_s", report.index_s},
                                             {"examine_s", report.examine_s}}}};
    if (report.layers) {
        object["layers"] = texts(english(*report.layers));
    }
    object["lumps"] = study::lumpsJson(report.scene, report.lumps);
    if (report.distances) {
        object["distances"] = study::toJson(*report.distances);
    }
    return object;
}

} // namespace palpate::app
