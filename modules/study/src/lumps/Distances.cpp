// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/Distances.h"

#include "palpate/study/Layers.h"
#include "palpate/study/LumpRule.h"

#include <palpate/core/Parallel.h>
#include <palpate/meshio/AnatomyKind.h>

#include <atomic>
#include <cmath>
#include <utility>

namespace palpate::study {

namespace {

/// Share of the work done by several threads. The calling thread, number 0, reports it.
class Share
{
  public:
    Share(std::size_t count, const std::function<bool(double)>& progress)
        : m_count(count)
        , m_progress(progress)
    {
    }
    /// Returns true while the work is wanted.
    bool begin(unsigned thread)
    {
        if (thread == 0 && m_progress && !m_progress(static_cast<double>(m_done) / static_cast<double>(m_count))) {
            m_isEnded = true;
        }
        ++m_done;
        return !m_isEnded;
    }

  private:
    std::size_t m_count;
    const std::function<bool(double)>& m_progress;
    std::atomic<std::size_t> m_done{0};
    std::atomic<bool> m_isEnded{false};
};

} // namespace

std::optional<double> StructureSize::ballDiameter_mm() const
{
    return volume_mm3 ? std::optional(std::cbrt(6.0 * *volume_mm3 / M_PI)) : std::nullopt;
}

StructureSize sizeOf(std::string name, const geometry::MeshReport& report)
{
    StructureSize size;
    size.name = std::move(name);
    size.area_mm2 = report.area_mm2;
    if (!report.bounds.isEmpty()) {
        size.extent_mm = report.bounds.sizes();
    }
    if (report.closedComponents == 0) {
        size.gap = VolumeGap::Open;
        size.note = {
            PALPATE_TEXT("no volume: no part is closed (open edges: %1, edges of more than two triangles: %2)"),
            core::Count(report.openEdges), core::Count(report.nonManifoldEdges)};
    } else if (report.insideOutComponents > 0) {
        size.gap = VolumeGap::InsideOut;
        size.note = {PALPATE_TEXT("no volume: the surface is inside out")};
    } else {
        size.volume_mm3 = report.volume_mm3;
        if (report.openComponents > 0) {
            size.gap = VolumeGap::Partial;
            size.note = {PALPATE_TEXT("the volume is that of the closed parts: %1 of %2"),
                         core::Count(report.closedComponents), core::Count(report.components)};
        }
    }
    return size;
}

SharedIndices completeIndices(const meshio::LoadedScene& scene,
                              std::span<const std::shared_ptr<const geometry::SurfaceIndex>> indices)
{
    SharedIndices all(indices.begin(), indices.end());
    all.resize(scene.structures.size());
    core::parallelFor(all.size(), [&](std::size_t i, unsigned /*thread*/) {
        if (all[i] == nullptr && scene.structures[i].surface != nullptr) {
            all[i] = std::make_shared<const geometry::SurfaceIndex>(
                geometry::SurfaceIndex::build(*scene.structures[i].surface));
        }
        if (all[i] != nullptr && all[i]->triangleCount() == 0) {
            all[i] = nullptr;
        }
    });
    return all;
}

std::vector<std::size_t> lumpsOf(const meshio::LoadedScene& scene, const SharedIndices& indices)
{
    std::vector<LayeredSurface> surfaces;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        surfaces.push_back({indices[i] ? scene.structures[i].surface.get() : nullptr, indices[i].get()});
    }
    const Layering layers = layering(surfaces);
    std::vector<PlacedStructure> placed;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        placed.push_back({&scene.structures[i].description, surfaces[i].surface, layers.structures[i].in});
    }
    const LumpRule rule(std::move(placed));
    std::vector<std::size_t> lumps;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const meshio::SceneStructure& one = scene.structures[i].description;
        if (indices[i] && (meshio::isLump(meshio::anatomyKind(one.name)) || one.young_ratio || rule.organOf(i))) {
            lumps.push_back(i);
        }
    }
    return lumps;
}

DistanceTable measureDistances(const meshio::LoadedScene& scene,
                               std::span<const std::shared_ptr<const geometry::SurfaceIndex>> indices,
                               std::span<const double> limits_mm, std::span<const std::size_t> from,
                               const std::function<bool(double share)>& progress)
{
    DistanceTable table;
    table.limits_mm.assign(limits_mm.begin(), limits_mm.end());
    table.tapes = scene.scene.tapes;
    for (const meshio::LoadedStructure& one : scene.structures) {
        table.sizes.push_back(sizeOf(one.description.name, one.surface ? one.surface->report : geometry::MeshReport()));
    }
    const SharedIndices surfaces = completeIndices(scene, indices);
    const std::vector<std::size_t> lumps =
        from.empty() ? lumpsOf(scene, surfaces) : std::vector<std::size_t>(from.begin(), from.end());
    std::vector<bool> areLumps(surfaces.size(), false);
    for (const std::size_t lump : lumps) {
        areLumps[lump] = true;
    }
    for (std::size_t a = 0; a < surfaces.size(); ++a) {
        for (std::size_t b = 0; b < surfaces.size(); ++b) {
            if (a == b || surfaces[a] == nullptr || surfaces[b] == nullptr || (!lumps.empty() && !areLumps[a])) {
                continue;
            }
            if (areLumps[a]) {
                table.margins.push_back({a, b, {}});
            }
            if (a < b || (areLumps[a] && !areLumps[b])) {
                table.pairs.push_back({a, b, {}});
            }
        }
    }
    Share share(table.pairs.size() + table.margins.size(), progress);
    core::parallelFor(table.pairs.size(), [&](std::size_t i, unsigned thread) {
        PairDistance& pair = table.pairs[i];
        if (share.begin(thread)) {
            pair.found = geometry::surfaceDistance(*surfaces[pair.first], *surfaces[pair.second]).value();
        }
    });
    for (LumpMargin& margin : table.margins) {
        if (!share.begin(0)) {
            break;
        }
        margin.found = geometry::surfaceMargin(*surfaces[margin.lump], *surfaces[margin.structure], limits_mm);
    }
    return table;
}

} // namespace palpate::study
