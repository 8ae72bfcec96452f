// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/FeltSurface.h>
#include <palpate/study/BuriedLumps.h>

#include <QString>

#include <optional>

namespace palpate::ui {

/// How much otherwise a place feels: "+8 %". @param ratio  k/k0
[[nodiscard]] QString feltChangeText(double ratio);
/// "not by hand", as `palpate felt` says it, in the window's language.
[[nodiscard]] QString verdictText(buried::Verdict verdict);
/// A verdict with what it rests on, as buried::verdictText says it, in the window's language.
[[nodiscard]] QString verdictRangeText(const buried::FeltSurface::LumpPress& press,
                                       const std::optional<buried::RatioRange>& ratio);
/// What a hand that presses there is told: "plainly felt", "a trained hand tells it".
[[nodiscard]] QString saysOf(buried::Verdict verdict);
/// A ratio and its range: "4.4 (1 … 5.2)", "not known"
[[nodiscard]] QString ratioRangeText(const std::optional<study::StiffnessRatio>& ratio);
/// "malignant tumour of the liver", in the window's language.
[[nodiscard]] QString publishedName(const study::PublishedRatio& published);
/// A sign that tells verdicts apart without colours: a full disc where a lump is plainly felt.
[[nodiscard]] QString verdictSign(buried::Verdict verdict);
/// "from the tissues' stiffness"
[[nodiscard]] QString ratioSourceText(study::RatioSource source);

/// What is felt at a place: "lump 12 mm: 6 mm below, +8 % (5 … 14 %): below what a trained hand tells; +17 % when
/// pressed 4 mm"; the last on a line of its own.
/// @param vertex  of `felt.surface`; @param press  number in `felt.press`
[[nodiscard]] QString feltPlaceText(const buried::FeltSurface& felt, std::size_t vertex, std::size_t press);

} // namespace palpate::ui
