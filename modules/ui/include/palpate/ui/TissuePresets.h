// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Tissue.h>

#include <vector>

namespace palpate::ui {

/// Named tissue as perceived by a fingertip: stiffness, damping and force law. Friction is a separate choice.
struct TissuePreset
{
    const char* name;
    const char* source; ///< source of the numbers, for the user
    core::Tissue tissue;
};
[[nodiscard]] PALPATE_EXPORT const std::vector<TissuePreset>& tissuePresets();
/// Index of the preset that matches a tissue apart from friction; -1: no match.
[[nodiscard]] PALPATE_EXPORT int presetOf(const core::Tissue& tissue);
/// Applies a preset and keeps the friction of `tissue`.
[[nodiscard]] PALPATE_EXPORT core::Tissue withPreset(core::Tissue tissue, const TissuePreset& preset);

/// Named friction coefficient between surface and fingertip.
struct FrictionPreset
{
    const char* name;
    double coefficient; ///< static and dynamic
};
[[nodiscard]] PALPATE_EXPORT const std::vector<FrictionPreset>& frictionPresets();
/// Index of the preset that matches a tissue's friction; -1: no match.
[[nodiscard]] PALPATE_EXPORT int frictionPresetOf(const core::Tissue& tissue);

} // namespace palpate::ui
