// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TouchPlace.h"

#include <algorithm>
#include <cmath>

namespace palpate::session {

using core::Vec3;

TouchPlace::TouchPlace(const haptics::TickResult& felt, const haptics::Contact& contact)
    : m_p_W(felt.touched_W(contact))
    , m_centre_W(contact.p_WG)
    , m_radius_mm(felt.fingertip_mm)
{
}

bool TouchPlace::isFinite() const noexcept
{
    return m_p_W.allFinite() && m_centre_W.allFinite();
}

double TouchPlace::squaredDistance_mm2(const Vec3& p_W) const noexcept
{
    const double away_mm2 = (p_W - m_p_W).squaredNorm();
    if (m_radius_mm == 0.0) {
        return away_mm2;
    }
    // A ball with room keeps its radius and a skin from every point in front of it, so that none is inside.
    const Vec3 from_W = p_W - m_centre_W;
    const double fromCentre_mm2 = from_W.squaredNorm();
    if (fromCentre_mm2 >= m_radius_mm * m_radius_mm) {
        return away_mm2;
    }
    const Vec3 line_W = m_p_W - m_centre_W;
    const double length_mm2 = line_W.squaredNorm();
    const double share = length_mm2 > 0.0 ? std::clamp(from_W.dot(line_W) / length_mm2, 0.0, 1.0) : 0.0;
    return (from_W - share * line_W).squaredNorm();
}

bool TouchPlace::reaches(const Vec3& p_W, double distance_mm) const noexcept
{
    return std::sqrt(squaredDistance_mm2(p_W)) <= distance_mm;
}

} // namespace palpate::session
