// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/AxisCheck.h"

#include <algorithm>
#include <cmath>

namespace palpate::device {

namespace {

constexpr double kUsualWay_mm = 40.0;
constexpr double kShareOfWorkspace = 0.3;
constexpr double kStill_mm = 2.0; // a hand at rest stays within
constexpr double kStill_s = 0.3;
constexpr double kFollows = 0.766; // cosine of 40 degrees

core::Message nameOfDirection(const Vec3& d_U)
{
    Eigen::Index axis = 0;
    d_U.cwiseAbs().maxCoeff(&axis);
    const bool isPositive = d_U[axis] > 0.0;
    switch (axis) {
    case 0:
        return isPositive ? core::Message(PALPATE_TEXT("to the right")) : core::Message(PALPATE_TEXT("to the left"));
    case 1:
        return isPositive ? core::Message(PALPATE_TEXT("up")) : core::Message(PALPATE_TEXT("down"));
    default:
        return isPositive ? core::Message(PALPATE_TEXT("towards you")) : core::Message(PALPATE_TEXT("away from you"));
    }
}

} // namespace

AxisCheck::AxisCheck(const DeviceInfo& info)
    : m_q_UD(info.q_UD)
    , m_device(info.name)
{
    if (info.workspaceRadius_mm > 0.0) {
        m_way_mm = std::min(kUsualWay_mm, kShareOfWorkspace * info.workspaceRadius_mm);
    }
    m_results[0].asked_U = Vec3::UnitX();
    m_results[1].asked_U = -Vec3::UnitZ();
    m_results[2].asked_U = Vec3::UnitY();
}

void AxisCheck::follow(const DeviceState& state, double time_s)
{
    if (isDone()) {
        return;
    }
    const bool isUsable = state.isPresent && !state.isLost && state.p_D.allFinite();
    if (!isUsable) {
        m_isResting = false;
        m_hasStart = false;
    } else if (!m_isResting || (state.p_D - m_rest_D).norm() > kStill_mm) {
        m_isResting = true;
        m_rest_D = state.p_D;
        m_restSince_s = time_s;
    }
    if (m_began_s == 0.0) {
        m_began_s = time_s;
    }
    const bool isStill = m_isResting && time_s - m_restSince_s >= kStill_s;
    if (isUsable && !m_hasStart && isStill) {
        m_hasStart = true;
        m_start_D = state.p_D;
        m_began_s = time_s;
    }
    const Vec3 moved_mm = m_hasStart ? Vec3(m_q_UD * (state.p_D - m_start_D)) : Vec3(Vec3::Zero());
    if (m_hasStart && isStill && moved_mm.norm() >= m_way_mm) {
        finish(moved_mm, true);
        m_start_D = state.p_D; // the next direction begins where this one ended
        m_began_s = time_s;
    } else if (time_s - m_began_s > kLongest_s) {
        finish(isUsable ? moved_mm : Vec3(Vec3::Zero()), false);
        m_began_s = time_s;
        m_hasStart = false;
    }
}

void AxisCheck::finish(const Vec3& moved_mm, bool hasMoved)
{
    AxisResult& result = m_results[m_next++];
    result.moved_mm = moved_mm;
    if (!hasMoved) {
        result.verdict = AxisVerdict::Unmoved;
        return;
    }
    const Vec3 d_U = moved_mm.normalized();
    const double along = d_U.dot(result.asked_U);
    result.verdict = along >= kFollows                       ? AxisVerdict::Follows
                     : along <= -kFollows                    ? AxisVerdict::Mirrored
                     : d_U.cwiseAbs().maxCoeff() >= kFollows ? AxisVerdict::Swapped
                                                             : AxisVerdict::Oblique;
}

bool AxisCheck::isRight() const noexcept
{
    return std::all_of(m_results.begin(), m_results.end(),
                       [](const AxisResult& r) { return r.verdict == AxisVerdict::Follows; });
}

bool AxisCheck::isMirrored() const noexcept
{
    const bool areMoved = std::none_of(m_results.begin(), m_results.end(), [](const AxisResult& r) {
        return r.verdict == AxisVerdict::Pending || r.verdict == AxisVerdict::Unmoved;
    });
    // Right, away, up is a right-handed frame: right x away = up.
    return areMoved && m_results[0].moved_mm.cross(m_results[1].moved_mm).dot(m_results[2].moved_mm) < 0.0;
}

core::Message AxisCheck::instruction() const
{
    constexpr double kMillimetresPerCentimetre = 10.0;
    const core::Rounded way_cm{m_way_mm / kMillimetresPerCentimetre, 1};
    switch (m_next) {
    case 0:
        return m_hasStart
                   ? core::Message(PALPATE_TEXT("Move the handle %1 cm to your right and hold it there."), way_cm)
                   : core::Message(PALPATE_TEXT("Hold the handle still in the middle of its workspace."));
    case 1:
        return core::Message(PALPATE_TEXT("Move the handle %1 cm away from you and hold it there."), way_cm);
    case 2:
        return core::Message(PALPATE_TEXT("Move the handle %1 cm up and hold it there."), way_cm);
    default:
        return {};
    }
}

core::Message AxisCheck::statement(std::size_t direction) const
{
    const AxisResult& result = m_results.at(direction);
    const core::Message asked = nameOfDirection(result.asked_U);
    const core::Message shown = nameOfDirection(result.moved_mm);
    switch (result.verdict) {
    case AxisVerdict::Pending:
        break;
    case AxisVerdict::Follows:
        return core::Message(PALPATE_TEXT("Asked to move %1: the device follows."), asked);
    case AxisVerdict::Mirrored:
        return core::Message(PALPATE_TEXT("Asked to move %1: the device shows a motion %2. This axis is reversed."),
                             asked, shown);
    case AxisVerdict::Swapped:
        return core::Message(PALPATE_TEXT("Asked to move %1: the device shows a motion %2. This axis is another one."),
                             asked, shown);
    case AxisVerdict::Oblique:
        return core::Message(PALPATE_TEXT("Asked to move %1: the device shows a motion between two axes, mostly %2."),
                             asked, shown);
    case AxisVerdict::Unmoved:
        return core::Message(PALPATE_TEXT("Asked to move %1: no such motion within %2 s."), asked, kLongest_s);
    }
    return {};
}

core::Message AxisCheck::remedy() const
{
    if (!isDone() || isRight()) {
        return {};
    }
    const auto hasVerdict = [this](AxisVerdict verdict) {
        return std::any_of(m_results.begin(), m_results.end(),
                           [verdict](const AxisResult& r) { return r.verdict == verdict; });
    };
    if (hasVerdict(AxisVerdict::Unmoved)) {
        return core::Message(PALPATE_TEXT("Check that %1 is calibrated and that its tooltip in the tool bar reports no "
                                          "problem, then repeat the check."),
                             m_device);
    }
    if (isMirrored()) {
        return core::Message(PALPATE_TEXT("%1 mirrors the motion: an encoder counts backwards. Do not touch with "
                                          "forces. Calibrate the device in its "
                                          "calibration pose; for WoodenHaptics, correct \"variant\" in "
                                          "woodenhaptics.json. Then repeat the check."),
                             m_device);
    }
    return core::Message(
        PALPATE_TEXT("%1 is turned: turn its base so that it faces you, then repeat the check. To align the "
                     "device with the patient instead of the view, use \"Aligned with\" in the "
                     "panel Device."),
        m_device);
}

} // namespace palpate::device
