// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PointerHand.h"

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace {

/// Starts and ends at rest.
double smooth(double x)
{
    return x * x * (3.0 - 2.0 * x);
}

} // namespace

PointerHandSettings settingsForSize(double diagonal_mm)
{
    PointerHandSettings settings;
    if (!(diagonal_mm > 0.0) || !std::isfinite(diagonal_mm)) {
        return settings;
    }
    const double share = std::min(1.0, diagonal_mm / 200.0);
    settings.hover_mm *= share;
    settings.depth_mm *= share;
    settings.step_mm *= share;
    settings.deepest_mm *= share;
    return settings;
}

void PointerHand::setSettings(const PointerHandSettings& settings)
{
    m_settings = settings;
}

void PointerHand::pointAt(const Vec3& eye_W, const Vec3& d_W, const std::optional<Vec3>& surface_W)
{
    std::optional<Vec3> place = surface_W;
    const bool isTouching = m_isDown && m_surface_W.has_value();
    if (isTouching && place) {
        // A step much deeper or nearer than it is wide is the rim of something else, not the slope of what is pressed.
        const Vec3 step = *place - *m_surface_W;
        const double along = step.dot(m_d_W);
        const double across = (step - along * m_d_W).norm();
        if (std::abs(along) > 3.0 * across + m_settings.depth_mm) {
            place.reset();
        }
    }
    if (!place && m_surface_W) {
        // Off the surface the hand stays at the distance it had.
        const double towards = d_W.dot(m_d_W);
        if (towards > 1e-3) {
            place = eye_W + d_W * ((*m_surface_W - eye_W).dot(m_d_W) / towards);
        }
    }
    if (place) {
        m_surface_W = place;
    }
    m_d_W = d_W;
}

void PointerHand::goAway()
{
    m_surface_W.reset();
    m_isDown = false;
    m_isLanded = false;
    m_atChange = 0.0;
    m_change_s = 0.0;
}

void PointerHand::press(double now_s)
{
    if (!m_isDown && m_surface_W) {
        m_isLanded = m_isLanded && phase(now_s) == Phase::Lifting;
        m_atChange = pressed(now_s);
        m_change_s = now_s;
        m_isDown = true;
    }
}

void PointerHand::release(double now_s)
{
    if (m_isDown) {
        m_atChange = pressed(now_s);
        m_change_s = now_s;
        m_isDown = false;
    }
}

void PointerHand::land(double now_s)
{
    if (m_isDown && !m_isLanded) {
        m_isLanded = true;
        m_change_s = now_s;
    }
}

void PointerHand::turnDepth(double steps)
{
    m_settings.depth_mm = std::clamp(m_settings.depth_mm + steps * m_settings.step_mm, 0.0, m_settings.deepest_mm);
}

double PointerHand::pressed(double now_s) const
{
    if (m_isDown && !m_isLanded) {
        return m_atChange;
    }
    const double since = std::max(0.0, now_s - m_change_s);
    return m_isDown ? std::min(1.0, m_atChange + since / m_settings.pressTime_s)
                    : std::max(0.0, m_atChange - since / m_settings.liftTime_s);
}

PointerHand::Phase PointerHand::phase(double now_s) const
{
    if (!m_surface_W) {
        return Phase::Away;
    }
    if (m_isDown) {
        return Phase::Pressing;
    }
    return pressed(now_s) > 0.0 ? Phase::Lifting : Phase::Hovering;
}

bool PointerHand::isMoving(double now_s) const
{
    const Phase now = phase(now_s);
    return now == Phase::Lifting || (now == Phase::Pressing && pressed(now_s) < 1.0);
}

std::optional<Vec3> PointerHand::hip(double now_s) const
{
    if (!m_surface_W) {
        return std::nullopt;
    }
    const double in = smooth(pressed(now_s));
    return *m_surface_W + m_d_W * ((1.0 - in) * -m_settings.hover_mm + in * m_settings.depth_mm);
}

device::DeviceState PointerHand::state(double now_s, std::int64_t time_ns) const
{
    device::DeviceState state;
    const Phase now = phase(now_s);
    state.time_ns = time_ns;
    state.isPresent = now == Phase::Pressing || now == Phase::Lifting;
    state.buttons = now == Phase::Pressing ? 1 : 0;
    if (const auto p_W = hip(now_s)) {
        state.p_D = *p_W;
    }
    return state;
}

} // namespace palpate::ui
