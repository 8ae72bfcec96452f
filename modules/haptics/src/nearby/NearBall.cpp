// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/NearBall.h"

#include "nearby/AsFloats.h"
#include "nearby/InsideShare.h"
#include "nearby/TriangleBatch.h"

#include <palpate/geometry/internal/BoxHierarchySwept.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate::haptics::internal {

namespace {

constexpr double kNever = 2.0;
constexpr double kLessThan = 1.0 - 1e-6; // safety factor for cosines in single precision
constexpr double kShort = 0.5; // radii; maximum length of a move that is filtered as a whole, from its midpoint
constexpr int kMostPieces = 8;
constexpr double kCellsOnWay = 3.0; // moves with more cells than this ahead are tested by a traversal of the hierarchy

// Prices in units of TickWork.
constexpr std::uint32_t kSweep = 24; // arithmetic per move
constexpr std::uint32_t kGroup = 2;  // distances of eight facets, or the test whether they oppose the move
constexpr std::uint32_t kExact = 4;  // exact test of one facet
constexpr std::uint32_t kTimed = 9;  // surcharge if the fraction is computed
constexpr std::uint32_t kMeets = 12; // surcharge if the facet blocks
constexpr std::uint32_t kNodeTest = 10;
constexpr std::uint32_t kFarNode = 26; // in a large layer: includes memory latency
constexpr std::uint32_t kBatch = 18;   // eight facets of the hierarchy

bool isBefore(const BallCrossing& a, const BallCrossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.stop != b.stop) {
        return a.stop < b.stop;
    }
    if (a.closing_mm != b.closing_mm) {
        return a.closing_mm > b.closing_mm; // of several touching facets, the one that opposes the move most
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

} // namespace

/// Keeps the first of the crossings offered. The result does not depend on the order of the offers.
struct NearBall::First
{
    const Vec3& x;
    const Vec3& y;
    double radius_mm;
    const TightRoom* room; ///< may be null
    BallCrossing& best;
    double limit;
    bool found = false;

    std::uint32_t price = 0; ///< price of all offers, in units of TickWork

    /// @param origin,reach_mm  origin of the groups, and their largest coordinate
    [[nodiscard]] Heading seenFrom(const Vec3& origin, float reach_mm) const noexcept
    {
        Heading heading{};
        heading.coordinate_mm = std::max(reach_mm, asFloats(x, origin, heading.x));
        const Vec3 move = y - x;
        const double length = move.norm();
        (void)asFloats(length > 0.0 ? Vec3(move / length) : move, Vec3::Zero(), heading.u);
        return heading;
    }

    /// Returns the minimum opposition of a facet of interest.
    [[nodiscard]] float cosine() const noexcept
    {
        return found && best.key == 0.0 ? static_cast<float>(kLessThan * best.closing_mm / (y - x).norm()) : 0.0f;
    }

