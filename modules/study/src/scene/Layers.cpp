// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/Layers.h"

#include <palpate/core/Parallel.h>
#include <palpate/geometry/Inside.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate::study {

namespace {

/// Returns the enclosed volume, independent of the orientation of the normals [mm3].
double enclosed_mm3(const LayeredSurface& one)
{
    return std::abs(one.surface->report.volume_mm3);
}

/// Returns true for equal surfaces, such as a file opened twice. Independent of the order of triangles.
bool isDuplicate(const geometry::MeshReport& a, const geometry::MeshReport& b)
{
    const auto isSame = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
    return a.triangles == b.triangles && a.vertices == b.vertices && a.bounds.min() == b.bounds.min() &&
           a.bounds.max() == b.bounds.max() && isSame(a.area_mm2, b.area_mm2) && isSame(a.volume_mm3, b.volume_mm3);
}

/// Returns true if at least kInsideShare of the sampled vertices of `inner` are inside `outer`.
bool isMostlyInside(const geometry::RepairedMesh& inner, const geometry::SurfaceIndex& outer)
{
    const std::vector<core::Vec3>& vertices = inner.mesh.vertices;
    const std::size_t samples = std::min(kSamples, vertices.size());
    const auto needed = static_cast<std::size_t>(std::ceil(kInsideShare * static_cast<double>(samples)));
    std::size_t inside = 0;
    for (std::size_t i = 0; i < samples && inside < needed; ++i) {
        if (inside + (samples - i) < needed) {
            return false; // out of reach even if all remaining samples are inside
        }
        inside += geometry::isInside(outer, vertices[i * vertices.size() / samples]) ? 1 : 0;
    }
    return inside >= needed && samples > 0;
}

class Nesting
{
  public:
    explicit Nesting(std::span<const LayeredSurface> surfaces)
        : m_surfaces(surfaces)
        , m_holders(surfaces.size())
    {
    }

    Layering find()
    {
        m_out.structures.resize(m_surfaces.size());
        core::parallelFor(m_surfaces.size(), [this](std::size_t i, unsigned /*thread*/) { findHolders(i); });
        // A nested structure has less volume than the one around it. In order of decreasing volume, the surrounding
        // structures are therefore already processed.
        std::vector<std::size_t> order(m_surfaces.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [this](std::size_t a, std::size_t b) { return volume(a) > volume(b); });
        for (const std::size_t i : order) {
            place(i);
        }
        for (Layering::Structure& one : m_out.structures) {
            if (one.in && m_out.structures[*one.in].twin) {
                one.in = m_out.structures[*one.in].twin; // name the first of two equal structures
            }
            if (one.twin) {
                const Layering::Structure& first = m_out.structures[*one.twin];
                one.layer = first.layer;
                one.depth = first.depth;
                one.in = first.in;
                one.unreliableParent.reset(); // already reported for the first
            }
        }
        return std::move(m_out);
    }

  private:
    double volume(std::size_t i) const { return m_surfaces[i].surface != nullptr ? enclosed_mm3(m_surfaces[i]) : 0.0; }

    /// Finds the enclosing structures and the equal structure of a single structure.
    void findHolders(std::size_t i)
    {
        if (m_surfaces[i].surface == nullptr) {
            return;
        }
        const geometry::RepairedMesh& inner = *m_surfaces[i].surface;
        Layering::Structure& out = m_out.structures[i];
        for (std::size_t a = 0; a < m_surfaces.size(); ++a) {
            const LayeredSurface& outer = m_surfaces[a];
            if (a == i || outer.surface == nullptr || !outer.surface->report.bounds.intersects(inner.report.bounds)) {
                continue;
            }
            if (isDuplicate(outer.surface->report, inner.report)) {
                if (a < i && !out.twin) {
                    out.twin = a;
                }
            } else if (const bool isSure = hasReliableInterior(outer.surface->report);
                       outer.index != nullptr && (!isSure || enclosed_mm3(outer) > enclosed_mm3(m_surfaces[i])) &&
                       (isSure || isLarger(*outer.surface, inner)) && isMostlyInside(inner, *outer.index)) {
                if (isSure) {
                    m_holders[i].push_back(a);
                } else if (!out.unreliableParent) {
                    out.unreliableParent = a;
                }
            }
        }
    }

    /// Compares surfaces without a reliable volume: the outer bounding box must contain the inner one.
    static bool isLarger(const geometry::RepairedMesh& outer, const geometry::RepairedMesh& inner)
    {
        return outer.report.bounds.contains(inner.report.bounds);
    }

