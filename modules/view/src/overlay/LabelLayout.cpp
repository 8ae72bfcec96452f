// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/LabelLayout.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace palpate::view {

namespace {

using Point = Eigen::Vector2d;

constexpr double kGap_px = 2.0;   ///< between a label and other objects
constexpr int kRings = 9;         ///< candidate rings around a disc
constexpr double kRing_px = 12.0; ///< distance between rings

/// In order of preference: to the right of the disc first, where a label is most clearly associated with its disc.
const std::array<Point, 8> kDirections{Point(1, 1), Point(1, -1), Point(-1, 1), Point(-1, -1),
                                       Point(1, 0), Point(-1, 0), Point(0, 1),  Point(0, -1)};

/// Centre of the text in a direction, clear of the disc by the gap and the ring distance.
Point offsetTowards(const Point& direction, int ring, const DiscLabel& label, double discRadius_px)
{
    const double near = discRadius_px + kGap_px;
    return direction.cwiseProduct(0.5 * label.size_px + Point::Constant(near)) +
           direction.normalized() * kRing_px * ring;
}

bool overlap(const Point& a, const Point& aSize, const Point& b, const Point& bSize, double gap)
{
    return ((a - b).cwiseAbs().array() < (0.5 * (aSize + bSize)).array() + gap).all();
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const auto side = [](const Point& p, const Point& q, const Point& r) {
        return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
    };
    return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

Eigen::AlignedBox2d boxAbout(const Point& middle, const Point& size, double gap)
{
    const Point half = 0.5 * size + Point::Constant(gap);
    return {middle - half, middle + half};
}

Eigen::AlignedBox2d lineBox(const Point& from, const Point& to)
{
    return {from.cwiseMin(to), from.cwiseMax(to)};
}

/// Uniform grid of screen cells with the indices of the boxes that touch each cell, so that a box is compared with
/// its neighbours only. The grid is centred on the origin; boxes outside are clamped to the outermost cells.
class ScreenCells
{
  public:
    void add(std::size_t number, const Eigen::AlignedBox2d& box)
    {
        visit(box, [&](int& first) {
            m_entries.push_back({number, first});
            first = static_cast<int>(m_entries.size()) - 1;
            return false;
        });
    }

    /// Returns whether `test` is true for any box that shares a cell with this box; may test an index twice.
    template<typename Test>
    [[nodiscard]] bool any(const Eigen::AlignedBox2d& box, const Test& test)
    {
        return visit(box, [&](const int& first) {
            for (int i = first; i >= 0; i = m_entries[static_cast<std::size_t>(i)].next) {
                if (test(m_entries[static_cast<std::size_t>(i)].number)) {
                    return true;
                }
            }
            return false;
        });
    }

  private:
    static constexpr int kCells = 96;           // per side
    static constexpr double kCell_px = 24.0;    // about the size of a number
    static constexpr double kRounding_px = 0.1; // boxes that touch within rounding share a cell

    struct Entry
    {
        std::size_t number;
        int next; ///< next entry of the same cell, -1: end
    };

    /// Visits the cells of a box until `visitor` returns true.
    template<typename Visitor>
    bool visit(const Eigen::AlignedBox2d& box, const Visitor& visitor)
    {
        const auto cell = [&](const Point& p) {
            return (p / kCell_px + Point::Constant(0.5 * kCells))
                .cwiseMax(0.0)
                .cwiseMin(kCells - 1.0)
                .cast<int>()
                .eval();
        };
        const Eigen::Vector2i low = cell(box.min() - Point::Constant(kRounding_px));
        const Eigen::Vector2i high = cell(box.max() + Point::Constant(kRounding_px));
        for (int y = low.y(); y <= high.y(); ++y) {
            for (int x = low.x(); x <= high.x(); ++x) {
                if (visitor(m_first[static_cast<std::size_t>(y * kCells + x)])) {
                    return true;
                }
            }
        }
        return false;
    }

    /// First entry of each cell, row-major; -1: empty.
    std::vector<int> m_first = std::vector<int>(static_cast<std::size_t>(kCells) * kCells, -1);
    std::vector<Entry> m_entries;
};

} // namespace

void placeLabels(std::vector<DiscLabel>& labels, double discRadius_px, const std::vector<Eigen::AlignedBox2d>& taken)
{
    const Point disc = Point::Constant(2.0 * discRadius_px);
    ScreenCells discs, texts, lines;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        discs.add(i, boxAbout(labels[i].disc_px, disc, 0.0));
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        DiscLabel& own = labels[i];
        const auto isFree = [&](const Point& offset, bool mayCross) {
            const Point centre = own.disc_px + offset;
            const auto coversDisc = [&](std::size_t k) {
                return overlap(centre, own.size_px, labels[k].disc_px, disc, 0.5 * kGap_px);
            };
            const auto coversText = [&](std::size_t k) {
                const Point otherCentre = labels[k].disc_px + labels[k].offset_px;
                return overlap(centre, own.size_px, otherCentre, labels[k].size_px, kGap_px);
            };
            const auto crosses = [&](std::size_t k) {
                return cross(own.disc_px, centre, labels[k].disc_px, labels[k].disc_px + labels[k].offset_px);
            };
            const Eigen::AlignedBox2d box = boxAbout(centre, own.size_px, 0.0);
            const auto isCovered = [&](const Eigen::AlignedBox2d& other) { return box.intersects(other); };
            return std::none_of(taken.begin(), taken.end(), isCovered) &&
                   !discs.any(boxAbout(centre, own.size_px, 0.5 * kGap_px), coversDisc) &&
                   !texts.any(boxAbout(centre, own.size_px, kGap_px), coversText) &&
                   (mayCross || !lines.any(lineBox(own.disc_px, centre), crosses));
        };
        const Point usual = offsetTowards(kDirections[0], 0, own, discRadius_px);
        Point best = usual;
        bool found = isFree(usual, false);
        if (!found && !own.offset_px.isZero() && isFree(own.offset_px, true)) {
            best = own.offset_px;
            found = true;
        }
        for (int step = 0; step < 2 * kRings && !found; ++step) {
            for (const Point& direction : kDirections) {
                const Point offset = offsetTowards(direction, step % kRings, own, discRadius_px);
                if (isFree(offset, step >= kRings)) {
                    best = offset;
                    found = true;
                    break;
                }
            }
        }
        own.offset_px = best;
        own.isMoved = best != usual;
        texts.add(i, boxAbout(own.disc_px + best, own.size_px, 0.0));
        lines.add(i, lineBox(own.disc_px, own.disc_px + best));
    }
}

