// SPDX-License-Identifier: BSD-3-Clause
// Tests the float filters in front of the exact tests: a filter must never drop a facet that the exact tests would
// find.
#include "Shapes.h"
#include "TestRunner.h"
#include "nearby/DistanceLanes.h"
#include "nearby/PlaneLanes.h"
#include "probe/BallProbe.h"
#include "solver/VertexRing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace palpate;
using namespace palpate::haptics::internal;

namespace {

constexpr int kCount = kLanes;

Facet facetOf(const Vec3& a, const Vec3& b, const Vec3& c, bool isTwoSided = false)
{
    Facet f;
    f.a = a;
    f.b = b;
    f.c = c;
    f.n = (b - a).cross(c - a).normalized();
    f.skin_mm = 1e-9;
    f.structure = f.triangle = 0;
    f.isTwoSided = isTwoSided;
    return f;
}

Corners cornersOf(const std::vector<Facet>& facets, const Vec3& origin)
{
    const double from[4] = {origin[0], origin[1], origin[2], 0.0};
    double points[3][kCount][4]{};
    const double* corner[3][kCount];
    Corners corners;
    for (int i = 0; i < kCount; ++i) {
        const Facet& f = facets[static_cast<std::size_t>(i)];
        int c = 0;
        for (const Vec3* p : {&f.a, &f.b, &f.c}) {
            std::copy_n(p->data(), 3, points[c][i]);
            corner[c][i] = points[c][i];
            ++c;
        }
        corners.isTwoSided[i] = f.isTwoSided ? -1 : 0;
    }
    setCorners(corner[0], corner[1], corner[2], from, corners);
    return corners;
}

/// Returns triangles of all shapes near `origin`: well-shaped, slivers, and some seen edge-on.
std::vector<Facet> someFacets(std::mt19937_64& random, const Vec3& origin)
{
    std::normal_distribution<double> normal;
    std::vector<Facet> facets;
    for (int i = 0; i < kCount; ++i) {
        const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        const Vec3 a = origin + point(), b = a + point();
        const double flatness = std::pow(10.0, -std::abs(2.5 * normal(random)));
        facets.push_back(facetOf(a, b, a + 0.3 * (b - a) + flatness * point(), i % 3 == 0));
    }
    return facets;
}

} // namespace

