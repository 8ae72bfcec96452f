// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfacePicker.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::view {

using geometry::SurfaceIndex;

namespace {

RayHit hitAt(const Ray& ray, double distance_mm, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t triangle)
{
    Vec3 n = (b - a).cross(c - a).normalized();
    if (n.dot(ray.d_W) > 0.0) {
        n = -n;
    }
    return {distance_mm, ray.p_W + distance_mm * ray.d_W, n, triangle};
}

/// Returns whether a ray hits a box (slab test).
bool meets(const core::Box& box, const Ray& ray)
{
    double near = 0.0, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double p = ray.p_W[axis], d = ray.d_W[axis];
        if (d == 0.0) {
            if (p < box.min()[axis] || p > box.max()[axis]) {
                return false;
            }
            continue;
        }
        const double a = (box.min()[axis] - p) / d, b = (box.max()[axis] - p) / d;
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far;
}

} // namespace

std::optional<RayHit> firstHit(const SurfaceIndex& surface, const Ray& ray)
{
    if (surface.triangleCount() == 0 || !ray.p_W.allFinite() || !ray.d_W.allFinite()) {
        return std::nullopt;
    }
    // The hierarchy takes segments: make one long enough to reach the far side of the box.
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
    return hitAt(ray, best, surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2]), found);
}

std::optional<RayHit> firstHit(const geometry::TriangleMesh& mesh, const core::Box& bounds, const Ray& ray)
{
    if (bounds.isEmpty() || !ray.p_W.allFinite() || !ray.d_W.allFinite() || !meets(bounds, ray)) {
        return std::nullopt;
    }
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const geometry::Triangle& t = mesh.triangles[i];
        const double hit =
            geometry::distanceAlongRay(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], ray.p_W, ray.d_W);
        if (hit < best) {
            best = hit;
            found = static_cast<std::uint32_t>(i);
        }
    }
    if (std::isinf(best)) {
        return std::nullopt;
    }
    const geometry::Triangle& t = mesh.triangles[found];
    return hitAt(ray, best, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], found);
}

} // namespace palpate::view
