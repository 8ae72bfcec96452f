// SPDX-License-Identifier: BSD-3-Clause
#include "solver/CarryOver.h"

#include "palpate/haptics/Palpator.h"
#include "probe/BallProbe.h"
#include "probe/ConstrainedPoint.h"

#include <palpate/geometry/internal/BoxHierarchySwept.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace palpate::haptics::internal {

namespace {

constexpr double kFarthest_mm = 1.0; // maximum distance that a god-object is moved off a surface
constexpr std::uint32_t kMaxTriangles = 4096;
constexpr std::uint32_t kSearched = 512; // search range in the index, before and after the previous position
constexpr int kMaxRounds = 4;            // over all surfaces
constexpr std::size_t kPlanes = 4;       // that constrainedPoint takes
constexpr double kAbove = 2.0;           // skins: just out of contact
constexpr double kTurned = 0.5;          // cosine of the maximum turn

/// Returns the surface of the same structure in the previous scene; null if there is none.
const geometry::SurfaceIndex* predecessor(const HapticScene& before, const HapticScene& after,
                                          std::uint32_t structure) noexcept
{
    const auto &from = before.structures(), &to = after.structures();
    return structure < from.size() && from[structure].name == to[structure].name ? from[structure].surface.get()
                                                                                 : nullptr;
}

/// Position relative to a surface.
struct Against
{
    Facet facet;      ///< nearest facet; of several, the one with the position most nearly along its normal
    Vec3 q;           ///< closest point [mm]
    double height_mm; ///< signed distance; < 0: behind
    double agreement; ///< maximum cosine between the normals of the nearest facets and the given ones; -1 without those
};

/// Returns nothing if no triangle is within `reach_mm`, or too many are.
std::optional<Against> nearestWithin(const geometry::SurfaceIndex& surface, std::uint32_t structure, const Vec3& p,
                                     double reach_mm, std::span<const Vec3> normals = {}) noexcept
{
    if (surface.bounds().squaredExteriorDistance(p) > reach_mm * reach_mm) {
        return {};
    }
    std::uint32_t asked = 0;
    const auto eachNear = [&](auto&& use) {
        surface.hierarchy().visitAround(p, reach_mm, [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t i = first; i < first + count; ++i) {
                const Facet facet = Facet::of(surface, structure, i);
                const Nearest nearest = nearestOn(facet, p);
                use(facet, nearest.q, nearest.away.norm());
            }
            asked += count;
            return asked <= kMaxTriangles;
        });
    };
    double least = reach_mm;
    eachNear([&](const Facet&, const Vec3&, double distance) { least = std::min(least, distance); });
    if (asked > kMaxTriangles || least >= reach_mm) {
        return {};
    }
    asked = 0;
    std::optional<Against> against;
    double most = -1.0, agreement = -1.0;
    // At an edge or a corner several facets are nearest. The sign is taken from the facet with the position most nearly
    // along its normal: by the angle, because their distances differ by as much as a contact's.
    eachNear([&](const Facet& facet, const Vec3& q, double distance) {
        if (!(distance <= least + facet.skin_mm)) {
            return;
        }
        for (const Vec3& n : normals) {
            agreement = std::max(agreement, n.dot(facet.n));
        }
        const double along = facet.n.dot(p - q), cosine = distance > 0.0 ? std::abs(along) / distance : 1.0;
        if (cosine > most) {
            most = cosine;
            against = {facet, q, along < 0.0 ? -distance : distance, -1.0};
        }
    });
    if (against) {
        against->agreement = agreement;
    }
    return against;
}

/// Returns the mesh index of the triangle across an edge.
std::uint32_t beyond(const geometry::SurfaceIndex& surface, std::uint32_t triangle, std::uint32_t edge) noexcept
{
    const std::uint32_t neighbour = surface.neighbour(triangle, edge).triangle;
    return neighbour == geometry::SurfaceIndex::kNoNeighbour ? neighbour : surface.sourceTriangle(neighbour);
}

