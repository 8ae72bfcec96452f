// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/PassivityController.h"
#include "palpate/servo/SafetyGate.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/device/HapticDevice.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::servo {

/// Steps of a self-test, in order.
enum class SelfTestStep : std::uint8_t
{
    Wait,            ///< for a position inside of the workspace
    Rest,            ///< no force: noise, resolution, rate of the device
    Friction,        ///< slow ramps of the force until the handle moves
    RoundTrip,       ///< short pulses of the force
    Hand,            ///< for a hand at the handle
    Walls,           ///< without the passivity controller
    ControlledWalls, ///< with it, as in the window
    Done,
};
/// @return instruction for the user; empty for Done
[[nodiscard]] PALPATE_EXPORT core::Message instruction(SelfTestStep step);

/// What ended a self-test, or a part of it.
enum class SelfTestStop : std::uint8_t
{
    None,
    Cancelled,  ///< the user stopped the test
    Fault,      ///< SelfTest::fault
    NoPosition, ///< no position inside of the workspace
    NoMotors,   ///< nothing but rest can be tested
    NoResponse, ///< the position does not clearly follow the force
    Reversed,   ///< the position moves against the force: a wall would be unstable
    NoHand,     ///< nobody held the handle
    LetGo,      ///< the hand let go in front of a wall
    OutOfTime,  ///< longer than SelfTestOptions::longest_s
};
/// @return cause and remedy, for the user; empty for None and Fault
[[nodiscard]] PALPATE_EXPORT core::Message text(SelfTestStop stop);

struct SelfTestOptions
{
    double rate_Hz = 1000.0;
    double lead_s = 3.0;       ///< time to follow an instruction
    double handTimeout_s = 12; ///< time to take the handle
    double longest_s = 150.0;  ///< the force is removed then
    int pulses = 100;          ///< of the round trip, 40 to kMostPulses
    double stiffest_N_per_mm = 25.0;
    static constexpr int kMostPulses = 200;
};

/// Largest force of a self-test on this device: 2.5 times the resting force of the walls [N]
[[nodiscard]] PALPATE_EXPORT double mostTestForce_N(const device::DeviceInfo& info) noexcept;

/// One tick of a test.
struct SelfTestSample
{
    double time_s = 0.0;     ///< of the tick, from the start of the test
    double measured_s = 0.0; ///< of the measurement of the device
    Vec3 p_D = Vec3::Zero(); ///< position [mm]
    double force_N = 0.0;    ///< sent, along the direction of the test
    SelfTestStep step = SelfTestStep::Wait;
    std::uint16_t part = 0; ///< number of the ramp, pulse or wall within the step, from 1; 0: between them
};

/// One wall that was pressed against the hand.
struct SelfTestWall
{
    double stiffness_N_per_mm = 0.0;
    double press_N = 0.0;   ///< force at rest before the wall fell back
    double swing_mm = 0.0;  ///< peak to peak at the end
    double settled_s = 0.0; ///< time from the fall until the tip rested, or until the wall was withdrawn
    bool isControlled = false;
    bool isHeld = false;
};

/// One break-away of the handle.
struct SelfTestRamp
{
    double force_N = 0.0; ///< signed; at the bound if the handle did not move
    bool hasMoved = false;
};

/// What is known about a test besides its samples.
struct SelfTestFacts
{
    device::DeviceInfo device;
    double rate_Hz = 0.0; ///< nominal
    double press_N = 0.0; ///< resting force of the walls
    int delayTicks = 1;   ///< of the driver, as known to the passivity controller
    std::uint64_t overruns = 0;
    SelfTestStop stopped = SelfTestStop::None; ///< why the test ended early; None: all steps were done
    FaultKind fault = FaultKind::None;
    SelfTestStep lastStep = SelfTestStep::Done; ///< in which the test ended
    std::vector<SelfTestRamp> ramps;
    std::vector<SelfTestWall> walls;
};

/// All that a test has recorded so far.
struct SelfTestRecord : SelfTestFacts
{
    Vec3 u_D = Vec3::UnitZ(); ///< direction of the forces, unit
    SelfTestStep step = SelfTestStep::Wait;
    std::vector<SelfTestSample> samples;
};

class SelfTestSteps;

/// Self-test of a device: measures noise, resolution, rate, friction, round trip and the stiffness of a wall that the
/// device and the hand of the user hold without oscillation. One tick without thread, clock or device, like ServoCore;
/// SelfTestRun runs it.
///
/// The direction of all forces is the user's z axis, towards the user. The wall comes to the hand: it advances at
/// 30 mm/s until it presses with the resting force (3 N, or 40 % of the device's maximum), falls back by up to 3 mm,
/// and the hand falls onto it. The wall is held if the tip then comes to rest. The stiffness rises by 40 % per
/// wall. At the first sign of instability - a swing that grows, exceeds 10 mm, or has not settled 1 s after the fall -
/// the wall is withdrawn; no stiffer one is tried, only softer ones to narrow the result to 6 %.
///
/// Force: at most 2.5 times the resting force and the maximum of the device, within the rate and power bounds of the
/// SafetyGate, zero without a hand, after a fault and at the end. Ramps and pulses are at most 1 N above the friction
/// and a fifth of the maximum. A test presses no wall against a handle that does not clearly follow the pulses, moves
/// against them, or is not held.
/// @par Real-time `tick` is wait-free and allocates nothing. One thread.
class PALPATE_EXPORT SelfTest
{
  public:
    explicit SelfTest(const device::DeviceInfo& info, const SelfTestOptions& options = {});
    ~SelfTest();
    SelfTest(const SelfTest&) = delete;
    SelfTest& operator=(const SelfTest&) = delete;

    /// @return force for the device in frame D [N]
    [[nodiscard]] Vec3 tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// Reports whether the last tick ended late.
    void noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING;
    /// Sets the delay of the device's force, see PassivityController::setDelay.
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING;
    /// Ramps the force to zero and ends the test.
    void stop(SelfTestStop why) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const SelfTestRecord& record() const noexcept;
    /// The test has ended and the force is zero.
    [[nodiscard]] bool isFinished() const noexcept;
    /// Elapsed share of the test, 0 to 1, an estimate.
    [[nodiscard]] double progress() const noexcept;

  private:
    std::unique_ptr<SelfTestSteps> m_steps;
};

} // namespace palpate::servo
