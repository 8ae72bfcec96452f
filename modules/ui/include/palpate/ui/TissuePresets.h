// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Tissue.h>

#include <vector>

namespace palpate::ui {

/// A tissue by name, "as felt" by a fingertip: stiffness, damping and law. Friction is chosen apart from it.
struct TissuePreset
{
    const char* name;
    const char* source; ///< where its numbers are from, for a person
    core::Tissue tissue;
};
[[nodiscard]] const std::vector<TissuePreset>& tissuePresets();
/// @return the position of the preset that a tissue is, but for its friction; -1: it is its own.
[[nodiscard]] int presetOf(const core::Tissue& tissue);
/// @return `tissue` as the preset has it, its friction kept.
[[nodiscard]] core::Tissue withPreset(core::Tissue tissue, const TissuePreset& preset);

/// How much a surface holds a fingertip, by name.
struct FrictionPreset
{
    const char* name;
    double coefficient; ///< at rest and sliding
};
[[nodiscard]] const std::vector<FrictionPreset>& frictionPresets();
/// @return the position of the preset that a tissue's friction is; -1: it is its own.
[[nodiscard]] int frictionPresetOf(const core::Tissue& tissue);

} // namespace palpate::ui
