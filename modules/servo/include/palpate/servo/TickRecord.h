// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/haptics/TickResult.h>

#include <cstdint>
#include <type_traits>

namespace palpate::servo {

using core::Vec3;

/// Why a tick is not an ordinary one; a bit each.
enum TickFlag : std::uint16_t
{
    kOverrun = 1,        ///< the tick ended after its deadline
    kInputGated = 2,     ///< the safety gate changed or refused the HIP
    kOutputGated = 4,    ///< the safety gate changed the force
    kIterationLimit = 8, ///< the solver stopped at its bound
    kDroppedBefore = 16, ///< ticks before this one are missing: the ring was full
    kSceneChanged = 32,  ///< first tick on another scene
    kReset = 64,         ///< the god-object started anew at the HIP in this tick (the hand came or the device started)
    kClutched = 256,     ///< the device moved without the HIP: nothing was to be felt
    kNoHand = 128,       ///< the device gave no state: nothing was solved, the force is zero
    kSlides = 512,       ///< friction lets the god-object of the reported layer slide
    kHolds = 1024,       ///< friction holds it
};

/// All of one servo tick. Goes through the ring to the recorder and, as a snapshot, to the window. What a recording
/// keeps of it, and under which names, is listed in session/src/TickColumns.h.
struct TickRecord
{
    std::int64_t tick = 0;    ///< since the servo started
    std::int64_t time_ns = 0; ///< monotonic
    Vec3 p_WH = Vec3::Zero(); ///< HIP that was solved, after the safety gate [mm]
    /// The hand's velocity as dampers were given it; zero in free space and where nothing has one [mm/s]
    Vec3 v_WH = Vec3::Zero();
    haptics::TickResult felt;       ///< god-object, contact and force of the model, not bounded by the device
    Vec3 fSent_W = Vec3::Zero();    ///< force given to the device, after the safety gate, as seen in the scene [N]
    Vec3 fDamping_W = Vec3::Zero(); ///< part of it that the passivity controller asked for; not recorded [N]
    double energy_mJ = 0.0;    ///< that the hand put in since contact began and has not got back; < 0: it got more; not
                               ///< recorded
    std::uint32_t scene = 0;   ///< generation number of the scene that was felt, see ServoLoop::setScene
    std::uint32_t buttons = 0; ///< of the device, a bit each
    std::uint32_t solve_ns = 0; ///< time in the solver
    std::uint16_t flags = 0;    ///< TickFlag
};
static_assert(std::is_trivially_destructible_v<TickRecord>); // crosses threads in a PlainCopy

} // namespace palpate::servo
