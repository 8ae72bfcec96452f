// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::app {

/// Prints to stdout how a re-simulated recording compares: bit-identical, or equal within the rounding between
/// builds. Larger differences, and bit differences with the build that made the recording, are printed to stderr.
/// @return the exit code
[[nodiscard]] int reportAgreement(const std::filesystem::path& file, const session::RecordingInfo& info,
                                  const session::Resimulation& again);

/// Prints damage of a recording to stderr, as far as the recording was read.
/// @param code  exit code of the run apart from damage
/// @return kSomeLost if `code` is kDone and there is damage, otherwise `code`
[[nodiscard]] int reportDamage(const std::filesystem::path& file, const std::vector<core::Message>& faults, int code);

/// Prints a summary of a recording, in about ten lines.
void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader);

} // namespace palpate::app
