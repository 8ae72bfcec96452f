// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/ContactSprings.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace palpate::evaluation {

namespace {

constexpr std::size_t kMostPlanes = 24; // planes whose combinations are tried: 2,324 sets
constexpr double kResolved = 1e-6;      // tolerance for rounding and the skin, relative to the spring and in mm

/// Multipliers of planes with the best fit to a spring, and the residual.
struct Resolved
{
    Eigen::VectorXd lambda_mm;
    Vec3 rest_mm;
};

Resolved resolve(std::span<const SpringPlane> planes, const Vec3& spring_mm)
{
    Eigen::Matrix<double, 3, Eigen::Dynamic> normals(3, static_cast<Eigen::Index>(planes.size()));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        normals.col(static_cast<Eigen::Index>(i)) = planes[i].n;
    }
    Resolved result{normals.colPivHouseholderQr().solve(spring_mm), Vec3::Zero()};
    result.lambda_mm = result.lambda_mm.cwiseMax(0.0);
    result.rest_mm = spring_mm - normals * result.lambda_mm;
    return result;
}

/// Merges identical planes, keeping the stiffest one as at a seam, and sorts by alignment with the spring.
std::vector<SpringPlane> distinct(const std::vector<SpringPlane>& touched, const Vec3& spring_mm)
{
    constexpr double kSame = 1e-9;
    std::vector<SpringPlane> planes;
    for (const SpringPlane& plane : touched) {
        const auto same = std::find_if(planes.begin(), planes.end(),
                                       [&](const SpringPlane& known) { return (known.n - plane.n).norm() < kSame; });
        if (same == planes.end()) {
            planes.push_back(plane);
        } else if (plane.stiffness_N_per_mm > same->stiffness_N_per_mm) {
            *same = plane;
        }
    }
    std::stable_sort(planes.begin(), planes.end(), [&](const SpringPlane& a, const SpringPlane& b) {
        return a.n.dot(spring_mm) > b.n.dot(spring_mm);
    });
    planes.resize(std::min(planes.size(), kMostPlanes), SpringPlane{});
    return planes;
}

/// Returns the smallest set of planes that supports the spring, or else the set with the smallest residual.
std::vector<SpringPlane> holding(const std::vector<SpringPlane>& planes, const Vec3& spring_mm)
{
    std::vector<SpringPlane> best;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](std::span<const SpringPlane> set) {
        const double rest = resolve(set, spring_mm).rest_mm.norm();
        if (rest < least) {
            least = rest;
            best.assign(set.begin(), set.end());
        }
    };
    const double enough = kResolved * std::max(1.0, spring_mm.norm());
    for (const SpringPlane& one : planes) {
        offer(std::array{one});
    }
    for (std::size_t i = 0; i < planes.size() && least > enough; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            offer(std::array{planes[i], planes[j]});
        }
    }
    for (std::size_t i = 0; i < planes.size() && least > enough; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                offer(std::array{planes[i], planes[j], planes[k]});
            }
        }
    }
    return best;
}

} // namespace

ContactSprings::ContactSprings(const std::vector<SpringPlane>& touched, const Vec3& spring_mm)
    : m_planes(holding(distinct(touched, spring_mm), spring_mm))
{
    m_stiffest_N_per_mm = 0.0;
    for (const SpringPlane& plane : m_planes) {
        m_stiffest_N_per_mm = std::max(m_stiffest_N_per_mm, plane.stiffness_N_per_mm);
    }
    const auto differs = [this](const SpringPlane& p) { return p.structure != m_planes.front().structure; };
    if (std::none_of(m_planes.begin(), m_planes.end(), differs)) {
        m_planes.clear();
    }
}

Vec3 ContactSprings::force(const Vec3& spring_mm) const
{
    if (m_planes.empty()) {
        return m_stiffest_N_per_mm * spring_mm;
    }
    const Resolved resolved = resolve(m_planes, spring_mm);
    struct Push
    {
        double stiffness_N_per_mm = 0.0, lambda_mm = 0.0;
        Vec3 push_mm = Vec3::Zero();
    };
    std::map<std::size_t, Push> byStructure;
    double lambda_mm = 0.0, weighted_N = 0.0;
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
        Push& push = byStructure[m_planes[i].structure];
        const double lambda = resolved.lambda_mm[static_cast<Eigen::Index>(i)];
        push.stiffness_N_per_mm = m_planes[i].stiffness_N_per_mm;
        push.push_mm += lambda * m_planes[i].n;
        lambda_mm += lambda;
        weighted_N += lambda * m_planes[i].stiffness_N_per_mm;
    }
    if (!(lambda_mm > 0.0)) {
        return m_stiffest_N_per_mm * spring_mm;
    }
    std::vector<Push> pushes;
    for (const auto& [structure, push] : byStructure) {
        pushes.push_back(push);
    }
    std::sort(pushes.begin(), pushes.end(),
              [](const Push& a, const Push& b) { return a.stiffness_N_per_mm < b.stiffness_N_per_mm; });
    const Vec3 all = spring_mm - resolved.rest_mm;
    Vec3 f_W = weighted_N / lambda_mm * resolved.rest_mm;
    double below = 0.0;
    for (std::size_t j = 0; j < pushes.size(); ++j) {
        Vec3 level = Vec3::Zero();
        for (std::size_t i = j; i < pushes.size(); ++i) {
            level += pushes[i].push_mm;
        }
        const double length2 = level.squaredNorm();
        const double reached = length2 > 0.0 ? std::clamp(all.dot(level) / length2, 0.0, 1.0) : 0.0;
        f_W += (pushes[j].stiffness_N_per_mm - below) * reached * level;
        below = pushes[j].stiffness_N_per_mm;
    }
    return f_W;
}

} // namespace palpate::evaluation
