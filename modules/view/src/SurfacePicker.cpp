// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfacePicker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::view {

namespace {

using geometry::SurfaceIndex;

/// Distance along the ray to the triangle, or infinity.
double hitTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const Ray& ray)
{
    const double kMiss = std::numeric_limits<double>::infinity();
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 q = ray.d_W.cross(v);
    const double det = u.dot(q);
    if (det == 0.0) {
        return kMiss;
    }
    const Vec3 s = ray.p_W - a;
    const double eps = 1e-12; // a ray through an edge belongs to both neighbours, not to none
    const double beta = s.dot(q) / det;
    const Vec3 r = s.cross(u);
    const double gamma = ray.d_W.dot(r) / det;
    if (!(beta >= -eps && gamma >= -eps && beta + gamma <= 1.0 + eps)) {
        return kMiss;
    }
    const double distance = v.dot(r) / det;
    return distance > 0.0 ? distance : kMiss;
}

} // namespace

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
                const double hit = hitTriangle(surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2]), ray);
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

bool isInside(const geometry::SurfaceIndex& surface, const Vec3& p_W)
{
    constexpr int kMostWalls = 1000;
    if (!surface.bounds().contains(p_W)) {
        return false;
    }
    const double step = 1e-9 * (surface.bounds().diagonal().norm() + p_W.norm());
    Ray ray{p_W, Vec3(0.31, 0.53, 0.79).normalized()}; // along no axis: anatomy is often cut along them
    int walls = 0;
    for (auto hit = firstHit(surface, ray); hit && walls < kMostWalls; hit = firstHit(surface, ray)) {
        ++walls;
        ray.p_W = hit->p_W + step * ray.d_W;
    }
    return walls % 2 == 1;
}

} // namespace palpate::view
