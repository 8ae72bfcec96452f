// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/DeviceLimit.h"

#include <palpate/haptics/ForceTable.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace palpate::study {

namespace {

constexpr double kLeast_N_per_mm = 1e-6; // of a law for which nothing is left

bool isThere(const haptics::HapticStructure& structure)
{
    return structure.surface != nullptr && structure.surface->triangleCount() > 0;
}

} // namespace

double greatestStiffness(const haptics::HapticStructure& structure)
{
    return structure.law != nullptr ? structure.law->greatestSlope_N_per_mm()
                                    : haptics::greatestStiffness(structure.tissue);
}

double greatestDamping(const haptics::HapticStructure& structure) noexcept
{
    return structure.tissue.damping_Ns_per_mm;
}

void boundBy(const haptics::Tissue& greatest, std::span<haptics::HapticStructure> structures)
{
    std::map<std::uint32_t, std::vector<haptics::HapticStructure*>> layers; // outermost first
    for (haptics::HapticStructure& one : structures) {
        layers[one.layer].push_back(&one);
    }
    haptics::Tissue left = greatest;
    for (auto& [number, members] : layers) {
        double stiffness = 0.0, damping = 0.0;
        for (haptics::HapticStructure* one : members) {
            for (const core::TissueTerm& term : core::kTissueTerms) {
                one->tissue.*term.member = std::min(one->tissue.*term.member, left.*term.member);
            }
            if (one->law == nullptr) {
                one->law = haptics::ForceTable::build(one->tissue);
            }
            one->law = haptics::ForceTable::bounded(one->law, std::max(kLeast_N_per_mm, left.stiffness_N_per_mm));
            if (isThere(*one)) {
                stiffness = std::max(stiffness, greatestStiffness(*one));
                damping = std::max(damping, greatestDamping(*one));
            }
        }
        left.stiffness_N_per_mm = std::max(0.0, left.stiffness_N_per_mm - stiffness);
        left.damping_Ns_per_mm = std::max(0.0, left.damping_Ns_per_mm - damping);
    }
}

TakenElsewhere takenElsewhere(std::span<const haptics::HapticStructure> structures, std::size_t structure)
{
    struct Most
    {
        std::size_t by;
        double stiffness, damping;
    };
    std::map<std::uint32_t, Most> layers;
    for (std::size_t i = 0; i < structures.size(); ++i) {
        const haptics::HapticStructure& one = structures[i];
        if (!isThere(one) || one.layer == structures[structure].layer) {
            continue;
        }
        const double stiffness = greatestStiffness(one);
        const auto [at, isFirst] = layers.try_emplace(one.layer, Most{i, stiffness, greatestDamping(one)});
        if (!isFirst) {
            Most& most = at->second;
            most.damping = std::max(most.damping, greatestDamping(one));
            if (stiffness > most.stiffness) {
                most.by = i;
                most.stiffness = stiffness;
            }
        }
    }
    TakenElsewhere taken;
    for (const auto& [number, most] : layers) {
        taken.tissue.stiffness_N_per_mm += most.stiffness;
        taken.tissue.damping_Ns_per_mm += most.damping;
        taken.by.push_back(most.by);
    }
    return taken;
}

} // namespace palpate::study
