// SPDX-License-Identifier: BSD-3-Clause
#include "LayerJudge.h"

#include <algorithm>

namespace palpate::adversary {

namespace {

/// Returns whether nothing blocks the move, by a wide margin: legal moves may be rejected, blocked moves are never
/// accepted. A facet counts as hit if the move comes within some skins.
bool isClearlyLegal(const JudgedLayer& layer, const Vec3& from, const Vec3& to, double fingertip_mm)
{
    const double beside = fingertip_mm > 0.0 ? fingertip_mm : 4.0 * layer.skin_mm;
    const core::Box box(from.cwiseMin(to).array() - beside, from.cwiseMax(to).array() + beside);
    for (const JudgedTriangle& t : layer.triangles) {
        if (!t.box.intersects(box)) {
            continue;
        }
        if (fingertip_mm <= 0.0) {
            double start = t.n.dot(from - t.corner[0]), end = t.n.dot(to - t.corner[0]);
            if (t.isTwoSided && start < 0.0) {
                start = -start;
                end = -end;
            }
            const bool isBehind = !t.isTwoSided && start < -0.125 * layer.skin_mm;
            if (isBehind || end >= start || end > 2.0 * layer.skin_mm) {
                continue;
            }
        }
        if (distanceOfSegment_mm(from, to, t.corner) <= beside) {
            return false;
        }
    }
    return true;
}

/// Normals and edges of the touched facets, which candidate moves follow.
struct Touched
{
    std::vector<Vec3> normals, edges;
};

Touched touchedAt(const JudgedLayer& layer, const Vec3& god, double fingertip_mm)
{
    Touched result;
    const double reach = fingertip_mm + 16.0 * layer.skin_mm;
    for (const JudgedTriangle& t : layer.triangles) {
        if (result.normals.size() >= 8 || t.box.exteriorDistance(god) > reach ||
            distanceToTriangle_mm(god, t.corner) > reach) {
            continue;
        }
        result.normals.push_back(t.n.dot(god - t.corner[0]) < 0.0 ? Vec3(-t.n) : t.n);
        for (std::size_t k = 0; k < 3; ++k) {
            result.edges.push_back((t.corner[(k + 1) % 3] - t.corner[k]).normalized());
            if (fingertip_mm > 0.0) { // around an edge or a corner, a ball rolls
                const Vec3 out = (god - t.corner[k]).normalized();
                result.edges.push_back(out.cross(result.edges.back()).normalized());
            }
        }
    }
    return result;
}

std::vector<Vec3> directions(const Touched& touched, const Vec3& pull, Chance& chance)
{
    std::vector<Vec3> result{pull.normalized()};
    for (std::size_t i = 0; i < touched.normals.size(); ++i) {
        const Vec3& n = touched.normals[i];
        result.push_back(pull - n.dot(pull) * n);
        for (std::size_t j = 0; j < i; ++j) {
            result.push_back(n.cross(touched.normals[j]));
        }
    }
    result.insert(result.end(), touched.edges.begin(), touched.edges.end());
    for (int i = 0; i < 16; ++i) {
        result.push_back(chance.direction());
    }
    for (Vec3& d : result) {
        const double length = d.norm();
        d = length > 1e-9 * pull.norm() ? Vec3(d / (d.dot(pull) < 0.0 ? -length : length)) : Vec3::Zero();
    }
    return result;
}

} // namespace

WayCloser wayCloser(const JudgedLayer& layer, const Vec3& god, const Vec3& hip, double fingertip_mm, double enough_mm,
                    const std::function<bool(const Vec3&)>& mayEnd, Chance& chance)
{
    WayCloser best;
    const Vec3 pull = hip - god;
    const double depth = pull.norm();
    if (depth <= enough_mm) {
        return best;
    }
    const Touched touched = touchedAt(layer, god, fingertip_mm);
    for (const Vec3& d : directions(touched, pull, chance)) {
        const double foot = d.dot(pull);
        for (const double share : {1.0, 0.3, 0.03, 1e-3}) {
            // Slightly raised off the facets along the path, so that rounding does not make them block.
            Vec3 to = god + share * foot * d;
            for (const Vec3& n : touched.normals) {
                to += n.dot(d) > -1e-7 ? Vec3(16.0 * layer.skin_mm * n) : Vec3::Zero();
            }
            const double gain = depth - (to - hip).norm();
            if (gain <= std::max(best.gain_mm, enough_mm)) {
                break; // a shorter move gains less
            }
            if (isClearlyLegal(layer, god, to, fingertip_mm) && mayEnd(to)) {
                best = {gain, to};
                break;
            }
        }
    }
    return best;
}

} // namespace palpate::adversary
