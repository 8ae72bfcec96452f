// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/RecordedScale.h"

#include <palpate/haptics/ForceTable.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace palpate::study {

double lawForce_N(const session::StructureRecord& on, double depth_mm)
{
    const auto bytes = std::as_bytes(std::span(on.lawTable.data(), on.lawTable.size()));
    const auto table = haptics::ForceTable::fromBytes(bytes);
    return !on.lawTable.empty() && table.isOk() ? table.value()->force(depth_mm)
                                                : on.tissue.stiffness_N_per_mm * depth_mm;
}

void reconstructScales(servo::TickRecord& tick, const session::SceneRecord& scene, const core::Vec3& v_WH)
{
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        haptics::Contact& contact = tick.felt.contacts[i];
        contact.stiffnessScale = 1.0;
        if (contact.structure >= scene.structures.size() || scene.structures[contact.structure].maps.empty()) {
            continue;
        }
        const session::StructureRecord& on = scene.structures[contact.structure];
        // For structures that share a layer, use the structure's own component of the spring.
        const bool isShared = contact.depth_mm != (contact.p_WG - tick.p_WH).norm();
        const core::Vec3 push_W =
            isShared ? core::Vec3(contact.depth_mm * contact.n_W) : core::Vec3(contact.p_WG - tick.p_WH);
        const double depth = push_W.norm(), force = lawForce_N(on, depth);
        if (depth > 0.0 && force > 0.0) {
            const core::Vec3 spring_W = contact.f_W + on.tissue.damping_Ns_per_mm * v_WH;
            contact.stiffnessScale = std::max(0.0, spring_W.dot(push_W) / (depth * force));
        }
    }
}

} // namespace palpate::study
