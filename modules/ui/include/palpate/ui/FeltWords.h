// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/FeltSurface.h>
#include <palpate/study/BuriedLumps.h>

#include <QString>

namespace palpate::ui {

/// How much otherwise a place feels: "+8 %". @param ratio  k/k0
[[nodiscard]] QString feltChangeText(double ratio);
/// "not by hand", as `palpate felt` says it, in the window's language.
[[nodiscard]] QString verdictText(buried::Verdict verdict);
/// A sign that tells verdicts apart without colours: a full disc where a lump is plainly felt.
[[nodiscard]] QString verdictSign(buried::Verdict verdict);
/// "from the tissues' stiffness"
[[nodiscard]] QString ratioSourceText(study::RatioSource source);

/// What is felt at a place: "lump 12 mm: 6 mm below, +8 % (5 … 14 %): below what a trained hand tells; +17 % when
/// pressed 4 mm"; the last on a line of its own.
/// @param vertex  of `felt.surface`; @param press  number in `felt.press`
[[nodiscard]] QString feltPlaceText(const buried::FeltSurface& felt, std::size_t vertex, std::size_t press);

} // namespace palpate::ui
