// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Types.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/servo/TickRecord.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// Returns true if all bits are equal. Distinguishes the signs of zero and treats all NaNs as equal.
[[nodiscard]] bool sameBits(double a, double b) noexcept;
[[nodiscard]] bool sameBits(const core::Vec3& a, const core::Vec3& b) noexcept;

/// Appends the checksum input for a tick: the stored values with NULLs resolved, from wide to narrow types.
/// @param tick  `time_ns` since the first tick of the recording
/// @param version  of the recording with the checksum
void packTick(std::string& out, const servo::TickRecord& tick, int version = kRecordingVersion);

/// Appends the checksum input for a scene.
/// @param version  of the recording with the checksum
void packScene(std::string& out, const SceneRecord& scene, int version);
/// Appends the checksum input for an event.
void packEvent(std::string& out, std::int64_t id, const RecordingEvent& event);
/// Returns the checksum of an embedded surface, over all arrays.
[[nodiscard]] std::string embeddedHash(const geometry::RepairedMesh& surface);

[[nodiscard]] std::string packState(const haptics::PalpatorState& state, int version = kRecordingVersion);
/// Unpacks a state of this or an earlier version: version 3 has no LostContact entries, version 2 no friction either.
/// @return empty for a wrong length or a number out of range.
[[nodiscard]] std::optional<haptics::PalpatorState> unpackState(std::string_view bytes);

/// Returns the raw SHA-256.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// Returns the first hash in the chain of checksums. @param meta  keys and values, ascending by key, without "complete"
[[nodiscard]] std::string metaHash(const std::vector<std::pair<std::string, std::string>>& meta);

} // namespace palpate::session::internal
