// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Effort.h"

#include <palpate/geometry/SurfaceDistance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace palpate::ui {

void Effort::setMost(double most_N) noexcept
{
    m_most_N = std::isfinite(most_N) ? std::clamp(most_N, kLeast_N, kMost_N) : kUsual_N;
}

bool Effort::turn(double notches) noexcept
{
    const double wanted_N = m_most_N + notches * kNotch_N;
    setMost(wanted_N);
    return m_most_N == wanted_N;
}

void Effort::end() noexcept
{
    m_touches_s.reset();
    m_share.reset();
}

void Effort::setShare(double share) noexcept
{
    m_share = std::clamp(share, 0.0, 1.0);
}

double Effort::force_N(double now_s) const noexcept
{
    if (!m_touches_s || now_s < *m_touches_s) {
        return 0.0;
    }
    return m_share ? *m_share * m_most_N : std::min(m_most_N, kRise_N_per_s * (now_s - *m_touches_s));
}

std::vector<study::PressedSurface> surfacesAlongPress(const haptics::HapticScene& scene, const view::Ray& press,
                                                      double time_s, std::optional<double> fingertip_mm)
{
    constexpr double kFlattest = 0.05; // limits the correction for surfaces seen edge-on
    const double radius_mm = fingertip_mm.value_or(scene.fingertip_mm());
    std::vector<study::PressedSurface> found;
    for (std::size_t i = 0; i < scene.layerCount(); ++i) {
        std::optional<study::PressedSurface> first;
        for (const std::uint32_t number : scene.layer(i).structures) {
            const haptics::HapticStructure& one = scene.structures()[number];
            const auto hit = one.motion == nullptr
                                 ? view::firstHit(*one.surface, press)
                                 : view::firstHit(*one.surface, *one.motion, one.motion->at(time_s), press);
            if (!hit) {
                continue;
            }
            const bool isFromInside = hit->isBehind && !one.surface->isTwoSided(hit->triangle);
            const double slant = std::max(kFlattest, -hit->n_W.dot(press.d_W));
            const double entry_mm = hit->distance_mm - radius_mm / slant;
            if (!isFromInside && (!first || entry_mm < first->entry_mm)) {
                first = study::PressedSurface{&one, hit->triangle, hit->rest_W, entry_mm, slant};
            }
        }
        if (first) {
            found.push_back(*first);
        }
    }
    return found;
}

namespace {

/// Returns true if the surface can be touched where it is nearest: from its front, or from both sides.
bool isTouchable(const geometry::SurfaceIndex& surface, const core::Vec3& p, const core::Vec3& nearest)
{
    const core::Vec3 way = nearest - p;
    if (!(way.norm() > 0.0)) {
        return true;
    }
    const auto hit = view::firstHit(surface, {p, way.normalized()});
    return !hit || !hit->isBehind || surface.isTwoSided(hit->triangle);
}

} // namespace

double touchAlongRay_mm(const haptics::HapticScene& scene, const view::Ray& ray, double hit_mm, double time_s,
                        std::optional<double> fingertip_mm)
{
    // Sphere tracing: a step as long as the gap between ball and surfaces passes no surface.
    constexpr double kFarthest = 20.0; // start before the surface, in radii: enough for slants up to 87 degrees
    constexpr double kTouch = 1e-3;    // gap that counts as touch, in radii
    constexpr double kPast = 0.25;     // step beside a surface that cannot be touched from here, in radii
    constexpr int kMostSteps = 256;
    const double radius_mm = fingertip_mm.value_or(scene.fingertip_mm());
    if (!(radius_mm > 0.0)) {
        return hit_mm;
    }
    std::vector<geometry::SurfaceMotion::Moment> moments;
    for (const haptics::HapticStructure& one : scene.structures()) {
        moments.push_back(one.motion != nullptr ? one.motion->at(time_s) : geometry::SurfaceMotion::Moment());
    }
    const auto nearestOf = [&](std::size_t i, const core::Vec3& p_W, std::optional<double> within_mm) {
        const haptics::HapticStructure& one = scene.structures()[i];
        const core::Vec3 p = one.motion != nullptr ? one.motion->toRest(moments[i], p_W, p_W).X : p_W;
        const auto near = one.surface != nullptr ? geometry::nearestPoint(*one.surface, p, within_mm) : std::nullopt;
        return std::pair(p, near);
    };
    // Structures beside the ray are passed, so that a press reaches the surface at the pointer.
    std::vector<std::size_t> pointed;
    for (std::size_t i = 0; i < scene.structures().size(); ++i) {
        if (nearestOf(i, ray.p_W + hit_mm * ray.d_W, kTouch * radius_mm).second) {
            pointed.push_back(i);
        }
    }
    const auto gapAt = [&](const core::Vec3& p_W, double most_mm) {
        double least_mm = most_mm;
        for (const std::size_t i : pointed) {
            if (const auto [p, near] = nearestOf(i, p_W, least_mm + radius_mm); near) {
                const double gap_mm = near->distance_mm - radius_mm, past_mm = kPast * radius_mm;
                const bool blocks = gap_mm >= past_mm || isTouchable(*scene.structures()[i].surface, p, near->at);
                least_mm = std::min(least_mm, blocks ? gap_mm : past_mm);
            }
        }
        return least_mm;
    };
    double at_mm = std::max(0.0, hit_mm - kFarthest * radius_mm);
    for (int step = 0; step < kMostSteps && at_mm < hit_mm; ++step) {
        const double gap_mm = gapAt(ray.p_W + at_mm * ray.d_W, hit_mm - at_mm);
        if (gap_mm < kTouch * radius_mm) {
            break;
        }
        at_mm += gap_mm;
    }
    return std::min(at_mm, hit_mm);
}

} // namespace palpate::ui
