// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/haptics/TickResult.h>

#include <cstdint>
#include <type_traits>

namespace palpate::servo {

using core::Vec3;

/// Special conditions of a tick, one bit each.
enum TickFlag : std::uint16_t
{
    kOverrun = 1,        ///< the tick ended after its deadline
    kInputGated = 2,     ///< the safety gate changed or refused the HIP
    kOutputGated = 4,    ///< the safety gate changed the force
    kIterationLimit = 8, ///< the solver reached the iteration limit
    kDroppedBefore = 16, ///< ticks before this tick were dropped because the ring was full
    kSceneChanged = 32,  ///< first tick on another scene
    kReset = 64,         ///< the god-object restarted at the HIP in this tick (new hand or device start)
    kClutched = 256,     ///< the device moved without the HIP: no force
    kNoHand = 128,       ///< the device returned no state: nothing was solved, the force is zero
    kSlides = 512,       ///< the god-object of the reported layer slides: dynamic friction of the reported structure
    kHolds = 1024,       ///< the same god-object sticks: static friction. Neither flag without friction
};

/// Complete data of one servo tick. Passed through the ring to the recorder and as a snapshot to the window. The
/// recorded columns are described in docs/recording.md.
struct TickRecord
{
    std::int64_t tick = 0;    ///< since the servo started
    std::int64_t time_ns = 0; ///< monotonic
    Vec3 p_WH = Vec3::Zero(); ///< HIP passed to the solver, after the safety gate [mm]
    /// Hand velocity passed to the dampers; zero in free space and without dampers [mm/s]
    Vec3 v_WH = Vec3::Zero();
    haptics::TickResult felt;       ///< god-object, contact and force of the model, before device limits
    Vec3 fSent_W = Vec3::Zero();    ///< force sent to the device after the safety gate, in the world frame [N]
    Vec3 fDamping_W = Vec3::Zero(); ///< part requested by the passivity controller; not recorded [N]
    double energy_mJ = 0.0; ///< net energy from the hand since contact began; < 0: the hand received more; not recorded
    std::uint32_t scene = 0;    ///< generation number of the solved scene, see ServoLoop::setScene
    std::uint32_t buttons = 0;  ///< of the device, one bit each
    std::uint32_t solve_ns = 0; ///< time in the solver
    std::uint16_t flags = 0;    ///< TickFlag
};
static_assert(std::is_trivially_destructible_v<TickRecord>); // crosses threads in a PlainCopy

} // namespace palpate::servo
