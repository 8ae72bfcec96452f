// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>

#include <filesystem>
#include <string>

namespace palpate::app {

/// Says on stdout how a recording that was computed again compares: the same bits, or no more apart than rounding
/// brings two builds. What is neither, and other bits from the very build that recorded them, goes to stderr.
/// @return the exit code for it
[[nodiscard]] int reportAgreement(const std::filesystem::path& file, const session::RecordingInfo& info,
                                  const session::Resimulation& again);

/// Prints what a recording holds, in about ten lines.
void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader);

} // namespace palpate::app
