// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/CloseTriangles.h"

#include "palpate/haptics/internal/AsFloats.h"
#include "palpate/haptics/internal/InsideShare.h"

#include <cmath>

namespace palpate::haptics::internal {

namespace {

constexpr double kTicksAhead = 6.0;
constexpr int kFew = 24;
constexpr double kLeast = 0.25; // of the reach that is wanted

/// @return how far `p` is inside of the box on all sides.
double room(const core::Box& box, const Vec3& p) noexcept
{
    return std::min((box.max() - p).minCoeff(), (p - box.min()).minCoeff());
}

} // namespace

bool CloseTriangles::take(const Facets& held, const Vec3& x, const Vec3& y, const Vec3& motion, double radius_mm,
                          double facetSize_mm) noexcept
{
    m_reach_mm = -1.0;
    if (!held.holds(x) || !held.holds(y)) {
        return false;
    }
    if (m_wanted_mm == 0.0) {
        m_wanted_mm = 0.5 * facetSize_mm;
    }
    const double most = std::min(room(held.region(), x), room(held.region(), y));
    if (most < kLeast * m_wanted_mm) {
        return false;
    }
    const double reach = std::min(m_wanted_mm, most);
    const core::Box inner(held.region().min().array() + reach, held.region().max().array() - reach);
    m_from = x;
    m_way = y - x + motion * kTicksAhead;
    m_way *= insideShare(inner, x, x + m_way);
    m_way2 = m_way.squaredNorm();

    float at[3], half[3];
    const float coordinate = std::max(held.reach_mm(), asFloats(x + 0.5 * m_way, held.origin(), at));
    (void)asFloats(0.5 * m_way, Vec3::Zero(), half);
    alignas(32) float distance_mm[kMostTriangles];
    distances(held.groups(), held.count(), at, half, distance_mm);
    std::size_t count = 0;
    const double touching = radius_mm + leastDistanceRounding(coordinate, 0.5 * std::sqrt(m_way2), radius_mm);
    std::array<int, kMost> found;
    forEachBetween(distance_mm, held.count(), kAnyDistance, touching + reach, [&](int i) {
        if (count < kMost) {
            found[count] = i;
        }
        ++count;
    });
    if (count > kMost) {
        m_wanted_mm = 0.5 * reach;
        return false;
    }
    m_reach_mm = reach;
    m_origin = held.origin();
    m_coordinate_mm = held.reach_mm();
    m_count = static_cast<int>(count);
    for (std::size_t i = 0; i < count; ++i) {
        m_structure[i] = held.structure(found[i]);
        m_triangle[i] = held.triangle(found[i]);
        copyTriangle(held.groups(), found[i], m_groups.data(), static_cast<int>(i));
    }
    if (m_count < kFew && m_wanted_mm < most) {
        m_wanted_mm *= 1.25;
    }
    return covers(x) && covers(y);
}

} // namespace palpate::haptics::internal
