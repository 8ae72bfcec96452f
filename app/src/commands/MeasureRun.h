// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <string>

namespace palpate::app {

struct MeasureSettings
{
    std::filesystem::path scene; ///< empty: as the recording says
    std::string distance;        ///< text of --distance; empty: fingertip radius of the recording
};

/// Computes the measures with all available surfaces. Prints which surfaces are missing.
/// @param isWhole  false if a surface is missing
[[nodiscard]] core::Result<session::SessionMeasures> measureRecording(const session::RecordingReader& reader,
                                                                      const MeasureSettings& settings, bool& isWhole);

} // namespace palpate::app
