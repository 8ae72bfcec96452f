// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/ForceLaw.h"

namespace palpate::core {

namespace {

constexpr LawTerm kExponential[] = {
    {"k0_N_per_mm", "Stiffness at first touch", "N/mm", 1e-6, 1000.0, 0.1},
    {"beta_per_mm", "Growth with depth", "1/mm", 1e-6, 10.0, 0.35},
    {"k_max_N_per_mm", "Greatest stiffness", "N/mm", 1e-6, 1000.0, 2.0},
};
constexpr LawTerm kHertz[] = {
    {"young_kPa", "Young's modulus", "kPa", 1e-3, 1e7, 10.0},
    {"radius_mm", "Radius of the ball", "mm", 1e-3, 1000.0, 8.0},
};
constexpr LawTerm kLayer[] = {
    {"young_kPa", "Young's modulus", "kPa", 1e-3, 1e7, 10.0},
    {"radius_mm", "Radius of the ball", "mm", 1e-3, 1000.0, 8.0},
    {"thickness_mm", "Thickness of the layer", "mm", 1e-2, 1000.0, 20.0},
    {"bonded", "Bonded to what is below", "", 0.0, 1.0, 1.0},
};
constexpr LawTerm kClick[] = {
    {"k1_N_per_mm", "Stiffness before the click", "N/mm", 1e-6, 1000.0, 0.5},
    {"F1_N", "Force at which it gives way", "N", 1e-6, 1000.0, 1.0},
    {"F2_N", "Force that it falls to", "N", 0.0, 1000.0, 0.6},
    {"fall_mm", "Depth over which it falls", "mm", 1e-3, 25.0, 1.0},
    {"k3_N_per_mm", "Stiffness after the click", "N/mm", 1e-6, 1000.0, 0.5},
};

} // namespace

std::string_view lawName(LawKind kind) noexcept
{
    constexpr std::array<std::string_view, kLawKinds.size()> names{"linear", "exponential", "hertz",
                                                                   "layer",  "click",       "points"};
    return names[static_cast<std::size_t>(kind)];
}

std::span<const LawTerm> lawTerms(LawKind kind) noexcept
{
    switch (kind) {
    case LawKind::Exponential:
        return kExponential;
    case LawKind::Hertz:
        return kHertz;
    case LawKind::Layer:
        return kLayer;
    case LawKind::Click:
        return kClick;
    case LawKind::Linear:
    case LawKind::Points:
        break;
    }
    return {};
}

} // namespace palpate::core
