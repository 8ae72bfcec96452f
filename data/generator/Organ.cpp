// SPDX-License-Identifier: BSD-3-Clause
#include "Organ.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::phantom {

namespace {

/// Smooth minimum of two distances, blended over a width of `k` [mm] (cubic polynomial).
double smoothMin(double a, double b, double k)
{
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * h * k / 6.0;
}

double smoothMax(double a, double b, double k)
{
    return -smoothMin(-a, -b, k);
}

/// Difference: inside `a` and outside `b`.
double carve(double a, double b, double k)
{
    return smoothMax(a, -b, k);
}

/// Distance to an ellipsoid, exact to first order near its surface.
double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii, double turnZ_deg = 0.0, double turnY_deg = 0.0)
{
    constexpr double kDegree = std::numbers::pi / 180.0;
    const double cz = std::cos(turnZ_deg * kDegree), sz = std::sin(turnZ_deg * kDegree);
    const double cy = std::cos(turnY_deg * kDegree), sy = std::sin(turnY_deg * kDegree);
    const Vec3 d = p - centre;
    const Vec3 a(cz * d.x() + sz * d.y(), -sz * d.x() + cz * d.y(), d.z());
    const Vec3 q(cy * a.x() + sy * a.z(), a.y(), -sy * a.x() + cy * a.z());
    const double k0 = q.cwiseQuotient(radii).norm();
    const double k1 = q.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
}

double capsule(const Vec3& p, const Vec3& from, const Vec3& to, double radius)
{
    const Vec3 axis = to - from;
    const double t = std::clamp((p - from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (p - from - t * axis).norm() - radius;
}

} // namespace

double organDistance(const Vec3& p)
{
    // Lobes below the dome of the diaphragm: right, right inferior, middle, left, caudate.
    double d = ellipsoid(p, {-41, 6, -3}, {58, 71, 66}, 10, 6);
    d = smoothMin(d, ellipsoid(p, {-56, -2, -30}, {42, 58, 46}), 34);
    d = smoothMin(d, ellipsoid(p, {0, -8, 8}, {56, 56, 44}, 0, 10), 40);
    d = smoothMin(d, ellipsoid(p, {44, -22, 19}, {66, 44, 26}, -12, 10), 44);
    d = smoothMin(d, ellipsoid(p, {2, 36, 8}, {28, 28, 36}), 24);

    // The visceral face points down, left and back and meets the front in a thin inferior margin.
    const Vec3 face = Vec3(0.41, 0.27, -0.87).normalized();
    d = smoothMax(d, face.dot(p) - 12.0, 14);
    d = carve(d, ellipsoid(p, {72, 22, -22}, {60, 50, 46}), 20);      // stomach
    d = carve(d, ellipsoid(p, {-58, 66, -66}, {40, 44, 54}), 18);     // right kidney
    d = carve(d, ellipsoid(p, {-66, -34, -92}, {44, 40, 34}), 18);    // colon
    d = carve(d, capsule(p, {4, 78, -80}, {8, 70, 80}, 15), 12);      // inferior vena cava
    d = carve(d, capsule(p, {-30, 16, -28}, {20, 2, -5}, 7), 14);     // porta hepatis
    d = carve(d, ellipsoid(p, {-26, -36, -42}, {12, 36, 14}, 14), 8); // gallbladder
    d = carve(d, ellipsoid(p, {26, 0, 96}, {56, 60, 50}), 30);        // heart, above the diaphragm
    // Round ligament: a notch in the inferior margin and a fissure on the visceral face behind.
    d = carve(d, ellipsoid(p, {22, -38, -14}, {4.5, 40, 13}, -8), 14);
    return d;
}

Vec3 outward(const Distance& distance, const Vec3& p)
{
    constexpr double h = 1e-3;
    Vec3 g;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = h * Vec3::Unit(axis);
        g[axis] = distance(p + step) - distance(p - step);
    }
    return g.normalized();
}

Vec3 onSurface(const Distance& distance, Vec3 p)
{
    constexpr double h = 1e-3;
    for (int i = 0; i < 8; ++i) {
        const double d = distance(p);
        if (std::abs(d) < 1e-7) {
            break;
        }
        Vec3 g;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = h * Vec3::Unit(axis);
            g[axis] = (distance(p + step) - distance(p - step)) / (2.0 * h);
        }
        p -= d / std::max(g.squaredNorm(), 0.04) * g;
    }
    return p;
}

Vec3 exitPoint(const Distance& distance, const Vec3& inside, const Vec3& direction)
{
    double low = 0.0;
    double high = 0.0;
    while (distance(inside + high * direction) < 0.0) {
        low = high;
        high += 1.0;
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (distance(inside + middle * direction) < 0.0 ? low : high) = middle;
    }
    return inside + low * direction;
}

double Lump::distance(const Vec3& p) const
{
    const Vec3 d = p - centre_W;
    const double r = d.norm();
    if (r == 0.0) {
        return -radius_mm;
    }
    const Vec3 u = d / r;
    const double bumps = std::sin(4.0 * u.x() + 1.0) * std::sin(5.0 * u.y()) + std::sin(3.0 * u.z() + 2.0) * u.x();
    return r - radius_mm * (1.0 + 0.045 * bumps);
}

Lump lumpBelow(const Vec3& inside, const Vec3& direction, double depth_mm, double radius_mm)
{
    const Vec3 top = exitPoint(organDistance, inside, direction.normalized());
    return {top - (depth_mm + radius_mm) * outward(organDistance, top), radius_mm, top};
}

} // namespace palpate::phantom
