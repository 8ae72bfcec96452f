// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/MeasureSession.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate::session {

using core::Status;
using core::StatusCode;

namespace {

double areaOf(const geometry::TriangleMesh& mesh)
{
    double area_mm2 = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const core::Vec3& a = mesh.vertices[t[0]];
        area_mm2 += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return area_mm2;
}

/// The surfaces of a recording's scenes, found by what a tick says.
class Surfaces
{
  public:
    Surfaces(const RecordingReader& reader, const MeshesByHash& meshes, double distance_mm)
        : m_reader(reader)
        , m_meshes(meshes)
        , m_distance_mm(distance_mm)
    {
        for (const SceneRecord& scene : reader.scenes()) {
            for (const StructureRecord& structure : scene.structures) {
                if (structure.palpable) {
                    m_places.emplace(std::pair(structure.name, structure.source.sha256), Place{});
                }
            }
        }
    }

    void add(const servo::TickRecord& tick, double dt_s)
    {
        if (m_lastScene != tick.scene || m_lastStructure != tick.felt.structure) {
            m_lastScene = tick.scene;
            m_lastStructure = tick.felt.structure;
            m_last = surfaceOf(tick);
        }
        if (m_last != nullptr) {
            m_last->add(tick.felt.p_WG, tick.felt.f_W.norm(), dt_s);
        }
    }

    void finish(SessionMeasures& out)
    {
        for (auto& [which, place] : m_places) {
            const auto mesh = m_meshes.find(which.second);
            if (mesh == m_meshes.end()) {
                out.unmeasured.push_back(which.first);
                continue;
            }
            SurfaceMeasures& measures = out.surfaces.emplace_back();
            measures.structure = which.first;
            measures.area_mm2 = areaOf(mesh->second->mesh);
            if (place.surface != nullptr) {
                measures.coveredArea_mm2 = place.surface->coveredArea_mm2();
                const auto& dwell_s = place.surface->dwell_s();
                measures.longestDwell_s = *std::max_element(dwell_s.begin(), dwell_s.end());
                measures.surface = std::move(place.surface);
            }
        }
    }

  private:
    struct Place
    {
        std::unique_ptr<TouchedSurface> surface; ///< made at the first touch
    };

    TouchedSurface* surfaceOf(const servo::TickRecord& tick)
    {
        const SceneRecord* scene = m_reader.scene(tick.scene);
        const auto number = static_cast<std::size_t>(tick.felt.structure);
        if (scene == nullptr || tick.felt.structure < 0 || number >= scene->structures.size()) {
            return nullptr;
        }
        const StructureRecord& structure = scene->structures[number];
        const auto mesh = m_meshes.find(structure.source.sha256);
        const auto place = m_places.find(std::pair(structure.name, structure.source.sha256));
        if (mesh == m_meshes.end() || place == m_places.end() || mesh->second->mesh.vertices.empty()) {
            return nullptr;
        }
        if (place->second.surface == nullptr) {
            place->second.surface = std::make_unique<TouchedSurface>(mesh->second->mesh, m_distance_mm);
        }
        return place->second.surface.get();
    }

    const RecordingReader& m_reader;
    const MeshesByHash& m_meshes;
    double m_distance_mm;
    std::map<std::pair<std::string, std::string>, Place> m_places; ///< by name and hash
    std::uint32_t m_lastScene = 0;
    std::int32_t m_lastStructure = -1;
    TouchedSurface* m_last = nullptr;
};

} // namespace

core::Result<SessionMeasures> measureSession(const RecordingReader& reader, const MeshesByHash& meshes,
                                             const MeasureOptions& options)
{
    const double dt_s = reader.info().dt_s;
    MeasureAccumulator sums(dt_s);
    PhaseAccumulator phases(dt_s);
    FindingAccumulator findings(reader.events(), reader.extent().firstTick, dt_s, options.distance_mm);
    Surfaces surfaces(reader, meshes, options.distance_mm);
    bool isCancelled = false;
    const Status status = reader.forEach(std::numeric_limits<std::int64_t>::min(),
                                         std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
                                             sums.add(tick, reader.structureName(tick));
                                             phases.add(tick);
                                             findings.add(tick);
                                             surfaces.add(tick, dt_s);
                                             isCancelled = options.isCancelled != nullptr && *options.isCancelled;
                                             return !isCancelled;
                                         });
    if (!status.isOk()) {
        return status;
    }
    if (isCancelled) {
        return Status(StatusCode::Cancelled, "measuring was cancelled");
    }
    SessionMeasures out;
    out.distance_mm = options.distance_mm;
    out.sums = sums.result();
    out.phases = phases.result();
    out.findings = findings.result();
    surfaces.finish(out);
    return out;
}

} // namespace palpate::session
