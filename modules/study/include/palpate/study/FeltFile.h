// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <span>
#include <string>

namespace palpate::study {

/// What can be felt through one organ of a scene.
struct FeltOrgan
{
    OrganWithLumps organ;
    buried::FeltSurface felt;
};

/// @return `{"version", "radius_mm", "lumps": [...], "notes": [...]}`: each lump with its ratio, least cover, and for
/// each press the best place, ratio with bounds there, areas above 7, 14 and 28 %, and the verdict. A number that there
/// is none of is null.
[[nodiscard]] std::string feltJson(const meshio::LoadedScene& scene, std::span<const FeltOrgan> organs);

/// @return the organs' surfaces (LPS, mm) with the point arrays FeltRatio, FeltRatioLow, FeltRatioHigh (k/k0 at the
/// first press), Cover_mm (NaN: no lump is felt), Lump (number from 1; 0: none) and NotJudged (bits of
/// buried::NotJudged)
[[nodiscard]] core::Result<std::string> feltVtp(std::span<const FeltOrgan> organs);

/// @return a lump in one sentence: "lump 12 mm (3 times as stiff, from the tissues' stiffness), 6.0 mm below at least".
[[nodiscard]] std::string lumpSentence(const buried::FeltSurface::Lump& lump, const LumpOf& of);

} // namespace palpate::study
