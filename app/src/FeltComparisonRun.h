// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace palpate::app {

/// `palpate evaluate --felt`: holds what is said of buried lumps against exact solutions and writes the report.
/// @param out  a folder that is there
/// @return an ExitCode; kSomeLost when a bound does not hold that must
[[nodiscard]] int runFeltComparison(const std::filesystem::path& out, bool isQuick);

} // namespace palpate::app
