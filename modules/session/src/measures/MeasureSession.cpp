// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/MeasureSession.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
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

/// Finds the surfaces of a recording from the scene and structure of a tick.
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
        for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
            const haptics::Contact& contact = tick.felt.contacts[i];
            Last& last = m_last[i];
            if (last.scene != tick.scene || last.structure != contact.structure) {
                last = {tick.scene, contact.structure, surfaceOf(tick.scene, contact.structure)};
            }
            if (last.surface != nullptr) {
                last.surface->add(contact.p_WG, contact.f_W.norm(), contact.depth_mm, dt_s);
            }
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
        std::unique_ptr<TouchedSurface> surface; ///< created at the first contact
    };

    TouchedSurface* surfaceOf(std::uint32_t generation, std::uint32_t number)
    {
        const SceneRecord* scene = m_reader.scene(generation);
        if (scene == nullptr || number >= scene->structures.size()) {
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
    /// Cached lookup for one contact index.
    struct Last
    {
        std::uint32_t scene = 0;
        std::uint32_t structure = std::numeric_limits<std::uint32_t>::max(); ///< no cached structure
        TouchedSurface* surface = nullptr;
    };
    std::array<Last, haptics::kMaxContacts> m_last{};
};

/// Classifies the phases of each structure separately.
class StructurePhases
{
  public:
    explicit StructurePhases(double dt_s)
        : m_dt_s(dt_s)
    {
    }

    void add(const servo::TickRecord& tick, const RecordingReader& reader)
    {
        const auto contacts = std::span(tick.felt.contacts).first(tick.felt.contactCount);
        for (const haptics::Contact& contact : contacts) {
            const std::string_view name = reader.structureName(tick.scene, contact.structure);
            if (m_phases.find(name) == m_phases.end()) {
                m_phases.emplace(name, PhaseAccumulator(m_dt_s, reader.extent().firstTick));
            }
        }
        for (auto& [name, phases] : m_phases) {
            const auto touched =
                std::find_if(contacts.begin(), contacts.end(), [&, &name = name](const haptics::Contact& contact) {
                    return reader.structureName(tick.scene, contact.structure) == name;
                });
            phases.add(tick, touched == contacts.end() ? nullptr : &*touched);
        }
    }

    [[nodiscard]] std::map<std::string, std::vector<Phase>> result() const
    {
        std::map<std::string, std::vector<Phase>> out;
        for (const auto& [name, phases] : m_phases) {
            out.emplace(name, phases.result());
        }
        return out;
    }

  private:
    double m_dt_s;
    std::map<std::string, PhaseAccumulator, std::less<>> m_phases;
};

} // namespace

double minDistance_mm(const MeshesByHash& meshes)
{
    constexpr double kMostTriangles = 1e7;
    double area_mm2 = 0.0;
    for (const auto& [hash, mesh] : meshes) {
        area_mm2 += areaOf(mesh->mesh);
    }
    // An equilateral triangle with edge d/2 has the area sqrt(3)/16 d^2.
    return std::sqrt(16.0 / std::numbers::sqrt3 * area_mm2 / kMostTriangles);
}

core::Result<SessionMeasures> measureSession(const RecordingReader& reader, const MeshesByHash& meshes,
                                             const MeasureOptions& options)
{
    if (const double least_mm = minDistance_mm(meshes); !(options.distance_mm >= least_mm)) {
        return Status(StatusCode::OutOfRange,
                      PALPATE_TEXT("distance: found %1 mm, expected at least %2 mm for surfaces this large"),
                      options.distance_mm, std::ceil(100.0 * least_mm) / 100.0);
    }
    const double dt_s = reader.info().dt_s;
    MeasureAccumulator sums(dt_s);
    PhaseAccumulator phases(dt_s);
    StructurePhases structurePhases(dt_s);
    FindingAccumulator findings(reader.events(), reader.extent().firstTick, dt_s, options.distance_mm);
    Surfaces surfaces(reader, meshes, options.distance_mm);
    bool isCancelled = false;
    const Status status = reader.forEach(
        std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
        [&](const servo::TickRecord& tick) {
            sums.add(tick, [&](std::uint32_t number) { return reader.structureName(tick.scene, number); });
            phases.add(tick);
            structurePhases.add(tick, reader);
            findings.add(tick);
            surfaces.add(tick, dt_s);
            isCancelled = options.isCancelled != nullptr && *options.isCancelled;
            return !isCancelled;
        });
    if (!status.isOk()) {
        return status;
    }
    if (isCancelled) {
        return Status(StatusCode::Cancelled, PALPATE_TEXT("measuring was cancelled"));
    }
    SessionMeasures out;
    out.distance_mm = options.distance_mm;
    out.sums = sums.result();
    out.phases = phases.result();
    out.structurePhases = structurePhases.result();
    out.findings = findings.result();
    surfaces.finish(out);
    out.lostTicks = reader.extent().dropped;
    out.lateTicks = reader.extent().late;
    out.damaged = reader.faults();
    return out;
}

} // namespace palpate::session
