// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace palpate::app {

/// Runs `palpate evaluate --felt`: compares the model of buried lumps with exact solutions and writes the report.
/// @param out  existing folder
/// @return an ExitCode; kSomeLost when a required bound is exceeded
[[nodiscard]] int runFeltComparison(const std::filesystem::path& out, bool isQuick);

} // namespace palpate::app
