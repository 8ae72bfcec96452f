// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/Fault.h"

namespace palpate::servo {

core::Message text(FaultKind kind)
{
    switch (kind) {
    case FaultKind::None:
        return {};
    case FaultKind::NonFiniteInput:
        return core::Message(
            PALPATE_TEXT("The device gave a position that is not a number. Check its driver, then re-arm."));
    case FaultKind::OutOfWorkspace:
        return core::Message(
            PALPATE_TEXT("The device gave positions outside its workspace. Calibrate it, then re-arm."));
    case FaultKind::InputJump:
        return core::Message(PALPATE_TEXT("The device's position jumped farther than a hand can move. Check its cable "
                                          "and calibration, then re-arm."));
    case FaultKind::StaleInput:
        return core::Message(
            PALPATE_TEXT("The device stopped giving new positions. Check its connection, then re-arm."));
    case FaultKind::DeviceLost:
        return core::Message(PALPATE_TEXT("The device no longer answers. Plug it in again, then re-arm."));
    case FaultKind::NonFiniteForce:
        return core::Message(
            PALPATE_TEXT("The model gave a force that is not a number. Leave the surface, then re-arm."));
    case FaultKind::OverrunRun:
        return core::Message(PALPATE_TEXT(
            "The computer could not keep the servo rate. Close other programs or lower the rate, then re-arm."));
    case FaultKind::LoopFailed:
        return core::Message(PALPATE_TEXT("The servo thread ended by an error. Start the device again."));
    }
    return {};
}

} // namespace palpate::servo
