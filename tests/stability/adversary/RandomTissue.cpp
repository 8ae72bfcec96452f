// SPDX-License-Identifier: BSD-3-Clause
#include "RandomTissue.h"

#include <vector>

namespace palpate::adversary {

namespace {

/// Returns a map with log-uniform values at the vertices.
haptics::TissueMap randomMap(const geometry::SurfaceIndex& surface, double low, double high, Chance& chance)
{
    std::vector<float> values(surface.vertexCount());
    for (float& value : values) {
        value = static_cast<float>(chance.magnitude(low, high));
    }
    auto corners = std::make_shared<std::vector<std::array<float, 3>>>(surface.triangleCount());
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const Triangle t = surface.triangle(i);
        (*corners)[i] = {values[t[0]], values[t[1]], values[t[2]]};
    }
    haptics::TissueMap map{std::move(corners), chance.is(0.5) ? 1.0 : 0.5};
    if (surface.triangleCount() % 2 == 0) { // linear on each triangle: the stored energy has a closed form
        map.bends = std::make_shared<const std::vector<std::array<float, 6>>>();
    }
    return map;
}

core::ForceLaw randomLaw(double scale, Chance& chance)
{
    core::ForceLaw law = core::usualLaw(core::kLawKinds[chance.below(core::kLawKinds.size() - 1)]);
    if (chance.is(0.3)) {
        law.kind = core::LawKind::Points;
        law.numbers = {};
        law.points = {{0.0, 0.0}, {scale, 0.2}, {2.0 * scale, 1.0}, {3.0 * scale, 0.8}, {6.0 * scale, 4.0}};
    }
    return core::check(law).isOk() ? law : core::ForceLaw{};
}

} // namespace

void makeRough(RandomScene& scene, Chance& chance)
{
    constexpr std::array kMu{0.02, 0.3, 1.0, 3.0};
    for (RandomStructure& one : scene.structures) {
        haptics::Tissue& tissue = one.tissue;
        if (chance.is(0.85)) {
            tissue.friction_dynamic = kMu[chance.below(kMu.size())];
            tissue.friction_static = tissue.friction_dynamic * (chance.is(0.5) ? 1.0 : chance.between(1.0, 1.6));
            tissue.friction_drag_Ns_per_mm = chance.is(0.3) ? chance.magnitude(1e-5, 1e-1) : 0.0;
        }
        if (chance.is(0.4)) {
            tissue.law = randomLaw(scene.scale, chance);
        }
        one.law = haptics::ForceTable::build(tissue);
        if (chance.is(0.4)) {
            one.maps.stiffness = randomMap(*one.surface, 0.2, 5.0, chance);
        }
        if (chance.is(0.2)) {
            one.maps.damping = randomMap(*one.surface, 1e-4, 1e-2, chance);
        }
        if (chance.is(0.3)) {
            one.maps.friction = randomMap(*one.surface, 0.1, 2.0, chance);
        }
    }
}

} // namespace palpate::adversary
