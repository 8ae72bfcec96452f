// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <QJsonArray>

#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// @return the lumps of a scene as `palpate felt --json` has them: each with its ratio, where that comes from, least
/// cover, and for each press the best place, ratio with bounds there, areas above 7, 14 and 28 %, and the verdict with
/// that for the ends of the ratio's range. A number that there is none of is null; so is a verdict without a ratio.
[[nodiscard]] QJsonArray lumpsJson(const meshio::LoadedScene& scene, std::span<const FeltOrgan> organs);

/// @return what must still be said of lumps whose stiffness ratio is not known, one sentence each.
[[nodiscard]] std::vector<std::string> ratioQuestions(const meshio::LoadedScene& scene,
                                                      std::span<const FeltOrgan> organs);

/// @return a lump's ratio: "4.4 (1 to 5.2) times as stiff, published for such lumps", "stiffness ratio not known"
[[nodiscard]] std::string ratioText(const std::optional<StiffnessRatio>& ratio);

/// @return ratio and verdicts of each lump in a line: "lump 12 mm in liver: 3 times as stiff, as typed; touched lightly
/// not by hand; pressed 2 mm by a trained hand, ..."
[[nodiscard]] std::vector<std::string> lumpLines(const meshio::LoadedScene& scene, std::span<const FeltOrgan> organs);

/// @return `{"version", "radius_mm", "lumps": [...], "notes": [...]}`; the lumps as `lumpsJson` has them.
[[nodiscard]] std::string feltJson(const meshio::LoadedScene& scene, std::span<const FeltOrgan> organs);

/// @return the organs' surfaces (LPS, mm) with the point arrays FeltRatio, FeltRatioLow, FeltRatioHigh (k/k0 at the
/// first press), Cover_mm (NaN: no lump is felt), Lump (number from 1; 0: none) and NotJudged (bits of
/// buried::NotJudged)
[[nodiscard]] core::Result<std::string> feltVtp(std::span<const FeltOrgan> organs);

/// @return a lump in one sentence: "lump 12 mm (3 times as stiff, from the tissues' stiffness), 6.0 mm below at least";
/// a published ratio with its citation.
[[nodiscard]] std::string lumpSentence(const buried::FeltSurface::Lump& lump, const LumpOf& of);

} // namespace palpate::study
