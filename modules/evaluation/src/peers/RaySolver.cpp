// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/RaySolver.h"

#include "palpate/evaluation/LagrangeElimination.h"

#include <vector>

namespace palpate::evaluation {

namespace {

constexpr int kPasses = 32;

/// Finds the point closest to `hip` in front of all planes: the smallest set of at most three planes whose multipliers
/// push outwards and whose point violates no other plane. The newest plane is always in the set.
bool nearestInFront(const Vec3& hip, const std::vector<Plane>& planes, double allowance_mm, Vec3& p)
{
    const std::size_t newest = planes.size() - 1;
    for (std::size_t size = 1; size <= 3; ++size) {
        for (std::size_t set = 0; set < (std::size_t{1} << newest); ++set) {
            std::vector<Plane> chosen{planes[newest]};
            for (std::size_t i = 0; i < newest; ++i) {
                if ((set >> i & 1) != 0) {
                    chosen.push_back(planes[i]);
                }
            }
            if (chosen.size() != size) {
                continue;
            }
            const Elimination solved = eliminate(hip, chosen);
            bool isGood = solved.isSolved;
            for (std::size_t i = 0; i < size; ++i) {
                isGood = isGood && solved.lambda[i] < 0.0; // x = hip - N^T lambda
            }
            for (const Plane& plane : planes) {
                isGood = isGood && plane.n.dot(solved.p) - plane.d >= -allowance_mm;
            }
            if (isGood) {
                p = solved.p;
                return true;
            }
        }
    }
    return false;
}

} // namespace

RaySolver::RaySolver(const Surface& surface, std::unique_ptr<SegmentCaster> caster)
    : m_surface(surface)
    , m_caster(std::move(caster))
    , m_gap_mm(1e-6 * surface.bounds().sizes().maxCoeff())
{
}

RaySolver::~RaySolver() = default;

/// Finds the first hit that blocks the move; `n` is the normal towards the god-object.
bool RaySolver::firstBlocking(const Vec3& target, SegmentCaster::Hit& hit, Vec3& n)
{
    const Vec3 way = target - m_god;
    double done = 0.0;
    for (int i = 0; i < kPasses; ++i) {
        const Vec3 from = m_god + done * way;
        if (!m_caster->cast(from, target, hit)) {
            return false;
        }
        hit.share = done + hit.share * (1.0 - done);
        const Vec3 &a = m_surface.corner(hit.triangle, 0), &b = m_surface.corner(hit.triangle, 1),
                   &c = m_surface.corner(hit.triangle, 2);
        n = (b - a).cross(c - a).normalized();
        const bool isBack = n.dot(way) >= 0.0;
        if (!isBack || m_surface.isTwoSided(hit.triangle)) {
            n = isBack ? Vec3(-n) : n;
            return true;
        }
        done = hit.share + m_gap_mm / way.norm(); // hit from inside: continue behind the hit
        if (done >= 1.0) {
            return false;
        }
    }
    return false;
}

/// Adds planes from none until the god-object rests. @return number of constraining planes at the end
int RaySolver::pass(const Vec3& p_WH)
{
    std::vector<Plane> planes;
    Vec3 target = p_WH;
    for (;;) {
        SegmentCaster::Hit hit;
        Vec3 n;
        const Vec3 way = target - m_god;
        const double length = way.norm();
        if (length == 0.0 || !firstBlocking(m_god + way * (1.0 + m_gap_mm / length), hit, n)) {
            m_god = target;
            return static_cast<int>(planes.size());
        }
        const double towards = -n.dot(way) / length;
        const double free = hit.share * (length + m_gap_mm) - m_gap_mm / std::max(towards, 1e-3);
        if (free > 0.0) {
            m_god += way * (free / length);
        }
        if (planes.size() == 4) {
            return 3;
        }
        planes.push_back({n, n.dot(m_surface.corner(hit.triangle, 0)) + m_gap_mm});
        if (!nearestInFront(p_WH, planes, 0.1 * m_gap_mm, target)) {
            return static_cast<int>(std::min<std::size_t>(planes.size(), 3));
        }
    }
}

SolverStep RaySolver::step(const Vec3& p_WH)
{
    SolverStep result;
    result.p_WG = m_god;
    if (!p_WH.allFinite()) {
        result.isConverged = false;
        return result;
    }
    result.isConverged = false;
    for (int i = 0; i < kPasses && !result.isConverged; ++i) {
        const Vec3 before = m_god;
        result.constraints = pass(p_WH);
        ++result.iterations;
        result.isConverged = result.constraints == 0 || (m_god - before).norm() <= m_gap_mm;
    }
    result.p_WG = m_god;
    result.spring_mm = m_god - p_WH;
    return result;
}

} // namespace palpate::evaluation
