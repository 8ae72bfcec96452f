// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MotionFile.h"
#include "palpate/session/RecordingReader.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/servo/MotionTrack.h>
#include <palpate/servo/TickRecord.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace palpate::session {

/// Tick callback. Return false to stop.
using TickSink = std::function<bool(const servo::TickRecord&)>;

/// Runs a motion through the Palpator as fast as possible with one sample per tick, using the same code as the servo
/// thread. The god-object starts at the first HIP. `fSent_W` is the model force because there is no device.
/// @par Cost `solve_ns` measures the Palpator's step only, with the monotonic clock.
PALPATE_EXPORT void replay(const haptics::HapticScene& scene, const Motion& motion, const TickSink& sink);
/// As above, for a path in memory of the caller.
/// @param p_WH  one position per tick [mm]. A position that is not finite gives no force
/// @param dt_s  time between ticks [s], > 0, typically 0.001
PALPATE_EXPORT void replay(const haptics::HapticScene& scene, std::span<const Vec3> p_WH, double dt_s,
                           const TickSink& sink);

/// Feels a scene tick by tick with the same code and the same bits as `replay`, for a path that is not known in
/// advance.
///
///     ReplayHand hand;
///     hand.borrowScene(scene.get());
///     const servo::TickRecord tick = hand.step(p_WH, 1e-3); // tick.felt.f_W is the force [N]
///
/// @par Thread One thread at a time. Not for the servo thread, which has servo::ServoCore.
class PALPATE_EXPORT ReplayHand
{
  public:
    /// Sets the scene of the following ticks, see haptics::Palpator::setScene.
    /// @param scene  only read; must stay alive until another scene is set or this object is destroyed
    void borrowScene(const haptics::HapticScene* scene) noexcept;
    /// The next tick is the first of a motion again: tick 0, with the god-object at the HIP.
    void reset() noexcept;
    /// Computes the next tick.
    /// @param p_WH  HIP [mm]
    /// @param dt_s  time since the previous tick [s], > 0. Moving structures are at the time `tick * dt_s`
    [[nodiscard]] servo::TickRecord step(const Vec3& p_WH, double dt_s) noexcept;

  private:
    haptics::Palpator m_palpator;
    servo::MotionTrack m_track{0.0}; // a motion has no information about sensor resolution
    std::int64_t m_tick = 0;
    bool m_isDamped = false;
};

/// Overrides for core::kTissueTerms, in the same order and units; empty entries keep the value.
using TissueOverride = std::array<std::optional<double>, core::kTissueTerms.size()>;

/// Applies the overrides to every structure. With any override, structures become a plain spring and damper: friction,
/// maps and other force laws are removed.
[[nodiscard]] PALPATE_EXPORT haptics::HapticScene withTissue(const haptics::HapticScene& scene,
                                                             const TissueOverride& given);

/// Surfaces, keyed by geometryHash.
using SurfacesByHash = std::map<std::string, std::shared_ptr<const geometry::SurfaceIndex>>;

/// Rebuilds a recorded scene. @return Mismatch with the name of the structure whose geometry is missing
[[nodiscard]] PALPATE_EXPORT core::Result<std::shared_ptr<const haptics::HapticScene>>
rebuildScene(const SceneRecord& record, const SurfacesByHash& surfaces);

/// Comparison of a re-simulation with the recording.
///
/// Other compilers or later versions may round sums differently. The effect is bounded by multiples of the surface
/// skin, the margin that the solver keeps for rounding and for distinguishing positions; see kRoundingTolerance_skins.
/// A larger difference means that the god-object took a different path.
struct Resimulation
{
    std::int64_t compared = 0;                   ///< recomputed ticks
    std::int64_t unverified = 0;                 ///< ticks after a loss, before the state was known again
    std::int64_t differing = 0;                  ///< ticks with any different bit
    std::optional<std::int64_t> firstDifference; ///< first differing tick; empty: all bits are equal
    core::Message difference;                    ///< first difference, one line
    double farthest_mm = 0.0;                    ///< largest distance between recorded and recomputed god-object
    double farthest_N = 0.0;                     ///< largest difference between recorded and recomputed force
    double rounding_mm = 0.0;                ///< maximum god-object distance that rounding explains, over all scenes
    std::optional<std::int64_t> firstBeyond; ///< first tick with a difference beyond rounding
    core::Message beyond;                    ///< that difference with its amount, one line

    /// True if all bits of all god-objects, forces and contacts are equal.
    bool isSame() const noexcept { return !firstDifference.has_value(); }
    bool isWithinRounding() const noexcept { return !firstBeyond.has_value(); }
};

/// Rounding tolerance in skins of the layer. The solver treats god-objects within this distance as one position: the
/// god-object leaves a corner only if this brings it closer by at least this distance (docs/god-object.md).
/// The rounding error of a plane distance is at most one eighth of a skin, so the tolerance also holds in a crease of 2
/// degrees. The force tolerance is this distance times the stiffness.
inline constexpr double kRoundingTolerance_skins = 16.0;

/// Recomputes a recording from its start state, HIPs, resets and scene changes. Compares every god-object and force and
/// their triangle and number of constraints bit for bit.
/// @param sink  receives each recomputed tick; may be empty
[[nodiscard]] PALPATE_EXPORT core::Result<Resimulation>
resimulate(const RecordingReader& recording, const SurfacesByHash& surfaces, const TickSink& sink = {});

} // namespace palpate::session
