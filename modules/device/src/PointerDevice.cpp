// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/PointerDevice.h"

#include "palpate/device/DevicePresets.h"

namespace palpate::device {

Vec3 PointerDevice::newestForce() noexcept PALPATE_NONBLOCKING
{
    m_force.fetch();
    return m_force.value().get();
}

DeviceInfo PointerDevice::info() const
{
    DeviceInfo info;
    info.id = "mouse";
    info.name = "Mouse";
    info.buttons = 3;
    info.maxForce_N = kShownForceLimit_N;
    return info;
}

core::Status PointerDevice::start()
{
    return {};
}

void PointerDevice::stop() noexcept {}

DeviceState PointerDevice::read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    m_state.fetch();
    const PointerState pointer = m_state.value().get();
    DeviceState state = pointer;
    state.time_ns = now_ns;
    const bool isDown = (pointer.buttons & 1U) != 0;
    if (!pointer.isPresent || (!isDown && !m_isHandHere && pointer.hover_mm > 0.0)) {
        m_isHandHere = state.isPresent = false;
        return state;
    }
    if (!m_isHandHere) {
        m_depth.rest(-pointer.hover_mm);
        m_isHandHere = true;
    }
    if (const double to = isDown ? pointer.depth_mm : -pointer.hover_mm; to != m_depth.target()) {
        double over_s = isDown ? pointer.pressTime_s : pointer.liftTime_s;
        const double way_mm = to - m_depth.at(now_ns);
        if (pointer.pressSpeed_mm_per_s > 0.0 && way_mm > pointer.easeThreshold_mm) {
            over_s += (way_mm - pointer.easeThreshold_mm) / pointer.pressSpeed_mm_per_s;
        }
        m_depth.aim(to, over_s, now_ns);
    }
    state.p_D += m_depth.at(now_ns) * pointer.d_D;
    if (!isDown && pointer.hover_mm > 0.0 && m_depth.isThere(now_ns)) {
        m_isHandHere = false; // absent from the next tick on
    }
    return state;
}

void PointerDevice::write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_force.write(PlainCopy<Vec3>(f_D));
}

} // namespace palpate::device
