// SPDX-License-Identifier: BSD-3-Clause
#include "JudgedLayer.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace palpate::adversary {

namespace {

// The ray of `Body::winding` is not along an axis or a diagonal; the other two vectors span the projection plane.
const Vec3 kRay = Vec3(0.5377, 0.8339, -0.1259).normalized();
const Vec3 kAcross = kRay.cross(Vec3(0.318, -0.434, 0.843)).normalized();
const Vec3 kUp = kRay.cross(kAcross);
constexpr long double kRounding = 64 * std::numeric_limits<long double>::epsilon();

Eigen::Vector2d seen(const Vec3& p)
{
    return {kAcross.dot(p), kUp.dot(p)};
}

/// Returns the sign of a triple product of differences of doubles; 0 where rounding may affect the sign.
int signOfVolume(const Long3& a, const Long3& b, const Long3& c)
{
    const long double volume = a.dot(b.cross(c)), doubt = kRounding * a.norm() * b.norm() * c.norm();
    return volume > doubt ? 1 : volume < -doubt ? -1 : 0;
}

/// Returns the signed solid angle of a triangle.
/// @par Source
/// Van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
long double solidAngle(const Long3& a, const Long3& b, const Long3& c)
{
    const long double la = a.norm(), lb = b.norm(), lc = c.norm();
    const long double volume = a.dot(b.cross(c));
    return 2 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

} // namespace

Body::Body(std::vector<std::array<Vec3, 3>> triangles)
    : m_triangles(std::move(triangles))
{
    for (const auto& t : m_triangles) {
        Eigen::AlignedBox2d box;
        for (const Vec3& corner : t) {
            box.extend(seen(corner));
            m_box.extend(corner);
        }
        m_seen.push_back(box);
    }
    m_magnitude_mm = std::max(m_box.min().cwiseAbs().maxCoeff(), m_box.max().cwiseAbs().maxCoeff());
}

std::optional<int> Body::windingByRay(const Vec3& p) const
{
    const double rounding = 32 * std::numeric_limits<double>::epsilon() * (m_magnitude_mm + p.norm());
    const Eigen::Vector2d at = seen(p), low = at.array() + rounding, high = at.array() - rounding;
    const Long3 from = p.cast<long double>(), ray = kRay.cast<long double>();
    int turns = 0;
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
        if ((m_seen[i].min().array() > low.array()).any() || (m_seen[i].max().array() < high.array()).any()) {
            continue;
        }
        const auto& t = m_triangles[i];
        const Long3 a = t[0].cast<long double>() - from, b = t[1].cast<long double>() - from,
                    c = t[2].cast<long double>() - from;
        const int ab = signOfVolume(ray, a, b), bc = signOfVolume(ray, b, c), ca = signOfVolume(ray, c, a);
        if (std::max({ab, bc, ca}) - std::min({ab, bc, ca}) == 2) {
            continue; // misses the triangle
        }
        const int volume = signOfVolume(a, b, c);
        if (ab == 0 || bc == 0 || ca == 0 || volume == 0) {
            return std::nullopt;
        }
        if (volume == ab) { // ahead of the start; positive if the ray leaves through the front
            turns += volume;
        }
    }
    return turns;
}

std::optional<int> Body::winding(const Vec3& p) const
{
    if (!m_box.contains(p)) {
        return 0;
    }
    if (const auto turns = windingByRay(p)) {
        return turns;
    }
    long double sum = 0;
    const Long3 from = p.cast<long double>();
    for (const auto& t : m_triangles) {
        sum += solidAngle(t[0].cast<long double>() - from, t[1].cast<long double>() - from,
                          t[2].cast<long double>() - from);
    }
    const long double turns = sum / (4 * std::numbers::pi_v<long double>);
    if (std::abs(turns - std::round(turns)) > 0.01L) {
        return std::nullopt;
    }
    return static_cast<int>(std::lround(turns));
}

double Body::distance_mm(const Vec3& p) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : m_triangles) {
        least = std::min(least, distanceToTriangle_mm(p, t));
    }
    return least;
}

JudgedLayer::JudgedLayer(const RandomScene& scene, std::uint32_t layer)
{
    for (std::uint32_t i = 0; i < scene.structures.size(); ++i) {
        if (scene.structures[i].layer == layer) {
            add(scene.structures[i].mesh, i);
            skin_mm = std::max(skin_mm, scene.structures[i].surface->skin_mm());
        }
    }
}

