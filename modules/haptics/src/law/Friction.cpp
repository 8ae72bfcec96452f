// SPDX-License-Identifier: BSD-3-Clause
#include "law/Friction.h"

#include "law/MapSample.h"
#include "law/Transmission.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate::haptics::internal {

namespace {

constexpr double kSliver = 1e-6; // squared sine of a triangle's angle below which the area is inaccurate

/// Returns true if |grad ln s| is at most `most_per_mm` on the whole facet; also returns false if the corner values do
/// not decide.
bool isGentle(const TissueMap& map, const Facet& facet, double most_per_mm) noexcept
{
    if (map.bendsOn(facet.triangle)) {
        return false;
    }
    const std::array<float, 3>& at = (*map.corners)[facet.triangle];
    const double d1 = double{at[1]} - double{at[0]}, d2 = double{at[2]} - double{at[0]};
    const Vec3 e1 = facet.b - facet.a, e2 = facet.c - facet.a;
    const double e11 = e1.squaredNorm(), e12 = e1.dot(e2), e22 = e2.squaredNorm();
    const double area2 = e11 * e22 - e12 * e12;                               // squared double area
    const double rise2 = d1 * d1 * e22 - 2.0 * d1 * d2 * e12 + d2 * d2 * e11; // |grad s|^2 times area2
    const double most = most_per_mm * double{std::min({at[0], at[1], at[2]})};
    return area2 > kSliver * e11 * e22 && rise2 <= most * most * area2;
}

/// The same test for transmission maps (buried lumps). Their lateral pull is `sum W_j grad s_j`, their push `F sum s_j
/// B_j(d)`. The W_j add up to W <= d F, so the pull is at most the maximum of |grad s_j| times W, and the push at least
/// the minimum of s_j times F.
bool areGentle(const std::array<TissueMap, kFeltPress_mm.size()>& felt, const Facet& facet, double most_per_mm) noexcept
{
    constexpr double kSure = 0.999; // margin for rounding
    const Vec3 e1 = facet.b - facet.a, e2 = facet.c - facet.a;
    const double e11 = e1.squaredNorm(), e12 = e1.dot(e2), e22 = e2.squaredNorm();
    const double area2 = e11 * e22 - e12 * e12;
    double rise2 = 0.0, least = std::numeric_limits<double>::max();
    for (const TissueMap& map : felt) {
        if (map.bendsOn(facet.triangle)) {
            return false;
        }
        const std::array<float, 3>& at = (*map.corners)[facet.triangle];
        const double d1 = map.factor * (double{at[1]} - double{at[0]}),
                     d2 = map.factor * (double{at[2]} - double{at[0]});
        rise2 = std::max(rise2, d1 * d1 * e22 - 2.0 * d1 * d2 * e12 + d2 * d2 * e11);
        least = std::min(least, map.factor * double{std::min({at[0], at[1], at[2]})});
    }
    const double most = kSure * most_per_mm * least;
    return area2 > kSliver * e11 * e22 && rise2 <= most * most * area2;
}

/// Returns the secant stiffness, force divided by depth, including all maps [N/mm]; approximately the limit at depth 0.
double stiffnessAt(const HapticStructure& on, const Facet& facet, const Vec3& foot, double depth_mm) noexcept
{
    const bool isPressed = depth_mm > 0.0, hasFelt = on.maps.hasFelt();
    const TissueMap& map = on.maps.stiffness;
    const ForceTable::Value law = isPressed ? on.lawAt(depth_mm) : ForceTable::Value{};
    const double k = isPressed ? law.force_N / depth_mm : on.tissue.stiffness_N_per_mm;
    if (map.isEmpty() && !hasFelt) {
        return k;
    }
    const law::MapPlace place(facet, foot);
    double s = map.isEmpty() ? 1.0 : place.risesOf(map).value;
    if (hasFelt) {
        s *= isPressed ? law::Transmission::scaleAt(place, on, depth_mm) : place.risesOf(on.maps.felt[0]).value;
    }
    return s * k;
}

} // namespace

void CoulombFriction::press(const Facet& facet, const Vec3& foot, double lambda_mm) noexcept
{
    const HapticStructure& on = m_layer.frictional[facet.structure];
    double atRest = on.tissue.friction_static, sliding = on.tissue.friction_dynamic;
    if (!on.maps.friction.isEmpty()) {
        const double by = law::MapPlace(facet, foot).risesOf(on.maps.friction).value;
        atRest *= by;
        sliding *= by;
    }
    const bool varies = !on.maps.stiffness.isEmpty() || on.maps.hasFelt();
    if (varies && on.tissue.hasFriction()) { // without friction, the force itself contains this pull
        raise(on, facet, foot, lambda_mm, atRest, sliding);
    }
    m_now.still_mm += atRest * lambda_mm;
    m_now.sliding_mm += sliding * lambda_mm;
    if (m_layer.drags) {
        m_now.drag = std::max(m_now.drag, on.tissue.friction_drag_Ns_per_mm);
        m_now.stiffest = std::max(m_now.stiffest, stiffnessAt(on, facet, foot, lambda_mm));
    }
    if (m_layer.structures.size() > 1) {
        share(facet, foot, lambda_mm, atRest, sliding);
    }
}

