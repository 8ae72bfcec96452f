// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/LumpRule.h"

#include "palpate/study/BuriedLumps.h"
#include "palpate/study/HapticCopy.h"
#include "palpate/study/Layers.h"

#include <palpate/haptics/HapticScene.h>

#include <algorithm>
#include <utility>

namespace palpate::study {

namespace {

core::Message notFelt(const meshio::SceneStructure& one)
{
    return {PALPATE_TEXT("%1 is hidden or not palpable"), one.name};
}

} // namespace

LumpRule::LumpRule(std::vector<PlacedStructure> structures, std::set<std::string> lumps)
    : m_structures(std::move(structures))
    , m_lumps(std::move(lumps))
    , m_areNamed(std::any_of(m_structures.begin(), m_structures.end(), [](const PlacedStructure& one) {
        return one.surface != nullptr && !one.description->inside.empty();
    }))
{
}

bool LumpRule::isThere(std::size_t structure) const
{
    return m_structures[structure].surface != nullptr && canBeFelt(*m_structures[structure].description);
}

bool LumpRule::isCandidate(std::size_t structure) const
{
    const meshio::SceneStructure& one = *m_structures[structure].description;
    return m_lumps.count(one.name) > 0 || isLumpCandidate(one);
}

LumpRule::Organ LumpRule::organAround(std::size_t structure) const
{
    const meshio::SceneStructure& one = *m_structures[structure].description;
    if (!one.inside.empty() && m_structures[structure].surface != nullptr) {
        for (std::size_t i = 0; i < m_structures.size(); ++i) {
            const meshio::SceneStructure& other = *m_structures[i].description;
            if (i != structure && m_structures[i].surface != nullptr && other.name == one.inside) {
                return isThere(i) ? Organ{i, {}} : Organ{{}, notFelt(other)};
            }
        }
        return {{}, {PALPATE_TEXT("the scene has no structure \"%1\", which it names as the organ"), one.inside}};
    }
    if (!isThere(structure)) {
        return {{}, notFelt(one)};
    }
    std::optional<std::size_t> organ;
    for (std::optional<std::size_t> in = m_structures[structure].in; in; in = m_structures[*in].in) {
        if (isThere(*in) && hasReliableInterior(m_structures[*in].surface->report)) {
            organ = in;
            if (!isCandidate(*in)) {
                break; // an organ, whatever is around it
            }
        }
    }
    return organ ? Organ{organ, {}} : Organ{{}, {PALPATE_TEXT("it lies in no closed surface that can be felt")}};
}

LumpRule::Organ LumpRule::organOf(std::size_t structure) const
{
    if (m_structures[structure].description->inside.empty() && !isCandidate(structure)) {
        return {{}, {PALPATE_TEXT("its name is not that of a lump, and the scene gives no stiffness ratio")}};
    }
    return organAround(structure);
}

LumpRule::Organ LumpRule::feltThrough(std::size_t structure) const
{
    if (!isThere(structure)) {
        return {{}, notFelt(*m_structures[structure].description)};
    }
    if (m_areNamed && m_structures[structure].description->inside.empty()) {
        return {{}, {PALPATE_TEXT("the scene names the organs of other lumps, but not of this one")}};
    }
    return organOf(structure);
}

std::uint32_t LumpRule::layerWithin(std::size_t structure) const
{
    std::uint32_t around = 0;
    for (std::optional<std::size_t> in = m_structures[structure].in; in; in = m_structures[*in].in) {
        around += isThere(*in) ? 1 : 0;
    }
    return std::min<std::uint32_t>(around, haptics::kMaxLayers - 1);
}

} // namespace palpate::study
