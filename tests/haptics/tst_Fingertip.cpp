// SPDX-License-Identifier: BSD-3-Clause
// Tests the ball god-object against closed forms and by brute force against the definition: never nearer to a surface
// than the radius, and no small legal move brings the ball closer to the HIP.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "nearby/NearBall.h"
#include "solver/GodObject.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

namespace {

struct BallFeel
{
    geometry::TriangleMesh mesh;
    HapticScene scene;
    Palpator palpator;

    BallFeel(geometry::TriangleMesh m, double radius_mm, const haptics::GodObjectLimits& limits = {})
        : mesh(std::move(m))
        , scene({HapticStructure{"it", indexed(mesh), {0.5, 0.0}, 0}}, radius_mm)
        , palpator(haptics::Fingertips::Any, limits)
    {
        palpator.borrowScene(&scene);
    }
    TickResult at(const Vec3& hip) { return palpator.step(hip, kTick_s); }
    TickResult move(const Vec3& from, const Vec3& to, int ticks)
    {
        TickResult result = at(from);
        for (int i = 1; i <= ticks; ++i) {
            result = at(from + (to - from) * (double(i) / ticks));
        }
        return result;
    }
};

double toSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 e = b - a;
    return (p - a - std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm();
}

/// Returns the smallest distance from p to the mesh: to the plane where p projects into a triangle, to the edges
/// elsewhere.
double clearance(const geometry::TriangleMesh& mesh, const Vec3& p)
{
    double least = 1e300;
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 n = (b - a).cross(c - a).normalized();
        const bool isOver =
            n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
        least = std::min({least, isOver ? std::abs(n.dot(p - a)) : 1e300, toSegment(p, a, b), toSegment(p, b, c),
                          toSegment(p, c, a)});
    }
    return least;
}

} // namespace

