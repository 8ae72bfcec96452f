// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/PassivityController.h"
#include "palpate/servo/SafetyGate.h"
#include "palpate/servo/TickRecord.h"
#include "palpate/servo/WorkspaceMap.h"

#include <palpate/core/Export.h>
#include <palpate/haptics/Palpator.h>

#include <cstdint>

namespace palpate::servo {

/// Solves the tick described by `p_WH`, `v_WH` and `flags` of the record: no contact with kNoHand, a restart with
/// kReset. Stores the result, the solver time and kIterationLimit in the record. The servo thread and every replay call
/// only this function, so that a replay needs only the rows (p_WH, v_WH, flags) and the nominal period. When the
/// `scene` of a row differs from the previous row, call `palpator.setScene` first. Flushes denormals during the call on
/// any thread: denormals would be a hundred times slower, and a replay must produce the same bits.
/// @param dt_s  nominal period, 1 / rate [s]
/// @par Real-time Wait-free.
PALPATE_EXPORT void feelTick(haptics::Palpator& palpator, double dt_s, TickRecord& tick) noexcept PALPATE_NONBLOCKING;

/// State passed from a finished servo loop to the next one, which continues from there.
struct ServoHand
{
    haptics::PalpatorState palpator;
    WorkspaceMap map;
    Vec3 p_WH = Vec3::Zero(); ///< last HIP [mm]
    double away_s = 0.0;      ///< duration of ticks without a hand since then [s]
    bool hasBeenHere = false; ///< a hand was present at least once
};

/// One servo tick without thread, clock or device: safety gate in, workspace map, model, passivity controller, safety
/// gate out. Gate and controller work in the device frame D.
///
/// A hand that returns, or a lost device that is re-armed, keeps the god-objects when it is back within 0.5 s and
/// within Palpator::kNear_mm of the last position; the force is then eased in, as it is when a scene restores a
/// contact. The time counts ticks without a hand, not ticks of a fault.
///
/// The damper uses the nominal period instead of the measured period: a late tick gets slightly too much damping, but
/// the same rows produce the same forces on every machine.
/// @par Real-time Wait-free, no allocation. One thread.
class PALPATE_EXPORT ServoCore
{
  public:
    /// @param rate_Hz  > 0
    ServoCore(const GateLimits& limits, double rate_Hz, const PassivityLimits& passivity = {.isOn = false}) noexcept;

    /// Sets the scene for the following ticks.
    /// @param scene  read-only; must outlive the use in this class; null: empty scene
    void borrowScene(const haptics::HapticScene* scene, std::uint32_t generation) noexcept PALPATE_NONBLOCKING;

    /// Applies from the next tick on.
    void setMap(const MapSettings& settings) noexcept PALPATE_NONBLOCKING { m_map.set(settings); }
    [[nodiscard]] const WorkspaceMap& map() const noexcept { return m_map; }

    /// Sets the delay of the device force, see PassivityController.
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING { m_passivity.setDelay(ticks); }

    /// @return the record of the tick. The caller adds kOverrun and kDroppedBefore.
    [[nodiscard]] TickRecord tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;

    /// Force to send to the device, in the device frame D [N].
    [[nodiscard]] const Vec3& forceForDevice() const noexcept { return m_sent_D; }

    /// Reports whether the last tick ended late.
    void noteOverrun(bool isOverrun, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    void rearm() noexcept PALPATE_NONBLOCKING;
    void beginStop() noexcept PALPATE_NONBLOCKING { m_gate.beginStop(); }

    [[nodiscard]] const SafetyGate& gate() const noexcept { return m_gate; }
    [[nodiscard]] Fault fault() const noexcept { return m_fault; }
    /// Number of the next tick.
    [[nodiscard]] std::int64_t nextTick() const noexcept { return m_tick; }
    [[nodiscard]] std::uint32_t sceneGeneration() const noexcept { return m_generation; }
    /// State for another core that continues with the same scene and device.
    [[nodiscard]] ServoHand hand() const noexcept;
    /// Continues from the state of another core.
    /// @pre the scene of that state is set, and no tick has run yet
    void resume(const ServoHand& hand) noexcept;
    /// Complete state that determines the following ticks, apart from scene, HIP, velocity and flags.
    [[nodiscard]] haptics::PalpatorState palpatorState() const noexcept { return m_palpator.state(); }

  private:
    void latch(std::int64_t tick, std::int64_t now_ns) noexcept;
    [[nodiscard]] bool isBack(const Vec3& p_WH) const noexcept;
    [[nodiscard]] double tissueWork_mJ(const Vec3& f_D) noexcept;

    haptics::Palpator m_palpator;
    SafetyGate m_gate;
    PassivityController m_passivity;
    WorkspaceMap m_map;
    Vec3 m_sent_D = Vec3::Zero();
    Vec3 m_p_WH = Vec3::Zero(); // last HIP
    double m_away_s = 0.0;      // time without a hand since then, a sum of tick periods; without faults
    bool m_hasBeenHere = false;
    double m_dt_s;
    std::int64_t m_tick = 0;
    std::uint32_t m_generation = 0;
    bool m_isSceneChanged = false;
    double m_tissuePower_mW = 0.0; // of the last tick
    Fault m_fault;
};

} // namespace palpate::servo