namespace {

/// The triangles of one structure over welded vertices, without duplicates.
struct Welded
{
    std::vector<std::uint32_t> number; ///< per vertex: the first vertex with the same coordinates
    std::vector<std::uint32_t> kept;   ///< indices of triangles in the mesh
    std::vector<std::uint32_t> keptAs; ///< per triangle of the mesh: index in `kept` of the triangle or its duplicate
    std::vector<std::uint32_t> part;   ///< per entry of `kept`
    std::vector<char> isTwoSided;      ///< per entry of `kept`
    std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> rims; ///< per part: rim edges as vertex pairs
};

/// @return 1 if `other` is the same triangle with the same winding, -1 if reversed
int sameWinding(const Triangle& t, const Triangle& other)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (t[0] == other[k]) {
            return t[1] == other[(k + 1) % 3] ? 1 : -1;
        }
    }
    return -1;
}

Triangle corners(const Welded& welded, const TriangleMesh& mesh, std::uint32_t i)
{
    const Triangle& t = mesh.triangles[i];
    return {welded.number[t[0]], welded.number[t[1]], welded.number[t[2]]};
}

void weld(Welded& welded, const TriangleMesh& mesh)
{
    std::map<std::array<double, 3>, std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3& v = mesh.vertices[i];
        welded.number.push_back(vertices.try_emplace({v.x(), v.y(), v.z()}, i).first->second);
    }
    std::map<Triangle, std::uint32_t> once;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle sorted = corners(welded, mesh, i);
        std::sort(sorted.begin(), sorted.end());
        const auto [at, isNew] = once.try_emplace(sorted, static_cast<std::uint32_t>(welded.kept.size()));
        if (isNew) {
            welded.kept.push_back(i);
        }
        welded.keptAs.push_back(at->second);
    }
}

void findParts(Welded& welded, const TriangleMesh& mesh)
{
    struct Edge
    {
        int count = 0, balance = 0;
        std::uint32_t first = 0;
    };
    std::map<std::array<std::uint32_t, 2>, Edge> edges;
    std::vector<std::uint32_t> root(welded.kept.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&root](std::uint32_t i) {
        while (root[i] != i) {
            i = root[i] = root[root[i]];
        }
        return i;
    };
    for (std::uint32_t i = 0; i < welded.kept.size(); ++i) {
        const Triangle t = corners(welded, mesh, welded.kept[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
            if (edge.count == 0) {
                edge.first = i;
            }
            root[find(i)] = find(edge.first);
            ++edge.count;
            edge.balance += a < b ? 1 : -1;
        }
    }
    std::set<std::uint32_t> open;
    for (const auto& [ends, edge] : edges) {
        if (edge.balance != 0) {
            open.insert(find(edge.first));
        }
        if (edge.count % 2 != 0) {
            welded.rims[find(edge.first)].push_back(ends);
        }
    }
    for (std::uint32_t i = 0; i < welded.kept.size(); ++i) {
        welded.part.push_back(find(i));
        welded.isTwoSided.push_back(open.count(find(i)) != 0 ? 1 : 0);
    }
}

} // namespace

