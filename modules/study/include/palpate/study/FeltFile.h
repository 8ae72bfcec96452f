// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <palpate/core/Message.h>

#include <QJsonArray>

#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// Serializes the lumps of a scene for `palpate felt --json`: ratio and source, minimum cover, and for each press depth
/// the best place, the ratio with bounds there, the areas above 7, 14 and 28 %, and the verdict, also for both ends of
/// the ratio's range. Undefined numbers, and verdicts without a ratio, are null.
[[nodiscard]] QJsonArray lumpsJson(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs);

/// Returns one question for each lump with an unknown stiffness ratio.
[[nodiscard]] std::vector<core::Message> ratioQuestions(const meshio::LoadedScene& scene,
                                                        std::span<const OrganPalpability> organs);

/// Describes a ratio: "4.4 (1 to 5.2) times as stiff, published for such lumps", "stiffness ratio not known".
[[nodiscard]] std::string ratioText(const std::optional<StiffnessRatio>& ratio);

/// Summarizes ratio and verdicts of each lump in one line: "lump 12 mm in liver: 3 times as stiff, as typed; touched
/// lightly not by hand; pressed 2 mm by a trained hand, ...".
[[nodiscard]] std::vector<std::string> lumpLines(const meshio::LoadedScene& scene,
                                                 std::span<const OrganPalpability> organs);

/// Returns the document `{"version", "radius_mm", "lumps": [...], "notes": [...]}` with the lumps from `lumpsJson`.
[[nodiscard]] std::string feltJson(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs);

/// Returns the surfaces of the organs as VTP (LPS, mm) with the point arrays FeltRatio, FeltRatioLow, FeltRatioHigh
/// (k/k0 at the first press), Cover_mm (NaN: no palpable lump), Lump (from 1; 0: none) and NotJudged (bits of
/// buried::NotJudged).
[[nodiscard]] core::Result<std::string> feltVtp(std::span<const OrganPalpability> organs);

/// Describes a lump in one sentence: "lump 12 mm (3 times as stiff, from the tissues' stiffness), 6.0 mm below at
/// least". Adds the citation of a published ratio.
[[nodiscard]] std::string lumpSentence(const buried::FeltSurface::Lump& lump, const SceneLump& of);

} // namespace palpate::study
