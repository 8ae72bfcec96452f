// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Report.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/session/CompareSessions.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate::study {

struct CompareOptions
{
    std::filesystem::path scene;       ///< scene of the recordings; empty: as stored in them
    session::MeshesByHash opened;      ///< surfaces used where the recordings' own are not available
    std::optional<double> distance_mm; ///< empty: see checkComparable
    /// Progress callback (0 to 1). Return false to cancel. May be empty.
    std::function<bool(double)> progress;
};

/// Comparison of two recordings of the same surfaces.
struct RecordingComparison
{
    session::SessionComparison sessions;
    std::vector<core::Message> conditions; ///< conditions that were not the same, one sentence each
    std::vector<core::Message> missing;    ///< what is missing or damaged, one sentence each
};

/// Checks that two recordings can be compared.
/// @param surfaces  surfaces that are measured
/// @return the distance that counts as touched in both [mm], the larger of their default distances; BadCommandLine for
/// recordings of different surfaces (see session::checkSameSurfaces), or for one recording given twice; the error of a
/// recording
[[nodiscard]] PALPATE_EXPORT core::Result<double> checkComparable(const std::filesystem::path& first,
                                                                  const std::filesystem::path& second,
                                                                  const session::MeshesByHash& surfaces);

/// Measures two recordings and compares the measures. Missing surfaces and damage are listed in `missing`.
/// @return the errors of checkComparable, or of the scene in `options`; Cancelled
/// @par Cost About twice that of `session measure`
/// @par Thread Any
[[nodiscard]] PALPATE_EXPORT core::Result<RecordingComparison> compareRecordings(const std::filesystem::path& first,
                                                                                 const std::filesystem::path& second,
                                                                                 const CompareOptions& options = {});

/// Makes the tables that the command line prints and the window shows, with the recordings as A and B: the touched
/// surfaces, then the measures of each group.
[[nodiscard]] PALPATE_EXPORT std::vector<ReportTable> comparisonTables(const session::SessionComparison& sessions);

/// Serializes a comparison, see docs/measures.md.
[[nodiscard]] PALPATE_EXPORT std::string comparisonJson(const RecordingComparison& comparison);

} // namespace palpate::study
