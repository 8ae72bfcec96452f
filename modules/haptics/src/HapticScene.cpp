// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/HapticScene.h"

#include "palpate/haptics/ForceTable.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace palpate::haptics {

namespace {

constexpr std::size_t kCached = std::size_t{1} << 20; // bytes of nodes that fit into the private caches of a core

/// Computes the bends of the maps whose gradients contribute to the force.
void bendMaps(HapticStructure& structure)
{
    const auto bend = [&](TissueMap& map) {
        if (!map.isEmpty() && map.bends == nullptr && map.corners->size() == structure.surface->triangleCount()) {
            map = map.withBends(*structure.surface);
        }
    };
    bend(structure.maps.stiffness);
    std::for_each(structure.maps.felt.begin(), structure.maps.felt.end(), bend);
}

bool canTouch(const HapticStructure& structure)
{
    return structure.surface != nullptr && structure.surface->triangleCount() > 0;
}

/// Structures by layer number and motion; motions in the order of the structures, rest first.
std::map<std::pair<std::uint32_t, std::size_t>, std::vector<std::uint32_t>>
layersOf(const std::vector<HapticStructure>& structures)
{
    std::map<std::pair<std::uint32_t, std::size_t>, std::vector<std::uint32_t>> layers;
    std::vector<const geometry::SurfaceMotion*> motions{nullptr};
    for (std::uint32_t i = 0; i < structures.size(); ++i) {
        if (!canTouch(structures[i])) {
            continue;
        }
        const geometry::SurfaceMotion* const motion = structures[i].motion.get();
        const auto isSame = [motion](const geometry::SurfaceMotion* other) {
            return motion == other || (motion != nullptr && other != nullptr && *motion == *other);
        };
        const auto found = std::find_if(motions.begin(), motions.end(), isSame);
        const auto number = static_cast<std::size_t>(found - motions.begin());
        if (found == motions.end()) {
            motions.push_back(motion);
        }
        layers[{structures[i].layer, number}].push_back(i);
    }
    return layers;
}

core::Status noStructure(std::size_t number, std::size_t count)
{
    return {core::StatusCode::OutOfRange, PALPATE_TEXT("found structure %1, expected a number below %2"), number,
            count};
}

core::Status checked(const HapticStructure& structure, std::size_t number)
{
    return check(structure.tissue).at(core::Message(PALPATE_TEXT("structure %1 (%2)"), number, structure.name));
}

} // namespace

HapticScene::HapticScene(std::vector<HapticStructure> structures, double fingertip_mm)
    : m_structures(std::move(structures))
    , m_fingertip_mm(fingertip_mm)
{
    for (HapticStructure& structure : m_structures) {
        if (structure.law == nullptr) {
            structure.law = ForceTable::build(structure.tissue);
        }
        if (structure.surface != nullptr) {
            bendMaps(structure);
        }
    }
    for (std::uint32_t i = 0; i < m_structures.size(); ++i) {
        m_isDamped = m_isDamped || (canTouch(m_structures[i]) && m_structures[i].isDamped());
    }
    for (const auto& [key, members] : layersOf(m_structures)) {
        const geometry::SurfaceMotion* const motion = m_structures[members.front()].motion.get();
        if (m_layers.size() < kMaxLayers) {
            m_layers.emplace_back().number = key.first;
            m_layers.back().motion = motion;
        }
        m_isMoving = m_isMoving || motion != nullptr;
        HapticLayer& layer = m_layers.back();
        layer.lastNumber = key.first;
        layer.structures.insert(layer.structures.end(), members.begin(), members.end());
    }
    core::Box all;
    for (HapticLayer& layer : m_layers) {
        layer.fingertip_mm = m_fingertip_mm;
        for (const HapticStructure& structure : m_structures) {
            layer.surfaces.push_back(structure.surface.get());
        }
        const std::vector<std::uint32_t> members = std::move(layer.structures);
        layer.structures.clear();
        core::Box bounds;
        for (const std::uint32_t i : members) {
            bounds.extend(m_structures[i].surface->bounds());
        }
        all.extend(bounds);
        std::vector<geometry::BoxedItem> items;
        std::size_t bytes = 0;
        for (const std::uint32_t i : members) {
            const geometry::SurfaceIndex& surface = *m_structures[i].surface;
            bytes += surface.hierarchy().nodeCount() * sizeof(geometry::BoxHierarchy::Node);
            // A god-object within a few skins of a surface must find that surface.
            const double reach = 8.0 * surface.skin_mm();
            layer.skin_mm = std::max(layer.skin_mm, surface.skin_mm());
            layer.isPlain = layer.isPlain && m_structures[i].isPlain();
            const core::Box box(surface.bounds().min().array() - reach, surface.bounds().max().array() + reach);
            items.emplace_back(geometry::FloatBox::around(box, bounds.center()), i);
            layer.facetSize_mm = layer.facetSize_mm == 0.0 ? surface.facetSize_mm()
                                                           : std::min(layer.facetSize_mm, surface.facetSize_mm());
        }
        if (std::any_of(members.begin(), members.end(),
                        [this](std::uint32_t i) { return m_structures[i].tissue.hasFriction(); })) {
            layer.frictional = m_structures.data();
        }
        layer.drags = std::any_of(members.begin(), members.end(), [this](std::uint32_t i) {
            return m_structures[i].tissue.friction_drag_Ns_per_mm > 0.0;
        });
        layer.isLarge = bytes > kCached;
        layer.hierarchy = geometry::BoxHierarchy::build(items, bounds.center(), 1);
        for (const geometry::BoxedItem& item : items) {
            layer.structures.push_back(item.number);
        }
    }
    if (!m_layers.empty()) {
        m_middle = all.center();
        m_farthest_mm = kFarthest * all.diagonal().norm();
    }
}