class Fingertip : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void restsOnAPlaneByItsRadius()
    {
        BallFeel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 0), 3), 1.5);
        const TickResult r = feel.move(Vec3(1, 2, 8), Vec3(1.2, 1.7, -3), 200);
        QVERIFY_AT(r, Vec3(1.2, 1.7, 1.5));
        QCOMPARE(r.constraints, std::uint8_t(1));
        QVERIFY((r.n_W - Vec3::UnitZ()).norm() < 1e-6);
        QVERIFY((r.f_W - 0.5 * (r.p_WG - Vec3(1.2, 1.7, -3))).norm() < 1e-12);
    }

    void cannotEnterAGrooveNarrowerThanItself_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {150.0, 90.0, 40.0, 10.0, 1.0}) {
            QTest::newRow(qPrintable(QString("%1 degrees").arg(degrees))) << degrees;
        }
    }
    void cannotEnterAGrooveNarrowerThanItself()
    {
        QFETCH(double, degrees);
        const double half = degrees * std::numbers::pi / 360;
        const double radius = std::min(0.5, 10 * std::tan(half));
        BallFeel feel(groove(2 * half, 20.0, 12.0), radius);
        // groove() opens upwards from the y axis; the ball rests where both walls are one radius away.
        const double height = radius / std::sin(half);
        TickResult r = feel.move(Vec3(0, 0, 19), Vec3(0, 0, -5), 400);
        QVERIFY_AT(r, Vec3(0, 0, height));
        QCOMPARE(r.constraints, std::uint8_t(2));
        r = feel.move(Vec3(0, 0, -5), Vec3(0, 6, -5), 300);
        QVERIFY_AT(r, Vec3(0, 6, height));
    }

    void rollsRoundAnEdgeAndACorner()
    {
        BallFeel feel(box(Vec3(-10, -10, -10), Vec3(0, 10, 0), 2), 2.0);
        // Over the edge along y at x = 0, z = 0 the pull direction decides where on the quarter circle the ball rests.
        feel.move(Vec3(-3, 1, 5), Vec3(-3, 1, 1), 50);
        for (const double angle : {0.2, 0.6, 1.0, 1.4}) {
            const Vec3 out(std::sin(angle), 0, std::cos(angle));
            const Vec3 hip = Vec3(0, 1, 0) + 1.3 * out;
            const TickResult r = feel.move(feel.palpator.state().p_WH, hip, 200);
            QVERIFY_AT(r, Vec3(0, 1, 0) + 2.0 * out);
        }
        BallFeel corner(box(Vec3(-10, -10, -10), Vec3(0, 0, 0), 2), 2.0);
        const Vec3 out = Vec3(1, 2, 3).normalized();
        const TickResult r = corner.move(6 * out, 1.2 * out, 200);
        QVERIFY_AT(r, 2.0 * out);
        QVERIFY(r.iterations < 20);
    }

    void feelsASheetFromBothSides()
    {
        for (const double side : {1.0, -1.0}) {
            BallFeel feel(sheet(10.0, 4), 1.0);
            QVERIFY_AT(feel.move(Vec3(0.3, 0.2, 6 * side), Vec3(0.3, 0.2, -4 * side), 100), Vec3(0.3, 0.2, side));
        }
    }

    void aThinPlateHitFastIsNotPassed()
    {
        // 2 m/s is 2 mm per tick, four times the thickness of the plate.
        BallFeel feel(box(Vec3(-10, -10, -0.5), Vec3(10, 10, 0), 4), 0.3);
        const TickResult r = feel.move(Vec3(0.1, 0.2, 20), Vec3(0.1, 0.2, -20), 20);
        QVERIFY_AT(r, Vec3(0.1, 0.2, 0.3));
    }

    void aBallThatStartsTooDeepIsLetOutWithoutAPush()
    {
        BallFeel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 0), 3), 2.0);
        TickResult r = feel.at(Vec3(0, 0, 0.5));
        QVERIFY(r.f_W.norm() == 0.0);
        r = feel.at(Vec3(0, 0, 0.3)); // no deeper than at the start
        QVERIFY((r.p_WG - Vec3(0, 0, 0.5)).norm() < 1e-6);
        r = feel.move(Vec3(0, 0, 0.3), Vec3(0, 0, 5), 50);
        QVERIFY(r.f_W.norm() == 0.0);
        QVERIFY_AT(feel.move(Vec3(0, 0, 5), Vec3(0, 0, -1), 50), Vec3(0, 0, 2));
        QCOMPARE(feel.at(Vec3(0, 0, std::nan(""))).status, TickStatus::InvalidInput);
    }

    /// The ball starts far too deep and rolls around an edge; each step pushes the ball out for good. The gains shrink,
    /// so the ball must converge while the hand rests.
    void aBallThatStartsTooDeepComesToRest()
    {
        BallFeel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3), 4.0);
        (void)feel.at(Vec3(10.3, 10.1, 10.5));
        const Vec3 hip(10.002, 9.999, 9.997);
        int moves = 0;
        TickResult r;
        for (int i = 0; i < 20; ++i) {
            r = feel.at(hip);
            QCOMPARE(r.status, TickStatus::Converged);
            moves += static_cast<int>(r.iterations);
        }
        QVERIFY2(moves < 1200, qPrintable(QString::number(moves)));
        const Vec3 before = r.p_WG;
        r = feel.at(hip);
        QVERIFY(r.p_WG == before);
    }

    /// Four intersecting organs, each in a separate layer, with too much work for the ball in all of them.
    void layersShareTheWorkAndTheInnermostHasItAll()
    {
        std::vector<HapticStructure> organs;
        for (std::uint32_t i = 0; i < 4; ++i) {
            organs.push_back({"organ", indexed(bumpySphere(40, 30.0 - 0.5 * i, 0.03)), {0.2, 0.0}, i + 1});
        }
        const HapticScene four(organs, 20.0), innermost({organs[3]}, 20.0);
        const haptics::GodObjectLimits limits{.ballWork = 12000};
        Palpator all(haptics::Fingertips::Any, limits), alone(haptics::Fingertips::Any, limits),
            other(haptics::Fingertips::Any, limits);
        all.borrowScene(&four);
        alone.borrowScene(&innermost);
        other.borrowScene(&four);
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        int bounded = 0, boundedAlone = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 hip = 20.0 * Vec3(normal(random), normal(random), normal(random));
            other.restore(all.state());
            const TickResult a = all.step(hip, kTick_s), b = alone.step(hip, kTick_s), c = other.step(hip, kTick_s);
            QVERIFY2(all.state().layers[3].p_WG == alone.state().layers[0].p_WG, qPrintable(QString("tick %1").arg(i)));
            QVERIFY(a.p_WG == c.p_WG && a.f_W == c.f_W && a.status == c.status);
            for (std::size_t k = 1; k < a.contactCount; ++k) {
                QVERIFY(a.contacts[k - 1].layer < a.contacts[k].layer);
            }
            bounded += a.status == TickStatus::IterationLimit ? 1 : 0;
            boundedAlone += b.status == TickStatus::IterationLimit ? 1 : 0;
        }
        QVERIFY(boundedAlone > 0);
        qInfo("%d bounded, %d alone", bounded, boundedAlone);
        QVERIFY(bounded > boundedAlone);
    }

    /// Preparation for the next tick is charged, but a tick that lacks work only for this preparation still counts as
    /// complete.
    void whatTheNextTickNeedsDoesNotBoundThisOne()
    {
        using namespace haptics::internal;
        const HapticScene scene({{"organ", indexed(bumpySphere(40, 30.0, 0.03)), {0.2, 0.0}, 0}}, 4.0);
        const haptics::HapticLayer& layer = scene.layer(0);
        GodObject god, bounded;
        NearBall ball, ballOfBounded;
        int prepared = 0;
        for (int i = 0; i < 400; ++i) {
            const double arc = 0.004 * i;
            const Vec3 hip = (36.0 - std::min(4.0, 0.1 * i)) * Vec3(std::cos(arc), std::sin(arc), 0.0);
            bounded.restore(god.state());
            const GodObjectStep whole = god.step(hip, kTick_s, layer, {.work = 20000}, &ball);
            QCOMPARE(whole.status, TickStatus::Converged);
            const GodObjectStep less = bounded.step(hip, kTick_s, layer, {.work = whole.work - 1}, &ballOfBounded);
            if (less.status == TickStatus::Converged) {
                ++prepared;
                QVERIFY(bounded.state().p_WG == god.state().p_WG);
                QCOMPARE(less.iterations, whole.iterations);
            }
        }
        QVERIFY2(prepared > 20, qPrintable(QString::number(prepared)));
    }

    void aTouchedFloorHidesNoWall_data()
    {
        QTest::addColumn<double>("gap");
        QTest::addColumn<double>("depth");
        for (const double gap : {1.4, 1.2, 1.05}) {
            for (const double depth : {2e-10, 1e-9, 1e-8, 1e-6}) {
                QTest::newRow(qPrintable(QString("%1 skins above, then %2 mm below").arg(gap).arg(depth)))
                    << gap << depth;
            }
        }
    }
    void aTouchedFloorHidesNoWall()
    {
        // The floor is touched and would stop the move only far behind the wall.
        QFETCH(double, gap);
        QFETCH(double, depth);
        geometry::TriangleMesh corner = box(Vec3(-10, -10, -10), Vec3(10, 10, 0), 4);
        append(corner, box(Vec3(1, -5, -1), Vec3(9, 5, 5)));
        BallFeel feel(corner, 0.5);
        const double skin = feel.scene.layer(0).skin_mm;
        (void)feel.at(Vec3(0.4, 0, 2));
        (void)feel.at(Vec3(0.4, 0, 0.5 + gap * skin));
        QVERIFY(feel.at(Vec3(6, 0, 0.5 - depth)).p_WG.x() < 0.5 + kBound_mm);
    }

    void aBallPutDownOnTheSurfaceItselfIsHeld()
    {
        for (const double height : {0.0, 1e-12, 1e-3}) {
            BallFeel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 0), 4), 2.0);
            std::mt19937_64 random(4);
            std::normal_distribution<double> normal;
            (void)feel.at(Vec3(0.3, 0.2, height));
            double lowest = height;
            for (int i = 0; i < 3000; ++i) {
                const double deeper = std::abs(normal(random)) * (i % 2 == 0 ? 1.0 : 1e-12);
                lowest = std::min(lowest,
                                  feel.at(Vec3(0.3 + normal(random), 0.2 + normal(random), height - deeper)).p_WG.z());
            }
            QVERIFY2(lowest > height - 1e-9, qPrintable(QString::number(lowest)));
        }
    }

    void aTinyBallStaysOffALongEdge()
    {
        // An edge of 2 m: the distance to the edge is seven digits smaller than the distances to its ends.
        const double size = 1000.0, radius = 0.001;
        BallFeel feel(box(Vec3(-size, -size, -size), Vec3(size, size, size)), radius);
        const double skin = feel.scene.layer(0).skin_mm;
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> part(-1.0, 1.0);
        for (int path = 0; path < 40; ++path) {
            const Vec3 base(size, 0.9 * size * part(random), size);
            feel.palpator.reset();
            (void)feel.at(base + Vec3(1, 0, 1) * 10 * radius);
            for (int i = 0; i < 200; ++i) {
                const Vec3 g = feel.at(base + 2 * radius * Vec3(part(random), part(random), part(random))).p_WG;
                QVERIFY2(clearance(feel.mesh, g) > radius - 8 * skin, qPrintable(QString("path %1").arg(path)));
            }
        }
    }

    void withoutContactItIsAtTheHip()
    {
        // HIPs exactly on edges and vertices, and steps of up to a hundred extents.
        const geometry::TriangleMesh mesh = sphere(6, 10.0);
        BallFeel feel(mesh, 4.0);
        std::mt19937_64 random(3);
        std::uniform_int_distribution<std::size_t> any(0, mesh.triangles.size() - 1);
        (void)feel.at(Vec3(30, 0, 0));
        for (int i = 0; i < 4000; ++i) {
            const geometry::Triangle& t = mesh.triangles[any(random)];
            const double away = i % 7 == 0 ? 1e3 : i % 7 == 3 ? 2.0 : 1.0;
            const Vec3 hip =
                away * (i % 2 == 0 ? mesh.vertices[t[0]] : Vec3(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]])));
            const TickResult r = feel.at(hip);
            QVERIFY2(r.constraints > 0 || r.p_WG == hip, qPrintable(QString("tick %1").arg(i)));
        }
    }

    void atTheCentreOfCurvatureItComesToRest()
    {
        // One radius deep at a vertex: the ball may roll around the HIP without coming nearer.
        const geometry::TriangleMesh mesh = sphere(20, 20.0);
        for (const double radius : {1.0, 4.0}) {
            BallFeel feel(mesh, radius);
            std::mt19937_64 random(1);
            std::normal_distribution<double> normal;
            (void)feel.at(Vec3(90, 1, 2));
            std::uint64_t moves = 0;
            for (int i = 0; i < 1000; ++i) {
                const geometry::Triangle& t =
                    mesh.triangles[static_cast<std::size_t>(i / 5) * 37 % mesh.triangles.size()];
                const TickResult r =
                    feel.at(mesh.vertices[t[0]] + 1e-5 * Vec3(normal(random), normal(random), normal(random)));
                QVERIFY(std::abs((r.p_WG - mesh.vertices[t[0]]).norm() - radius) < 1e-4);
                moves += r.iterations;
            }
            qInfo("radius %g: %.1f moves a tick", radius, double(moves) / 1000.0);
            QVERIFY(moves < 60 * 1000);
        }
    }

    void farFromTheOriginItRestsAtOnce()
    {
        // At this distance a step is seldom exactly zero: rounding of positions tilts the plane of the contact point
        // back and forth.
        geometry::TriangleMesh mesh = sphere(10, 30.0);
        const Vec3 far(-282557.4, 9611.3, 277752.6);
        for (Vec3& v : mesh.vertices) {
            v += far;
        }
        BallFeel feel(mesh, 20.0);
        std::mt19937_64 random(1);
        std::normal_distribution<double> normal;
        std::uint32_t most = 0;
        for (int place = 0; place < 40; ++place) {
            const Vec3 out = Vec3(normal(random), normal(random), normal(random)).normalized();
            (void)feel.move(far + 60.0 * out, far + 35.0 * out, 50);
            for (int i = 0; i < 5; ++i) {
                most = std::max(most, feel.at(far + 35.0 * out).iterations);
            }
            (void)feel.at(far + 60.0 * out);
        }
        qInfo("%u moves at most where the HIP rests", most);
        QVERIFY(most <= 8);
    }

    void whereTheHipIsAVertexItStays()
    {
        // All positions around the vertex are equally near to the HIP: after any approach the ball must come to rest.
        const geometry::TriangleMesh mesh = bumpySphere(6, 10.0, 0.1);
        const double radius = 8.0;
        geometry::TriangleMesh both = mesh;
        append(both, box(Vec3(-20, -20, -40), Vec3(20, 20, -40 + 1e-7))); // slivers that make the skin a micrometre
        BallFeel feel(both, radius);
        std::mt19937_64 random(11);
        std::normal_distribution<double> normal;
        double farthest = 0.0;
        std::uint32_t most = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec3& vertex = mesh.vertices[static_cast<std::size_t>(i) * 37 % mesh.vertices.size()];
            (void)feel.at(40.0 * Vec3(normal(random), normal(random), normal(random)).normalized());
            const Vec3 g = feel.at(vertex).p_WG;
            if ((g - vertex).norm() > radius + 2.0 * feel.scene.layer(0).skin_mm) {
                continue; // held off by other facets
            }
            for (int j = 0; j < 20; ++j) {
                const TickResult r = feel.at(vertex);
                farthest = std::max(farthest, (r.p_WG - g).norm());
                most = std::max(most, r.iterations);
            }
        }
        qInfo("%.2g mm, at most %u moves", farthest, most);
        QVERIFY2(farthest < 1e-6, qPrintable(QString::number(farthest)));
        QVERIFY2(most <= 20, qPrintable(QString::number(most)));
    }

    void aBallPutDownOnAnEdgeMeetsItOnce()
    {
        // The lower face is nearer than the rounding: the ball touches both faces, whatever the sign of the small
        // offset.
        BallFeel feel(box(Vec3(-10, -10, -1e-8), Vec3(10, 10, 0), 4), 2.0);
        QVERIFY(feel.scene.layer(0).skin_mm > 1e-6);
        for (const Vec3& at : {Vec3(0, 0, 1e-9), Vec3(5, 1, 1e-9), Vec3(5, 5, 1e-9)}) {
            for (const double way : {0.3, -0.3}) {
                feel.palpator.reset();
                (void)feel.at(at);
                const TickResult r = feel.at(at + Vec3(0, 0, way));
                QCOMPARE(r.status, TickStatus::Converged);
                // The faces push against each other until a tick has made 16 moves without a gain.
                QVERIFY2(r.iterations < 20, qPrintable(QString::number(r.iterations)));
                QVERIFY(r.constraints > 0 || r.p_WG == at + Vec3(0, 0, way));
            }
        }
    }

    void theWorkOfATickIsBounded()
    {
        // 4,000 facets that share a vertex: too many to query often within a tick.
        geometry::TriangleMesh fan;
        const int n = 4000;
        fan.vertices = {Vec3(0, 0, 5), Vec3(0, 0, -10)};
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            fan.vertices.push_back(Vec3(20 * std::cos(angle), 20 * std::sin(angle), i % 2));
        }
        for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
            const std::uint32_t j = (i + 1) % std::uint32_t(n);
            fan.triangles.push_back({0, 2 + i, 2 + j});
            fan.triangles.push_back({1, 2 + j, 2 + i});
        }
        BallFeel kept(fan, 4.0), thrownAway(fan, 4.0);
        int limited = 0;
        for (int i = 0; i < 400; ++i) {
            const double angle = 0.02 * i, away = 2 * std::abs(std::sin(0.003 * i));
            const Vec3 hip(away * std::cos(angle), away * std::sin(angle), i < 5 ? 20.0 - 2 * i : 3.0 - 0.01 * i);
            thrownAway.palpator.restore(thrownAway.palpator.state());
            const TickResult r = kept.at(hip), other = thrownAway.at(hip);
            QVERIFY2(r.p_WG == other.p_WG && r.iterations == other.iterations && r.status == other.status,
                     qPrintable(QString("tick %1").arg(i)));
            limited += r.status == TickStatus::IterationLimit ? 1 : 0;
            // The state is legal wherever the bound stopped the tick, and the contact produces a force.
            if (i % 10 == 0) {
                QVERIFY2(clearance(fan, r.p_WG) > 4.0 - 1e-8, qPrintable(QString("tick %1").arg(i)));
            }
            QVERIFY2(r.constraints > 0 || hip.z() > 9.0, qPrintable(QString("tick %1").arg(i)));
        }
        qInfo("%d of 400 ticks at the bound", limited);
        QVERIFY(limited > 0);
    }

    void aLargeBallSlidesWithinItsWork()
    {
        // In hollows as wide as the ball: every small cell has hundreds of nearby facet boxes.
        BallFeel feel(bumpySphere(81, 50.0, 0.02), 20.0);
        int limited = 0;
        for (const int first : {3650, 9780, 11350}) {
            feel.palpator.reset();
            for (int i = first - 20; i < first + 100; ++i) {
                const double arc = 0.002 * i;
                const Vec3 out(std::cos(arc) * std::cos(0.37 * arc), std::sin(arc) * std::cos(0.37 * arc),
                               std::sin(0.37 * arc));
                const TickResult r = feel.at(std::max(68.0, 75.0 - 0.5 * (i - first + 20)) * out);
                limited += r.status == TickStatus::IterationLimit ? 1 : 0;
            }
        }
        QCOMPARE(limited, 0);
    }

    void noSmallLegalMoveComesCloser_data()
    {
        QTest::addColumn<geometry::TriangleMesh>("mesh");
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("size");
        geometry::TriangleMesh boxes = box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3);
        append(boxes, box(Vec3(-4, -4, 3), Vec3(16, 5, 17), 2));
        QTest::newRow("bumpy sphere, 0.1 mm") << bumpySphere(10, 10.0, 0.08) << 0.1 << 10.0;
        QTest::newRow("bumpy sphere, 1 mm") << bumpySphere(10, 10.0, 0.08) << 1.0 << 10.0;
        QTest::newRow("bumpy sphere, 4 mm") << bumpySphere(10, 10.0, 0.08) << 4.0 << 10.0;
        QTest::newRow("crossing boxes, 1 mm") << boxes << 1.0 << 12.0;
        QTest::newRow("groove of 10 degrees, 0.3 mm") << groove(std::numbers::pi / 18, 10.0, 12.0) << 0.3 << 8.0;
    }
    void noSmallLegalMoveComesCloser()
    {
        QFETCH(geometry::TriangleMesh, mesh);
        QFETCH(double, radius);
        QFETCH(double, size);
        BallFeel feel(mesh, radius, {.ballWork = 40000}); // no tick is cut short: the bound has separate tests
        std::mt19937_64 random(7);
        std::normal_distribution<double> normal;
        const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
        Vec3 hip = direction() * (size * 3), goal = hip;
        (void)feel.at(hip);
        int contacts = 0, curved = 0;
        std::uint32_t most = 0;
        for (int tick = 0; tick < 6000; ++tick) {
            if ((goal - hip).norm() < 0.3) {
                goal = direction() * (size * (0.3 + 0.9 * std::abs(normal(random))));
            }
            hip += 0.3 * (goal - hip).normalized();
            const TickResult r = feel.at(hip);
            QVERIFY2(r.status == TickStatus::Converged, qPrintable(QString("tick %1").arg(tick)));
            most = std::max(most, r.iterations);
            if (r.constraints == 0) {
                QVERIFY((r.p_WG - hip).norm() < 1e-9);
                continue;
            }
            ++contacts;
            if (tick % 10 != 0) {
                continue;
            }
            const double gap = clearance(mesh, r.p_WG);
            QVERIFY2(gap > radius - 1e-9 && gap < radius + kBound_mm,
                     qPrintable(QString("tick %1: %2 mm from the surface").arg(tick).arg(gap - radius)));
            curved += r.constraints < 3 ? 1 : 0;
            const double spring = (hip - r.p_WG).norm();
            for (int attempt = 0; attempt < 60; ++attempt) {
                const double length = std::pow(10.0, -4 + 2.5 * (attempt % 10) / 9.0);
                // Straight towards the HIP, or to the side of the normal, where a better position would be.
                Vec3 d = direction();
                d += (attempt % 3) * (hip - r.p_WG) / spring;
                const Vec3 to = r.p_WG + length * d.normalized();
                const double gain = spring - (hip - to).norm();
                if (gain < kBound_mm) {
                    continue;
                }
                bool isLegal = true;
                for (int i = 1; i <= 4 && isLegal; ++i) {
                    isLegal = clearance(mesh, r.p_WG + (to - r.p_WG) * (i / 4.0)) >= radius;
                }
                QVERIFY2(!isLegal, qPrintable(QString("tick %1: a move of %2 mm gains %3 mm, spring %4 mm")
                                                  .arg(tick)
                                                  .arg(length)
                                                  .arg(gain)
                                                  .arg(spring)));
            }
        }
        qInfo("%d ticks in contact, at most %u moves", contacts, most);
        QVERIFY(contacts > 500);
    }

    void whatIsKeptBetweenTicksChangesNothing()
    {
        BallFeel kept(bumpySphere(30, 10.0, 0.08), 1.0), thrownAway(bumpySphere(30, 10.0, 0.08), 1.0);
        int contacts = 0;
        for (int i = 0; i < 2000; ++i) {
            const double height = std::max(8.5, 13.0 - 0.01 * i);
            const Vec3 hip = Vec3(std::sin(0.02 * i), std::cos(0.023 * i), std::sin(0.011 * i)).normalized() * height;
            thrownAway.palpator.restore(thrownAway.palpator.state());
            const TickResult a = kept.at(hip), b = thrownAway.at(hip);
            QVERIFY2(a.p_WG == b.p_WG, qPrintable(QString("tick %1").arg(i)));
            contacts += a.constraints > 0 ? 1 : 0;
        }
        QVERIFY2(contacts > 1000, qPrintable(QString::number(contacts)));
    }

    void rollsOnFromFacetToFacet()
    {
        // A ball that fell from facet to facet instead would need 2.1 moves per tick.
        BallFeel feel(sphere(32, 12.5), 1.0);
        std::uint32_t moves = 0, contacts = 0;
        for (int i = 0; i < 5000; ++i) {
            const double arc = 0.008 * i;
            const Vec3 direction(std::cos(arc) * std::cos(0.37 * arc), std::sin(arc) * std::cos(0.37 * arc),
                                 std::sin(0.37 * arc));
            const TickResult r = feel.at(std::max(8.5, 14.0 - 0.05 * i) * direction);
            if (i >= 200) {
                moves += r.iterations;
                contacts += r.constraints > 0 ? 1 : 0;
            }
        }
        qInfo("%.3f moves a tick", moves / 4800.0);
        QCOMPARE(contacts, 4800u);
        QVERIFY(moves < 1.8 * 4800);
    }

    void radiusZeroIsThePoint()
    {
        BallFeel ball(bumpySphere(10, 10.0, 0.08), 0.0);
        HapticScene scene({HapticStructure{"it", indexed(bumpySphere(10, 10.0, 0.08)), {0.5, 0.0}, 0}});
        Palpator point(haptics::Fingertips::Points); // point mode, without a ball
        point.borrowScene(&scene);
        for (int i = 0; i < 500; ++i) {
            const Vec3 hip = Vec3(std::sin(0.01 * i), std::cos(0.013 * i), 0.3) * (12 - 0.01 * i);
            QCOMPARE(ball.at(hip).p_WG, point.step(hip, kTick_s).p_WG);
        }
    }
};

PALPATE_TEST(Fingertip)
#include "tst_Fingertip.moc"
