// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/FeltSurface.h>
#include <palpate/core/Export.h>
#include <palpate/study/BuriedLumps.h>

#include <QString>

#include <optional>

namespace palpate::ui {

/// Change of response as text: "+8 %". @param ratio  k/k0 [1]
[[nodiscard]] PALPATE_EXPORT QString responseChangeText(double ratio);
/// Translated verdict as printed by `palpate felt`: "not by hand".
[[nodiscard]] PALPATE_EXPORT QString verdictText(buried::Verdict verdict);
/// Translated verdict with the underlying ratios, as in buried::verdictText.
[[nodiscard]] PALPATE_EXPORT QString verdictRangeText(const buried::FeltSurface::LumpPress& press,
                                                      const std::optional<buried::RatioRange>& ratio);
/// Translated verdict for the user's hand: "plainly felt", "felt by a trained hand".
[[nodiscard]] PALPATE_EXPORT QString verdictPhrase(buried::Verdict verdict);
/// Verdict on a change of response, followed by that for the user's own hand if its threshold is used (OwnThreshold).
/// @param ratio  k/k0 [1]
[[nodiscard]] PALPATE_EXPORT QString verdictPhrase(double ratio);
/// Stiffness ratio with range: "4.4 (1 … 5.2)", or "unknown".
[[nodiscard]] PALPATE_EXPORT QString ratioRangeText(const std::optional<study::StiffnessRatio>& ratio);
/// Translated name of a published ratio: "malignant tumour of the liver".
[[nodiscard]] PALPATE_EXPORT QString publishedName(const study::PublishedRatio& published);
/// Colour-independent symbol of a verdict; a full disc stands for "plainly felt".
[[nodiscard]] PALPATE_EXPORT QString verdictSign(buried::Verdict verdict);
/// Source of a ratio: "from the tissues' stiffness".
[[nodiscard]] PALPATE_EXPORT QString ratioSourceText(study::RatioSource source);

/// Palpability at a place: "lump 12 mm: 6 mm below, +8 % (5 … 14 %): below what a trained hand tells; +17 % when
/// pressed 4 mm". The part after the last semicolon is on a separate line.
/// @param vertex  vertex of `felt.surface`
/// @param press  index into `felt.press`
[[nodiscard]] PALPATE_EXPORT QString palpabilityText(const buried::FeltSurface& felt, std::size_t vertex,
                                                     std::size_t press);

} // namespace palpate::ui
