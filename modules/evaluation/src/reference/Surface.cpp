// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Surface.h"

#include "reference/Orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate::evaluation {

namespace {

constexpr std::size_t kBlock = 64;

/// Morton code: interleaves the bits of three 10-bit numbers, so that neighbours in space are close in the order.
std::uint32_t curvePosition(const Vec3& p, const Box& bounds)
{
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double side = bounds.sizes()[axis];
        const double share = side > 0.0 ? (p[axis] - bounds.min()[axis]) / side : 0.0;
        const auto cell = static_cast<std::uint32_t>(std::clamp(share * 1024.0, 0.0, 1023.0));
        for (unsigned bit = 0; bit < 10; ++bit) {
            code |= ((cell >> bit) & 1u) << (3 * bit + static_cast<unsigned>(axis));
        }
    }
    return code;
}

std::uint32_t numberComponents(const geometry::TriangleMesh& mesh, std::vector<std::uint32_t>& componentOf)
{
    // Vertices joined by a triangle are connected; the mesh is welded.
    std::vector<std::uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&root](std::uint32_t v) {
        while (root[v] != v) {
            v = root[v] = root[root[v]];
        }
        return v;
    };
    for (const geometry::Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : {t[1], t[2]}) {
            const std::uint32_t a = find(t[0]), b = find(v);
            root[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::uint32_t> number(mesh.vertices.size(), 0);
    std::uint32_t next = 0;
    componentOf.clear();
    for (const geometry::Triangle& t : mesh.triangles) {
        std::uint32_t& n = number[find(t[0])];
        n = n == 0 ? ++next : n;
        componentOf.push_back(n - 1);
    }
    return next;
}

} // namespace

Surface::Surface(geometry::RepairedMesh mesh)
    : m_mesh(std::move(mesh))
    , m_order(m_mesh.mesh.triangles.size())
    , m_bounds(m_mesh.mesh.bounds())
{
    std::iota(m_order.begin(), m_order.end(), 0u);
    std::vector<std::uint32_t> code;
    double area_mm2 = 0.0;
    for (std::uint32_t i = 0; i < triangleCount(); ++i) {
        code.push_back(curvePosition((corner(i, 0) + corner(i, 1) + corner(i, 2)) / 3.0, m_bounds));
        area_mm2 += 0.5 * (corner(i, 1) - corner(i, 0)).cross(corner(i, 2) - corner(i, 0)).norm();
        m_isClosed = m_isClosed && !isTwoSided(i);
    }
    std::stable_sort(m_order.begin(), m_order.end(), [&code](auto a, auto b) { return code[a] < code[b]; });
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        if (i % kBlock == 0) {
            m_fine.emplace_back();
        }
        m_fine.back().extend(box(m_order[i]));
    }
    for (std::size_t i = 0; i < m_fine.size(); ++i) {
        if (i % kBlock == 0) {
            m_coarse.emplace_back();
        }
        m_coarse.back().extend(m_fine[i]);
    }
    if (triangleCount() > 0) {
        m_magnitude_mm = std::max(
            {m_bounds.sizes().maxCoeff(), m_bounds.min().cwiseAbs().maxCoeff(), m_bounds.max().cwiseAbs().maxCoeff()});
        m_facetSize_mm = std::sqrt(4.0 / std::sqrt(3.0) * area_mm2 / triangleCount());
    }
    m_componentCount = numberComponents(m_mesh.mesh, m_components);
}

Box Surface::box(std::uint32_t triangle) const noexcept
{
    const Vec3 &a = corner(triangle, 0), &b = corner(triangle, 1), &c = corner(triangle, 2);
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

void Surface::appendNear(const Box& wanted, std::vector<std::uint32_t>& triangles) const
{
    for (std::size_t k = 0; k < m_coarse.size(); ++k) {
        if (!m_coarse[k].intersects(wanted)) {
            continue;
        }
        for (std::size_t j = k * kBlock; j < std::min((k + 1) * kBlock, m_fine.size()); ++j) {
            if (!m_fine[j].intersects(wanted)) {
                continue;
            }
            for (std::size_t i = j * kBlock; i < std::min((j + 1) * kBlock, m_order.size()); ++i) {
                if (box(m_order[i]).intersects(wanted)) {
                    triangles.push_back(m_order[i]);
                }
            }
        }
    }
}

int Surface::winding(const Vec3& p, int component) const
{
    // Near-axis directions cross few boxes. If a crossing is degenerate, try the next direction.
    constexpr std::array<std::array<double, 3>, 6> kSlant{{{1, 1.3e-3, 2.9e-3},
                                                           {-2.3e-3, 1, 1.7e-3},
                                                           {3.1e-3, -1.9e-3, 1},
                                                           {-1, 4.7e-3, -3.7e-3},
                                                           {4.1e-2, -1, 5.3e-2},
                                                           {6.1e-2, 7.1e-2, -1}}};
    const double reach = 3.0 * (m_bounds.sizes().sum() + (p - m_bounds.center()).norm());
    std::vector<std::uint32_t> near;
    for (const auto& slant : kSlant) {
        const Vec3 q = p + reach * Vec3(slant[0], slant[1], slant[2]);
        near.clear();
        appendNear(Box(p.cwiseMin(q), p.cwiseMax(q)), near);
        int turns = 0;
        bool isPlain = true;
        const Long3 from = p.cast<long double>(), to = q.cast<long double>();
        for (const std::uint32_t i : near) {
            if (isTwoSided(i) || (component >= 0 && m_components[i] != static_cast<std::uint32_t>(component))) {
                continue;
            }
            const Long3 a = corner(i, 0).cast<long double>(), b = corner(i, 1).cast<long double>(),
                        c = corner(i, 2).cast<long double>();
            const int ab = orientation(from, to, a, b), bc = orientation(from, to, b, c),
                      ca = orientation(from, to, c, a);
            if (std::max({ab, bc, ca}) - std::min({ab, bc, ca}) == 2) {
                continue; // passes beside the triangle
            }
            const int start = orientation(a, b, c, from), end = orientation(a, b, c, to);
            if (start * end > 0) {
                continue;
            }
            if (ab == 0 || bc == 0 || ca == 0 || start == 0 || end == 0) {
                isPlain = false;
                break;
            }
            turns += start < 0 ? 1 : -1; // leaves through the front, so was inside
        }
        if (isPlain) {
            return turns;
        }
    }
    return 0; // degenerate in every direction: on the surface
}

geometry::RepairedMesh merged(const std::vector<const geometry::RepairedMesh*>& meshes)
{
    geometry::RepairedMesh all;
    for (const geometry::RepairedMesh* one : meshes) {
        const auto first = static_cast<std::uint32_t>(all.mesh.vertices.size());
        all.mesh.vertices.insert(all.mesh.vertices.end(), one->mesh.vertices.begin(), one->mesh.vertices.end());
        for (const geometry::Triangle& t : one->mesh.triangles) {
            all.source.push_back(static_cast<std::uint32_t>(all.mesh.triangles.size()));
            all.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        all.twoSided.insert(all.twoSided.end(), one->twoSided.begin(), one->twoSided.end());
    }
    return all;
}

} // namespace palpate::evaluation