/// Weights the contacts by their forces if they belong to several structures.
void CoulombFriction::share(const Facet& facet, const Vec3& foot, double lambda_mm, double atRest,
                            double sliding) noexcept
{
    if (!(lambda_mm > 0.0) || m_pressedCount == m_pressed.size()) {
        return;
    }
    m_pressed[m_pressedCount++] = {&facet, foot, lambda_mm, atRest, sliding};
    const std::span<const Pressed> pressed = std::span(m_pressed).first(m_pressedCount);
    if (std::all_of(pressed.begin(), pressed.end(),
                    [&](const Pressed& one) { return one.facet->structure == facet.structure; })) {
        return;
    }
    double lambda = 0.0, force_N = 0.0, still_N = 0.0, sliding_N = 0.0, drag = 0.0;
    for (const Pressed& one : pressed) {
        const HapticStructure& on = m_layer.frictional[one.facet->structure];
        const double own_N = stiffnessAt(on, *one.facet, one.foot, one.lambda_mm) * one.lambda_mm;
        lambda += one.lambda_mm;
        force_N += own_N;
        still_N += one.atRest * own_N;
        sliding_N += one.sliding * own_N;
        drag += on.tissue.friction_drag_Ns_per_mm * one.lambda_mm;
    }
    if (force_N > 0.0) {
        m_now.still_mm = lambda * (still_N / force_N);
        m_now.sliding_mm = lambda * (sliding_N / force_N);
        m_now.drag = drag / lambda;
        m_now.stiffest = force_N / lambda;
    }
}

/// Raises the friction limit where the stiffness varies, by a map or by buried lumps. The gradient pulls the foot along
/// the surface by |grad_x U| / (dU/dd) times the push, which is (W/F) |grad ln s| for a map alone. Friction of this
/// size dissipates all the energy that could be generated by omitting the pull from the force.
void CoulombFriction::raise(const HapticStructure& on, const Facet& facet, const Vec3& foot, double lambda_mm,
                            double& atRest, double& sliding) const noexcept
{
    const TissueMap& map = on.maps.stiffness;
    if (!(lambda_mm > 0.0)) {
        return; // no contact pressure
    }
    // W <= lambda F for a monotonic law: in most places this simple bound already proves that friction suffices.
    if (!on.maps.hasFelt() && on.isMonotonic() && isGentle(map, facet, std::min(atRest, sliding) / lambda_mm)) {
        return;
    }
    if (on.maps.hasFelt() && map.isEmpty() && on.isMonotonic() &&
        areGentle(on.maps.felt, facet, std::min(atRest, sliding) / lambda_mm)) {
        return;
    }
    const ForceTable::Value law = on.lawAt(lambda_mm);
    const law::MapPlace place(facet, foot);
    const law::MapSample s = map.isEmpty() ? law::MapSample{} : place.valueOf(map);
    double push_N = s.value * law.force_N;
    Vec3 pull_N = law.energy_mJ * s.gradient;
    if (on.maps.hasFelt()) {
        const law::Transmission felt = law::Transmission::at(place, on, lambda_mm, law);
        push_N *= felt.scale;
        pull_N = s.value * felt.gradient + felt.energy_mJ * s.gradient;
    }
    const double least = push_N > 0.0 ? pull_N.norm() / push_N : 0.0;
    atRest = std::max(atRest, least);
    sliding = std::max(sliding, least);
}

double CoulombFriction::remainingFraction(double r_mm, double rounding_mm) noexcept
{
    m_now.lastSlid = false;
    if (!m_now.slides) {
        if (r_mm <= m_now.still_mm + rounding_mm) {
            return 1.0;
        }
        m_now.slides = true;
    }
    if (r_mm <= m_now.sliding_mm + rounding_mm) {
        m_now.slides = !(r_mm < kCaught * m_now.sliding_mm);
        return 1.0;
    }
    if (m_now.drag > 0.0 && m_dt_s > 0.0 && !m_now.isBehind) {
        // k (r' - R) = (c/dt) (r - r'): the lag by the implicit Euler step, once per tick.
        m_now.isBehind = true;
        const double c = m_now.drag / m_dt_s;
        m_now.behind_mm = (r_mm - m_now.sliding_mm) * (c / (m_now.stiffest + c));
    }
    const double behind_mm = m_now.drag > 0.0 ? m_now.behind_mm : 0.0; // without drag there is no lag
    const double left = std::min(1.0, (m_now.sliding_mm + behind_mm) / r_mm);
    m_now.lastSlid = left < 1.0;
    return left;
}

} // namespace palpate::haptics::internal
