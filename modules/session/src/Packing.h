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

/// @return true when all bits are equal; tells the zeros apart, and takes every NaN as the same.
[[nodiscard]] bool sameBits(double a, double b) noexcept;
[[nodiscard]] bool sameBits(const core::Vec3& a, const core::Vec3& b) noexcept;

/// Appends what a checksum covers of a tick: what is stored of it, NULLs filled in, from the wide numbers to the
/// narrow.
/// @param tick  `time_ns` since the recording's first
/// @param version  of the recording that the tick is checked against
void packTick(std::string& out, const servo::TickRecord& tick, int version = kRecordingVersion);

/// What the checksum of a scene covers.
/// @param version  of the recording that the scene is checked against
void packScene(std::string& out, const SceneRecord& scene, int version);
/// What the checksum of events covers.
void packEvent(std::string& out, std::int64_t id, const RecordingEvent& event);
/// What the checksum of an embedded surface covers: all its arrays.
[[nodiscard]] std::string embeddedHash(const geometry::RepairedMesh& surface);

[[nodiscard]] std::string packState(const haptics::PalpatorState& state, int version = kRecordingVersion);
/// Takes a state of this version or of one before: 3 knew no contacts that were left, 2 no friction. @return nothing
/// when `bytes` has another length or a number out of range.
[[nodiscard]] std::optional<haptics::PalpatorState> unpackState(std::string_view bytes);

/// SHA-256, raw.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// Hash that the chain of checks starts with. @param meta  keys and values, ascending by key, without "complete"
[[nodiscard]] std::string metaHash(const std::vector<std::pair<std::string, std::string>>& meta);

} // namespace palpate::session::internal