/// Finds the triangle with the same index in the mesh and the same neighbours, searching around its previous position:
/// the index is ordered by location, and a different triangle order in a file would change the neighbours.
std::optional<std::uint32_t> sameTriangle(const geometry::SurfaceIndex& from, std::uint32_t position,
                                          const geometry::SurfaceIndex& to) noexcept
{
    const std::uint32_t count = to.triangleCount(), source = from.sourceTriangle(position);
    if (count != from.triangleCount()) {
        return {};
    }
    const auto isSame = [&](std::uint32_t i) {
        return i < count && to.sourceTriangle(i) == source && beyond(to, i, 0) == beyond(from, position, 0) &&
               beyond(to, i, 1) == beyond(from, position, 1) && beyond(to, i, 2) == beyond(from, position, 2);
    };
    for (std::uint32_t off = 0; off <= kSearched; ++off) {
        if (isSame(position + off)) {
            return position + off;
        }
        if (off <= position && isSame(position - off)) {
            return position - off;
        }
    }
    return {};
}

/// Maps positions with a moving triangle: affine in its plane, with constant height above.
class Ride
{
  public:
    Ride(const Facet& from, const Facet& to) noexcept
        : m_from(from)
        , m_to(to)
    {
        const Vec3 u = from.b - from.a, v = from.c - from.a;
        const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), d = uu * vv - uv * uv;
        m_alongU = (vv * u - uv * v) / d;
        m_alongV = (uu * v - uv * u) / d;
    }
    [[nodiscard]] Vec3 taken(const Vec3& p) const noexcept
    {
        const Vec3 at = p - m_from.a;
        return m_to.a + m_alongU.dot(at) * (m_to.b - m_to.a) + m_alongV.dot(at) * (m_to.c - m_to.a) +
               m_from.n.dot(at) * m_to.n;
    }

  private:
    const Facet& m_from;
    const Facet& m_to;
    Vec3 m_alongU, m_alongV;
};

/// Returns the distance that the god-object keeps from a touched facet [mm]: the fingertip's radius, or less for a ball
/// that was placed nearer.
double heldDistance(const Facet& touched, const GodObjectState& god, double fingertip_mm) noexcept
{
    return god.placed == GodObjectState::kTight ? std::min(fingertip_mm, nearestOn(touched, god.p_WG).away.norm())
                                                : fingertip_mm;
}

/// Returns true if a replaced surface is unchanged where the god-object touches it.
/// @param held_mm  see heldDistance
bool isStillOn(const geometry::SurfaceIndex& surface, std::uint32_t structure, const GodObjectState& god,
               std::size_t contact, double held_mm) noexcept
{
    const double skin_mm = surface.skin_mm();
    const auto on = nearestWithin(surface, structure, god.p_WG, held_mm + 2.0 * kAbove * skin_mm);
    return on && std::abs(god.side[contact] * on->height_mm - held_mm) <= kAbove * skin_mm;
}

/// Returns the position that follows the contact; the current position if the contact no longer exists.
Vec3 ridden(const HapticScene& before, const HapticScene& after, const GodObjectState& god, const Vec3& p_WH,
            double fingertip_mm) noexcept
{
    for (std::size_t k = 0; k < god.constraints; ++k) {
        const std::uint32_t structure = god.structure[k];
        if (structure >= after.structures().size()) {
            continue;
        }
        const geometry::SurfaceIndex* from = predecessor(before, after, structure);
        const geometry::SurfaceIndex* to = after.structures()[structure].surface.get();
        if (from == nullptr || to == nullptr || from == to) {
            continue;
        }
        const Facet was = Facet::of(*from, structure, god.triangle[k]);
        if (isStillOn(*to, structure, god, k, heldDistance(was, god, fingertip_mm))) {
            return god.p_WG;
        }
        const auto there = sameTriangle(*from, god.triangle[k], *to);
        if (!there) {
            continue;
        }
        const Facet is = Facet::of(*to, structure, *there);
        const Ride ride(was, is);
        const Vec3 p_WG = ride.taken(god.p_WG);
        const bool isNear = (ride.taken(p_WH) - p_WH).norm() <= Palpator::kNear_mm; // false for NaN
        if (isNear && p_WG.allFinite() && was.n.dot(is.n) >= kTurned) {
            return p_WG;
        }
    }
    return god.p_WG;
}

