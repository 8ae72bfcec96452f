// SPDX-License-Identifier: BSD-3-Clause
#include "law/Friction.h"

#include "law/MapValue.h"

#include <algorithm>

namespace palpate::haptics::internal {

void CoulombFriction::press(const Facet& facet, const Vec3& foot, double lambda_mm) noexcept
{
    const HapticStructure& on = m_layer.frictional[facet.structure];
    const std::array<Vec3, 3> corners{facet.a, facet.b, facet.c};
    const TissueMap& scale = on.maps.friction;
    const double by = scale.isEmpty() ? 1.0 : law::MapPlace(facet.triangle, corners, foot).risesOf(scale).value;
    double atRest = by * on.tissue.friction_static, sliding = by * on.tissue.friction_dynamic;
    double k = on.tissue.stiffness_N_per_mm;
    if (on.law != nullptr || !on.maps.stiffness.isEmpty()) {
        const ForceTable::Value law = on.lawAt(lambda_mm);
        k = lambda_mm > 0.0 ? law.force_N / lambda_mm : k;
        if (!on.maps.stiffness.isEmpty()) {
            // A stiffness that varies pulls the foot along the surface by (W/F) |grad ln s|, times the push. Friction
            // of that size takes all the energy that leaving this pull out of the force could make.
            const law::MapValue s = law::MapPlace(facet.triangle, corners, foot).valueOf(on.maps.stiffness);
            const double least = law.force_N > 0.0 ? law.energy_mJ / law.force_N * s.gradient.norm() / s.value : 0.0;
            atRest = std::max(atRest, least);
            sliding = std::max(sliding, least);
            k *= s.value;
        }
    }
    m_still_mm += atRest * lambda_mm;
    m_sliding_mm += sliding * lambda_mm;
    m_drag = std::max(m_drag, on.tissue.friction_drag_Ns_per_mm);
    m_stiffest = std::max(m_stiffest, k);
}

double CoulombFriction::share(double r_mm, double rounding_mm) noexcept
{
    m_lastSlid = false;
    if (!m_slides) {
        if (r_mm <= m_still_mm + rounding_mm) {
            return 0.0;
        }
        m_slides = true;
    }
    if (r_mm <= m_sliding_mm + rounding_mm) {
        m_slides = !(r_mm < kCaught * m_sliding_mm);
        return 0.0;
    }
    if (!m_isBehind) {
        // k (r' - R) = (c/dt) (r - r'): what lags behind, by the implicit Euler step, once a tick.
        m_isBehind = true;
        const double c = m_drag / m_dt_s;
        m_behind_mm = m_drag > 0.0 && m_dt_s > 0.0 ? (r_mm - m_sliding_mm) * (c / (m_stiffest + c)) : 0.0;
    }
    const double share = std::max(0.0, 1.0 - (m_sliding_mm + m_behind_mm) / r_mm);
    m_lastSlid = share > 0.0;
    return share;
}

} // namespace palpate::haptics::internal
