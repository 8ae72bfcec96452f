// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Message.h"

namespace palpate::core {

/// Writes a volume for people with the unit that fits: mm³ below 0.1 ml, ml, l from 10 l, m³ from 1000 l. A liver:
/// "1520 ml". @param digits  significant digits, 1 to 17
[[nodiscard]] PALPATE_EXPORT Message volumeText(double volume_mm3, int digits = 4);

/// Writes an area for people with the unit that fits: mm² below 1 cm², cm², m² from 10,000 cm². A liver: "873 cm²".
/// @param digits  significant digits, 1 to 17
[[nodiscard]] PALPATE_EXPORT Message areaText(double area_mm2, int digits = 4);

/// Writes a length along a path for people: mm, and m from 10 m. @param digits  significant digits, 1 to 17
[[nodiscard]] PALPATE_EXPORT Message pathText(double length_mm, int digits = 4);

} // namespace palpate::core
