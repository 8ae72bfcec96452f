// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Subject.h"
#include "reference/ClosestPoint.h"
#include "scenes/HandPath.h"

#include <limits>
#include <numbers>

namespace palpate::evaluation {

namespace {

/// Random walk on a surface: steps in a direction and projects back to the nearest surface point.
class SurfaceWalk
{
  public:
    SurfaceWalk(const Surface& surface, std::uint64_t seed)
        : m_surface(surface)
        , m_dice(seed)
    {
        // The extreme vertex in any direction is on the outside, whatever the surface.
        const Vec3 out = m_dice.normal3().normalized();
        double farthest = -std::numeric_limits<double>::infinity();
        std::uint32_t triangle = 0;
        for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
            const double d = out.dot(surface.corner(i, 0) + surface.corner(i, 1) + surface.corner(i, 2));
            if (d > farthest) {
                farthest = d;
                triangle = i;
            }
        }
        m_at = (surface.corner(triangle, 0) + surface.corner(triangle, 1) + surface.corner(triangle, 2)) / 3.0;
        m_n = normal(triangle);
        m_n = m_n.dot(out) < 0.0 && surface.isTwoSided(triangle) ? Vec3(-m_n) : m_n;
        m_heading = m_n.unitOrthogonal();
    }

    void step(double length_mm)
    {
        m_turn += 0.01 * (0.3 * m_dice.normal() - m_turn);
        m_heading = Eigen::AngleAxisd(m_turn * length_mm, m_n) * m_heading;
        const Vec3 wanted = m_at + length_mm * m_heading;
        std::uint32_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        Vec3 put = wanted;
        for (double reach = 2.0 * length_mm; least > reach && reach < m_surface.bounds().sizes().sum(); reach *= 2.0) {
            m_near.clear();
            m_surface.appendNear(Box(wanted.array() - reach, wanted.array() + reach), m_near);
            for (const std::uint32_t i : m_near) {
                const Vec3 q = closestPoint<double>(m_surface.corner(i, 0), m_surface.corner(i, 1),
                                                    m_surface.corner(i, 2), wanted);
                if ((q - wanted).norm() < least) {
                    least = (q - wanted).norm();
                    put = q;
                    nearest = i;
                }
            }
        }
        m_at = put;
        const Vec3 n = normal(nearest);
        // Smooth the normal: a hand does not follow every facet.
        m_n = (m_n + 0.05 * (m_surface.isTwoSided(nearest) && n.dot(m_n) < 0.0 ? Vec3(-n) : n)).normalized();
        const Vec3 along = m_heading - m_n * m_n.dot(m_heading);
        m_heading = along.norm() > 1e-6 ? Vec3(along.normalized()) : m_n.unitOrthogonal();
    }

    [[nodiscard]] Vec3 above(double height_mm) const { return m_at + height_mm * m_n; }

  private:
    [[nodiscard]] Vec3 normal(std::uint32_t i) const
    {
        const Vec3& a = m_surface.corner(i, 0);
        return (m_surface.corner(i, 1) - a).cross(m_surface.corner(i, 2) - a).normalized();
    }

    const Surface& m_surface;
    RandomSource m_dice;
    Vec3 m_at = Vec3::Zero(), m_n = Vec3::UnitZ(), m_heading = Vec3::UnitX();
    double m_turn = 0.0;
    std::vector<std::uint32_t> m_near;
};

constexpr int kPerMillisecond = static_cast<int>(HandMotion::kBase_Hz / 1000.0);

/// Slide speed: 100 mm/s on subjects of 200 mm or more, slower on smaller ones. [mm per base sample]
double slidePerSample(const Surface& surface)
{
    return std::min(100.0, 0.5 * surface.bounds().sizes().maxCoeff()) / HandMotion::kBase_Hz;
}

/// Press depth: 5 mm, or a tenth of a small subject.
double pressDepth(const Surface& surface)
{
    return std::min(5.0, 0.1 * surface.bounds().sizes().maxCoeff());
}

HandMotion slide(const Surface& surface, std::uint64_t seed, int milliseconds)
{
    HandMotion motion{"press and slide", {}};
    SurfaceWalk walk(surface, seed);
    const double depth = pressDepth(surface);
    const int approach = kPerMillisecond * 60, samples = kPerMillisecond * milliseconds;
    const double step = slidePerSample(surface);
    for (int i = 0; i < samples; ++i) {
        const double share = std::min(1.0, double(i) / approach);
        const double height = depth * (0.4 - 1.4 * share * share * (3.0 - 2.0 * share));
        if (i >= approach) {
            walk.step(step);
        }
        motion.p_WH.push_back(walk.above(height));
    }
    return motion;
}

HandMotion poke(const Surface& surface, std::uint64_t seed, int milliseconds)
{
    HandMotion motion{"poke", {}};
    SurfaceWalk walk(surface, seed);
    const double depth = pressDepth(surface);
    const int period = kPerMillisecond * 50;
    for (int i = 0; i < kPerMillisecond * milliseconds; ++i) {
        const double phase = 2.0 * std::numbers::pi * (i % period) / period;
        if (std::cos(phase) > 0.0) {
            walk.step(1.5 * slidePerSample(surface)); // advance while above the surface
        }
        motion.p_WH.push_back(walk.above(depth * (0.9 * std::cos(phase) + 0.1)));
    }
    return motion;
}

} // namespace

HandMotion resampled(std::string name, const std::vector<Vec3>& p_WH, double dt_s)
{
    HandMotion motion{std::move(name), {}};
    const double perSample = dt_s * HandMotion::kBase_Hz;
    const auto count = static_cast<std::size_t>(std::floor(double(p_WH.size() - 1) * perSample + 1e-9)) + 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = double(i) / perSample;
        const auto k = std::min(static_cast<std::size_t>(at), p_WH.size() - 1);
        const double share = at - double(k);
        const Vec3& next = p_WH[std::min(k + 1, p_WH.size() - 1)];
        motion.p_WH.push_back(share > 1e-9 ? Vec3(p_WH[k] + share * (next - p_WH[k])) : p_WH[k]);
    }
    return motion;
}

std::vector<HandMotion> standardMotions(const Surface& surface, std::uint64_t seed, int milliseconds)
{
    // Four random streams per seed, not shared with any other seed.
    const std::uint64_t first = 4 * seed;
    HandMotion noisy = slide(surface, first + 2, milliseconds);
    noisy.name = "slide with noise";
    const double noise_mm = std::min(0.1, 1e-3 * surface.bounds().sizes().maxCoeff());
    RandomSource dice(first + 3);
    for (Vec3& p : noisy.p_WH) {
        p += noise_mm / std::sqrt(3.0) * dice.normal3();
    }
    return {slide(surface, first, milliseconds), poke(surface, first + 1, milliseconds), std::move(noisy)};
}

} // namespace palpate::evaluation
