// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfacePicker.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::view {

using geometry::SurfaceIndex;

namespace {

RayHit hitAt(const Ray& ray, double distance_mm, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t triangle)
{
    Vec3 n = (b - a).cross(c - a).normalized();
    const bool isBehind = n.dot(ray.d_W) > 0.0;
    if (isBehind) {
        n = -n;
    }
    const Vec3 p_W = ray.p_W + distance_mm * ray.d_W;
    return {distance_mm, p_W, n, triangle, p_W, isBehind};
}

/// Part of a ray inside a box, as distances from its origin [mm]; empty: far < near.
struct Within
{
    double near_mm, far_mm;
};

/// Intersects a ray with a box (slab test).
Within within(const core::Box& box, const Ray& ray)
{
    double near = 0.0, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double p = ray.p_W[axis], d = ray.d_W[axis];
        if (d == 0.0) {
            if (p < box.min()[axis] || p > box.max()[axis]) {
                return {0.0, -1.0};
            }
            continue;
        }
        const double a = (box.min()[axis] - p) / d, b = (box.max()[axis] - p) / d;
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return {near, far};
}

bool meets(const core::Box& box, const Ray& ray)
{
    const Within in = within(box, ray);
    return in.near_mm <= in.far_mm;
}

/// @param reach  length of the ray [mm], > 0
std::optional<RayHit> hitWithin(const SurfaceIndex& surface, const Ray& ray, double reach)
{
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
    if (!(best <= reach)) {
        return std::nullopt;
    }
    const geometry::Triangle t = surface.triangle(found);
    return hitAt(ray, best, surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2]), found);
}

} // namespace

std::optional<RayHit> firstHit(const SurfaceIndex& surface, const Ray& ray)
{
    if (surface.triangleCount() == 0 || !ray.p_W.allFinite() || !ray.d_W.allFinite()) {
        return std::nullopt;
    }
    // The hierarchy takes segments: make one long enough to reach the far side of the box.
    const core::Box& box = surface.bounds();
    return hitWithin(surface, ray, 1.01 * ((box.center() - ray.p_W).norm() + box.diagonal().norm()));
}

std::optional<RayHit> firstHit(const SurfaceIndex& surface, const geometry::SurfaceMotion& motion,
                               const geometry::SurfaceMotion::Moment& moment, const Ray& ray)
{
    constexpr double kPiece_mm = 5.0;
    constexpr int kMostPieces = 64;
    if (surface.triangleCount() == 0 || !ray.p_W.allFinite() || !ray.d_W.allFinite()) {
        return std::nullopt;
    }
    // The pose is undone exactly; what remains is the displacement of the lattice.
    const Ray posed{moment.turn.transpose() * (ray.p_W - moment.shift), moment.turn.transpose() * ray.d_W};
    core::Box box = surface.bounds();
    const Vec3 margin = Vec3::Constant(1e-6 + (moment.frames > 0 ? motion.reach_mm() : 0.0));
    box.extend(core::Box(box.min() - margin, box.max() + margin));
    const Within in = within(box, posed);
    if (!(in.near_mm < in.far_mm)) {
        return std::nullopt;
    }
    const double length_mm = in.far_mm - in.near_mm;
    const int pieces =
        moment.frames == 0 ? 1 : std::clamp(static_cast<int>(std::ceil(length_mm / kPiece_mm)), 1, kMostPieces);
    const auto at = [&](double share) { return Vec3(ray.p_W + (in.near_mm + share * length_mm) * ray.d_W); };
    Vec3 from = motion.toRest(moment, at(0.0), posed.p_W + in.near_mm * posed.d_W).X;
    for (int i = 0; i < pieces; ++i) {
        const Vec3 to = motion.toRest(moment, at((i + 1.0) / pieces), from).X;
        const double piece_mm = (to - from).norm();
        const auto hit = hitWithin(surface, {from, (to - from) / piece_mm}, piece_mm);
        if (hit) {
            // The piece is a chord of the curve to which the motion takes the ray. Newton's method moves the hit along
            // the ray into the plane of the triangle.
            constexpr int kSteps = 4;
            double distance_mm = in.near_mm + (i + hit->distance_mm / piece_mm) / pieces * length_mm;
            Vec3 rest_W = hit->p_W;
            for (int step = 0; step < kSteps; ++step) {
                const auto rest = motion.toRest(moment, ray.p_W + distance_mm * ray.d_W, rest_W);
                rest_W = rest.X;
                const double speed = hit->n_W.dot(rest.invF * ray.d_W), off_mm = hit->n_W.dot(rest_W - hit->p_W);
                if (step + 1 < kSteps && std::abs(off_mm) < kPiece_mm * std::abs(speed)) {
                    distance_mm -= off_mm / speed;
                }
            }
            geometry::Mat3 F;
            (void)motion.toWorld(moment, rest_W, F);
            const Vec3 n_W = (F.inverse().transpose() * hit->n_W).normalized();
            return RayHit{distance_mm, ray.p_W + distance_mm * ray.d_W, n_W, hit->triangle, rest_W, hit->isBehind};
        }
        from = to;
    }
    return std::nullopt;
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
