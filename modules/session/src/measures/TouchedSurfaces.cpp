// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TouchedSurfaces.h"

#include "palpate/session/TouchPlace.h"

#include <cstddef>
#include <utility>

namespace palpate::session {

TouchedSurfaces::TouchedSurfaces(MeshesByHash meshes, KeyOf keyOf, double distance_mm)
    : m_meshes(std::move(meshes))
    , m_keyOf(std::move(keyOf))
    , m_distance_mm(distance_mm)
{
}

void TouchedSurfaces::add(const servo::TickRecord& tick, double time_s, double dt_s)
{
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        const haptics::Contact& contact = tick.felt.contacts[i];
        Last& last = m_last[i];
        if (last.scene != tick.scene || last.structure != contact.structure) {
            last = {tick.scene, contact.structure, surfaceOf(tick.scene, contact.structure)};
        }
        if (last.surface != nullptr) {
            last.surface->add({TouchPlace(tick.felt, contact), contact.f_W.norm(), contact.depth_mm, time_s, dt_s});
        }
    }
}

std::unique_ptr<TouchedSurface> TouchedSurfaces::take(const StructureKey& key)
{
    m_last.fill({});
    const auto node = m_touched.extract(key);
    return node.empty() ? nullptr : std::move(node.mapped());
}

TouchedSurface* TouchedSurfaces::surfaceOf(std::uint32_t scene, std::uint32_t structure)
{
    StructureKey key = m_keyOf(scene, structure);
    const auto mesh = m_meshes.find(key.second);
    if (mesh == m_meshes.end() || mesh->second->mesh.vertices.empty()) {
        return nullptr;
    }
    auto& surface = m_touched[std::move(key)];
    if (surface == nullptr) {
        surface = std::make_unique<TouchedSurface>(mesh->second->mesh, m_distance_mm);
    }
    return surface.get();
}

} // namespace palpate::session
