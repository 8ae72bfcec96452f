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
constexpr double kLessThan = 1.0 - 1e-6; // so much of a cosine, in floats, is surely less
constexpr double kShort = 0.5;           // radii: a move that is ruled out as a whole, from its middle
constexpr int kMostPieces = 8;
constexpr double kCellsOnWay = 3.0; // with more than so many cells still to go, a move is asked of the whole hierarchy

// In units of TickWork.
constexpr std::uint32_t kSweep = 24; // the move's own arithmetic
constexpr std::uint32_t kGroup = 2;  // eight facets' distances, or which of them stand against the move
constexpr std::uint32_t kExact = 4;  // the exact test of one
constexpr std::uint32_t kTimed = 9;  // and more where it asks for the share
constexpr std::uint32_t kMeets = 12; // and more where it blocks
constexpr std::uint32_t kNode = 10;
constexpr std::uint32_t kFarNode = 26; // where the layer is large: it has to be waited for
constexpr std::uint32_t kBatch = 18;   // of eight facets of the hierarchy

bool isBefore(const BallCrossing& a, const BallCrossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.stop != b.stop) {
        return a.stop < b.stop;
    }
    if (a.closing_mm != b.closing_mm) {
        return a.closing_mm > b.closing_mm; // of many that touch, the one that stands most against the move
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

} // namespace

/// Keeps the first crossing of those offered. The order of the offers does not matter.
struct NearBall::First
{
    const Vec3& x;
    const Vec3& y;
    double radius_mm;
    BallCrossing& best;
    double limit;
    bool found = false;

    std::uint32_t price = 0; ///< of all that was offered, in units of TickWork

    /// @param origin,reach_mm  of the groups, and their largest coordinate
    [[nodiscard]] Heading seenFrom(const Vec3& origin, float reach_mm) const noexcept
    {
        Heading heading{};
        heading.coordinate_mm = std::max(reach_mm, asFloats(x, origin, heading.x));
        const Vec3 move = y - x;
        const double length = move.norm();
        (void)asFloats(length > 0.0 ? Vec3(move / length) : move, Vec3::Zero(), heading.u);
        return heading;
    }

    /// @return how much a facet must at least stand against the move to be of interest
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
        const bool isBlocked =
            blocksBall(Facet::of(surface, structure, triangle), x, y, radius_mm, limit, crossing, least);
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

/// Offers what the ball may touch on the part `begin` … `end` of the move, which leads through the cell. Facets are
/// ruled out by their distance from the middle of a short part, from the beginning of a long one, which is expected to
/// end early.
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
        // The nearer facets first: an early crossing spares the rest.
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

/// Asks the whole hierarchy for the rest of a move.
class NearBall::Traversal
{
  public:
    /// @param begin  share of the move that is known to be free
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

    /// @return the share of the move up to which all was asked: 1, or less where the work was spent
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
    [[nodiscard]] geometry::SweptInterest interest() const noexcept
    {
        // Of the rest of a move, which begins elsewhere, no cosine is known.
        return {(m_first.limit - m_begin) / (1.0 - m_begin), m_begin > 0.0 ? 0.0 : m_first.cosine()};
    }

    template<class Leaf>
    void visit(const geometry::BoxHierarchy& hierarchy, double reach, Leaf&& leaf) noexcept
    {
        const std::uint32_t price = m_layer.isLarge ? kFarNode : kNode;
        std::uint32_t nodes = m_work.left() / price, before = nodes;
        const double free =
            hierarchy.visitSwept(m_from, m_first.y, reach, interest(), nodes, [&](std::uint32_t i, std::uint32_t n) {
                m_work.spend(price * (before - nodes));
                leaf(i, n);
                nodes = before = m_work.left() / price;
                return m_work.isSpent() ? geometry::SweptInterest{-1.0, 0.0} : interest();
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
        // A leaf's facets are added when the next is found: until then the memory has time.
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

    /// Offers those of the batch that the ball may touch.
    void flush() noexcept
    {
        if (m_batch.isEmpty()) {
            return;
        }
        float at[3], along[3];
        TriangleGroup group;
        const float reach = m_batch.derive(m_from4, group);
        // Where on the way that is still of interest the ball comes nearest to them.
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
    double m_whole;                                             ///< length of the move [mm]
    double m_free_mm = std::numeric_limits<double>::infinity(); ///< of the rest, before what was not asked
    Vec3 m_u;                                                   ///< its direction
    Vec3 m_from;                                                ///< where the rest begins [mm]
    double m_from4[4]{};
    float m_u3[3];
    TickWork& m_work;
    First& m_first;
    TriangleBatch m_batch;
};

void NearBall::prepare(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work) noexcept
{
    if ((y - x).cwiseAbs().maxCoeff() > kCellsOnWay * m_cells.size_mm(layer)) {
        return; // such moves are asked of the whole hierarchy
    }
    (void)m_cells.at(layer, x, work);
    (void)m_cells.at(layer, y, work);
}

Sweep NearBall::sweep(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work,
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
    First first{x, y, layer.fingertip_mm, best, 1.0};
    const double length = (y - x).cwiseAbs().maxCoeff();
    double done = 0.0; // share of the move that is known to be free
    for (int piece = 0; piece < kMostPieces; ++piece) {
        const Vec3 p = x + done * (y - x);
        // A cell is not worth its price to a long move, unless it is paid for already.
        const bool isLong = (1.0 - done) * length > kCellsOnWay * m_cells.size_mm(layer);
        const BallCell* held = m_cells.paidAt(p);
        if (held == nullptr && isLong) {
            break;
        }
        const BallCell& cell = m_cells.at(layer, p, work);
        if (cell.isFull() || !cell.region().contains(p)) {
            break;
        }
        const double upTo = done + (1.0 - done) * insideShare(cell.region(), p, y);
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
