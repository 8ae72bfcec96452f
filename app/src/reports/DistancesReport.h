// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/study/Distances.h>

#include <string>
#include <vector>

namespace palpate::app {

/// Parses the borders of the bands of `--bands`: "5,10", above 0 and ascending [mm].
[[nodiscard]] core::Result<std::vector<double>> bandsOption(const std::string& text);

/// Prints sizes, least distances and margins, one line each.
void printDistances(const study::DistanceTable& table);

} // namespace palpate::app
