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

/// Key that only the writer's orderly end adds.
inline constexpr const char* kComplete = "complete";

[[nodiscard]] MetaTable toMeta(const RecordingInfo& info);
/// @return true for a period that a recording may have, when it is that of the rate.
[[nodiscard]] bool isPeriodOf(double dt_s, double rate_Hz);
/// @return BadFormat with one line (without the file's name) for a value that is missing or wrong
[[nodiscard]] core::Result<RecordingInfo> fromMeta(const MetaTable& meta);
/// The pairs that the first check covers.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> hashedPairs(const MetaTable& meta);

/// A source's pose as the text of its upper three rows, and behind it the frame where one was chosen.
[[nodiscard]] std::string poseText(const StructureSource& source);
/// Sets pose and frame; the identity and none when the text is not twelve numbers and at most a frame's name.
void parsePose(std::string_view text, StructureSource& source);

} // namespace palpate::session::internal
