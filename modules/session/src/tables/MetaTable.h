// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Status.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// Keys and values of the table `meta`.
using MetaTable = std::map<std::string, std::string>;

/// Key added only when the writer closes the recording properly.
inline constexpr const char* kComplete = "complete";

[[nodiscard]] MetaTable toMeta(const RecordingInfo& info);
/// Returns true for a valid period that matches the rate.
[[nodiscard]] bool isPeriodOf(double dt_s, double rate_Hz);
/// @return BadFormat with one line (without file name) for a missing or invalid value
[[nodiscard]] core::Result<RecordingInfo> fromMeta(const MetaTable& meta);
/// Returns the pairs covered by the first checksum.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> hashedPairs(const MetaTable& meta);

/// Serializes the upper three rows of the pose, followed by the chosen frame if there is one.
[[nodiscard]] std::string poseText(const StructureSource& source);
/// Parses pose and frame. Sets the identity without a frame unless the text has twelve numbers and at most one frame
/// name.
void parsePose(std::string_view text, StructureSource& source);

} // namespace palpate::session::internal
