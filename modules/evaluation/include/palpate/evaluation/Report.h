// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

#include <palpate/core/Status.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Writes `report.html` (self-contained, no scripts), `results.csv`, `hard_cases.csv`, `results.json` (complete data)
/// and `chart.svg` (speed against error on the first subject). Creates the folder if missing. Files are replaced
/// atomically.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Evaluation& evaluation);
/// @return paths of the files written by writeReport
[[nodiscard]] std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder);

/// Content of the individual files.
[[nodiscard]] std::string reportHtml(const Evaluation& evaluation);
[[nodiscard]] std::string chartSvg(const Evaluation& evaluation);
[[nodiscard]] std::string resultsCsv(const Evaluation& evaluation); ///< trials, then cost on spheres
[[nodiscard]] std::string hardCasesCsv(const Evaluation& evaluation);
[[nodiscard]] std::string resultsJson(const Evaluation& evaluation);

} // namespace palpate::evaluation