    void offer(const HapticLayer& layer, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        price += kExact;
        const geometry::SurfaceIndex& surface = layer.surface(structure);
        BallCrossing crossing;
        const double least = found && best.key == 0.0 ? best.closing_mm : 0.0;
        const double kept_mm = room == nullptr ? radius_mm : room->radiusOff(layer, structure, triangle);
        const bool isBlocked =
            blocksBall(Facet::of(surface, structure, triangle), x, y, kept_mm, limit, crossing, least);
        price += crossing.isTimed ? kTimed : 0;
        if (!isBlocked) {
            return;
        }
        price += kMeets;
        if (!found || isBefore(crossing, best)) {
            best = crossing;
            limit = crossing.key;
            found = true;
        }
    }
};

/// Offers the facets that the ball may touch on the part `begin` to `end` of the move, which leads through the cell.
/// Facets are filtered by their distance from the midpoint of a short part, or from the start of a long one, which is
/// expected to end early.
void NearBall::offer(const HapticLayer& layer, const BallCell& cell, double begin, double end, TickWork& work,
                     First& first) noexcept
{
    const Vec3 part = (end - begin) * (first.y - first.x);
    const double length = part.norm();
    const bool isShort = length < kShort * first.radius_mm;
    const Vec3 half = isShort ? Vec3(0.5 * part) : Vec3(Vec3::Zero());
    float at[3], along[3];
    const Vec3 from = first.x + begin * (first.y - first.x);
    const float coordinate = std::max(cell.reach_mm(), asFloats(from + half, cell.origin(), at));
    (void)asFloats(half, Vec3::Zero(), along);
    alignas(32) float distance_mm[kMostTriangles];
    distances(cell.groups(), cell.count(), at, along, distance_mm);
    const double touching = first.radius_mm + leastDistanceRounding(coordinate, half.norm(), first.radius_mm);
    const auto opposing = [&](int group) {
        return opposingLanes(cell.groups()[group], first.seenFrom(cell.origin(), cell.reach_mm()), first.cosine());
    };
    const auto offer = [&](double beyond, double upTo) {
        first.price += kGroup * forEachOpposing(distance_mm, cell.count(), beyond, upTo, opposing, [&](int i) {
                           first.offer(layer, cell.structure(i), cell.triangle(i));
                       });
    };
    if (isShort) {
        offer(kAnyDistance, touching);
    } else {
        // Nearer facets first: an early crossing makes the rest unnecessary.
        double done = kAnyDistance;
        for (const double share : {0.01, 0.05, 0.25, 1.0}) {
            const double limit = end > begin ? (first.limit - begin) / (end - begin) : 1.0;
            const double upTo = touching + length * std::min(share, limit);
            offer(done, upTo);
            done = upTo;
            if (limit <= share) {
                break;
            }
        }
    }
    work.spend(kGroup * static_cast<std::uint32_t>((cell.count() + kLanes - 1) / kLanes) +
               std::exchange(first.price, 0u));
}

/// Tests the rest of a move by a traversal of the whole hierarchy.
class NearBall::Traversal
{
  public:
    /// @param begin  fraction of the move known to be free
    Traversal(const HapticLayer& layer, double begin, TickWork& work, First& first) noexcept
        : m_layer(layer)
        , m_begin(begin)
        , m_whole((first.y - first.x).norm())
        , m_u(m_whole > 0.0 ? Vec3((first.y - first.x) / m_whole) : Vec3(Vec3::Zero()))
        , m_from(first.x + begin * (first.y - first.x))
        , m_work(work)
        , m_first(first)
    {
        std::copy_n(m_from.data(), 3, m_from4);
        (void)asFloats(m_u, Vec3::Zero(), m_u3);
    }

    /// Returns the fraction of the move that was tested: 1, or less if the work was spent.
    double run() noexcept
    {
        const double reach = m_first.radius_mm + m_layer.skin_mm;
        visit(m_layer.hierarchy, reach, [&](std::uint32_t s, std::uint32_t n) {
            for (const std::uint32_t end = s + n; s < end && !m_work.isSpent(); ++s) {
                visitStructure(m_layer.structures[s], reach);
            }
        });
        flush();
        return m_free_mm < (1.0 - m_begin) * m_whole ? m_begin + m_free_mm / m_whole : 1.0;
    }

  private:
    [[nodiscard]] geometry::SweptPruning interest() const noexcept
    {
        // The minimum opposition is unknown for the rest of a move, which starts elsewhere.
        return {(m_first.limit - m_begin) / (1.0 - m_begin), m_begin > 0.0 ? 0.0 : m_first.cosine()};
    }

    template<class Leaf>
    void visit(const geometry::BoxHierarchy& hierarchy, double reach, Leaf&& leaf) noexcept
    {
        const std::uint32_t price = m_layer.isLarge ? kFarNode : kNodeTest;
        std::uint32_t nodes = m_work.left() / price, before = nodes;
        const double free =
            hierarchy.visitSwept(m_from, m_first.y, reach, interest(), nodes, [&](std::uint32_t i, std::uint32_t n) {
                m_work.spend(price * (before - nodes));
                leaf(i, n);
                nodes = before = m_work.left() / price;
                return m_work.isSpent() ? geometry::SweptPruning{-1.0, 0.0} : interest();
            });
        m_work.spend(price * (before - nodes));
        if (free < m_free_mm) {
            m_free_mm = free;
            m_work.spend(m_work.left());
        }
    }

    void visitStructure(std::uint32_t number, double reach) noexcept
    {
        const geometry::SurfaceIndex& surface = m_layer.surface(number);
        // The facets of a leaf are added when the next leaf is found, to hide the memory latency.
        std::uint32_t begin = 0, end = 0;
        const auto addLast = [&] {
            for (; begin < end; ++begin) {
                m_batch.add(surface, number, begin);
                if (m_batch.isFull()) {
                    flush();
                }
            }
        };
        visit(surface.hierarchy(), reach, [&](std::uint32_t i, std::uint32_t n) {
            surface.prefetchTriangles(i);
            addLast();
            begin = i;
            end = i + n;
        });
        addLast();
    }

