// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/PaperSolver.h"

#include "palpate/evaluation/LagrangeElimination.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace palpate::evaluation {

PaperSolver::PaperSolver(const Surface& surface, Search search)
    : m_surface(surface)
    , m_search(search)
    // Single precision, usual at the time of the paper, resolves 1e-7; for doubles 1e-10 of the scene covers the
    // rounding.
    , m_roundoff_mm(1e-10 * surface.magnitude_mm())
{
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        Facet f{surface.corner(i, 0), surface.corner(i, 1), surface.corner(i, 2), Vec3::Zero(), surface.isTwoSided(i)};
        f.n = (f.b - f.a).cross(f.c - f.a).normalized();
        m_facets.push_back(f);
    }
    m_near.resize(m_facets.size());
    std::iota(m_near.begin(), m_near.end(), 0u);
}

/// Collects the facets that a move from the god-object to `target` can intersect. A facet counts as intersected up to
/// the roundoff tolerance beyond its edges, which reaches farther at a sharp corner: the margin covers corners down to
/// a tenth of a degree.
void PaperSolver::findNear(const Vec3& target)
{
    if (m_search == Search::BruteForce) {
        return;
    }
    const double margin = 1200.0 * m_roundoff_mm;
    m_near.clear();
    m_surface.appendNear(Box(m_god.cwiseMin(target).array() - margin, m_god.cwiseMax(target).array() + margin), m_near);
    std::sort(m_near.begin(), m_near.end());
}

/// The two conditions of the paper: positive distance of the old god-object and negative distance of the target, and
/// an intersection of the line with the interior of the facet.
bool PaperSolver::meets(const Facet& facet, const Vec3& target, double& share, double& side) const
{
    double start = facet.n.dot(m_god - facet.a), end = facet.n.dot(target - facet.a);
    side = 1.0;
    if (start < -m_roundoff_mm) {
        if (!facet.isTwoSided) {
            return false;
        }
        side = -1.0;
        start = -start;
        end = -end;
    }
    if (end >= -m_roundoff_mm) {
        return false;
    }
    share = start > 0.0 ? start / (start - end) : 0.0;
    const Vec3 p = m_god + share * (target - m_god);
    const auto isInside = [&](const Vec3& u, const Vec3& v) {
        const Vec3 edge = v - u;
        return facet.n.dot(edge.cross(p - u)) >= -m_roundoff_mm * edge.norm();
    };
    return isInside(facet.a, facet.b) && isInside(facet.b, facet.c) && isInside(facet.c, facet.a);
}

SolverStep PaperSolver::step(const Vec3& p_WH)
{
    SolverStep result;
    result.p_WG = m_god;
    if (!p_WH.allFinite()) {
        result.isConverged = false;
        return result;
    }
    Vec3 target = p_WH;
    std::array<Plane, 3> planes;
    std::array<const Facet*, 3> held{};
    std::size_t count = 0;
    while (count < planes.size()) {
        const Facet* first = nullptr;
        double least = 2.0, sideMet = 1.0;
        findNear(target);
        for (const std::uint32_t i : m_near) {
            const Facet& facet = m_facets[i];
            double share = 0.0, side = 1.0;
            if (&facet != held[0] && &facet != held[1] && meets(facet, target, share, side) && share < least) {
                first = &facet;
                least = share;
                sideMet = side;
            }
        }
        ++result.iterations;
        if (first == nullptr) {
            break;
        }
        held[count] = first;
        planes[count++] = {sideMet * first->n, sideMet * first->n.dot(first->a)};
        const Elimination solved = eliminate(p_WH, std::span(planes).first(count));
        if (!solved.isSolved) {
            target = m_god;
            break;
        }
        target = solved.p;
    }
    m_god = target;
    result.p_WG = m_god;
    result.spring_mm = m_god - p_WH;
    result.constraints = static_cast<int>(count);
    return result;
}

} // namespace palpate::evaluation