Point placeBeside(PointLabel& label, const std::vector<Eigen::AlignedBox2d>& taken, const Eigen::AlignedBox2d& view)
{
    constexpr int kWays = 8, kSteps = 24;
    constexpr double kStep_px = 12.0;
    // The label of a point outside the view is placed at the border.
    const Point point = label.point_px.cwiseMin(view.max()).cwiseMax(view.min());
    const double best = std::atan2(label.towards.y(), label.towards.x());
    const auto boxAt = [&](int place) {
        // The preferred direction, then alternately to either side.
        const int way = place % kWays;
        const double turn = (way % 2 == 1 ? 1 : -1) * ((way + 1) / 2) * (2.0 * std::numbers::pi / kWays);
        const Point direction(std::cos(best + turn), std::sin(best + turn));
        // Distance at which the edge of the text box just clears the point.
        const Point half = 0.5 * label.size_px + Point::Constant(kGap_px);
        const double clear = std::min(half.x() / std::max(1e-9, std::abs(direction.x())),
                                      half.y() / std::max(1e-9, std::abs(direction.y())));
        const Point centre = point + direction * (clear + kStep_px * (place / kWays));
        return Eigen::AlignedBox2d(centre - 0.5 * label.size_px, centre + 0.5 * label.size_px);
    };
    const auto isFree = [&](const Eigen::AlignedBox2d& box) {
        return view.contains(box) && std::none_of(taken.begin(), taken.end(), [&](const Eigen::AlignedBox2d& other) {
                   return !box.intersection(other).isEmpty();
               });
    };
    if (label.place >= 0 && isFree(boxAt(label.place))) {
        return boxAt(label.place).center();
    }
    for (int place = 0; place < kWays * kSteps; ++place) {
        if (const Eigen::AlignedBox2d box = boxAt(place); isFree(box)) {
            label.place = place;
            return box.center();
        }
    }
    label.place = -1;
    const Point low = view.min() + 0.5 * label.size_px, high = view.max() - 0.5 * label.size_px;
    return boxAt(0).center().cwiseMin(high).cwiseMax(low);
}

} // namespace palpate::view
