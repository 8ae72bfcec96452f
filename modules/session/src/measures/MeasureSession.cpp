// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/MeasureSession.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
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

/// Name and surface of a structure in a recording; empty if unknown or not palpable.
StructureKey keyOf(const RecordingReader& reader, std::uint32_t generation, std::uint32_t number)
{
    const SceneRecord* scene = reader.scene(generation);
    if (scene == nullptr || number >= scene->structures.size() || !scene->structures[number].palpable) {
        return {};
    }
    return {scene->structures[number].name, scene->structures[number].source.sha256};
}

/// Fills in the measures of each palpable structure, touched or not.
void finish(const RecordingReader& reader, const MeshesByHash& meshes, TouchedSurfaces& surfaces, SessionMeasures& out)
{
    std::set<StructureKey> palpable;
    for (const SceneRecord& scene : reader.scenes()) {
        for (const StructureRecord& structure : scene.structures) {
            if (structure.palpable) {
                palpable.emplace(structure.name, structure.source.sha256);
            }
        }
    }
    for (const StructureKey& key : palpable) {
        const auto mesh = meshes.find(key.second);
        if (mesh == meshes.end()) {
            out.unmeasured.push_back(key.first);
            continue;
        }
        SurfaceMeasures& measures = out.surfaces.emplace_back();
        measures.structure = key.first;
        measures.area_mm2 = areaOf(mesh->second->mesh);
        measures.surface = surfaces.take(key);
        if (measures.surface != nullptr) {
            measures.coveredArea_mm2 = measures.surface->coveredArea_mm2();
            const auto& dwell_s = measures.surface->dwell_s();
            measures.longestDwell_s = *std::max_element(dwell_s.begin(), dwell_s.end());
        }
    }
}

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
    TouchedSurfaces surfaces(
        meshes, [&reader](std::uint32_t scene, std::uint32_t structure) { return keyOf(reader, scene, structure); },
        options.distance_mm);
    constexpr std::int64_t kAsk = 4096; // ticks between two calls of the progress
    std::int64_t ticks = 0;
    bool isCancelled = false;
    const Status status =
        reader.forEach(std::numeric_limits<std::int64_t>::min(), options.lastTick, [&](const servo::TickRecord& tick) {
            sums.add(tick, [&](std::uint32_t number) { return reader.structureName(tick.scene, number); });
            phases.add(tick);
            structurePhases.add(tick, reader);
            findings.add(tick);
            surfaces.add(tick, static_cast<double>(tick.tick) * dt_s, dt_s);
            if (options.sink) {
                options.sink(tick);
            }
            isCancelled = ticks++ % kAsk == 0 && options.progress && !options.progress(reader.shareBefore(tick.tick));
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
    finish(reader, meshes, surfaces, out);
    out.lostTicks = reader.extent().dropped;
    out.lateTicks = reader.extent().late;
    out.damaged = reader.faults();
    return out;
}

} // namespace palpate::session
