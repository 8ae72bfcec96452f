// SPDX-License-Identifier: BSD-3-Clause
#include "reports/DistancesReport.h"

#include "shared/Console.h"

#include <algorithm>
#include <cstddef>

namespace palpate::app {

core::Result<std::vector<double>> bandsOption(const std::string& text)
{
    std::vector<double> limits_mm;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(',', from), text.size());
        const auto limit_mm = numberOption("--bands", text.substr(from, to - from), {.isAbove = true});
        if (!limit_mm.isOk()) {
            return limit_mm.status();
        }
        if (!limits_mm.empty() && limit_mm.value() <= limits_mm.back()) {
            return core::Status(core::StatusCode::BadCommandLine,
                                PALPATE_TEXT("--bands: found \"%1\", expected ascending distances in mm, as 5,10"),
                                text);
        }
        limits_mm.push_back(limit_mm.value());
        from = to + 1;
    }
    return limits_mm;
}

void printDistances(const study::DistanceTable& table)
{
    for (const study::StructureSize& size : table.sizes) {
        print("  size: %s\n", study::sentence(size).english().c_str());
    }
    for (const study::PairDistance& pair : table.pairs) {
        print("  distance: %s\n", study::sentence(table, pair).english().c_str());
    }
    for (const study::LumpMargin& margin : table.margins) {
        std::string bands;
        for (const core::Message& clause : study::clauses(table, margin)) {
            bands.append(bands.empty() ? "" : ", ").append(clause.english());
        }
        print("  margin: %s to %s: %s of its area\n", table.sizes[margin.lump].name.c_str(),
              table.sizes[margin.structure].name.c_str(), bands.c_str());
    }
    for (const core::Tape& tape : table.tapes) {
        print("  tape: %s\n", study::sentence(tape).english().c_str());
    }
}

} // namespace palpate::app