/// Where the god-object was, relative to a surface of the previous scene.
struct Before
{
    int side = 0; ///< +1: in front, -1: behind a two-sided surface, 0: not to be kept out, or unknown
    std::array<Vec3, kPlanes> normals{}; ///< of the touched facets, or of the facet that determined the side
    std::size_t count = 0;               ///< of these normals
    /// Distance to be kept [mm]: the fingertip's radius, or less where the ball was nearer already.
    double clearance_mm = 0.0;
};

Before beforeAt(const geometry::SurfaceIndex& surface, std::uint32_t structure, const GodObjectState& god,
                double fingertip_mm) noexcept
{
    Before before;
    for (std::size_t k = 0; k < god.constraints && before.count < kPlanes; ++k) {
        if (god.structure[k] == structure) {
            const Facet touched = Facet::of(surface, structure, god.triangle[k]);
            const double held_mm = heldDistance(touched, god, fingertip_mm);
            before.side = god.side[k];
            before.clearance_mm = before.count == 0 ? held_mm : std::min(before.clearance_mm, held_mm);
            before.normals[before.count++] = touched.n;
        }
    }
    if (before.count > 0) {
        return before;
    }
    const auto was = nearestWithin(surface, structure, god.p_WG, kFarthest_mm + fingertip_mm);
    if (was && (was->height_mm >= 0.0 || was->facet.isTwoSided)) {
        before.side = was->height_mm < 0.0 ? -1 : 1;
        before.normals[before.count++] = was->facet.n;
        before.clearance_mm = std::min(fingertip_mm, std::abs(was->height_mm));
    }
    return before;
}

/// Returns the half-space of positions p with the required distance from the surface, as `n . (p - at)`, if `at` lacks
/// it and a position near enough has it.
std::optional<HalfSpace> inFront(const geometry::SurfaceIndex& surface, std::uint32_t structure, const Vec3& at,
                                 const Before& before, double fingertip_mm) noexcept
{
    if (before.side == 0) {
        return {};
    }
    const auto is = nearestWithin(surface, structure, at, kFarthest_mm + fingertip_mm,
                                  std::span(before.normals).first(before.count));
    if (!is) {
        return {};
    }
    int side = before.side;
    if (is->agreement < 0.0) { // turned inside out
        if (!is->facet.isTwoSided) {
            return {};
        }
        side = -side;
    }
    const double above_mm = kAbove * is->facet.skin_mm, height_mm = side * is->height_mm;
    const double missing_mm = before.clearance_mm - height_mm;
    // A ball keeps its distance within the tolerance of a contact; a point in front of the surface is legal at any
    // height.
    if (missing_mm <= (before.clearance_mm > 0.0 ? above_mm : 0.0) || missing_mm > kFarthest_mm) {
        return {};
    }
    const bool isOffEdge = std::abs(height_mm) > above_mm;
    const Vec3 up = isOffEdge ? Vec3((at - is->q) / height_mm) : Vec3(side * is->facet.n);
    return HalfSpace{up, missing_mm + above_mm};
}

/// The active half-spaces on the way to a position in front of all surfaces.
class Lift
{
  public:
    explicit Lift(const Vec3& from) noexcept
        : m_from(from)
    {
    }
    [[nodiscard]] Vec3 p() const noexcept { return m_from + m_u; }
    [[nodiscard]] bool isMoved() const noexcept { return m_count > 0; }
    /// Adds a half-space relative to p().
    void add(const HalfSpace& plane, double allowance_mm) noexcept
    {
        m_planes[m_count] = {plane.n, plane.offset_mm + plane.n.dot(m_u)};
        const auto nearest = constrainedPoint(Vec3::Zero(), {m_planes.data(), m_count + 1}, allowance_mm);
        m_u = nearest.u;
        std::array<HalfSpace, kPlanes> active;
        m_count = static_cast<std::size_t>(nearest.count);
        for (std::size_t i = 0; i < m_count; ++i) {
            active[i] = m_planes[nearest.active[i]];
        }
        m_planes = active;
    }

