// SPDX-License-Identifier: BSD-3-Clause
#include "InfoReport.h"

#include "Console.h"
#include "SceneForTouch.h"

#include <QJsonArray>

#include <algorithm>
#include <vector>

namespace palpate::app {

namespace {

/// A structure smaller than this is more likely measured in metres. [mm]
constexpr double kSuspiciouslySmall_mm = 2.0;

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

const char* frameName(meshio::FileFrame frame)
{
    switch (frame) {
    case meshio::FileFrame::Lps:
        return "LPS";
    case meshio::FileFrame::Ras:
        return "RAS, converted to LPS";
    case meshio::FileFrame::Untagged:
        break;
    }
    return "untagged, taken as LPS";
}

/// What the surface means for touching.
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

std::vector<std::string> notes(const FileReport& report)
{
    std::vector<std::string> out = report.scene.warnings;
    geometry::Box all;
    for (const auto& structure : report.scene.structures) {
        for (const std::string& sentence : structure.surface->report.sentences()) {
            std::erase(out, structure.description.name + ": " + sentence); // said with the structure
        }
        all.extend(structure.surface->report.bounds);
    }
    if (!all.isEmpty() && all.sizes().maxCoeff() < kSuspiciouslySmall_mm) {
        out.emplace_back("all of it is smaller than 2 mm: if its numbers are metres, say --unit m");
    }
    return out;
}

QJsonArray triple(const core::Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

void printReport(const FileReport& report)
{
    print("%s\n", report.path.string().c_str());
    for (const auto& structure : report.scene.structures) {
        const geometry::MeshReport& r = structure.surface->report;
        print("  %s: %s triangles, %s vertices, frame %s%s\n", structure.description.name.c_str(),
              grouped(static_cast<long long>(r.triangles)).c_str(), grouped(static_cast<long long>(r.vertices)).c_str(),
              frameName(structure.frame), structure.description.palpable ? "" : "; not palpable");
        if (!r.bounds.isEmpty()) {
            const core::Vec3 size = r.bounds.sizes();
            const core::Vec3 centre = r.bounds.center();
            print("    extent %.6g x %.6g x %.6g mm about (%.6g, %.6g, %.6g), area %.6g mm2, volume %.6g mm3\n",
                  size.x(), size.y(), size.z(), centre.x(), centre.y(), centre.z(), r.area_mm2, r.volume_mm3);
        }
        print("    %s; components %zu (closed %zu, open %zu, not orientable %zu, inside out %zu)\n", feeling(r).c_str(),
              r.components, r.closedComponents, r.openComponents, r.nonOrientableComponents, r.insideOutComponents);
        print("    edges: open %zu, non-manifold %zu, inconsistent %zu; triangles: zero-area %zu, duplicate %zu, "
              "reoriented %zu; vertices welded %zu\n",
              r.openEdges, r.nonManifoldEdges, r.inconsistentEdges, r.zeroAreaTriangles, r.duplicateTriangles,
              r.reorientedTriangles, r.weldedVertices);
        for (const std::string& sentence : r.sentences()) {
            print("    - %s\n", sentence.c_str());
        }
    }
    for (const std::string& note : notes(report)) {
        print("  note: %s\n", note.c_str());
    }
    print("  touch: %s triangles in %s bytes (%.1f a triangle), read in %.0f ms, indexed in %.0f ms\n",
          grouped(static_cast<long long>(report.touchTriangles)).c_str(),
          grouped(static_cast<long long>(report.touchBytes)).c_str(),
          static_cast<double>(report.touchBytes) / static_cast<double>(std::max<std::size_t>(report.touchTriangles, 1)),
          report.load_s * 1e3, report.index_s * 1e3);
}

QJsonObject toJson(const FileReport& report)
{
    const auto count = [](std::size_t n) { return static_cast<qint64>(n); };
    const auto sources = structureSources(report.scene);
    QJsonArray structures;
    for (std::size_t i = 0; i < report.scene.structures.size(); ++i) {
        const meshio::LoadedStructure& structure = report.scene.structures[i];
        const geometry::MeshReport& r = structure.surface->report;
        QJsonArray sentences;
        for (const std::string& sentence : r.sentences()) {
            sentences.append(text(sentence));
        }
        QJsonObject object{
            {"name", text(structure.description.name)},
            {"mesh", text(sources[i].mesh)},
            {"part", text(sources[i].part)},
            {"unit_mm", sources[i].unit_mm},
            {"frame", frameName(structure.frame)},
            {"palpable", structure.description.palpable},
            {"sha256", text(sources[i].sha256)},
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
            {"feels", text(feeling(r))},
            {"findings", sentences},
        };
        if (!r.bounds.isEmpty()) {
            object["low_mm"] = triple(r.bounds.min());
            object["high_mm"] = triple(r.bounds.max());
        }
        structures.append(object);
    }
    QJsonArray noteArray;
    for (const std::string& note : notes(report)) {
        noteArray.append(text(note));
    }
    return {{"file", text(report.path.string())},
            {"structures", structures},
            {"notes", noteArray},
            {"touch", QJsonObject{{"triangles", count(report.touchTriangles)},
                                  {"bytes", count(report.touchBytes)},
                                  {"load_s", report.load_s},
                                  {"index_s", report.index_s}}}};
}

} // namespace palpate::app
