// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <functional>
#include <optional>

namespace palpate::study {

struct RecordingMeasureOptions
{
    std::filesystem::path scene;       ///< scene of the recording; empty: as stored in the recording
    std::optional<double> distance_mm; ///< distance that counts as touched; empty: defaultDistance_mm
    /// Progress callback (0 to 1). Return false to cancel. May be empty.
    std::function<bool(double)> progress;
};

/// Measures of a recording on all available surfaces.
struct MeasuredRecording
{
    session::SessionMeasures measures;
    /// Why the structures in `measures.unmeasured` have no coverage; empty if no structure is unmeasured.
    core::Message unmeasured;
};

/// Finds scene and surfaces of a recording and measures, as `palpate session measure` does.
/// @return the error of the scene in `options`, of computePalpability or of measureSearch
/// @par Thread Any. Do not use the reader from other threads at the same time.
[[nodiscard]] PALPATE_EXPORT core::Result<MeasuredRecording>
measureRecording(const session::RecordingReader& reader, const RecordingMeasureOptions& options = {});

} // namespace palpate::study
