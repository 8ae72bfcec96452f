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

constexpr double kGap_px = 2.0;   ///< between a label and what it stays clear of
constexpr int kRings = 9;         ///< of places about a disc
constexpr double kRing_px = 12.0; ///< from one ring to the next

/// Preferred first: a text to the right of its disc is read as the disc's.
const std::array<Point, 8> kDirections{Point(1, 1), Point(1, -1), Point(-1, 1), Point(-1, -1),
                                       Point(1, 0), Point(-1, 0), Point(0, 1),  Point(0, -1)};

/// Centre of the text in a direction, clear of the disc by the gap and the ring.
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

} // namespace

void placeLabels(std::vector<DiscLabel>& labels, double discRadius_px)
{
    const Point disc = Point::Constant(2.0 * discRadius_px);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        DiscLabel& own = labels[i];
        const auto isFree = [&](const Point& offset, bool mayCross) {
            const Point centre = own.disc_px + offset;
            for (std::size_t k = 0; k < labels.size(); ++k) {
                const DiscLabel& other = labels[k];
                if (overlap(centre, own.size_px, other.disc_px, disc, 0.5 * kGap_px)) {
                    return false;
                }
                const Point otherCentre = other.disc_px + other.offset_px;
                if (k < i && (overlap(centre, own.size_px, otherCentre, other.size_px, kGap_px) ||
                              (!mayCross && cross(own.disc_px, centre, other.disc_px, otherCentre)))) {
                    return false;
                }
            }
            return true;
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
    }
}

Point placeBeside(PointLabel& label, const std::vector<Eigen::AlignedBox2d>& taken, const Eigen::AlignedBox2d& view)
{
    constexpr int kWays = 8, kSteps = 12;
    constexpr double kStep_px = 12.0;
    const double best = std::atan2(label.towards.y(), label.towards.x());
    const auto boxAt = [&](int place) {
        // The way that it had best be, then alternately to either side of it.
        const int way = place % kWays;
        const double turn = (way % 2 == 1 ? 1 : -1) * ((way + 1) / 2) * (2.0 * std::numbers::pi / kWays);
        const Point direction(std::cos(best + turn), std::sin(best + turn));
        // So far that the text's box ends beside the point.
        const Point half = 0.5 * label.size_px + Point::Constant(kGap_px);
        const double clear = std::min(half.x() / std::max(1e-9, std::abs(direction.x())),
                                      half.y() / std::max(1e-9, std::abs(direction.y())));
        const Point centre = label.point_px + direction * (clear + kStep_px * (place / kWays));
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
