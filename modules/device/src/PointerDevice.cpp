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
    DeviceState state = m_state.value().get();
    state.time_ns = now_ns;
    return state;
}

void PointerDevice::write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_force.write(PlainCopy<Vec3>(f_D));
}

} // namespace palpate::device
