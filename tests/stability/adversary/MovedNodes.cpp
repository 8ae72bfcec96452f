// SPDX-License-Identifier: BSD-3-Clause
#include "MovedNodes.h"

#include <algorithm>
#include <cmath>

namespace palpate::adversary {

namespace {

constexpr std::size_t kMostTriangles = 3000;

/// Splits a triangle into n × n triangles.
void split(const std::array<Vec3, 3>& t, int n, std::vector<std::array<Vec3, 3>>& out)
{
    const auto at = [&](int i, int j) -> Vec3 {
        return (double(n - i - j) * t[0] + double(i) * t[1] + double(j) * t[2]) / double(n);
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            out.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i + j + 1 < n) {
                out.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    }
}

} // namespace

MovedNodes::MovedNodes(const JudgedLayer& layer, const RandomMotion* motion)
    : m_motion(motion)
    , m_skin_mm(layer.skin_mm)
{
    const double bend = motion == nullptr ? 0.0 : motion->bend_per_mm();
    for (const Body& body : layer.bodies) {
        Watched& watched = m_bodies.emplace_back();
        for (const auto& t : body.triangles()) {
            for (std::size_t k = 0; k < 3; ++k) {
                watched.edge_mm = std::max(watched.edge_mm, (t[(k + 1) % 3] - t[k]).norm());
            }
        }
        // The same number for all triangles, so that no crack opens.
        const double most = std::sqrt(double(kMostTriangles) / double(body.triangles().size()));
        const double wanted = bend > 0.0 ? 4.0 * watched.edge_mm / motion->spacing_mm() : 1.0;
        const int n = std::max(1, static_cast<int>(std::min(std::ceil(wanted), most)));
        watched.edge_mm /= n;
        for (const auto& t : body.triangles()) {
            split(t, n, watched.rest);
        }
    }
}

void MovedNodes::forget()
{
    for (Watched& body : m_bodies) {
        body.isKnown = false;
    }
}

void MovedNodes::look(double t, const Vec3& god, double rounding_mm, Faults& faults)
{
    for (Watched& watched : m_bodies) {
        std::vector<std::array<Vec3, 3>> now = watched.rest;
        if (m_motion != nullptr) {
            for (auto& triangle : now) {
                for (Vec3& corner : triangle) {
                    corner = m_motion->toWorld(t, corner);
                }
            }
        }
        const Body body(std::move(now));
        // Linear interpolation between nodes: at most half of the second derivative times the square of the
        // circumradius.
        const double bend = m_motion == nullptr ? 0.0 : m_motion->bend_per_mm();
        const double beside_mm = bend * watched.edge_mm * watched.edge_mm / 6.0 + 2.0 * m_skin_mm + rounding_mm;
        const std::optional<int> turns = body.winding(god);
        if (!turns || (watched.isKnown && *turns == watched.most) || body.distance_mm(god) <= 2.0 * beside_mm) {
            continue;
        }
        ++m_ticks;
        if (watched.isKnown && *turns > watched.most) {
            faults.push_back({"a moved surface has passed the god-object", body.distance_mm(god), "mm", god, god});
        }
        watched.isKnown = true;
        watched.most = *turns;
    }
}

} // namespace palpate::adversary