void JudgedLayer::add(const RandomMesh& source, std::uint32_t structure)
{
    const TriangleMesh& mesh = source.mesh;
    Welded welded;
    weld(welded, mesh);
    findParts(welded, mesh);
    const auto cornersOf = [&mesh](std::uint32_t i) {
        const Triangle& t = mesh.triangles[i];
        return std::array<Vec3, 3>{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    };
    std::map<std::uint32_t, Sheet> parts;
    const std::size_t first = triangles.size();
    for (std::size_t i = 0; i < welded.kept.size(); ++i) {
        JudgedTriangle triangle;
        triangle.corner = cornersOf(welded.kept[i]);
        triangle.n = (triangle.corner[1] - triangle.corner[0]).cross(triangle.corner[2] - triangle.corner[0]);
        triangle.n.normalize();
        for (const Vec3& corner : triangle.corner) {
            triangle.box.extend(corner);
        }
        triangle.structure = structure;
        triangle.isTwoSided = welded.isTwoSided[i] != 0;
        if (triangle.isTwoSided) {
            Sheet& sheet = parts[welded.part[i]];
            sheet.triangles.push_back(static_cast<std::uint32_t>(triangles.size()));
            sheet.box.extend(triangle.box);
        }
        triangles.push_back(triangle);
    }
    for (auto& [part, sheet] : parts) {
        for (const auto& ends : welded.rims[part]) {
            sheet.rim.push_back({mesh.vertices[ends[0]], mesh.vertices[ends[1]]});
        }
        sheets.push_back(std::move(sheet));
    }
    for (const std::vector<std::uint32_t>& body : source.bodies) {
        std::vector<std::array<Vec3, 3>> all;
        std::size_t twoSided = 0, turned = 0;
        for (const std::uint32_t i : body) {
            const std::uint32_t kept = welded.keptAs[i];
            all.push_back(cornersOf(i));
            twoSided += welded.isTwoSided[kept] != 0 ? 1 : 0;
            turned += sameWinding(corners(welded, mesh, i), corners(welded, mesh, welded.kept[kept])) < 0 ? 1 : 0;
        }
        // A mix of one-sided and two-sided triangles does not determine where the god-object may pass.
        if (twoSided == body.size() || (twoSided == 0 && turned == 0)) {
            bodies.emplace_back(std::move(all));
            bodies.back().isOneSided = twoSided == 0;
            for (std::size_t k = 0; source.isSolid && k < body.size(); ++k) {
                triangles[first + welded.keptAs[body[k]]].solid = static_cast<int>(bodies.size()) - 1;
            }
        }
    }
}

double distanceToSegment_mm(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 way = b - a;
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp((p - a).dot(way) / square, 0.0, 1.0) : 0.0;
    return (p - a - share * way).norm();
}

double distanceToTriangle_mm(const Vec3& p, const std::array<Vec3, 3>& t)
{
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]), a = t[0] - p, b = t[1] - p, c = t[2] - p;
    if (n.dot(a.cross(b)) >= 0.0 && n.dot(b.cross(c)) >= 0.0 && n.dot(c.cross(a)) >= 0.0) {
        return std::abs(n.dot(a)) / n.norm();
    }
    return std::min({distanceToSegment_mm(p, t[0], t[1]), distanceToSegment_mm(p, t[1], t[2]),
                     distanceToSegment_mm(p, t[2], t[0])});
}

namespace {

double distanceOfSegments_mm(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b)
{
    // Interior of both where the lines are closest; else at an end of either.
    const Vec3 u = to - from, v = b - a, w = from - a;
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), det = uu * vv - uv * uv;
    double least = std::min({distanceToSegment_mm(from, a, b), distanceToSegment_mm(to, a, b),
                             distanceToSegment_mm(a, from, to), distanceToSegment_mm(b, from, to)});
    if (det > 0.0) {
        const double s = (uv * v.dot(w) - vv * u.dot(w)) / det, t = (uu * v.dot(w) - uv * u.dot(w)) / det;
        if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
            least = std::min(least, (w + s * u - t * v).norm());
        }
    }
    return least;
}

} // namespace

double distanceOfSegment_mm(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t)
{
    if (crosses(from, to, t).value_or(true)) {
        return 0.0;
    }
    double least = std::min(distanceToTriangle_mm(from, t), distanceToTriangle_mm(to, t));
    for (std::size_t k = 0; k < 3; ++k) {
        least = std::min(least, distanceOfSegments_mm(from, to, t[k], t[(k + 1) % 3]));
    }
    return least;
}

std::optional<bool> crosses(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t)
{
    const Long3 start = from.cast<long double>(), way = to.cast<long double>() - start;
    const Long3 a = t[0].cast<long double>() - start, b = t[1].cast<long double>() - start,
                c = t[2].cast<long double>() - start;
    const int ab = signOfVolume(way, a, b), bc = signOfVolume(way, b, c), ca = signOfVolume(way, c, a);
    if (std::max({ab, bc, ca}) - std::min({ab, bc, ca}) == 2) {
        return false;
    }
    const int before = signOfVolume(a, b, c), after = signOfVolume(a - way, b - way, c - way);
    if (before * after > 0) {
        return false;
    }
    if (ab == 0 || bc == 0 || ca == 0 || before == 0 || after == 0) {
        return std::nullopt;
    }
    return true;
}

} // namespace palpate::adversary
