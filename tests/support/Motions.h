// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceMotion.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace palpate::test {

/// Returns a motion of random frames over a period of 4 s, scaled to nearly the largest strain.
inline std::shared_ptr<const geometry::SurfaceMotion> randomMotion(const core::Box& box, double spacing_mm,
                                                                   std::size_t frames, unsigned seed)
{
    using geometry::SurfaceMotion;
    const auto lattice = geometry::MotionLattice::around(box, spacing_mm);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> of(-1.0, 1.0);
    std::vector<std::vector<core::Vec3>> u(frames);
    for (auto& frame : u) {
        for (std::size_t i = 0; i < lattice.controlCount(); ++i) {
            frame.emplace_back(of(random), of(random), of(random));
        }
    }
    const auto scaled = [&u](double by) {
        auto out = u;
        for (auto& frame : out) {
            for (core::Vec3& at : frame) {
                at *= by;
            }
        }
        return out;
    };
    const double small = 1e-3 * spacing_mm;
    const double strain = SurfaceMotion::frames(4.0, lattice, scaled(small)).value()->strain();
    return SurfaceMotion::frames(4.0, lattice, scaled(small * 0.999 * SurfaceMotion::kMaxStrain / strain)).value();
}

/// Returns an oscillation along a direction by ± its length, sin(2π f t), as poses of one period.
inline std::shared_ptr<const geometry::SurfaceMotion> oscillation(const core::Vec3& amplitude_mm, double frequency_Hz)
{
    std::vector<geometry::PoseKey> keys;
    constexpr int kKeys = 64;
    for (int i = 0; i <= kKeys; ++i) {
        core::Transform pose = core::Transform::Identity();
        pose.translation() = std::sin(2.0 * std::numbers::pi * i / kKeys) * amplitude_mm;
        keys.push_back({i / (kKeys * frequency_Hz), pose});
    }
    keys.back().X_WR = keys.front().X_WR;
    return geometry::SurfaceMotion::poses(keys, true).value();
}

/// Returns a motion from the origin at constant speed for a time [mm/s, s].
inline std::shared_ptr<const geometry::SurfaceMotion> glide(const core::Vec3& v, double duration_s,
                                                            const core::Vec3& from = core::Vec3::Zero())
{
    core::Transform first = core::Transform::Identity(), last = core::Transform::Identity();
    first.translation() = from;
    last.translation() = from + duration_s * v;
    return geometry::SurfaceMotion::poses({{0.0, first}, {duration_s, last}}).value();
}

} // namespace palpate::test
