// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/PlaneLanes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace palpate::haptics::internal {

/// Eight triangles in single precision relative to a nearby origin, for eight point distances at a time.
struct alignas(32) TriangleGroup
{
    Corners corners;           ///< [mm]
    float normal[3][kLanes];   ///< not normalized; zero for a triangle too flat for single precision [mm²]
    float perNormal2[kLanes];  ///< 1 / squared length of `normal`
    float perEdge2[3][kLanes]; ///< 1 / squared length of ab, ac and bc [1/mm²]
};

/// Computes the derived members of a group.
/// @return the largest coordinate [mm]
float derive(const Corners& corners, TriangleGroup& group) noexcept PALPATE_NONBLOCKING;

inline constexpr int kMostTriangles = 256; ///< maximum number of triangles per distance query

/// Computes lower bounds of the distances from the move p - half ... p + half to the triangles, tight to a few ulp of
/// the largest coordinate.
/// @param half         half the move; zero for distances from p [mm]
/// @param distance_mm  one per lane of the groups; 0 or less for a triangle too flat to decide
void distances(const TriangleGroup* groups, int count, const float* p, const float* half,
               float* distance_mm) noexcept PALPATE_NONBLOCKING;

/// Interval along a line through the origin of a group.
struct Extent
{
    float low_mm;
    float high_mm;
};

/// Rounding error of a position along a line, relative to the largest coordinate. Three products of converted numbers
/// and their sum have an error of at most 16 times half an ulp, 1e-6; the constant is twice that.
inline constexpr double kPlaceRounding = 2e-6;

/// Projects the triangles onto a line.
/// @param u  unit direction of the line
/// @return the interval covered by the projections, accurate to kPlaceRounding
[[nodiscard]] Extent extentAlong(const TriangleGroup& group, const float* u) noexcept PALPATE_NONBLOCKING;

/// Start of a ball's centre and its unit direction of motion, relative to a group's origin.
struct Heading
{
    float x[3]; ///< [mm]
    float u[3];
    float coordinate_mm; ///< largest coordinate of x and of the groups
};

/// Finds the triangles that may oppose the motion.
/// @param cosine  triangles that oppose the motion by less than this are ignored; at least 0
/// @return bit i is set if triangle i may oppose the motion: x is not certainly behind its plane (one-sided facets
/// only), and the distance does not certainly grow, or shrink by less than `cosine` per mm
[[nodiscard]] std::uint32_t opposingLanes(const TriangleGroup& group, const Heading& heading,
                                          float cosine) noexcept PALPATE_NONBLOCKING;

/// Rounding error of a distance, relative to the largest coordinate, for the flattest triangle whose normal is used;
/// see `kFlattest` in DistanceLanes.cpp.
inline constexpr double kDistanceRounding = 1e-5;

/// Two squared distances d² are considered equal if they differ by less than this times d times the largest coordinate.
/// The error of each is at most 2 d times 1e-6 of that coordinate, eight ulp.
inline constexpr double kSquareRounding = 4e-6;

/// Returns an upper bound of the rounding error [mm] of the distance between a move and an object that is `away_mm`
/// from the middle of the move. The terms are the error of the distance and the error of the direction, which is
/// multiplied by half the move. If the closest points on two edges are equally near within rounding, the farther one
/// may be chosen; its offset is the square root of the difference of the squared distances.
inline double leastDistanceRounding(double coordinate_mm, double half_mm, double away_mm) noexcept
{
    return kDistanceRounding * coordinate_mm * (1.0 + half_mm / away_mm) +
           std::sqrt(kSquareRounding * coordinate_mm / away_mm) * half_mm;
}

/// Copies triangle i of `from` to position j of `to`.
void copyTriangle(const TriangleGroup* from, int i, TriangleGroup* to, int j) noexcept PALPATE_NONBLOCKING;

/// Compares up to 64 distances, in groups of eight.
/// @return bit i is set if distance i is greater than `beyond` and at most `upTo`
[[nodiscard]] std::uint64_t lanesBetween(const float* distance_mm, int count, float beyond,
                                         float upTo) noexcept PALPATE_NONBLOCKING;

inline constexpr double kAnyDistance = -1e30; ///< lower bound of all distances, as an initial value of `beyond`

/// Calls `f(i)` for each of `count` distances that is greater than `beyond` and at most `upTo`.
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

inline constexpr int kWorthAsking = 4; ///< out of eight triangles; fewer are tested exactly at once

/// Like forEachBetween, but filters groups with at least kWorthAsking candidates by `opposing` first.
/// @param opposing  returns the lanes of interest of the group with the given index
/// @return the number of groups filtered
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
