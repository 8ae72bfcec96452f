// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::app {

/// Says on stdout how a recording that was computed again compares: the same bits, or no more apart than rounding
/// brings two builds. What is neither, and other bits from the very build that recorded them, goes to stderr.
/// @return the exit code for it
[[nodiscard]] int reportAgreement(const std::filesystem::path& file, const session::RecordingInfo& info,
                                  const session::Resimulation& again);

/// Says on stderr what of a recording is not as it was written, as far as it was read.
/// @param code  exit code of a run that is done but for that
/// @return kSomeLost where it was kDone and something is
[[nodiscard]] int reportDamage(const std::filesystem::path& file, const std::vector<std::string>& faults, int code);

/// Prints what a recording holds, in about ten lines.
void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader);

} // namespace palpate::app
