// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/ForceLaw.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <vector>

namespace palpate::meshio {

/// Reads a measured force curve: CSV with the columns `depth_mm` and `force_N` and at most 64 rows that pass
/// core::check. Ignores other columns and empty lines. An error names the line and the value: "curve.csv: line 4: …".
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<core::ForceLaw::Point>>
readCurve(const std::filesystem::path& path);

} // namespace palpate::meshio