    /// Offers the facets of the batch that the ball may touch.
    void flush() noexcept
    {
        if (m_batch.isEmpty()) {
            return;
        }
        float at[3], along[3];
        TriangleGroup group;
        const float reach = m_batch.derive(m_from4, group);
        // Closest approach of the ball on the remaining part of interest.
        const Extent extent = extentAlong(group, m_u3);
        const double rounding = kPlaceRounding * reach;
        const double most = std::max(0.0, m_first.limit * m_whole - m_begin * m_whole);
        const double low = std::clamp(extent.low_mm - rounding, 0.0, most);
        const double high = std::clamp(extent.high_mm + rounding, 0.0, most);
        const Vec3 half = 0.5 * (high - low) * m_u;
        const float coordinate = std::max(reach, asFloats(0.5 * (low + high) * m_u, Vec3::Zero(), at));
        (void)asFloats(half, Vec3::Zero(), along);
        alignas(32) float distance_mm[kLanes];
        distances(&group, m_batch.count(), at, along, distance_mm);
        const double touching = m_first.radius_mm + leastDistanceRounding(coordinate, half.norm(), m_first.radius_mm);
        m_first.price +=
            kGroup * forEachOpposing(
                         distance_mm, m_batch.count(), kAnyDistance, touching,
                         [&](int) { return opposingLanes(group, m_first.seenFrom(m_from, reach), m_first.cosine()); },
                         [&](int i) { m_first.offer(m_layer, m_batch.structure(i), m_batch.triangle(i)); });
        m_work.spend(kBatch + std::exchange(m_first.price, 0u));
        m_batch.clear();
    }

    const HapticLayer& m_layer;
    double m_begin;
    double m_whole; ///< length of the move [mm]
    /// Free length of the rest, before the first untested part.
    double m_free_mm = std::numeric_limits<double>::infinity();
    Vec3 m_u;    ///< direction of the move
    Vec3 m_from; ///< start of the rest [mm]
    double m_from4[4]{};
    float m_u3[3];
    TickWork& m_work;
    First& m_first;
    TriangleBatch m_batch;
};

void NearBall::prepare(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work) noexcept
{
    if ((y - x).cwiseAbs().maxCoeff() > kCellsOnWay * m_cells.size_mm(layer)) {
        return; // such moves are tested by a traversal of the hierarchy
    }
    (void)m_cells.at(layer, x, work);
    (void)m_cells.at(layer, y, work);
}

Sweep NearBall::sweep(const HapticLayer& layer, const TightRoom* room, const Vec3& x, const Vec3& y, TickWork& work,
                      BallCrossing& best) noexcept
{
    best.stop = 0.0;
    best.key = kNever;
    if (work.isSpent()) {
        return Sweep::Unknown;
    }
    if (x == y) {
        return Sweep::Free;
    }
    work.spend(kSweep);
    First first{x, y, layer.fingertip_mm, room, best, 1.0};
    const double length = (y - x).cwiseAbs().maxCoeff();
    double done = 0.0; // fraction of the move known to be free
    for (int piece = 0; piece < kMostPieces; ++piece) {
        const Vec3 p = x + done * (y - x);
        // A long move does not justify the price of a cell, unless the cell is paid for already.
        const bool isLong = (1.0 - done) * length > kCellsOnWay * m_cells.size_mm(layer);
        const BallCell* held = m_cells.paidAt(p);
        if (held == nullptr && isLong) {
            break;
        }
        const BallCell& cell = m_cells.at(layer, p, work);
        if (cell.isFull() || !cell.region().contains(p)) {
            break;
        }
        const double upTo = done + (1.0 - done) * insideFraction(cell.region(), p, y);
        first.limit = upTo;
        offer(layer, cell, done, upTo, work, first);
        if (first.found || upTo >= 1.0) {
            return first.found ? Sweep::Blocked : Sweep::Free;
        }
        done = upTo;
        if (work.isSpent()) {
            break;
        }
    }
    first.limit = 1.0;
    const double asked = Traversal(layer, done, work, first).run();
    if (first.limit > asked) {
        best.key = first.found ? best.key : kNever;
        best.stop = first.found ? std::min(best.stop, asked) : asked;
        return Sweep::Unknown;
    }
    return first.found ? Sweep::Blocked : Sweep::Free;
}

} // namespace palpate::haptics::internal
