// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/PlaneLanes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace palpate::haptics::internal {

/// Eight triangles as floats relative to an origin near them: for distances from a point to all of them at once.
struct alignas(32) TriangleGroup
{
    Corners corners;           ///< [mm]
    float normal[3][kLanes];   ///< not of unit length; zero for a triangle too flat for floats [mm²]
    float perNormal2[kLanes];  ///< 1 / squared length of `normal`
    float perEdge2[3][kLanes]; ///< 1 / squared length of ab, ac and bc [1/mm²]
};

/// @return the largest coordinate [mm]
float derive(const Corners& corners, TriangleGroup& group) noexcept PALPATE_NONBLOCKING;

inline constexpr int kMostTriangles = 256; ///< that distances are asked to at once

/// Least distances from the move p - half ... p + half to the triangles, or less, to a few ulp of the largest
/// coordinate.
/// @param half         half the move; zero for the distances from p themselves [mm]
/// @param distance_mm  one for each of the groups' lanes; 0 or less for a triangle too flat to tell
void distances(const TriangleGroup* groups, int count, const float* p, const float* half,
               float* distance_mm) noexcept PALPATE_NONBLOCKING;

/// Places along a line through the origin of a group.
struct Extent
{
    float low_mm;
    float high_mm;
};

/// Rounding of a place along a line, of the largest coordinate: three products and their sum, of converted numbers, are
/// off by at most 16 times half an ulp of it, 1e-6; twice that.
inline constexpr double kPlaceRounding = 2e-6;

/// @param u  unit vector of the line
/// @return the interval that the triangles' projections on the line cover, to kPlaceRounding
[[nodiscard]] Extent extentAlong(const TriangleGroup& group, const float* u) noexcept PALPATE_NONBLOCKING;

/// Where a ball's centre starts, and the unit vector of its direction, as seen from a group's origin.
struct Heading
{
    float x[3]; ///< [mm]
    float u[3];
    float coordinate_mm; ///< largest of x and of the groups
};

/// @param cosine  of no interest is what stands less against the move: at least 0
/// @return bit i set where triangle i may stand against the move: x is not surely behind its plane, if it has an
/// inside, and the distance does not surely grow, or fall by less than `cosine` for each mm
[[nodiscard]] std::uint32_t opposingLanes(const TriangleGroup& group, const Heading& heading,
                                          float cosine) noexcept PALPATE_NONBLOCKING;

/// Rounding of a distance, in largest coordinates: that of the flattest triangle whose normal is relied on, see
/// `kFlattest` in DistanceLanes.cpp.
inline constexpr double kDistanceRounding = 1e-5;

/// Two squared distances d² are equal to rounding where they differ by less than this times d and the largest
/// coordinate: each is right to 2 d times 1e-6 of that, eight ulp.
inline constexpr double kSquareRounding = 4e-6;

/// @return rounding of the least distance of a move to what its middle is `away_mm` from, or more: that of the distance
/// there, and that of the direction to it, which the half of the move multiplies. Where the places on two edges are as
/// near to rounding, the farther may be taken: it is off the nearest by the root of what the squares differ by. [mm]
inline double leastDistanceRounding(double coordinate_mm, double half_mm, double away_mm) noexcept
{
    return kDistanceRounding * coordinate_mm * (1.0 + half_mm / away_mm) +
           std::sqrt(kSquareRounding * coordinate_mm / away_mm) * half_mm;
}

/// Copies triangle i of one set of groups to place j of another.
void copyTriangle(const TriangleGroup* from, int i, TriangleGroup* to, int j) noexcept PALPATE_NONBLOCKING;

/// @return bit i set where distance i, of up to 64 by eights, is greater than `beyond` and at most `upTo`
[[nodiscard]] std::uint64_t lanesBetween(const float* distance_mm, int count, float beyond,
                                         float upTo) noexcept PALPATE_NONBLOCKING;

inline constexpr double kAnyDistance = -1e30; ///< less than any, as what to begin beyond

/// Calls `f(i)` for each distance i of `count` that is greater than `beyond` and at most `upTo`.
template<class F>
void forEachBetween(const float* distance_mm, int count, double beyond, double upTo, F&& f) noexcept
{
    for (int first = 0; first < count; first += 64) {
        for (std::uint64_t lanes = lanesBetween(distance_mm + first, std::min(count - first, 64),
                                                static_cast<float>(beyond), static_cast<float>(upTo));
             lanes != 0; lanes &= lanes - 1) {
            f(first + std::countr_zero(lanes));
        }
    }
}

inline constexpr int kWorthAsking = 4; ///< of eight triangles: fewer are sooner tested exactly

/// The same, but asks about groups with many of them first.
/// @param opposing  given a group's number, returns its lanes that are of interest
/// @return how many groups were asked about
template<class Opposing, class F>
std::uint32_t forEachOpposing(const float* distance_mm, int count, double beyond, double upTo, Opposing&& opposing,
                              F&& f) noexcept
{
    std::uint32_t asked = 0;
    for (int first = 0; first < count; first += 64) {
        std::uint64_t lanes = lanesBetween(distance_mm + first, std::min(count - first, 64), static_cast<float>(beyond),
                                           static_cast<float>(upTo));
        while (lanes != 0) {
            const int shift = std::countr_zero(lanes) / kLanes * kLanes;
            std::uint32_t eight = static_cast<std::uint32_t>(lanes >> shift) & 0xffu;
            lanes &= ~(std::uint64_t{0xff} << shift);
            if (std::popcount(eight) >= kWorthAsking) {
                ++asked;
                eight &= opposing((first + shift) / kLanes);
            }
            for (; eight != 0; eight &= eight - 1) {
                f(first + shift + std::countr_zero(eight));
            }
        }
    }
    return asked;
}

} // namespace palpate::haptics::internal