class Filters : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void noBlockingFacetIsRuledOut()
    {
        std::mt19937_64 random(3);
        std::normal_distribution<double> normal;
        int blocking = 0, kept = 0, offered = 0;
        for (int round = 0; round < 20000; ++round) {
            const Vec3 origin = Vec3(normal(random), normal(random), normal(random)) * 300.0;
            const std::vector<Facet> facets = someFacets(random, origin);
            FacetGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            // Half of the moves pass through a point of a facet; some start in the facet's plane or along an edge.
            const Facet& aimed = facets[static_cast<std::size_t>(round % kCount)];
            const double s = std::abs(std::fmod(normal(random), 1.0)),
                         t = (1 - s) * std::abs(std::fmod(normal(random), 1.0));
            const Vec3 on = aimed.a + (round % 4 == 0 ? 0.0 : s) * (aimed.b - aimed.a) + t * (aimed.c - aimed.a);
            const Vec3 aside(normal(random), normal(random), normal(random));
            const Vec3 x = round % 2 == 0 ? Vec3(on + 1e-9 * aimed.n + (round % 6 == 0 ? 0.0 : 1.0) * aside)
                                          : Vec3(origin + aside);
            const Vec3 y = on - (on - x) * -std::abs(normal(random)) - 1e-3 * aimed.n;
            float from[3], to[3], a = 0, b = 0;
            for (int axis = 0; axis < 3; ++axis) {
                from[axis] = static_cast<float>(x[axis] - origin[axis]);
                to[axis] = static_cast<float>(y[axis] - origin[axis]);
                a = std::max(a, std::abs(from[axis]));
                b = std::max(b, std::abs(to[axis]));
            }
            const std::uint64_t lanes =
                crossedLanes(&group, kCount, from, to, a + b + reach, static_cast<float>(aimed.skin_mm));
            for (int i = 0; i < kCount; ++i) {
                Crossing crossing;
                const bool isKept = (lanes >> i & 1u) != 0;
                ++offered;
                kept += isKept ? 1 : 0;
                if (blocks(facets[static_cast<std::size_t>(i)], x, y, 1.0, crossing)) {
                    ++blocking;
                    QVERIFY2(isKept, qPrintable(QString("round %1, lane %2").arg(round).arg(i)));
                }
            }
        }
        qInfo("%d blocking, %d kept of %d", blocking, kept, offered);
        QVERIFY(blocking > 5000);
        QVERIFY(kept < offered / 2); // the filter does reject facets
    }

    void noFacetThatBlocksAChainIsRuledOut()
    {
        std::mt19937_64 random(5);
        std::normal_distribution<double> normal;
        int blocking = 0, kept = 0, offered = 0;
        for (int round = 0; round < 10000; ++round) {
            const Vec3 origin = Vec3(normal(random), normal(random), normal(random)) * 300.0;
            const std::vector<Facet> facets = someFacets(random, origin);
            FacetGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            // Short moves near a facet, through a point in its interior or on its edge.
            const Facet& aimed = facets[static_cast<std::size_t>(round % kCount)];
            const Vec3 on = aimed.a + (round % 4 == 0 ? 0.0 : 0.4) * (aimed.b - aimed.a) + 0.3 * (aimed.c - aimed.a);
            std::vector<Vec3> path;
            float points[4][3], coordinate = 0;
            for (int i = 0; i < 4; ++i) {
                const Vec3 aside(normal(random), normal(random), normal(random));
                path.push_back(on + (i - 1.5) * 0.1 * aside - (i - 1.5) * 0.05 * aimed.n);
                for (int axis = 0; axis < 3; ++axis) {
                    points[i][axis] = static_cast<float>(path.back()[axis] - origin[axis]);
                    coordinate = std::max(coordinate, std::abs(points[i][axis]));
                }
            }
            const std::uint64_t lanes =
                crossedLanes(&group, kCount, points, 4, 2 * coordinate + reach, static_cast<float>(aimed.skin_mm));
            for (int i = 0; i < kCount; ++i) {
                const bool isKept = (lanes >> i & 1u) != 0;
                ++offered;
                kept += isKept ? 1 : 0;
                for (std::size_t move = 0; move < 3; ++move) {
                    Crossing crossing;
                    if (blocks(facets[static_cast<std::size_t>(i)], path[move], path[move + 1], 1.0, crossing)) {
                        ++blocking;
                        QVERIFY2(isKept, qPrintable(QString("round %1, lane %2").arg(round).arg(i)));
                    }
                }
            }
        }
        qInfo("%d blocking, %d kept of %d", blocking, kept, offered);
        QVERIFY(blocking > 2000);
        QVERIFY(kept < offered / 2); // the filter does reject facets
    }
    void noBoxIsNearerThanItsDistance()
    {
        std::mt19937_64 random(6);
        std::normal_distribution<double> normal;
        for (int round = 0; round < 20000; ++round) {
            const Vec3 origin = Vec3(normal(random), normal(random), normal(random)) * 300.0;
            const std::vector<Facet> facets = someFacets(random, origin);
            FacetGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            const Vec3 p = origin + 8.0 * Vec3(normal(random), normal(random), normal(random));
            float at[3];
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = static_cast<float>(p[axis] - origin[axis]);
            }
            double exact = std::numeric_limits<double>::infinity();
            for (const Facet& f : facets) {
                const Vec3 low = f.a.cwiseMin(f.b).cwiseMin(f.c), high = f.a.cwiseMax(f.b).cwiseMax(f.c);
                exact = std::min(exact, std::max((low - p).maxCoeff(), (p - high).maxCoeff()));
            }
            const double found = boxDistance(&group, kCount, at);
            QVERIFY2(std::abs(found - exact) <= 2e-6 * (reach + 8.0), qPrintable(QString("round %1").arg(round)));
        }
        QVERIFY(std::isinf(boxDistance(nullptr, 0, nullptr)));
    }

    void distancesAreThoseOfTheNearestPoint()
    {
        std::mt19937_64 random(4);
        std::normal_distribution<double> normal;
        for (int round = 0; round < 20000; ++round) {
            const Vec3 origin = Vec3(normal(random), normal(random), normal(random)) * 300.0;
            const std::vector<Facet> facets = someFacets(random, origin);
            TriangleGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            const Vec3 p = origin + 2.0 * Vec3(normal(random), normal(random), normal(random));
            float at[3], distance[kCount];
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = static_cast<float>(p[axis] - origin[axis]);
            }
            const float still[3] = {0.0f, 0.0f, 0.0f};
            distances(&group, kCount, at, still, distance);
            for (int i = 0; i < kCount; ++i) {
                const double exact = (p - nearestOn(facets[static_cast<std::size_t>(i)], p).q).norm();
                // Never above the exact distance by more than the rounding; and close to it, except for very flat
                // triangles.
                QVERIFY2(distance[i] <= exact + kDistanceRounding * reach,
                         qPrintable(QString("round %1: %2, exactly %3").arg(round).arg(distance[i]).arg(exact)));
                QVERIFY(distance[i] == 0.0f || distance[i] >= exact - 1e-3 * reach);
            }
        }
    }

    /// A sliver's normal is inaccurate in floats: the distance must never be overestimated.
    void noSliverIsToldFartherThanItIs()
    {
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> share;
        std::normal_distribution<double> normal;
        const float still[3] = {0.0f, 0.0f, 0.0f};
        int told = 0;
        for (int round = 0; round < 40000; ++round) {
            const Vec3 origin = 100.0 * Vec3(normal(random), normal(random), normal(random));
            std::vector<Facet> facets;
            for (int i = 0; i < kCount; ++i) {
                const Vec3 along = Vec3(normal(random), normal(random), normal(random)).normalized();
                const Vec3 aside = along.cross(Vec3(normal(random), normal(random), normal(random))).normalized();
                const double length = std::pow(10.0, 1.5 * share(random) - 0.5);
                const double width = length / (i % 2 == 0 ? 950.0 : 70.0); // the second width counts as a sliver
                // Above a point in the interior.
                const Vec3 a = origin + 0.5 * along.cross(aside) - 0.4 * length * along - 0.3 * width * aside;
                std::array<Vec3, 3> c{a, a + length * along, a + share(random) * length * along + width * aside};
                std::rotate(c.begin(), c.begin() + round % 3, c.end());
                facets.push_back(facetOf(c[0], c[1], c[2]));
            }
            TriangleGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            alignas(32) float distance[kCount];
            distances(&group, kCount, still, still, distance);
            for (int i = 0; i < kCount; ++i) {
                const Facet& f = facets[static_cast<std::size_t>(i)];
                told += distance[i] > 0.4f ? 1 : 0;
                QVERIFY(distance[i] - (nearestOn(f, origin).q - origin).norm() <= kDistanceRounding * reach);
            }
        }
        QVERIFY(told > 40000 * kCount / 3);
    }

    void noMoveComesNearerThanItsLeastDistance()
    {
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        int close = 0;
        for (int round = 0; round < 20000; ++round) {
            const Vec3 origin = Vec3(normal(random), normal(random), normal(random)) * 300.0;
            const std::vector<Facet> facets = someFacets(random, origin);
            TriangleGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            Vec3 p = origin + 2.0 * Vec3(normal(random), normal(random), normal(random));
            if (round % 2 == 0) { // above the face of a sliver
                const Facet& f = facets[static_cast<std::size_t>(round / 2 % kCount)];
                p = f.a + 0.4 * (f.b - f.a) + 0.3 * (f.c - f.a) + std::abs(normal(random)) * f.n;
            }
            const Vec3 half =
                std::pow(10.0, -std::abs(normal(random))) * Vec3(normal(random), normal(random), normal(random));
            float at[3], along[3], distance[kCount];
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = static_cast<float>(p[axis] - origin[axis]);
                along[axis] = static_cast<float>(half[axis]);
            }
            distances(&group, kCount, at, along, distance);
            for (int i = 0; i < kCount; ++i) {
                double least = std::numeric_limits<double>::infinity();
                for (int k = -16; k <= 16; ++k) {
                    const Vec3 on = p + k / 16.0 * half;
                    least = std::min(least, (on - nearestOn(facets[static_cast<std::size_t>(i)], on).q).norm());
                }
                const double middle = (p - nearestOn(facets[static_cast<std::size_t>(i)], p).q).norm();
                const double rounding = leastDistanceRounding(reach, half.norm(), middle);
                QVERIFY2(distance[i] <= least + rounding,
                         qPrintable(QString("round %1: %2, exactly %3").arg(round).arg(distance[i]).arg(least)));
                close += distance[i] > 0.9 * least ? 1 : 0;
            }
        }
        QVERIFY(close > 20000); // the filter does reject facets
    }

    /// Above an edge, so near to the end point that floats may pick the end point as the nearest feature: the gain
    /// towards the edge is then perpendicular to the direction to that end point.
    void noMoveBesideTheEndOfAnEdgeComesNearerThanItsLeastDistance()
    {
        std::mt19937_64 random(8);
        std::uniform_real_distribution<double> share(0.0, 1.0), sign(-1.0, 1.0);
        for (int round = 0; round < 20000; ++round) {
            const double high = 1.0 + 19.0 * share(random), beside = 1e-3 * share(random) * high;
            std::vector<Facet> facets;
            for (int i = 0; i < kCount; ++i) {
                const Vec3 a(0, 0, 0), b(5.0 + i, 0, 0), c(sign(random), 2.0 + i, -5.0 * share(random));
                facets.push_back(i % 3 == 0 ? facetOf(a, b, c) : i % 3 == 1 ? facetOf(b, c, a) : facetOf(c, a, b));
            }
            TriangleGroup group;
            const float reach = derive(cornersOf(facets, Vec3::Zero()), group);
            const Vec3 p(beside, -share(random) * high, high);
            // Down by as much as the direction to the end point deviates from the direction to the edge.
            const Vec3 up = Vec3(0, p[1], p[2]).normalized();
            const Vec3 half = 0.25 * high * (Vec3::UnitX() - beside / p.norm() * up);
            float at[3], along[3], distance[kCount];
            for (int axis = 0; axis < 3; ++axis) {
                at[axis] = static_cast<float>(p[axis]);
                along[axis] = static_cast<float>(half[axis]);
            }
            distances(&group, kCount, at, along, distance);
            for (int i = 0; i < kCount; ++i) {
                const Facet& f = facets[static_cast<std::size_t>(i)];
                const double least = (p + half - nearestOn(f, p + half).q).norm();
                const double middle = (p - nearestOn(f, p).q).norm();
                const double rounding = leastDistanceRounding(std::max<double>(reach, high), half.norm(), middle);
                QVERIFY2(distance[i] <= least + rounding,
                         qPrintable(QString("round %1: %2, exactly %3").arg(round).arg(distance[i]).arg(least)));
            }
        }
    }

    void theExtentAlongALineHoldsAllTriangles()
    {
        std::mt19937_64 random(11);
        std::normal_distribution<double> normal;
        const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        for (int round = 0; round < 2000; ++round) {
            const Vec3 origin = 300.0 * point(), u = point().normalized();
            const std::vector<Facet> facets = someFacets(random, origin);
            TriangleGroup group;
            const double rounding = kPlaceRounding * derive(cornersOf(facets, origin), group);
            double low = facets[0].a.dot(u), high = low;
            for (const Facet& f : facets) {
                for (const Vec3* corner : {&f.a, &f.b, &f.c}) {
                    low = std::min(low, u.dot(*corner));
                    high = std::max(high, u.dot(*corner));
                }
            }
            const Eigen::Vector3f line = u.cast<float>();
            const Extent extent = extentAlong(group, line.data());
            QVERIFY(std::abs(extent.low_mm - (low - u.dot(origin))) <= rounding);
            QVERIFY(std::abs(extent.high_mm - (high - u.dot(origin))) <= rounding);
        }
    }

    void aBallIsBlockedWhereItComesNearerThanItsRadius()
    {
        std::mt19937_64 random(12);
        std::normal_distribution<double> normal;
        const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        int blocked = 0, passed = 0;
        for (int round = 0; round < 20000; ++round) {
            const Facet facet = someFacets(random, Vec3::Zero())[static_cast<std::size_t>(round % kCount)];
            // In front of the facet, a radius away or more, moving towards the facet or almost parallel.
            const double radius = std::abs(normal(random)) + 0.01,
                         gap = std::pow(10.0, -2.0 * std::abs(normal(random)));
            Vec3 away = point().normalized();
            away *= facet.n.dot(away) < 0.0 ? -1.0 : 1.0;
            const Vec3 x = facet.a + 0.3 * (facet.b - facet.a) + 0.3 * (facet.c - facet.a) + (radius + gap) * away;
            const Nearest from = nearestOn(facet, x);
            if (facet.n.dot(x - facet.a) < 1e-6 || from.away.norm() <= radius) {
                continue;
            }
            Vec3 move = 0.5 * point();
            const double falls = gap / from.away.norm() * (0.5 + 4.0 * std::abs(normal(random)));
            move -= (move.dot(from.away) / from.away.squaredNorm() + falls) * from.away;
            double nearest = from.away.norm();
            double first = 2.0;
            for (int i = 1; i <= 400; ++i) {
                const double d = nearestOn(facet, x + i / 400.0 * move).away.norm();
                nearest = std::min(nearest, d);
                first = first > 1.0 && d < radius ? i / 400.0 : first;
            }
            BallCrossing crossing;
            const bool isBlocked = blocksBall(facet, x, Vec3(x + move), radius, 1.0, crossing);
            if (nearest < radius - 1e-9) {
                ++blocked;
                QVERIFY2(isBlocked, qPrintable(QString("round %1").arg(round)));
                QVERIFY(crossing.key <= first + 1e-9 && crossing.key >= first - 1.0 / 400.0 - 1e-9);
            } else if (nearest > radius + 1e-3 * move.norm()) {
                ++passed;
                QVERIFY2(!isBlocked, qPrintable(QString("round %1").arg(round)));
            }
        }
        qInfo("%d blocked, %d passed", blocked, passed);
        QVERIFY(blocked > 2000 && passed > 2000);
    }

    void noFacetThatStandsAgainstABallIsRuledOut()
    {
        std::mt19937_64 random(9);
        std::normal_distribution<double> normal;
        const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        int blocking = 0, kept = 0, offered = 0;
        for (int round = 0; round < 20000; ++round) {
            const Vec3 origin = 300.0 * point();
            const std::vector<Facet> facets = someFacets(random, origin);
            TriangleGroup group;
            const float reach = derive(cornersOf(facets, origin), group);
            // Half of the moves are almost parallel to a facet, as when the facet holds the ball; a third start next to
            // the plane through the end of an edge, where floats may pick another nearest feature.
            const Facet& aimed = facets[static_cast<std::size_t>(round % kCount)];
            Vec3 x = origin + 2.0 * point();
            if (round % 3 == 0) {
                const Vec3 e = (aimed.b - aimed.a).normalized();
                x = aimed.a + std::abs(normal(random)) * e.cross(point()).normalized() + 1e-4 * normal(random) * e;
            }
            Vec3 move = 0.1 * point();
            if (round % 2 == 0) {
                const Vec3 away = nearestOn(aimed, x).away.normalized();
                move -= (move.dot(away) + 1e-7 * normal(random)) * away;
            }
            Heading heading{};
            const Vec3 u = move.normalized();
            heading.coordinate_mm = reach;
            for (int axis = 0; axis < 3; ++axis) {
                heading.x[axis] = static_cast<float>(x[axis] - origin[axis]);
                heading.u[axis] = static_cast<float>(u[axis]);
                heading.coordinate_mm = std::max(heading.coordinate_mm, std::abs(heading.x[axis]));
            }
            const double cosine = round % 5 == 0 ? std::min(std::abs(normal(random)), 0.999) : 0.0;
            const std::uint32_t lanes = opposingLanes(group, heading, static_cast<float>(cosine * (1.0 - 1e-6)));
            for (int i = 0; i < kCount; ++i) {
                BallCrossing crossing;
                const bool isKept = (lanes >> i & 1u) != 0;
                ++offered;
                kept += isKept ? 1 : 0;
                // With a radius that reaches all facets: each facet already touches.
                if (blocksBall(facets[static_cast<std::size_t>(i)], x, Vec3(x + move), 50.0, 1.0, crossing,
                               cosine * move.norm())) {
                    ++blocking;
                    QVERIFY2(isKept, qPrintable(QString("round %1, lane %2").arg(round).arg(i)));
                }
            }
        }
        qInfo("%d blocking, %d kept of %d", blocking, kept, offered);
        QVERIFY(blocking > 20000);
        QVERIFY(kept < offered * 7 / 10); // the filter does reject facets
    }

    void aPitHoldsWhatASaddleLetsGo()
    {
        // Six facets around the origin, with the rim vertices raised by the given heights.
        const auto fan = [](const std::vector<double>& height) {
            std::vector<Facet> facets;
            const auto rim = [&](std::size_t i) {
                const double angle = static_cast<double>(i % 6) * std::numbers::pi / 3;
                return Vec3(std::cos(angle), std::sin(angle), height[i % 6]);
            };
            for (std::size_t i = 0; i < 6; ++i) {
                facets.push_back(facetOf(Vec3::Zero(), rim(i), rim(i + 1)));
            }
            return facets;
        };
        const Vec3 from(0, 0, 1e-7), down(0.02, 0.01, -1);
        const double enough = down.norm() - 1e-6;
        QVERIFY(isHeldByVertexRing(fan({.2, .2, .2, .2, .2, .2}), from, down, enough));
        QVERIFY(!isHeldByVertexRing(fan({-.2, .2, .2, .2, .2, .2}), from, down, enough)); // down a groove
        QVERIFY(!isHeldByVertexRing(fan({-.2, -.2, -.2, -.2, -.2, -.2}), from, down, enough));
        // pulled away from the surface
        QVERIFY(!isHeldByVertexRing(fan({.2, .2, .2, .2, .2, .2}), from, Vec3(0, 0, 1), enough));
        std::vector<Facet> open = fan({.2, .2, .2, .2, .2, .2});
        open.pop_back();
        QVERIFY(!isHeldByVertexRing(open, from, down, enough));
    }
};

PALPATE_TEST(Filters)
#include "tst_Filters.moc"
