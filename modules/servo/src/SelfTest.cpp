// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/SelfTest.h"

#include "SelfTestSteps.h"

namespace palpate::servo {

core::Message instruction(SelfTestStep step)
{
    switch (step) {
    case SelfTestStep::Wait:
        return core::Message(
            PALPATE_TEXT("Put the handle into the middle of its workspace and let go of it. If it does "
                         "not stay there by itself, hold it still."));
    case SelfTestStep::Rest:
    case SelfTestStep::Friction:
    case SelfTestStep::RoundTrip:
        return core::Message(PALPATE_TEXT("Do not touch the handle. Small forces move it."));
    case SelfTestStep::Hand:
        return core::Message(
            PALPATE_TEXT("Now hold the handle like a pen, in the middle of its workspace, and keep it there."));
    case SelfTestStep::Walls:
    case SelfTestStep::ControlledWalls:
        return core::Message(PALPATE_TEXT(
            "Keep your hand in its place. A wall comes towards you, gives way a little and stops, and is a "
            "little stiffer each time."));
    case SelfTestStep::Done:
        break;
    }
    return {};
}

core::Message text(SelfTestStop stop)
{
    switch (stop) {
    case SelfTestStop::None:
    case SelfTestStop::Fault:
        return {};
    case SelfTestStop::Cancelled:
        return core::Message(PALPATE_TEXT("The test was stopped."));
    case SelfTestStop::NoPosition:
        return core::Message(
            PALPATE_TEXT("The device gave no position inside of its workspace. Put the handle into the "
                         "middle of the workspace, calibrate the device if it needs to be, and "
                         "start the test again."));
    case SelfTestStop::NoMotors:
        return core::Message(PALPATE_TEXT("The device has no motors, so that only the position at rest was tested."));
    case SelfTestStop::NoResponse:
        return core::Message(
            PALPATE_TEXT("The position did not clearly follow the force. Check that the motors have power "
                         "and that forces are switched on, and start the test again without a hand "
                         "at the handle until the test asks for one."));
    case SelfTestStop::Reversed:
        return core::Message(PALPATE_TEXT("The handle moved against the force: an axis or a motor is reversed. Do not "
                                          "touch with this device until the settings of its driver are corrected."));
    case SelfTestStop::NoHand:
        return core::Message(PALPATE_TEXT("Nobody held the handle, so that no wall was tested. Start the test again "
                                          "and hold the handle when asked."));
    case SelfTestStop::LetGo:
        return core::Message(PALPATE_TEXT(
            "The hand gave way or let go of the handle. Start the test again and keep the hand in its place."));
    case SelfTestStop::OutOfTime:
        return core::Message(PALPATE_TEXT("The test took too long and was stopped."));
    }
    return {};
}

SelfTest::SelfTest(const device::DeviceInfo& info, const SelfTestOptions& options)
    : m_steps(std::make_unique<SelfTestSteps>(info, options))
{
}

SelfTest::~SelfTest() = default;

Vec3 SelfTest::tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    return m_steps->tick(state, now_ns);
}

void SelfTest::noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING
{
    m_steps->noteOverrun(isOverrun);
}

void SelfTest::setDelay(int ticks) noexcept PALPATE_NONBLOCKING
{
    m_steps->setDelay(ticks);
}

void SelfTest::stop(SelfTestStop why) noexcept PALPATE_NONBLOCKING
{
    m_steps->stop(why);
}

const SelfTestRecord& SelfTest::record() const noexcept
{
    return m_steps->record();
}

bool SelfTest::isFinished() const noexcept
{
    return m_steps->isFinished();
}

double SelfTest::progress() const noexcept
{
    return m_steps->progress();
}

} // namespace palpate::servo
