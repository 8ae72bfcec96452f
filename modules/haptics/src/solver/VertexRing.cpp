// SPDX-License-Identifier: BSD-3-Clause
#include "solver/VertexRing.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::internal {

namespace {

constexpr std::size_t kMostFacets = 16;

/// A facet as seen from the common corner: its edges to the other two corners, in the triangle's order.
struct Sector
{
    const Vec3* first;
    const Vec3* second;
};

/// Finds the corner shared by all facets, and tests whether they form one closed ring around this corner.
/// @return the corner, or null if they do not
const Vec3* closedRing(std::span<const Facet> facets, std::array<Sector, kMostFacets>& sectors) noexcept
{
    for (const Vec3* apex : {&facets[0].a, &facets[0].b, &facets[0].c}) {
        std::size_t n = 0;
        for (const Facet& f : facets) {
            if (f.a == *apex) {
                sectors[n++] = {&f.b, &f.c};
            } else if (f.b == *apex) {
                sectors[n++] = {&f.c, &f.a};
            } else if (f.c == *apex) {
                sectors[n++] = {&f.a, &f.b};
            } else {
                break;
            }
        }
        if (n < facets.size()) {
            continue;
        }
        // Traverse the ring once; each facet must end where exactly one other facet begins.
        std::size_t at = 0, steps = 0;
        do {
            std::size_t next = n;
            for (std::size_t i = 0; i < n; ++i) {
                if (*sectors[i].first == *sectors[at].second) {
                    if (next != n) {
                        return nullptr;
                    }
                    next = i;
                }
            }
            if (next == n) {
                return nullptr;
            }
            at = next;
            ++steps;
        } while (at != 0 && steps <= n);
        return steps == n ? apex : nullptr;
    }
    return nullptr;
}

} // namespace

bool isHeldByVertexRing(std::span<const Facet> facets, const Vec3& from, const Vec3& wanted, double enough_mm) noexcept
{
    if (facets.size() < 3 || facets.size() > kMostFacets ||
        std::any_of(facets.begin(), facets.end(), [](const Facet& f) { return f.isTwoSided; })) {
        return false;
    }
    std::array<Sector, kMostFacets> sectors;
    const Vec3* apex = closedRing(facets, sectors);
    if (apex == nullptr) {
        return false;
    }
    const double spring2 = wanted.squaredNorm(), enough2 = enough_mm * enough_mm;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const Vec3 p = *sectors[i].first - *apex, q = *sectors[i].second - *apex;
        const double along = p.dot(wanted);
        if (along > 0.0 && spring2 - along * along / p.squaredNorm() <= enough2) {
            return false;
        }
        const Vec3& n = facets[i].n;
        const double press = n.dot(wanted);
        // The sides of a sector are tested by signs of triple products; values within rounding count as inside.
        const double rounding = 1e-12 * std::sqrt(spring2);
        if (press < 0.0 && -press <= enough_mm && n.dot(p.cross(wanted)) >= -rounding * p.norm() &&
            n.dot(wanted.cross(q)) >= -rounding * q.norm()) {
            return false;
        }
    }
    const Vec3 to = from + wanted;
    Crossing crossing;
    return std::any_of(facets.begin(), facets.end(),
                       [&](const Facet& f) { return blocks(f, from, to, 1.0, crossing); });
}

} // namespace palpate::haptics::internal
