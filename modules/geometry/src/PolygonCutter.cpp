// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/PolygonCutter.h"

#include <algorithm>
#include <numeric>

namespace palpate::geometry {

using Eigen::Vector2d;

namespace {

/// Twice the signed area of a triangle.
double area2(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace

void PolygonCutter::project(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners)
{
    // Newell's normal, relative to the first corner, so that a distant origin causes no cancellation.
    Vec3 normal = Vec3::Zero();
    const Vec3& origin = points[corners[0]];
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = points[corners[i]] - origin;
        const Vec3 b = points[corners[(i + 1) % corners.size()]] - origin;
        normal += a.cross(b);
    }
    Eigen::Index drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const Eigen::Index u = (drop + 1) % 3;
    const Eigen::Index v = (drop + 2) % 3;
    const bool isMirrored = normal[drop] < 0.0;
    m_flat.clear();
    for (const std::uint32_t corner : corners) {
        const Vec3 p = points[corner] - origin;
        m_flat.emplace_back(isMirrored ? p[v] : p[u], isMirrored ? p[u] : p[v]);
    }
}

double PolygonCutter::turnAt(std::size_t i) const
{
    const std::size_t n = m_left.size();
    return area2(m_flat[m_left[(i + n - 1) % n]], m_flat[m_left[i]], m_flat[m_left[(i + 1) % n]]);
}

bool PolygonCutter::isEar(std::size_t i) const
{
    if (!(turnAt(i) > 0.0)) {
        return false;
    }
    const std::size_t n = m_left.size();
    const Vector2d& a = m_flat[m_left[(i + n - 1) % n]];
    const Vector2d& b = m_flat[m_left[i]];
    const Vector2d& c = m_flat[m_left[(i + 1) % n]];
    for (std::size_t step = 2; step + 1 < n; ++step) {
        const std::size_t k = (i + step) % n;
        const Vector2d& p = m_flat[m_left[k]];
        const bool isInside = area2(a, b, p) >= 0.0 && area2(b, c, p) >= 0.0 && area2(c, a, p) >= 0.0;
        if (isInside && p != a && p != b && p != c && turnAt(k) <= 0.0) {
            return false;
        }
    }
    return true;
}

void PolygonCutter::cut(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners,
                        std::vector<geometry::Triangle>& out)
{
    project(points, corners);
    m_left.resize(corners.size());
    std::iota(m_left.begin(), m_left.end(), 0U);
    bool isSimple = true;
    std::size_t at = 0;
    while (m_left.size() > 2) {
        const std::size_t n = m_left.size();
        std::size_t ear = n;
        for (std::size_t step = 0; step < n && ear == n; ++step) {
            ear = n == 3 || isEar((at + step) % n) ? (at + step) % n : n;
        }
        if (ear == n) {
            // No ear: the rest has no area or intersects itself.
            ear = at % n;
            for (std::size_t i = 0; i < n; ++i) {
                isSimple = isSimple && turnAt(i) == 0.0;
                ear = turnAt(i) > turnAt(ear) ? i : ear;
            }
        }
        out.push_back({corners[m_left[(ear + n - 1) % n]], corners[m_left[ear]], corners[m_left[(ear + 1) % n]]});
        m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(ear));
        at = ear; // continue at the next corner: a fan around one corner would give slivers
    }
    m_crossing += isSimple ? 0 : 1;
}

} // namespace palpate::geometry
