// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/DeviceLimit.h"

#include <palpate/core/Numbers.h>
#include <palpate/haptics/ForceTable.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace palpate::study {

namespace {

constexpr double kLeast_N_per_mm = 1e-6; // slope of a law when the limit is used up

bool isThere(const haptics::HapticStructure& structure)
{
    return structure.surface != nullptr && structure.surface->triangleCount() > 0;
}

/// Returns the largest slope of the force law without the map [N/mm].
double slopeOf(const haptics::HapticStructure& structure)
{
    return structure.law != nullptr ? structure.law->greatestSlope_N_per_mm() : haptics::maxStiffness(structure.tissue);
}

/// Returns the largest slope of a force law with buried lumps [N/mm]: `s(d) F(d)`, where s may rise between two press
/// depths.
/// @param share  scale for the effect of the lumps, 0 … 1
double transmittedSlope(const haptics::HapticStructure& one, double share)
{
    const double slope = slopeOf(one);
    const auto nearer = [share](double s) { return s > 1.0 ? 1.0 + share * (s - 1.0) : s; };
    double most = slope * nearer(one.maps.felt.back().greatest());
    for (std::size_t j = 0; j + 1 < haptics::kFeltPress_mm.size(); ++j) {
        const auto &from = *one.maps.felt[j].corners, &to = *one.maps.felt[j + 1].corners;
        double rise = 0.0, greatest = 0.0;
        for (std::size_t i = 0; i < from.size(); ++i) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const double a = nearer(from[i][corner]), b = nearer(to[i][corner]);
                rise = std::max(rise, b - a);
                greatest = std::max({greatest, a, b});
            }
        }
        const double width = haptics::kFeltPress_mm[j + 1] - haptics::kFeltPress_mm[j];
        most = std::max(most, greatest * slope + rise / width * one.lawAt(haptics::kFeltPress_mm[j + 1]).force_N);
    }
    return most * (one.maps.stiffness.isEmpty() ? 1.0 : one.maps.stiffness.greatest());
}

/// Reduces the effect of buried lumps to the limit of the device.
void limitTransmitted(double most_N_per_mm, haptics::HapticStructure& one)
{
    if (!one.maps.hasFelt() || transmittedSlope(one, 1.0) <= most_N_per_mm) {
        return;
    }
    double holds = 0.0, fails = 1.0;
    for (int halving = 0; halving < 12; ++halving) { // to 1/4096 of the effect
        const double middle = 0.5 * (holds + fails);
        (transmittedSlope(one, middle) <= most_N_per_mm ? holds : fails) = middle;
    }
    for (haptics::TissueMap& felt : one.maps.felt) {
        felt = felt.towardsOne(holds);
    }
}

/// Applies the limit to one structure: to the map if there is one, because its values may all be below the tissue's
/// own; else to the tissue and its law.
void limitStructure(const haptics::Tissue& left, haptics::HapticStructure& one)
{
    const bool isMapped = !one.maps.stiffness.isEmpty();
    for (const core::TissueTerm& term : core::kTissueTerms) {
        if (!isMapped || term.member != &core::Tissue::stiffness_N_per_mm) {
            one.tissue.*term.member = std::min(one.tissue.*term.member, left.*term.member);
        }
    }
    if (one.law == nullptr) {
        one.law = haptics::ForceTable::build(one.tissue);
    }
    const double most = std::max(kLeast_N_per_mm, left.stiffness_N_per_mm);
    if (isMapped) {
        one.maps.stiffness = one.maps.stiffness.atMost(most / slopeOf(one));
    } else {
        one.law = haptics::ForceTable::bounded(one.law, most);
    }
    limitTransmitted(most, one);
    if (!one.maps.damping.isEmpty()) {
        one.maps.damping = one.maps.damping.atMost(left.damping_Ns_per_mm);
    }
}

} // namespace

double maxStiffness(const haptics::HapticStructure& structure)
{
    if (structure.maps.hasFelt()) {
        return transmittedSlope(structure, 1.0);
    }
    const double slope = slopeOf(structure);
    return structure.maps.stiffness.isEmpty() ? slope : slope * structure.maps.stiffness.greatest();
}

double maxDamping(const haptics::HapticStructure& structure) noexcept
{
    return structure.maps.damping.isEmpty() ? structure.tissue.damping_Ns_per_mm : structure.maps.damping.greatest();
}

void limitTissues(const haptics::Tissue& greatest, std::span<haptics::HapticStructure> structures)
{
    std::map<std::uint32_t, std::vector<haptics::HapticStructure*>> layers; // outermost layer first
    for (haptics::HapticStructure& one : structures) {
        layers[one.layer].push_back(&one);
    }
    haptics::Tissue left = greatest;
    for (auto& [number, members] : layers) {
        double stiffness = 0.0, damping = 0.0;
        for (haptics::HapticStructure* one : members) {
            limitStructure(left, *one);
            if (isThere(*one)) {
                stiffness = std::max(stiffness, maxStiffness(*one));
                damping = std::max(damping, maxDamping(*one));
            }
        }
        left.stiffness_N_per_mm = std::max(0.0, left.stiffness_N_per_mm - stiffness);
        left.damping_Ns_per_mm = std::max(0.0, left.damping_Ns_per_mm - damping);
    }
}

haptics::Tissue maxTissue(const device::DeviceInfo& info, double held_N_per_mm) noexcept
{
    haptics::Tissue greatest = core::unbounded();
    greatest.stiffness_N_per_mm = std::isfinite(held_N_per_mm) ? held_N_per_mm : 5.0;
    greatest.damping_Ns_per_mm = info.maxDamping_Ns_per_mm > 0.0 ? info.maxDamping_Ns_per_mm : 0.02;
    return greatest;
}

std::string limitedText(std::span<const haptics::HapticStructure> asked, std::span<const haptics::HapticStructure> held)
{
    constexpr double kRounding = 1.0 + 1e-5; // rounding of the slope of a bounded law
    constexpr int kDigits = 3;
    std::string text;
    const auto add = [&](const std::string& name, double was, double is, const char* unit) {
        if (was > kRounding * is) {
            text += (text.empty() ? "at most " : ", at most ") + core::shortNumber(is, kDigits) + unit + " of " + name +
                    " (asked for " + core::shortNumber(was, kDigits) + unit + ')';
        }
    };
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (isThere(asked[i])) {
            add(asked[i].name, maxStiffness(asked[i]), maxStiffness(held[i]), " N/mm");
            add(asked[i].name, maxDamping(asked[i]), maxDamping(held[i]), " N·s/mm");
        }
    }
    return text;
}

UsedByOtherLayers usedByOtherLayers(std::span<const haptics::HapticStructure> structures, std::size_t structure)
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
        const double stiffness = maxStiffness(one);
        const auto [at, isFirst] = layers.try_emplace(one.layer, Most{i, stiffness, maxDamping(one)});
        if (!isFirst) {
            Most& most = at->second;
            most.damping = std::max(most.damping, maxDamping(one));
            if (stiffness > most.stiffness) {
                most.by = i;
                most.stiffness = stiffness;
            }
        }
    }
    UsedByOtherLayers taken;
    for (const auto& [number, most] : layers) {
        taken.tissue.stiffness_N_per_mm += most.stiffness;
        taken.tissue.damping_Ns_per_mm += most.damping;
        taken.by.push_back(most.by);
    }
    return taken;
}

} // namespace palpate::study
