// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

#include <palpate/core/Status.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Writes `report.html` (self-contained, no scripts), `results.csv`, `hard_cases.csv`, `results.json` (all of it)
/// and `chart.svg` (speed against error on the first subject, as a picture) into a folder, which is made when it is
/// missing; each file appears only when it is whole.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Evaluation& evaluation);
/// @return the files that it writes
[[nodiscard]] std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder);

/// The same as text.
[[nodiscard]] std::string reportHtml(const Evaluation& evaluation);
[[nodiscard]] std::string chartSvg(const Evaluation& evaluation);
[[nodiscard]] std::string resultsCsv(const Evaluation& evaluation); ///< trials, then the cost on spheres
[[nodiscard]] std::string hardCasesCsv(const Evaluation& evaluation);
[[nodiscard]] std::string resultsJson(const Evaluation& evaluation);

} // namespace palpate::evaluation
