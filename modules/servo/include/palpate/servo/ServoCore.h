// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/PassivityController.h"
#include "palpate/servo/SafetyGate.h"
#include "palpate/servo/TickRecord.h"
#include "palpate/servo/WorkspaceMap.h"

#include <palpate/haptics/Palpator.h>

#include <cstdint>

namespace palpate::servo {

/// Feels the tick whose record has `p_WH`, `v_WH` and `flags`: nothing when they have kNoHand, from anew when they have
/// kReset. Puts in what was felt, the time of that one solver call, and kIterationLimit. The servo thread and every
/// replay call this and nothing else, so that rows (p_WH, v_WH, flags) and the nominal period are all a replay needs.
/// Where a row's `scene` differs from the one before, call `palpator.setScene` first. Numbers below the smallest normal
/// one count as zero meanwhile, on whatever thread this runs: they would cost a hundred times the time, and a replay
/// must give the same bits.
/// @param dt_s  nominal period, 1 / rate [s]
/// @par Real-time Wait-free.
void feelTick(haptics::Palpator& palpator, double dt_s, TickRecord& tick) noexcept PALPATE_NONBLOCKING;

/// What a servo loop that begins anew needs to go on where the one before it ended.
struct ServoHand
{
    haptics::PalpatorState palpator;
    WorkspaceMap map;
    Vec3 p_WH = Vec3::Zero(); ///< last HIP [mm]
    double away_s = 0.0;      ///< in ticks without a hand since then [s]
    bool hasBeenHere = false; ///< there was a hand at all
};

/// One servo tick without a thread, a clock or a device: safety gate in, workspace map, model, passivity controller,
/// safety gate out. The gate and the controller work in the device's frame, where hand and motors are.
///
/// A hand that was away, or a device that was lost and is re-armed, keeps its god-objects when it comes back within 0.5
/// s and Palpator::kNear_mm of where it was; then, and when a scene gives a contact back, the force is eased in. Time
/// is counted in periods of ticks without a hand, not in those of a fault.
///
/// The damper gets the nominal period, not the measured one: a late tick then feels a little more damping than it
/// should, but the same rows give the same forces on every machine.
/// @par Real-time Wait-free, no allocation. One thread.
class ServoCore
{
  public:
    /// @param rate_Hz  > 0
    ServoCore(const GateLimits& limits, double rate_Hz, const PassivityLimits& passivity = {.isOn = false}) noexcept;

    /// Lets the coming ticks feel another scene.
    /// @param scene  only read; must outlive its use here; null = nothing to touch
    void setScene(const haptics::HapticScene* scene, std::uint32_t generation) noexcept PALPATE_NONBLOCKING;

    /// From the next tick on.
    void setMap(const MapSettings& settings) noexcept PALPATE_NONBLOCKING { m_map.set(settings); }
    [[nodiscard]] const WorkspaceMap& map() const noexcept { return m_map; }

    /// How late the device's force acts, see PassivityController.
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING { m_passivity.setDelay(ticks); }

    /// @return the tick's record. kOverrun and kDroppedBefore are the caller's to add.
    [[nodiscard]] TickRecord tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;

    /// The force that the device is to be given, in its own frame D [N].
    [[nodiscard]] const Vec3& forceForDevice() const noexcept { return m_sent_D; }

    /// Says whether the tick just done ended late.
    void noteOverrun(bool isOverrun, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    void rearm() noexcept PALPATE_NONBLOCKING;
    void beginStop() noexcept PALPATE_NONBLOCKING { m_gate.beginStop(); }

    [[nodiscard]] const SafetyGate& gate() const noexcept { return m_gate; }
    [[nodiscard]] Fault fault() const noexcept { return m_fault; }
    /// Number of the coming tick.
    [[nodiscard]] std::int64_t nextTick() const noexcept { return m_tick; }
    [[nodiscard]] std::uint32_t sceneGeneration() const noexcept { return m_generation; }
    /// For a core that goes on with this one's scene and device.
    [[nodiscard]] ServoHand hand() const noexcept;
    /// @pre the scene is set, the one that the hand was on; no tick was done yet
    void resume(const ServoHand& hand) noexcept;
    /// Everything that decides the coming ticks besides scene, HIP, velocity and flags.
    [[nodiscard]] haptics::PalpatorState palpatorState() const noexcept { return m_palpator.state(); }

  private:
    void latch(std::int64_t tick, std::int64_t now_ns) noexcept;
    [[nodiscard]] bool isBack(const Vec3& p_WH) const noexcept;

    haptics::Palpator m_palpator;
    SafetyGate m_gate;
    PassivityController m_passivity;
    WorkspaceMap m_map;
    Vec3 m_sent_D = Vec3::Zero();
    Vec3 m_p_WH = Vec3::Zero(); // of the last hand
    double m_away_s = 0.0;      // in ticks since then
    bool m_hasBeenHere = false;
    double m_dt_s;
    std::int64_t m_tick = 0;
    std::uint32_t m_generation = 0;
    bool m_isSceneChanged = false;
    Fault m_fault;
};

} // namespace palpate::servo
