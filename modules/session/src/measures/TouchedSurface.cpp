// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TouchedSurface.h"

#include <palpate/core/Finding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>

namespace palpate::session {

using core::Vec3;
using geometry::Triangle;

namespace {
constexpr double kMostParts = 256.0; // per edge: limits the splitting of very large triangles

/// A line in a grid of cells.
struct Line
{
    Vec3 start, way;
    double cell_mm;

    struct Part
    {
        double from = 0.0, to = 1.0; ///< of the line; none if from > to
    };
    /// The part of a part that is in a cell or one of its two neighbours, in one axis.
    [[nodiscard]] Part near(Part part, int axis, std::int64_t cell) const
    {
        if (way[axis] != 0.0) {
            const auto at = [&](std::int64_t edge) {
                return (static_cast<double>(edge) * cell_mm - start[axis]) / way[axis];
            };
            const auto [first, last] = std::minmax({at(cell - 1), at(cell + 2)});
            part = {std::max(part.from, first), std::min(part.to, last)};
        }
        return part;
    }
    /// First and last cell of a part in one axis, with one more at each end.
    [[nodiscard]] std::pair<std::int64_t, std::int64_t> cells(Part part, int axis) const
    {
        const auto at = [&](double share) {
            return static_cast<std::int64_t>(std::floor((start[axis] + share * way[axis]) / cell_mm));
        };
        const std::int64_t a = at(part.from), b = at(part.to);
        return part.from > part.to ? std::pair(a, a - 1) : std::pair(std::min(a, b) - 1, std::max(a, b) + 1);
    }
};
} // namespace

std::size_t TouchedSurface::CellHash::operator()(const Cell& cell) const noexcept
{
    std::uint64_t hash = 0;
    for (const std::int64_t value : cell) {
        hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
}

TouchedSurface::Cell TouchedSurface::cellOf(const Vec3& p) const
{
    return {static_cast<std::int64_t>(std::floor(p.x() / m_distance_mm)),
            static_cast<std::int64_t>(std::floor(p.y() / m_distance_mm)),
            static_cast<std::int64_t>(std::floor(p.z() / m_distance_mm))};
}

void TouchedSurface::split(const geometry::TriangleMesh& mesh, double longest_mm)
{
    m_mesh.vertices = mesh.vertices;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        const double edge_mm = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        const auto parts = static_cast<std::uint32_t>(std::clamp(std::ceil(edge_mm / longest_mm), 1.0, kMostParts));
        if (parts == 1) {
            m_mesh.triangles.push_back(t);
            continue;
        }
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        for (std::uint32_t i = 0; i <= parts; ++i) {
            for (std::uint32_t j = 0; j <= parts - i; ++j) {
                m_mesh.vertices.push_back(a + (b - a) * (static_cast<double>(i) / parts) +
                                          (c - a) * (static_cast<double>(j) / parts));
            }
        }
        // Row i follows i rows with parts + 1, parts, ... points.
        const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + i * (parts + 1) - i * (i - 1) / 2 + j; };
        for (std::uint32_t i = 0; i < parts; ++i) {
            for (std::uint32_t j = 0; j < parts - i; ++j) {
                m_mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (j + 1 < parts - i) {
                    m_mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                }
            }
        }
    }
}

TouchedSurface::TouchedSurface(const geometry::TriangleMesh& mesh, double distance_mm)
    : m_distance_mm(distance_mm)
    , m_given(mesh.vertices.size())
{
    split(mesh, 0.5 * distance_mm);
    const std::size_t count = m_mesh.vertices.size();
    m_share_mm2.assign(count, 0.0);
    m_dwell_s.assign(count, 0.0);
    m_peakForce_N.assign(count, 0.0);
    m_impulse_Ns.assign(count, 0.0);
    m_peakDepth_mm.assign(count, 0.0);
    m_stiffness_N_per_mm.assign(count, 0.0);
    m_last_s.assign(count, -std::numeric_limits<double>::infinity());
    m_visits.assign(count, 0);
    for (const Triangle& t : m_mesh.triangles) {
        const Vec3& a = m_mesh.vertices[t[0]];
        const double area_mm2 = 0.5 * (m_mesh.vertices[t[1]] - a).cross(m_mesh.vertices[t[2]] - a).norm();
        m_area_mm2 += area_mm2;
        for (const std::uint32_t corner : t) {
            m_share_mm2[corner] += area_mm2 / 3.0;
        }
    }
    std::vector<Cell> cells(count);
    std::transform(m_mesh.vertices.begin(), m_mesh.vertices.end(), cells.begin(),
                   [this](const Vec3& p) { return cellOf(p); });
    m_order.resize(count);
    std::iota(m_order.begin(), m_order.end(), 0u);
    std::sort(m_order.begin(), m_order.end(), [&](std::uint32_t a, std::uint32_t b) { return cells[a] < cells[b]; });
    for (std::uint32_t i = 0; i < m_order.size();) {
        std::uint32_t end = i;
        while (end < m_order.size() && cells[m_order[end]] == cells[m_order[i]]) {
            ++end;
        }
        m_cells.emplace(cells[m_order[i]], std::pair(i, end));
        i = end;
    }
}

