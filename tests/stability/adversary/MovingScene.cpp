// SPDX-License-Identifier: BSD-3-Clause
#include "MovingScene.h"

#include <algorithm>

namespace palpate::adversary {

MovingScene::MovingScene(Chance& chance)
    : rest(randomScene(chance.is(0.5) ? Family::Layers : static_cast<Family>(chance.below(6)), chance))
{
    if (rest.layers == 1 && rest.structures.size() > 1) { // structures of one layer that move differently
        rest.layers = static_cast<std::uint32_t>(
            chance.whole(1, static_cast<int>(std::min<std::size_t>(4, rest.structures.size()))));
        for (std::size_t i = 0; i < rest.structures.size(); ++i) {
            rest.structures[i].layer = static_cast<std::uint32_t>(i) % rest.layers;
        }
    }
    // The engine sorts layers by motion in the order of the structures.
    std::stable_sort(rest.structures.begin(), rest.structures.end(),
                     [](const RandomStructure& a, const RandomStructure& b) { return a.layer < b.layer; });
    const bool isOneNumber = chance.is(0.5);
    groups.resize(rest.layers);
    for (std::uint32_t g = 0; g < rest.layers; ++g) {
        MovingGroup& group = groups[g];
        group.number = isOneNumber ? 0 : 3 * g;
        const bool mayRest = !isOneNumber || g == 0; // two groups at rest would be one layer
        if (mayRest && chance.is(0.25)) {
            if (chance.is(0.3)) {
                group.motion.emplace().addPulse(chance);
            }
            continue;
        }
        if (g > 0 && groups[0].motion && chance.is(0.25)) { // the same shape at another time
            group.motion = groups[0].motion;
            group.motion->setClock(0.0, chance.between(0.01, 0.5), 1.0, chance.between(0.3, 1.0));
        } else {
            group.motion.emplace(rest.bounds, chance);
            if (chance.is(0.25)) {
                group.motion->addPulse(chance);
            }
        }
    }
    if (std::none_of(groups.begin(), groups.end(), [](const MovingGroup& group) { return group.motion.has_value(); })) {
        groups.back().motion.emplace(rest.bounds, chance);
    }
}

std::unique_ptr<haptics::HapticScene> MovingScene::build(std::uint32_t shown) const
{
    std::vector<std::shared_ptr<const geometry::SurfaceMotion>> motions;
    for (const MovingGroup& group : groups) {
        motions.push_back(group.motion ? group.motion->engine() : nullptr);
    }
    std::vector<haptics::HapticStructure> all;
    for (const RandomStructure& one : rest.structures) {
        haptics::HapticStructure structure = one.structure();
        if ((shown >> one.layer & 1u) == 0) {
            structure.surface = nullptr;
        }
        structure.motion = motions[one.layer];
        structure.layer = groups[one.layer].number;
        all.push_back(std::move(structure));
    }
    return std::make_unique<haptics::HapticScene>(std::move(all), rest.fingertip_mm);
}

std::string MovingScene::name() const
{
    std::string text = rest.name + " that move by";
    for (const MovingGroup& group : groups) {
        text += " (" + (group.motion ? group.motion->name() : std::string("none")) + ")";
    }
    return text + (groups.size() > 1 && groups[1].number == 0 ? " in one layer" : "");
}

} // namespace palpate::adversary
