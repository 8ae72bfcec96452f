// SPDX-License-Identifier: BSD-3-Clause
// Tests the god-object against closed forms.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <cmath>
#include <numbers>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

namespace {

struct Feel
{
    HapticScene scene;
    Palpator palpator;

    explicit Feel(const geometry::TriangleMesh& mesh, double k = 0.5, double b = 0.0)
        : scene({HapticStructure{"it", indexed(mesh), {k, b}, 0}})
    {
        palpator.borrowScene(&scene);
    }
    TickResult at(const Vec3& hip) { return palpator.step(hip, kTick_s); }
    /// Moves straight from `from` to `to` in `ticks` equal steps.
    TickResult move(const Vec3& from, const Vec3& to, int ticks)
    {
        TickResult result = at(from);
        for (int i = 1; i <= ticks; ++i) {
            result = at(from + (to - from) * (double(i) / ticks));
        }
        return result;
    }
};

} // namespace

class ClosedForms : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void freeSpaceFollowsTheHipWithoutForce()
    {
        Feel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 0)));
        const TickResult r = feel.move(Vec3(-30, 4, 3), Vec3(30, -7, 0.5), 100);
        QVERIFY(r.p_WG == Vec3(30, -7, 0.5));
        QVERIFY(r.f_W == Vec3::Zero());
        QCOMPARE(int(r.constraints), 0);
        QCOMPARE(r.structure, -1);
    }

    void contactForceStartsInTheTickOfContact()
    {
        Feel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 0)), 0.7);
        QVERIFY(feel.at(Vec3(1, 2, 0.3)).f_W == Vec3::Zero());
        const TickResult r = feel.at(Vec3(1, 2, -0.2));
        QCOMPARE(int(r.constraints), 1);
        QCOMPARE(r.structure, 0);
        QVERIFY_AT(r, Vec3(1, 2, 0));
        QVERIFY((r.f_W - Vec3(0, 0, 0.14)).norm() < 1e-8);
        QVERIFY((r.n_W - Vec3::UnitZ()).norm() < 1e-8);
    }

    void forceIsSpringAndDamperToRounding()
    {
        constexpr double k = 0.37, b = 0.0043;
        Feel feel(sphere(20, 40.0), k, b);
        Vec3 last = Vec3(0, 0, 45);
        feel.at(last);
        for (int i = 1; i < 500; ++i) {
            const Vec3 hip(0.02 * i, 5 * std::sin(0.05 * i), 45 - std::min(0.1 * i, 9.0));
            const TickResult r = feel.at(hip);
            if (r.constraints > 0) {
                const Vec3 expected = k * (r.p_WG - hip) - b * (hip - last) / kTick_s;
                QVERIFY((r.f_W - expected).norm() <= 1e-14 * (1.0 + expected.norm()));
            } else {
                QVERIFY(r.f_W == Vec3::Zero());
            }
            last = hip;
        }
    }

    void thinPlateHoldsPressAndHit_data()
    {
        QTest::addColumn<double>("thickness");
        QTest::addColumn<double>("step");
        for (const double thickness : {0.5, 0.05, 0.001}) {
            for (const double step : {0.01, 2.0}) { // mm per tick: slow, and 2 m/s
                QTest::addRow("%g mm plate at %g m/s", thickness, step) << thickness << step;
            }
        }
    }
    void thinPlateHoldsPressAndHit()
    {
        QFETCH(double, thickness);
        QFETCH(double, step);
        Feel feel(box(Vec3(-20, -20, -thickness), Vec3(20, 20, 0), 7));
        const Vec3 from(0.31, -1.7, 3.1);
        const int ticks = static_cast<int>(8.1 / step);
        TickResult r = feel.at(from);
        for (int i = 1; i <= ticks + 20; ++i) {
            const Vec3 hip = from - Vec3(0, 0, std::min(8.1, i * step));
            r = feel.at(hip);
            QVERIFY_AT(r, Vec3(0.31, -1.7, std::max(0.0, hip.z())));
        }
        // Back out again: nothing sticks.
        r = feel.move(Vec3(0.31, -1.7, -5), Vec3(0.31, -1.7, 2), 50);
        QVERIFY(r.f_W == Vec3::Zero());
        QVERIFY(r.p_WG == Vec3(0.31, -1.7, 2));
    }

    void grooveHoldsAtItsBottom_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {90.0, 10.0, 1.0, 0.1}) {
            QTest::addRow("%g degrees", degrees) << degrees;
        }
    }
    void grooveHoldsAtItsBottom()
    {
        QFETCH(double, degrees);
        const double angle = degrees * std::numbers::pi / 180;
        Feel feel(groove(angle));
        // Down along one wall, 5 mm past the bottom, then dragged along the groove.
        const double w = 20 * std::tan(angle / 2);
        TickResult r = feel.move(Vec3(0.9 * w, -10, 21), Vec3(0.9 * w, -10, 19.9), 20);
        r = feel.move(Vec3(0.9 * w, -10, 19.9), Vec3(0, -10, -5), 300);
        QVERIFY_AT(r, Vec3(0, -10, 0));
        QCOMPARE(int(r.constraints), 2);
        for (int i = 0; i < 200; ++i) {
            r = feel.at(Vec3(0, -10 + 0.1 * i, -5));
            QVERIFY_AT(r, Vec3(0, -10 + 0.1 * i, 0));
            QCOMPARE(int(r.status), int(TickStatus::Converged));
        }
        r = feel.move(Vec3(0, 9.9, -5), Vec3(0, 9.9, 30), 100);
        QVERIFY(r.f_W == Vec3::Zero());
    }

    void pocketHoldsInItsCorner()
    {
        geometry::TriangleMesh cavity = box(Vec3(0, 0, 0), Vec3(30, 30, 30), 3);
        geometry::flip(cavity); // contact from inside
        Feel feel(cavity);
        feel.at(Vec3(15, 15, 15));
        TickResult r = feel.move(Vec3(15, 15, 15), Vec3(-5, -3, -4), 200);
        QVERIFY_AT(r, Vec3(0, 0, 0));
        QCOMPARE(int(r.constraints), 3);
        QVERIFY((r.f_W - 0.5 * Vec3(5, 3, 4)).norm() < 1e-6);
        // Two walls, one wall, no contact: constraints are released one by one.
        r = feel.move(Vec3(-5, -3, -4), Vec3(6, -3, -4), 50);
        QCOMPARE(int(r.constraints), 2);
        QVERIFY_AT(r, Vec3(6, 0, 0));
        r = feel.move(Vec3(6, -3, -4), Vec3(6, 3, -4), 50);
        QCOMPARE(int(r.constraints), 1);
        r = feel.move(Vec3(6, 3, -4), Vec3(6, 3, 4), 50);
        QCOMPARE(int(r.constraints), 0);
        QVERIFY(r.f_W == Vec3::Zero());
    }

    void slidesOverAConvexEdgeWithinTheTick()
    {
        Feel feel(box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 2));
        feel.at(Vec3(8, 1, 12));
        QVERIFY_AT(feel.at(Vec3(8, 1, 9)), Vec3(8, 1, 10));
        // Under the edge, nearer to the side: the god-object has moved around the edge by the end of the tick.
        QVERIFY_AT(feel.at(Vec3(11, 1, 8)), Vec3(11, 1, 8));
        QVERIFY_AT(feel.at(Vec3(9.5, 1, 5)), Vec3(10, 1, 5));
    }

    void whatStartsInsideLeavesFreely()
    {
        Feel feel(sphere(10, 20.0));
        const TickResult inside = feel.at(Vec3(1, 2, 3));
        QVERIFY(inside.f_W == Vec3::Zero());
        const TickResult outside = feel.move(Vec3(1, 2, 3), Vec3(40, 2, 3), 60);
        QVERIFY(outside.p_WG == Vec3(40, 2, 3));
        QVERIFY(outside.f_W == Vec3::Zero());
    }

    void anOpenSheetIsTouchedFromBothSides()
    {
        Feel feel(sheet(20.0, 4));
        for (const double side : {1.0, -1.0}) {
            feel.palpator.reset();
            TickResult r = feel.move(Vec3(1, 2, 4 * side), Vec3(1, 2, -3 * side), 30);
            QVERIFY_AT(r, Vec3(1, 2, 0));
            QVERIFY((r.f_W - Vec3(0, 0, 1.5 * side)).norm() < 1e-6);
            // Around the rim to the other side.
            r = feel.move(Vec3(1, 2, -3 * side), Vec3(25, 2, -3 * side), 50);
            QVERIFY(r.f_W == Vec3::Zero());
        }
    }

    void smoothSphereIsFeltAsASphere()
    {
        constexpr double radius = 50.0, depth = 5.0;
        constexpr int n = 64;
        Feel feel(sphere(n, radius));
        // An inscribed facet with edge e is at most e^2 / (6 R) below the sphere. The icosahedron's edge is 1.0515 R,
        // and the projection onto the sphere enlarges the middle of its faces by 1 / 0.7947.
        const double edge = 1.0515 / 0.7947 * radius / n;
        const double sag = edge * edge / (6 * radius);
        for (int i = 0; i < 3000; ++i) {
            const double a = 2e-3 * i, e = 0.7 * std::sin(0.9e-3 * i);
            const Vec3 direction(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
            const double r = i < 100 ? radius + 10 - (10 + depth) * i / 99.0 : radius - depth;
            const TickResult t = feel.at(direction * r);
            if (i >= 100) {
                QVERIFY(std::abs(t.p_WG.norm() - radius) <= 1.01 * sag);
                QVERIFY((t.p_WG - radius * direction).norm() <= edge);
                QCOMPARE(int(t.status), int(TickStatus::Converged));
            }
        }
    }

    void theAnswerMovesTurnsAndScalesWithTheScene_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("offset");
        QTest::addColumn<bool>("turned");
        QTest::newRow("a million mm away") << 1.0 << 1e6 << false;
        QTest::newRow("a thousand times smaller") << 1e-3 << 0.0 << false;
        QTest::newRow("a thousand times larger") << 1e3 << 0.0 << false;
        QTest::newRow("turned") << 1.0 << 0.0 << true;
    }
    void theAnswerMovesTurnsAndScalesWithTheScene()
    {
        QFETCH(double, scale);
        QFETCH(double, offset);
        QFETCH(bool, turned);
        const core::Quaternion q =
            turned ? core::Quaternion(0.3, 0.5, -0.7, 0.2).normalized() : core::Quaternion::Identity();
        const auto map = [&](const Vec3& v) { return Vec3(scale * (q * v) + offset * Vec3(1, -1, 1)); };
        const geometry::TriangleMesh mesh = bumpySphere(24, 40.0, 0.03);
        Feel here(mesh), there(transformed(mesh, map));
        const double own = 8 * 2.2e-16 * offset + 1e-9 * 40.0 * scale; // precision of the coordinates
        int contacts = 0;
        for (int i = 0; i < 800; ++i) {
            const double a = 1.7e-3 * i;
            const Vec3 hip = (i < 50 ? 46 - 0.2 * i : 36) * Vec3(std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6);
            const TickResult r = here.at(hip), s = there.at(map(hip));
            const double difference = (map(r.p_WG) - s.p_WG).norm();
            QVERIFY2(difference <= own, qPrintable(QString("tick %1: %2").arg(i).arg(difference)));
            contacts += r.constraints > 0 ? 1 : 0;
        }
        QVERIFY(contacts > 700);
    }

    void layersAddLikeSpringsInParallel()
    {
        const HapticScene scene(
            {HapticStructure{"organ", indexed(box(Vec3(-30, -30, -30), Vec3(30, 30, 0))), {0.2, 0.0}, 0},
             HapticStructure{"lump", indexed(box(Vec3(-5, -5, -15), Vec3(5, 5, -4))), {1.0, 0.0}, 1}});
        Palpator palpator;
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(0, 0, 5), kTick_s);
        TickResult r = palpator.step(Vec3(0, 0, -3), kTick_s);
        QVERIFY(std::abs(r.f_W.z() - 0.6) < 1e-6);
        r = palpator.step(Vec3(0, 0, -6), kTick_s);
        QVERIFY(std::abs(r.f_W.z() - (0.2 * 6 + 1.0 * 2)) < 1e-6);
        QCOMPARE(r.structure, 0);
        QVERIFY(std::abs(r.p_WG.z()) < 1e-6);
    }
};

PALPATE_TEST(ClosedForms)
#include "tst_ClosedForms.moc"
