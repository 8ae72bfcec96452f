// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/PaperBody.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace palpate::evaluation {

namespace {

constexpr std::uint32_t kMeridians = 28, kRings = 11; // 2 kMeridians kRings = 616 triangles
constexpr double kBodyHalfLength_mm = 50.0, kSpindle_mm = 10.0, kSpan_mm = 24.0, kFin_mm = 16.0, kFlatness = 0.6;

/// Point on the body: a spindle with wings at angles of 0 and 180 degrees and a fin at 90 degrees.
core::Vec3 pointAt(std::uint32_t ring, std::uint32_t meridian)
{
    const double s = static_cast<double>(ring) / (kRings + 1); // 0 at the nose, 1 at the tail
    const double angle = 2.0 * std::numbers::pi * meridian / kMeridians;
    const double spindle = kSpindle_mm * std::sqrt(std::sin(std::numbers::pi * std::sqrt(s)));
    const double wing = kSpan_mm * std::pow(s, 3.0) * (1.0 - std::pow(s, 12.0));
    const double fin = kFin_mm * std::pow(s, 8.0) * (1.0 - std::pow(s, 24.0));
    const double r = spindle + wing * std::pow(std::abs(std::cos(angle)), 8.0) +
                     fin * std::pow(std::max(0.0, std::sin(angle)), 12.0);
    return {r * std::cos(angle), kBodyHalfLength_mm * (2.0 * s - 1.0), kFlatness * r * std::sin(angle)};
}

} // namespace

geometry::TriangleMesh paperBody()
{
    geometry::TriangleMesh mesh;
    mesh.vertices.emplace_back(0.0, -kBodyHalfLength_mm, 0.0);
    for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
        for (std::uint32_t meridian = 0; meridian < kMeridians; ++meridian) {
            mesh.vertices.push_back(pointAt(ring, meridian));
        }
    }
    mesh.vertices.emplace_back(0.0, kBodyHalfLength_mm, 0.0);
    const std::uint32_t nose = 0, tail = kRings * kMeridians + 1;
    const auto at = [](std::uint32_t ring, std::uint32_t meridian) {
        return 1 + (ring - 1) * kMeridians + meridian % kMeridians;
    };
    for (std::uint32_t j = 0; j < kMeridians; ++j) {
        mesh.triangles.push_back({nose, at(1, j), at(1, j + 1)});
        for (std::uint32_t i = 1; i < kRings; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        mesh.triangles.push_back({at(kRings, j), tail, at(kRings, j + 1)});
    }
    return mesh;
}

} // namespace palpate::evaluation
