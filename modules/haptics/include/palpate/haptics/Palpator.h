// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/PalpatorState.h"
#include "palpate/haptics/TickResult.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace palpate::haptics {

/// Limits on the work of one tick. They are counts, not times, so that a replay reproduces every bit.
struct GodObjectLimits
{
    std::uint32_t iterations = 512; ///< moves per tick and layer; TickStatus::IterationLimit if reached
    /// Work budget of a point in units of about 10 ns (docs/cost.md), reported like `iterations`. Layers
    /// share the budget, innermost first, so that outer layers do not change the result of inner ones. Each layer gets
    /// at least 1/32.
    std::uint32_t work = 20000;
    std::uint32_t ballWork = 22000; ///< work budget of a ball
};

/// Probe shapes that a Palpator allocates memory for.
enum class Fingertips : std::uint8_t
{
    Points, ///< points only, at most 64 KiB; a scene with a ball-shaped probe gives InvalidInput
    Any,    ///< points and balls
};

/// Treatment of contacts when the scene changes.
enum class Continuity : std::uint8_t
{
    Contacts, ///< contacts follow the touched structures, see Palpator::setScene
    Places,   ///< god-objects keep their positions whatever the new scene contains, as in recordings before version 4
};

/// Computes contact forces of a scene for one HIP: moves the god-object of each layer and sums the forces of the
/// layers. The servo thread, replays and reports share this code, and the same sequence of calls gives the same bits.
///
/// @code
/// const auto scene = HapticScene::make({liver}); // see HapticScene.h
/// Palpator palpator;                             // allocates; outside the servo thread
/// palpator.setScene(scene.value());
/// const TickResult tick = palpator.step(p_WH, 1e-3); // at 1 kHz
/// // tick.f_W is the force on the hand in N, tick.p_WG the god-object in mm.
/// @endcode
class PALPATE_EXPORT Palpator
{
  public:
    /// Allocates all memory that later ticks need.
    explicit Palpator(Fingertips fingertips, const GodObjectLimits& limits = {});
    Palpator()
        : Palpator(Fingertips::Any)
    {
    }
    ~Palpator();
    Palpator(Palpator&&) noexcept;
    Palpator& operator=(Palpator&&) noexcept;

    /// Maximum distance between the HIP before and after an interruption for contacts to be restored [mm]
    static constexpr double kNear_mm = 5.0;

    /// Sets the scene of the following ticks. God-objects keep their positions and are matched to layers by layer
    /// number. A structure that appears around a god-object does not obstruct its way out. The god-object of a layer
    /// with a new number starts at the HIP.
    ///
    /// A structure is the same in both scenes if number and name are equal. If its surface was replaced (moved,
    /// smoothed or reloaded), a god-object in contact moves with the structure. A god-object that would end up inside
    /// the new surface is placed in front if the distance is at most 1 mm. The contact of a removed structure is
    /// stored, and restored when the structure returns while the HIP is within kNear_mm of its earlier position (for
    /// moving structures: in the rest shape): for 0.5 s, and for an open surface without limit, to keep the side.
    /// @param scene  shared until another scene is set; null = no scene
    /// @param continuity  how contacts are carried over to the new scene
    /// @return true if a contact was restored, or in moving tissue may be. Its force appears in one tick: ramp it up
    /// @par Real-time Not for the servo thread: may free the previous scene.
    bool setScene(std::shared_ptr<const HapticScene> scene, Continuity continuity = Continuity::Contacts) noexcept;
    /// As `setScene`, for a scene that the caller owns, as on the servo thread. A scene passed to `setScene` before is
    /// kept until the next `setScene`.
    /// @param scene  only read; must stay alive until another scene is set; null = no scene
    /// @par Real-time Wait-free; for replaced surfaces bounded by 4096 nearby triangles of each surface.
    bool borrowScene(const HapticScene* scene,
                     Continuity continuity = Continuity::Contacts) noexcept PALPATE_NONBLOCKING;
    /// As in version 0.1, for existing programs: borrows the scene, and releases a shared one.
    bool setScene(const HapticScene* scene, Continuity continuity = Continuity::Contacts) noexcept;
    /// Returns true if a god-object touches an open surface.
    [[nodiscard]] bool isOnSheet() const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] const HapticScene* scene() const noexcept;

    /// Discards all contacts. The next tick places every god-object at the HIP.
    /// @par Real-time Wait-free.
    void reset() noexcept PALPATE_NONBLOCKING;

    /// Computes one servo tick.
    /// @param p_WH  HIP [mm]. If not finite or beyond HapticScene::reaches, no state changes and the force is zero
    /// @param dt_s  time since the previous tick [s], > 0, typically 0.001
    /// @param v_WH  velocity of the hand for dampers [mm/s]; null: backward difference of the HIP, zero in the first
    ///              tick. A difference of exact positions is accurate. A difference of encoder counts is a sequence of
    ///              pulses: pass the estimate of servo::MotionTrack
    /// @param time_s  time of this tick, for moving structures. Never from a clock, so that a replay gives the same
    /// bits
    /// @return the result, constructed in the caller's variable; unused array entries are not initialised
    /// @par Real-time Wait-free, no allocation; bounded by GodObjectLimits.
    [[nodiscard]] TickResult step(const Vec3& p_WH, double dt_s, const Vec3* v_WH = nullptr,
                                  double time_s = 0.0) noexcept PALPATE_NONBLOCKING;

    /// Returns the power of the moving tissue in the last step [mW]: the energy per second that contacts gain although
    /// the hand rests. 0 without motion.
    [[nodiscard]] double tissuePower_mW() const noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] std::size_t byteSize() const noexcept; ///< memory of the palpator without the scene, in bytes

    /// State between ticks. Together with the scene and the next HIP it determines all following ticks.
    [[nodiscard]] PalpatorState state() const noexcept;
    /// Restores a recorded state.
    /// @pre the current scene equals the scene of the recorded state
    void restore(const PalpatorState& state) noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::haptics