  private:
    Vec3 m_from;
    Vec3 m_u = Vec3::Zero();
    std::array<HalfSpace, kPlanes> m_planes;
    std::size_t m_count = 0; ///< at most three between calls
};

} // namespace

std::uint64_t keyOf(const HapticScene& scene, std::uint32_t structure) noexcept PALPATE_NONBLOCKING
{
    // FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv
    constexpr std::uint64_t kBasis = 14695981039346656037U, kPrime = 1099511628211U;
    std::uint64_t key = (kBasis ^ structure) * kPrime;
    for (const char c : scene.structures()[structure].name) {
        key = (key ^ static_cast<unsigned char>(c)) * kPrime;
    }
    return key;
}

std::optional<std::size_t> layerOf(const HapticScene& scene, std::uint64_t key) noexcept PALPATE_NONBLOCKING
{
    for (std::size_t layer = 0; layer < scene.layerCount(); ++layer) {
        for (const std::uint32_t structure : scene.layer(layer).structures) {
            if (keyOf(scene, structure) == key) {
                return layer;
            }
        }
    }
    return {};
}

bool touchesSheet(const HapticScene& scene, const GodObjectState& god) noexcept PALPATE_NONBLOCKING
{
    for (std::size_t k = 0; k < god.constraints; ++k) {
        if (scene.structures()[god.structure[k]].surface->isTwoSided(god.triangle[k])) {
            return true;
        }
    }
    return false;
}

LostContact lostContact(const HapticScene& before, const HapticScene* after, const GodObjectState& god,
                        const Vec3& p_WH) noexcept PALPATE_NONBLOCKING
{
    for (std::size_t k = 0; k < god.constraints; ++k) {
        const std::uint64_t key = keyOf(before, god.structure[k]);
        if (after == nullptr || !layerOf(*after, key)) {
            return {god.p_WG, p_WH, 0.0, key, 1, static_cast<std::uint8_t>(touchesSheet(before, god) ? 1 : 0)};
        }
    }
    return {};
}

Vec3 carryOverPosition(const HapticScene& before, const HapticScene& after, const HapticLayer& layer,
                       const GodObjectState& god, const Vec3& p_WH) noexcept PALPATE_NONBLOCKING
{
    const Vec3 unlifted = ridden(before, after, god, p_WH, layer.fingertip_mm);
    const bool isRidden = unlifted != god.p_WG;
    Lift lift(unlifted);
    Vec3 best = unlifted; // a position that violates the surfaces less than those before it
    double least_mm = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMaxRounds; ++round) {
        const Vec3 start = lift.p();
        if ((start - unlifted).norm() > kFarthest_mm) {
            break; // planes at a small angle meet farther away
        }
        double worst_mm = 0.0;
        for (const std::uint32_t structure : layer.structures) {
            const geometry::SurfaceIndex* from = predecessor(before, after, structure);
            const geometry::SurfaceIndex& to = layer.surface(structure);
            if (from == nullptr || (from == &to && !isRidden && !lift.isMoved())) {
                continue;
            }
            const Before was = beforeAt(*from, structure, god, layer.fingertip_mm);
            if (const auto plane = inFront(to, structure, lift.p(), was, layer.fingertip_mm)) {
                worst_mm = std::max(worst_mm, plane->offset_mm);
                lift.add(*plane, to.skin_mm());
            }
        }
        if (worst_mm < least_mm) {
            least_mm = worst_mm;
            best = start;
        }
        if (worst_mm == 0.0) {
            break;
        }
    }
    return best;
}

} // namespace palpate::haptics::internal
