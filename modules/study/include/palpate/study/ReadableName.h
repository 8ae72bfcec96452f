// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <string>
#include <string_view>

namespace palpate::study {

/// Returns the name of a structure for people: "VH_F_liver_capsule" and "liver_capsule" become "liver capsule". Names
/// without underscores and repeated spaces are unchanged, so a readable name stays as it is.
[[nodiscard]] PALPATE_EXPORT std::string readableName(std::string_view name);

} // namespace palpate::study
