// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceGap.h"

#include "distance/TrianglePair.h"
#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <cmath>

namespace palpate::geometry {

namespace {

core::Box boxAround(const Corners& corners)
{
    core::Box box;
    for (const Vec3& p : corners) {
        box.extend(p);
    }
    return box;
}

core::Box grown(const core::Box& box, double by_mm)
{
    return {box.min() - Vec3::Constant(by_mm), box.max() + Vec3::Constant(by_mm)};
}

} // namespace

std::optional<SurfaceGap> nearestWithin(const SurfaceIndex& a, const SurfaceIndex& b, double within_mm,
                                        double touching_mm, std::size_t pairs)
{
    const bool isSwapped = a.triangleCount() > b.triangleCount();
    const SurfaceIndex &few = isSwapped ? b : a, &many = isSwapped ? a : b;
    const core::Box reach = grown(many.bounds(), within_mm);
    double nearest_mm = within_mm;
    std::size_t left = pairs;
    std::optional<SurfaceGap> found;
    for (std::uint32_t i = 0; i < few.triangleCount() && left > 0 && nearest_mm > touching_mm; ++i) {
        const Corners one = cornersAt(few, i);
        const core::Box box = boxAround(one);
        if (!box.intersects(reach)) {
            continue;
        }
        many.hierarchy().visitBox(grown(box, nearest_mm), [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t j = first; j < first + count && left > 0; ++j, --left) {
                const NearPair pair = nearestOf(one, cornersAt(many, j));
                if (const double distance_mm = std::sqrt(pair.distance2);
                    distance_mm < nearest_mm || (!found && distance_mm <= nearest_mm)) {
                    nearest_mm = distance_mm;
                    found = SurfaceGap{distance_mm, 0.5 * (pair.p + pair.q), false};
                }
            }
            return left > 0 && nearest_mm > touching_mm;
        });
    }
    if (found) {
        found->isBounded = left == 0;
    }
    return found;
}

} // namespace palpate::geometry