    void place(std::size_t i)
    {
        Layering::Structure& one = m_out.structures[i];
        for (const std::size_t a : m_holders[i]) {
            one.depth = std::max(one.depth, m_out.structures[a].depth + 1);
            if (!one.in || volume(a) < volume(*one.in)) {
                one.in = a;
            }
        }
        one.layer = std::min<std::uint32_t>(one.depth, haptics::kMaxLayers - 1);
    }

    std::span<const LayeredSurface> m_surfaces;
    std::vector<std::vector<std::size_t>> m_holders; ///< of each structure, ascending
    Layering m_out;
};

} // namespace

bool hasReliableInterior(const geometry::MeshReport& report) noexcept
{
    return report.isClosed() && report.insideOutComponents == 0;
}

bool isWhollyInside(const geometry::RepairedMesh& inner, const geometry::SurfaceIndex& outer)
{
    const std::vector<core::Vec3>& vertices = inner.mesh.vertices;
    const std::size_t samples = std::min(kSamples, vertices.size());
    for (std::size_t i = 0; i < samples; ++i) {
        if (!geometry::isInside(outer, vertices[i * vertices.size() / samples])) {
            return false;
        }
    }
    return samples > 0;
}

bool Layering::isLayered() const
{
    return std::any_of(structures.begin(), structures.end(), [](const Structure& one) { return one.layer > 0; });
}

std::vector<std::size_t> Layering::order() const
{
    std::vector<std::size_t> out;
    // Appends the contents of `in`, each followed recursively by its own contents. The recursion depth is the nesting
    // depth, which is below the number of structures.
    const auto add = [this, &out](const auto& self, std::optional<std::size_t> in) -> void {
        for (std::size_t i = 0; i < structures.size(); ++i) {
            if (structures[i].in == in) {
                out.push_back(i);
                self(self, i);
            }
        }
    };
    add(add, std::nullopt);
    return out;
}

Layering Layering::inOrder(const std::vector<std::size_t>& order) const
{
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
    }
    Layering out;
    for (const std::size_t i : order) {
        Structure& one = out.structures.emplace_back(structures[i]);
        for (std::optional<std::size_t>* other : {&one.in, &one.twin, &one.unreliableParent}) {
            if (*other) {
                *other = place[**other];
            }
        }
    }
    return out;
}

std::optional<std::size_t> Layering::palpableParent(std::size_t structure, const std::vector<bool>& isFelt) const
{
    std::optional<std::size_t> in = structures[structure].in;
    while (in && !isFelt[*in]) {
        in = structures[*in].in;
    }
    return in;
}

std::vector<core::Message> Layering::sentences(const std::vector<std::string>& names,
                                               const std::vector<bool>& isFelt) const
{
    std::vector<core::Message> lines;
    for (std::size_t i = 0; i < structures.size(); ++i) {
        const Structure& one = structures[i];
        const std::optional<std::size_t> in = isFelt[i] ? palpableParent(i, isFelt) : std::nullopt;
        if (one.twin) {
            lines.push_back({PALPATE_TEXT("%1 and %2 are the same surface twice"), names[i], names[*one.twin]});
        } else if (in && one.depth > one.layer) {
            lines.push_back(
                {PALPATE_TEXT("%1 lies in %2, which is felt in the last of %3 layers: both are felt in that "
                              "one"),
                 names[i], names[*in], haptics::kMaxLayers});
        } else if (in) {
            lines.push_back({PALPATE_TEXT("%1 lies in %2 and is felt below it"), names[i], names[*in]});
        }
        if (isFelt[i] && one.unreliableParent && isFelt[*one.unreliableParent]) {
            lines.push_back(
                {PALPATE_TEXT("%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it"),
                 names[i], names[*one.unreliableParent]});
        }
    }
    return lines;
}

Layering layering(std::span<const LayeredSurface> surfaces)
{
    return Nesting(surfaces).find();
}

std::vector<core::Message> setLayers(meshio::LoadedScene& scene, std::shared_ptr<const haptics::HapticScene>& felt)
{
    std::vector<LayeredSurface> surfaces;
    std::vector<std::string> names;
    std::vector<bool> isFelt;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        surfaces.push_back({scene.structures[i].surface.get(), felt->structures()[i].surface.get()});
        names.push_back(scene.structures[i].description.name);
        isFelt.push_back(felt->structures()[i].surface != nullptr);
    }
    const Layering found = layering(surfaces);
    if (found.isLayered()) {
        std::vector<haptics::HapticStructure> structures = felt->structures();
        for (std::size_t i = 0; i < structures.size(); ++i) {
            structures[i].layer = scene.structures[i].description.layer = found.structures[i].layer;
            scene.scene.structures[i].layer = found.structures[i].layer;
        }
        felt = std::make_shared<const haptics::HapticScene>(std::move(structures), felt->fingertip_mm());
    }
    return found.sentences(names, isFelt);
}

} // namespace palpate::study