core::Result<std::shared_ptr<const HapticScene>> HapticScene::make(std::vector<HapticStructure> structures,
                                                                   double fingertip_mm)
{
    if (!(fingertip_mm >= 0.0 && fingertip_mm <= kMostFingertip_mm)) {
        return core::Status(core::StatusCode::OutOfRange,
                            PALPATE_TEXT("fingertip: found a radius of %1, expected 0 to %2 mm"), fingertip_mm,
                            kMostFingertip_mm);
    }
    for (std::size_t i = 0; i < structures.size(); ++i) {
        const HapticStructure& one = structures[i];
        if (one.surface == nullptr || one.surface->triangleCount() == 0) {
            return core::Status(core::StatusCode::Empty,
                                PALPATE_TEXT("structure %1 (%2): found no surface, expected at least one triangle"), i,
                                one.name);
        }
        if (core::Status status = checked(one, i); !status.isOk()) {
            return status;
        }
    }
    const bool isMoving = std::any_of(structures.begin(), structures.end(),
                                      [](const HapticStructure& one) { return one.motion != nullptr; });
    if (const std::size_t layers = layersOf(structures).size(); isMoving && layers > kMaxLayers) {
        return core::Status(
            core::StatusCode::Unsupported,
            PALPATE_TEXT("found %1 layers with different motions, expected at most %2: let structures of "
                         "a layer move alike"),
            layers, kMaxLayers);
    }
    return std::make_shared<const HapticScene>(std::move(structures), fingertip_mm);
}

core::Result<std::shared_ptr<const HapticScene>> HapticScene::with(std::size_t number, const Tissue& tissue) const
{
    if (number >= m_structures.size()) {
        return noStructure(number, m_structures.size());
    }
    std::vector<HapticStructure> structures = m_structures;
    structures[number].tissue = tissue;
    structures[number].law = nullptr; // computed from the tissue again
    if (core::Status status = checked(structures[number], number); !status.isOk()) {
        return status;
    }
    return std::make_shared<const HapticScene>(std::move(structures), m_fingertip_mm);
}

core::Result<std::shared_ptr<const HapticScene>> HapticScene::without(std::size_t number) const
{
    if (number >= m_structures.size()) {
        return noStructure(number, m_structures.size());
    }
    std::vector<HapticStructure> structures = m_structures;
    structures[number].surface = nullptr;
    return std::make_shared<const HapticScene>(std::move(structures), m_fingertip_mm);
}

std::size_t HapticScene::byteSize() const
{
    std::set<const geometry::SurfaceIndex*> counted;
    std::size_t bytes = 0;
    for (const HapticStructure& structure : m_structures) {
        if (structure.surface != nullptr && counted.insert(structure.surface.get()).second) {
            bytes += structure.surface->byteSize();
        }
    }
    return bytes;
}

} // namespace palpate::haptics
