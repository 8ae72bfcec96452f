// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <string>

namespace palpate::app {

/// @return words to put after a difference when another build made the recording, which may round otherwise; else
/// empty.
[[nodiscard]] std::string builtDifferently(const session::RecordingInfo& info);

/// Prints what a recording holds, in about ten lines.
void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader);

} // namespace palpate::app