std::optional<std::uint32_t> TouchedSurface::add(const Touch& touch)
{
    std::optional<std::uint32_t> nearest;
    if (!touch.place.isFinite()) {
        return nearest;
    }
    double nearest_mm2 = std::numeric_limits<double>::infinity();
    const double square_mm2 = m_distance_mm * m_distance_mm;
    const auto visit = [&](const Cell& cell) {
        const auto found = m_cells.find(cell);
        if (found == m_cells.end()) {
            return;
        }
        for (std::uint32_t i = found->second.first; i < found->second.second; ++i) {
            const std::uint32_t vertex = m_order[i];
            const double away_mm2 = touch.place.squaredDistance_mm2(m_mesh.vertices[vertex]);
            if (away_mm2 <= square_mm2) {
                if (vertex < m_given && away_mm2 < nearest_mm2) {
                    nearest = vertex;
                    nearest_mm2 = away_mm2;
                }
                count(vertex, touch);
            }
        }
    };
    // All cells within the distance of the line from the touching point to the centre; around a point 3 in each axis.
    const Line line{touch.place.p_W(), touch.place.centre_W() - touch.place.p_W(), m_distance_mm};
    const auto [firstX, lastX] = line.cells({}, 0);
    for (std::int64_t x = firstX; x <= lastX; ++x) {
        const Line::Part inX = line.near({}, 0, x);
        const auto [firstY, lastY] = line.cells(inX, 1);
        for (std::int64_t y = firstY; y <= lastY; ++y) {
            const auto [firstZ, lastZ] = line.cells(line.near(inX, 1, y), 2);
            for (std::int64_t z = firstZ; z <= lastZ; ++z) {
                visit({x, y, z});
            }
        }
    }
    return nearest;
}

void TouchedSurface::count(std::uint32_t vertex, const Touch& touch)
{
    m_dwell_s[vertex] += touch.dt_s;
    m_impulse_Ns[vertex] += touch.force_N * touch.dt_s;
    m_peakForce_N[vertex] = std::max(m_peakForce_N[vertex], touch.force_N);
    m_peakDepth_mm[vertex] = std::max(m_peakDepth_mm[vertex], touch.depth_mm);
    if (touch.depth_mm >= core::kMinStiffnessDepth_mm) {
        m_stiffness_N_per_mm[vertex] = std::max(m_stiffness_N_per_mm[vertex], touch.force_N / touch.depth_mm);
    }
    m_visits[vertex] += touch.time_s - m_last_s[vertex] > 1.5 * touch.dt_s ? 1 : 0; // not at the tick before
    m_last_s[vertex] = touch.time_s;
}

std::vector<double> TouchedSurface::meanForce_N() const
{
    std::vector<double> mean_N(m_dwell_s.size(), 0.0);
    for (std::size_t i = 0; i < mean_N.size(); ++i) {
        mean_N[i] = m_dwell_s[i] > 0.0 ? m_impulse_Ns[i] / m_dwell_s[i] : 0.0;
    }
    return mean_N;
}

double TouchedSurface::coveredArea_mm2() const
{
    double covered_mm2 = 0.0;
    for (std::size_t i = 0; i < m_share_mm2.size(); ++i) {
        covered_mm2 += m_dwell_s[i] > 0.0 ? m_share_mm2[i] : 0.0;
    }
    return covered_mm2;
}

double mapEnd(const std::vector<float>& values)
{
    constexpr double kShare = 0.98;
    std::vector<float> touched;
    std::copy_if(values.begin(), values.end(), std::back_inserter(touched), [](float value) { return value > 0.0F; });
    if (touched.empty()) {
        return 1.0;
    }
    const auto at =
        touched.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(touched.size() - 1) + 0.5);
    std::nth_element(touched.begin(), at, touched.end());
    const double end = *at, power = std::pow(10.0, std::floor(std::log10(end)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (end <= digit * power * (1.0 + 1e-9)) {
            return digit * power;
        }
    }
    return 10.0 * power;
}

} // namespace palpate::session
