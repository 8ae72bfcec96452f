// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/WorkspaceMap.h"

#include <algorithm>
#include <cmath>

namespace palpate::servo {

namespace {

constexpr double kSmallestScale = 1e-6;
constexpr double kLargestScale = 1e6;
constexpr double kReleaseShare = 0.5; // fraction of the edge distance at which the edge clutch releases

bool isUsable(const MapSettings& settings) noexcept
{
    constexpr double kUnit = 1e-6;
    return settings.scale >= kSmallestScale && settings.scale <= kLargestScale && settings.centre_W.allFinite() &&
           std::isfinite(settings.edge_mm) && std::abs(settings.q_WD.norm() - 1.0) < kUnit;
}

} // namespace

void WorkspaceMap::set(const MapSettings& settings) noexcept PALPATE_NONBLOCKING
{
    if (settings.isDirect || isUsable(settings)) {
        m_asked = settings;
    }
}

MappedInput WorkspaceMap::map(const GatedInput& input, std::uint32_t buttons) noexcept PALPATE_NONBLOCKING
{
    MappedInput out;
    const Vec3& p_D = input.p_D;
    if (m_asked.isDirect) {
        out.isMoved = input.isFirst || !m_used.isDirect;
        m_used = m_asked;
        m_isPlaced = false;
        m_isClutched = false;
        m_isAtEdge = false;
        out.p_W = p_D;
        return out;
    }
    const bool isCentring = !m_isPlaced || m_used.isDirect || m_asked.centreRequest != m_used.centreRequest;
    // With a hand, a change of scale or orientation keeps the HIP of the previous tick.
    const bool isTurned = m_asked.scale != m_used.scale || m_asked.q_WD.coeffs() != m_used.q_WD.coeffs();
    if (isCentring) {
        m_used = m_asked;
        m_R_WD = m_asked.q_WD.toRotationMatrix();
        m_isPlaced = true;
        m_isClutched = false;
        m_isAtEdge = false;
        m_wasInside = false;
        anchor(Vec3::Zero(), m_asked.centre_W);
    } else {
        if (isTurned && !m_isClutched) {
            anchor(p_D, placed(p_D));
        }
        m_used = m_asked;
        m_R_WD = m_asked.q_WD.toRotationMatrix();
    }
    out.isMoved = input.isFirst || isCentring;

    const double reach_mm = p_D.norm();
    if (m_asked.edge_mm > 0.0) {
        m_wasInside = m_wasInside || reach_mm <= m_asked.edge_mm;
        m_isAtEdge =
            m_wasInside && (reach_mm > m_asked.edge_mm || (m_isAtEdge && reach_mm > kReleaseShare * m_asked.edge_mm));
    } else {
        m_isAtEdge = false;
    }
    const bool isClutched = m_isAtEdge || m_asked.isClutched || (buttons & m_asked.clutchButtons) != 0;
    if (isClutched && !m_isClutched) {
        m_p_W = placed(p_D);
    } else if (!isClutched && m_isClutched) {
        anchor(p_D, m_p_W);
        out.isReleased = true;
    }
    m_isClutched = isClutched;
    if (!isClutched) {
        m_p_W = placed(p_D);
    }
    out.p_W = m_p_W;
    out.isClutched = isClutched;
    out.isAtEdge = m_isAtEdge;
    return out;
}

Vec3 WorkspaceMap::toDevice(const Vec3& f_W) const noexcept PALPATE_NONBLOCKING
{
    return m_used.isDirect ? f_W : Vec3(m_R_WD.transpose() * f_W);
}

Vec3 WorkspaceMap::toScene(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING
{
    return m_used.isDirect ? f_D : Vec3(m_R_WD * f_D);
}

Vec3 WorkspaceMap::placed(const Vec3& p_D) const noexcept
{
    return m_a_W + m_used.scale * (m_R_WD * (p_D - m_a_D));
}

void WorkspaceMap::anchor(const Vec3& p_D, const Vec3& p_W) noexcept
{
    m_a_D = p_D;
    m_a_W = p_W;
}

double scaleToFill(double size_mm, double edge_mm) noexcept
{
    const double scale = 0.5 * size_mm / edge_mm;
    return std::isfinite(scale) ? std::clamp(scale, kSmallestScale, kLargestScale) : 1.0;
}

double edgeOf(const device::DeviceInfo& info) noexcept
{
    constexpr double kShare = 0.9;
    return kShare * std::max(0.0, info.workspaceRadius_mm);
}

} // namespace palpate::servo
