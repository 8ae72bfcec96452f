// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PointerHand.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace palpate::ui {

PointerHandSettings settingsForSize(double diagonal_mm)
{
    PointerHandSettings settings;
    if (!(diagonal_mm > 0.0) || !std::isfinite(diagonal_mm)) {
        return settings;
    }
    // Lengths and speed scale with the scene up to 200 mm; the durations stay the same.
    const double share = std::min(1.0, diagonal_mm / 200.0);
    settings.hover_mm *= share;
    settings.depth_mm *= share;
    settings.step_mm *= share;
    settings.easeThreshold_mm *= share;
    settings.pressSpeed_mm_per_s *= share;
    settings.stride_mm *= share;
    settings.deepest_mm = diagonal_mm;
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
        // A step much longer along the line of sight than across indicates the rim of another structure, not the slope
        // of the pressed surface.
        const Vec3 step = *place - *m_surface_W;
        const double along = step.dot(m_d_W);
        const double across = (step - along * m_d_W).norm();
        if (std::abs(along) > 3.0 * across + std::max(0.0, m_aim_mm.value_or(m_settings.depth_mm))) {
            place.reset();
        }
    }
    if (!place && m_surface_W) {
        // Beyond the surface the hand stays in the depth plane.
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
    m_release_s = -1.0;
}

void PointerHand::press()
{
    m_isDown = m_surface_W.has_value();
}

void PointerHand::release(double now_s)
{
    if (m_isDown) {
        m_isDown = false;
        m_release_s = now_s;
    }
}

bool PointerHand::setDepth(double depth_mm)
{
    m_settings.depth_mm = std::clamp(depth_mm, 0.0, m_settings.deepest_mm);
    return m_settings.depth_mm == depth_mm;
}

bool PointerHand::turnDepth(double notches)
{
    // Depths in steps, and the number of steps per notch from there on.
    constexpr std::pair<double, double> kNotches[] = {{0.0, 1.0}, {20.0, 2.0}, {40.0, 4.0}, {100.0, 10.0}};
    constexpr double kRounding = 1e-9; // in steps
    double depth = m_settings.depth_mm / m_settings.step_mm;
    const bool isDeeper = notches > 0.0;
    double left = std::abs(notches);
    if (isDeeper) {
        for (std::size_t i = 0; i < std::size(kNotches) && left > 0.0; ++i) {
            const bool isLast = i + 1 == std::size(kNotches);
            const double end = isLast ? std::numeric_limits<double>::infinity() : kNotches[i + 1].first;
            if (depth < end - kRounding) {
                const double used = std::min(left, (end - depth) / kNotches[i].second);
                depth += used * kNotches[i].second;
                left -= used;
            }
        }
    } else {
        for (std::size_t i = std::size(kNotches); i-- > 0 && left > 0.0;) {
            const double end = i == 0 ? -std::numeric_limits<double>::infinity() : kNotches[i].first;
            if (depth > end + kRounding) {
                const double used = std::min(left, (depth - end) / kNotches[i].second);
                depth -= used * kNotches[i].second;
                left -= used;
            }
        }
    }
    return setDepth(depth * m_settings.step_mm);
}

bool PointerHand::stepDepth(int steps)
{
    return setDepth(m_settings.depth_mm + steps * m_settings.step_mm);
}

void PointerHand::setAim(std::optional<double> depth_mm)
{
    m_aim_mm = depth_mm;
    if (m_aim_mm) {
        m_aim_mm = std::clamp(*m_aim_mm, -m_settings.hover_mm, m_settings.deepest_mm);
    }
}

double PointerHand::pressedDepth_mm(const Vec3& p_W) const
{
    return m_surface_W ? (p_W - *m_surface_W).dot(m_d_W) : 0.0;
}

PointerHand::Phase PointerHand::phase(double now_s) const
{
    if (!m_surface_W) {
        return Phase::Away;
    }
    if (m_isDown) {
        return Phase::Pressing;
    }
    const bool isLifting = m_release_s >= 0.0 && now_s < m_release_s + m_settings.liftTime_s;
    return isLifting ? Phase::Lifting : Phase::Hovering;
}

std::optional<Vec3> PointerHand::hoverPoint() const
{
    return m_surface_W ? std::optional<Vec3>(*m_surface_W - m_settings.hover_mm * m_d_W) : std::nullopt;
}

device::PointerState PointerHand::state(double now_s) const
{
    device::PointerState state;
    const Phase now = phase(now_s);
    state.isPresent = now == Phase::Pressing || now == Phase::Lifting;
    state.buttons = now == Phase::Pressing ? 1 : 0;
    state.p_D = m_surface_W.value_or(Vec3::Zero());
    state.d_D = m_d_W;
    state.depth_mm = m_aim_mm.value_or(m_settings.depth_mm);
    state.hover_mm = m_settings.hover_mm;
    state.pressTime_s = m_settings.pressTime_s;
    state.easeThreshold_mm = m_settings.easeThreshold_mm;
    state.pressSpeed_mm_per_s = m_settings.pressSpeed_mm_per_s;
    state.liftTime_s = m_settings.liftTime_s;
    return state;
}

} // namespace palpate::ui
