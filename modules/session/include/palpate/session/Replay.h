// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MotionFile.h"
#include "palpate/session/RecordingReader.h"

#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/TickRecord.h>

#include <array>
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

/// Values for core::kTissueTerms, in their order and units; none: as it is.
using TissueOverride = std::array<std::optional<double>, core::kTissueTerms.size()>;

/// Gives every structure these values instead of its own: with any of them it is a spring and a damper alone, without
/// friction, map or another law.
[[nodiscard]] haptics::HapticScene withTissue(const haptics::HapticScene& scene, const TissueOverride& given);

/// Surfaces by geometryHash.
using SurfacesByHash = std::map<std::string, std::shared_ptr<const geometry::SurfaceIndex>>;

/// Builds a recorded scene again. @return Mismatch with one line that names the structure whose geometry is missing
[[nodiscard]] core::Result<std::shared_ptr<const haptics::HapticScene>> rebuildScene(const SceneRecord& record,
                                                                                     const SurfacesByHash& surfaces);

/// How a re-simulation compares with what was recorded.
///
/// Another compiler, or a later version, may round otherwise in a sum. What follows from that is bounded by the skin of
/// the surfaces, the gap that the solver keeps for its rounding and in multiples of which it tells places apart: see
/// kSkinsOfRounding. What lies beyond is another way that the god-object took.
struct Resimulation
{
    std::int64_t compared = 0;                   ///< ticks computed again
    std::int64_t unverified = 0;                 ///< ticks after a loss, until the state was known again
    std::int64_t differing = 0;                  ///< ticks of which any bit differs
    std::optional<std::int64_t> firstDifference; ///< the first of them; nothing: all bits are equal
    std::string difference;                      ///< what differed there, one line
    double farthest_mm = 0.0;                    ///< largest distance of a god-object from the recorded one
    double farthest_N = 0.0;                     ///< the same of the forces
    double rounding_mm = 0.0;                    ///< how far apart rounding can bring god-objects, on any of the scenes
    std::optional<std::int64_t> firstBeyond;     ///< first tick that differs by more than rounding
    std::string beyond;                          ///< what differed there, and by how much, one line

    /// Every bit of every god-object and force, and what was touched.
    bool isSame() const noexcept { return !firstDifference.has_value(); }
    bool isWithinRounding() const noexcept { return !firstBeyond.has_value(); }
};

/// Two god-objects nearer to each other than this many skins of their layer are one place to the solver: it follows a
/// way out of a corner only when that leads closer by as much (resources/docs/god-object.md). The rounding of one plane
/// distance is at most an eighth of a skin, so that this holds in a crease of 2 degrees, too. A force may differ by as
/// much times the stiffness.
inline constexpr double kSkinsOfRounding = 16.0;

/// Computes a recording again from its start state, HIPs, resets and scene changes and compares every god-object and
/// force, and the triangle and the number of constraints that gave them, bit for bit.
/// @param sink  told each tick as computed now; may be empty
[[nodiscard]] core::Result<Resimulation> resimulate(const RecordingReader& recording, const SurfacesByHash& surfaces,
                                                    const TickSink& sink = {});

} // namespace palpate::session
