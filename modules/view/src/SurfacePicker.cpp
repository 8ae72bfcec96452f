// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfacePicker.h"

#include <palpate/geometry/Inside.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::view {

using geometry::SurfaceIndex;

std::optional<RayHit> firstHit(const SurfaceIndex& surface, const Ray& ray)
{
    if (surface.triangleCount() == 0 || !ray.p_W.allFinite() || !ray.d_W.allFinite()) {
        return std::nullopt;
    }
    // The hierarchy takes segments: one that surely reaches the far side of the box.
    const core::Box& box = surface.bounds();
    const double reach = 1.01 * ((box.center() - ray.p_W).norm() + box.diagonal().norm());
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    surface.hierarchy().visitSegment(
        ray.p_W, ray.p_W + reach * ray.d_W, [&](std::uint32_t first, std::uint32_t count) noexcept {
            for (std::uint32_t i = first; i < first + count; ++i) {
                const geometry::Triangle t = surface.triangle(i);
                const double hit = geometry::distanceAlongRay(surface.vertex(t[0]), surface.vertex(t[1]),
                                                              surface.vertex(t[2]), ray.p_W, ray.d_W);
                if (hit < best) {
                    best = hit;
                    found = i;
                }
            }
            return std::min(1.0, best / reach);
        });
    if (std::isinf(best)) {
        return std::nullopt;
    }
    const geometry::Triangle t = surface.triangle(found);
    const Vec3 a = surface.vertex(t[0]);
    Vec3 n = (surface.vertex(t[1]) - a).cross(surface.vertex(t[2]) - a).normalized();
    if (n.dot(ray.d_W) > 0.0) {
        n = -n;
    }
    return RayHit{best, ray.p_W + best * ray.d_W, n, found};
}

} // namespace palpate::view
