// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MotionFile.h"
#include "palpate/session/RecordingReader.h"

#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace palpate::session {

/// Takes a tick; returns false to stop.
using TickSink = std::function<bool(const servo::TickRecord&)>;

/// Feeds a motion to the Palpator as fast as possible, one sample a tick: the code that the servo thread runs. The
/// god-object starts at the first HIP. `fSent_W` is the model's force: there is no device.
/// @par Cost `solve_ns` is the Palpator's step alone, by the monotonic clock.
void replay(const haptics::HapticScene& scene, const Motion& motion, const TickSink& sink);

/// Gives every structure these values instead of its own. [N/mm], [N·s/mm]
[[nodiscard]] haptics::HapticScene withTissue(const haptics::HapticScene& scene, std::optional<double> stiffness,
                                              std::optional<double> damping);

/// Surfaces by geometryHash.
using SurfacesByHash = std::map<std::string, std::shared_ptr<const geometry::SurfaceIndex>>;

/// Builds a recorded scene again. @return Mismatch with one line that names the structure whose geometry is missing
[[nodiscard]] core::Result<std::shared_ptr<const haptics::HapticScene>> rebuildScene(const SceneRecord& record,
                                                                                     const SurfacesByHash& surfaces);

/// How a re-simulation compares.
struct Resimulation
{
    std::int64_t compared = 0;                   ///< ticks computed again
    std::int64_t unverified = 0;                 ///< ticks after a loss, until the state was known again
    std::optional<std::int64_t> firstDifference; ///< tick; nothing: all bits are equal
    std::string difference;                      ///< what differed there, one line
    bool isSame() const noexcept { return !firstDifference.has_value(); }
};

/// Computes a recording again from its start state, HIPs, resets and scene changes and compares every god-object and
/// force bit for bit.
/// @param sink  told each tick as computed now; may be empty
[[nodiscard]] core::Result<Resimulation> resimulate(const RecordingReader& recording, const SurfacesByHash& surfaces,
                                                    const TickSink& sink = {});

} // namespace palpate::session
