// SPDX-License-Identifier: BSD-3-Clause
// Tests Coulomb friction against closed forms, and properties that hold on any surface.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using haptics::Friction;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::Tissue;

namespace {

constexpr double kStiffness = 0.5; // N/mm

Tissue rough(double atRest, double sliding, double drag = 0.0)
{
    Tissue tissue;
    tissue.stiffness_N_per_mm = kStiffness;
    tissue.friction_static = atRest;
    tissue.friction_dynamic = sliding;
    tissue.friction_drag_Ns_per_mm = drag;
    return tissue;
}

struct Rough
{
    HapticScene scene;
    Palpator palpator;

    Rough(const geometry::TriangleMesh& mesh, const Tissue& tissue, double radius_mm = 0.0)
        : Rough(HapticStructure{"it", indexed(mesh), tissue, 0}, radius_mm)
    {
    }
    explicit Rough(const HapticStructure& structure, double radius_mm = 0.0)
        : scene({structure}, radius_mm)
    {
        palpator.borrowScene(&scene);
    }
    TickResult at(const Vec3& hip, double dt_s = kTick_s) { return palpator.step(hip, dt_s); }
    TickResult move(const Vec3& from, const Vec3& to, int ticks)
    {
        TickResult result = at(from);
        for (int i = 1; i <= ticks; ++i) {
            result = at(from + (to - from) * (double(i) / ticks));
        }
        return result;
    }
};

geometry::TriangleMesh block()
{
    return box(Vec3(-50, -50, -50), Vec3(50, 50, 0), 7);
}

Vec3 along(const Vec3& f)
{
    return Vec3(f.x(), f.y(), 0.0);
}

bool isBitEqual(const Vec3& a, const Vec3& b)
{
    return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

/// |g - g*|, where g* is the frictionless position with the planes that hold g, and R. For planes with the reported
/// normals.
struct FrictionCone
{
    double r_mm, radius_mm;
};

FrictionCone coneOf(const TickResult& t, const Vec3& hip, double mu)
{
    // n_W is the direction of the frictionless force, so its component along the spring determines the rest: for a
    // crease of equal walls, and for a plane.
    const Vec3 push = t.p_WG - hip;
    const double depth = push.dot(t.n_W);
    double sum = depth;
    if (t.constraints == 2) {
        sum = 2.0 * depth / (t.active[0].n_W + t.active[1].n_W).dot(t.n_W);
    }
    return {(push - depth * t.n_W).norm(), mu * sum};
}

} // namespace

class TestFriction : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void inclinedPullSticksUpToTheConesAngle_data()
    {
        QTest::addColumn<double>("mu");
        QTest::addColumn<double>("radius_mm");
        for (const double mu : {0.05, 0.3, 1.0, 3.0}) {
            QTest::addRow("mu %g, point", mu) << mu << 0.0;
            QTest::addRow("mu %g, ball of 4 mm", mu) << mu << 4.0;
        }
    }
    void inclinedPullSticksUpToTheConesAngle()
    {
        QFETCH(double, mu);
        QFETCH(double, radius_mm);
        Rough feel(block(), rough(mu, 0.5 * mu), radius_mm);
        const Vec3 top(1.3, 2.1, radius_mm);
        (void)feel.at(top + Vec3(0, 0, 1));
        (void)feel.at(top - Vec3(0, 0, 5));
        const auto pressed = feel.palpator.state();
        const Vec3 g = pressed.layers[0].p_WG;
        double sticks = 0.0, slips = 0.5 * std::numbers::pi;
        for (int i = 0; i < 60; ++i) {
            const double angle = 0.5 * (sticks + slips);
            feel.palpator.restore(pressed);
            const TickResult t = feel.at(g + 5.0 * Vec3(std::sin(angle), 0.0, -std::cos(angle)));
            (isBitEqual(t.p_WG, g) ? sticks : slips) = angle;
        }
        QVERIFY2(std::abs(sticks - std::atan(mu)) < 1e-12, qPrintable(QString::number(sticks - std::atan(mu))));
    }

    void slidingForceIsMuTimesTheNormalOne_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::newRow("point") << 0.0;
        QTest::newRow("ball of 4 mm") << 4.0;
    }
    void slidingForceIsMuTimesTheNormalOne()
    {
        QFETCH(double, radius_mm);
        const double mu = 0.37, depth = 3.0;
        Rough feel(block(), rough(2.0 * mu, mu), radius_mm);
        const Vec3 ahead = Vec3(3, 1, 0).normalized();
        const Vec3 from(-12, -9, radius_mm - depth);
        (void)feel.at(from + Vec3(0, 0, depth + 1));
        const TickResult t = feel.move(from, from + 25.0 * ahead, 400);
        const double normal = t.f_W.z();
        QVERIFY(std::abs(along(t.f_W).norm() / (mu * normal) - 1.0) < 1e-12);
        QVERIFY((along(t.f_W).normalized() + ahead).norm() < 1e-7); // deviation only by the half skin of an edge
        QVERIFY(std::abs(normal - kStiffness * depth) < 1e-8);
        QCOMPARE(t.friction(), Friction::Slides);
        QVERIFY((t.n_W - Vec3::UnitZ()).norm() < 1e-12); // no longer the direction of the spring
        QVERIFY(t.n_W.dot((t.p_WG - Vec3(t.p_WG - t.f_W)).normalized()) < 0.99);
    }

    void whatFrictionHoldsDoesNotCreep()
    {
        Rough feel(bumpySphere(12, 40.0, 0.02), rough(0.5, 0.3));
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> noise(-0.1, 0.1);
        const Vec3 up = Vec3(0.3, 0.5, 0.8).normalized();
        TickResult t = feel.move(45.0 * up, 36.0 * up, 20);
        const Vec3 g = t.p_WG;
        QCOMPARE(t.friction(), Friction::Holds);
        for (int i = 0; i < 1000000; ++i) {
            t = feel.at(36.0 * up + Vec3(noise(random), noise(random), noise(random)));
            QVERIFY2(isBitEqual(t.p_WG, g), qPrintable(QString("tick %1").arg(i)));
        }
        QCOMPARE(feel.at(36.0 * up).friction(), Friction::Holds);
    }

    void strokesLoseWhatCoulombSays()
    {
        const double mu = 0.25, A = 6.0;
        Rough feel(block(), rough(mu, mu));
        (void)feel.at(Vec3(0, 0.3, 1));
        Vec3 before(0, 0.3, -4.0);
        Vec3 force = feel.at(before).f_W;
        const double R = mu * force.z() / kStiffness;
        double work = 0.0;
        const int n = 4000;
        const auto stroke = [&](double from, double to) {
            for (int i = 1; i <= n; ++i) {
                const Vec3 p(from + (to - from) * i / n, 0.3, -4.0);
                const Vec3 f = feel.at(p).f_W;
                work -= 0.5 * (f + force).dot(p - before);
                before = p;
                force = f;
            }
        };
        stroke(0, A);
        stroke(A, -A);
        stroke(-A, A);
        work = 0.0; // settled: now a whole cycle
        stroke(A, -A);
        stroke(-A, A);
        const double step = 2.0 * A / n, off = work - 4.0 * kStiffness * R * (A - R);
        QVERIFY2(std::abs(off) < 2.0 * kStiffness * step * step, qPrintable(QString::number(off))); // two reversals
    }

    void aHandInACircleDragsItOnASmallerOne()
    {
        const double mu = 0.4, r = 7.0, step = 0.01;
        Rough feel(box(Vec3(-50, -50, -50), Vec3(50, 50, 0)), rough(mu, mu));
        const Vec3 about(25, 0, 0); // within one facet, for either diagonal
        (void)feel.at(about + Vec3(r, 0, 1));
        TickResult t;
        Vec3 hip;
        for (int i = 0; i < 40000; ++i) {
            hip = about + Vec3(r * std::cos(i * step), r * std::sin(i * step), -5.0);
            t = feel.at(hip);
        }
        // At rest in the rotating frame: |hip(i) - g(i)| = R, g(i) on the line from hip(i) to g(i - 1).
        const double R = mu * (t.p_WG.z() - hip.z());
        const double expected = std::sqrt(r * r - R * R * std::pow(std::cos(0.5 * step), 2)) - R * std::sin(0.5 * step);
        const double off = along(t.p_WG - about).norm() / expected - 1.0;
        QVERIFY2(std::abs(off) < 1e-12, qPrintable(QString::number(off)));
    }

    void grooveDragsAsAVBelt_data()
    {
        QTest::addColumn<double>("opening_deg");
        QTest::addColumn<double>("radius_mm");
        for (const double opening : {20.0, 60.0, 90.0, 140.0}) {
            QTest::addRow("%g degrees, point", opening) << opening << 0.0;
            QTest::addRow("%g degrees, ball of 2 mm", opening) << opening << 2.0;
        }
    }
    void grooveDragsAsAVBelt()
    {
        QFETCH(double, opening_deg);
        QFETCH(double, radius_mm);
        const double mu = 0.2, half = 0.5 * opening_deg * std::numbers::pi / 180.0;
        Rough feel(groove(2.0 * half), rough(mu, mu), radius_mm);
        const double bottom = radius_mm / std::sin(half), depth = 1.0;
        (void)feel.at(Vec3(0, -10, bottom + 4));
        (void)feel.move(Vec3(0, -10, bottom + 2), Vec3(0, -10, bottom - depth), 20);
        const TickResult t = feel.move(Vec3(0, -10, bottom - depth), Vec3(0, 10, bottom - depth), 300);
        QCOMPARE(int(t.constraints), 2);
        const double h = t.p_WG.z() - (bottom - depth);
        const double off = -t.f_W.y() / (mu * kStiffness * h / std::sin(half)) - 1.0;
        QVERIFY2(std::abs(off) < 1e-10, qPrintable(QString::number(off)));
    }

    void narrowGrooveLetsGo_data()
    {
        QTest::addColumn<double>("mu");
        QTest::newRow("mu 1") << 1.0;
        QTest::newRow("mu 5") << 5.0;
    }
    void narrowGrooveLetsGo()
    {
        // Narrower than 2 atan mu: two cones together would hold the hand by wedging.
        QFETCH(double, mu);
        Rough feel(groove(20.0 * std::numbers::pi / 180.0), rough(mu, mu));
        (void)feel.move(Vec3(0, 0, 15), Vec3(0, 0, -3), 100);
        for (int i = 0; i <= 400; ++i) {
            const Vec3 hip(0.02 * std::sin(i), 0.0, -3.0 + i * 0.05);
            const TickResult t = feel.at(hip);
            QVERIFY(t.constraints > 0 || t.f_W.norm() == 0.0);
            if (hip.z() > 1.0) {
                QVERIFY2(t.f_W.norm() == 0.0, qPrintable(QString("glued at z = %1").arg(hip.z())));
            }
        }
    }

    void holdsUpToTheBreakAwayAndCatchesAgainBelowTheRim()
    {
        const double atRest = 0.6, sliding = 0.3, depth = 2.0;
        Rough feel(block(), rough(atRest, sliding));
        (void)feel.at(Vec3(0.2, 0.3, 1));
        TickResult t = feel.at(Vec3(0.2, 0.3, -depth));
        const double felt = t.p_WG.z() + depth, g = t.p_WG.x();
        const auto pull = [&](double by) { return feel.at(Vec3(g + by, 0.3, -depth)); };
        t = pull(atRest * felt * (1.0 - 1e-9));
        QCOMPARE(t.p_WG.x(), g);
        QCOMPARE(t.friction(), Friction::Holds);
        const double out = atRest * felt * (1.0 + 1e-9);
        t = pull(out);
        QCOMPARE(t.friction(), Friction::Slides);
        QVERIFY(std::abs(g + out - t.p_WG.x() - sliding * felt) < 1e-12);
        const double rim = t.p_WG.x();
        const auto pullFrom = [&](double by) { return feel.at(Vec3(rim + by, 0.3, -depth)); };
        t = pullFrom(0.7 * sliding * felt); // inside the cone, but not yet static
        QCOMPARE(t.friction(), Friction::Slides);
        QCOMPARE(t.p_WG.x(), rim);
        t = pullFrom(sliding * felt * 1.001); // continues to slide at once
        QVERIFY(t.p_WG.x() > rim);
        const double again = t.p_WG.x();
        t = feel.at(Vec3(again + 0.5 * sliding * felt, 0.3, -depth));
        QCOMPARE(t.friction(), Friction::Holds); // static
        t = feel.at(Vec3(again + 0.99 * atRest * felt, 0.3, -depth));
        QCOMPARE(t.friction(), Friction::Holds);
        QCOMPARE(t.p_WG.x(), again);
    }

    void dragIsForceBySpeed_data()
    {
        QTest::addColumn<double>("mapped");
        QTest::addColumn<double>("below");
        QTest::newRow("no map") << 1.0 << 1.0;
        QTest::newRow("map of the stiffness") << 2.0 << 1.0;
        QTest::newRow("lumps felt below") << 1.0 << 2.5;
        QTest::newRow("both") << 2.0 << 2.5;
    }
    void dragIsForceBySpeed()
    {
        QFETCH(const double, mapped);
        QFETCH(const double, below);
        const double mu = 0.2, drag = 0.02, speed = 30.0, depth = 3.0; // N s/mm, mm/s, mm
        HapticStructure on{"it", indexed(block()), rough(mu, mu, drag), 0};
        const auto everywhere = [&on](double value) {
            const auto number = static_cast<float>(value);
            return std::make_shared<std::vector<std::array<float, 3>>>(on.surface->triangleCount(),
                                                                       std::array<float, 3>{number, number, number});
        };
        if (mapped != 1.0) {
            on.maps.stiffness.corners = everywhere(mapped);
        }
        if (below != 1.0) {
            for (haptics::TissueMap& map : on.maps.felt) {
                map.corners = everywhere(below);
            }
        }
        for (const double dt : {1e-3, 1e-4}) {
            Rough feel(on);
            (void)feel.at(Vec3(-10, 0.3, 1), dt);
            TickResult t;
            const int ticks = static_cast<int>(1.5 / dt); // e^-37 from the steady state
            for (int i = 0; i <= ticks; ++i) {
                t = feel.at(Vec3(-10 + speed * dt * i, 0.3, -depth), dt);
            }
            QVERIFY(std::abs(t.f_W.z() - mapped * below * kStiffness * depth) < 1e-6);
            const double felt = mu * t.f_W.z() + drag * speed;
            QVERIFY2(std::abs(along(t.f_W).norm() - felt) < 1e-11 * felt,
                     qPrintable(QString("%1, expected %2").arg(along(t.f_W).norm()).arg(felt)));
        }
    }

    void leavesTheContactWithoutForce()
    {
        Rough feel(bumpySphere(10, 30.0, 0.03), rough(1.0, 0.8));
        const Vec3 up = Vec3(1, 2, 3).normalized();
        (void)feel.move(40.0 * up, 26.0 * up, 30);
        const TickResult t = feel.move(26.0 * up, 40.0 * up, 90);
        QCOMPARE(int(t.constraints), 0);
        QVERIFY(t.f_W == Vec3::Zero());
        QVERIFY(isBitEqual(t.p_WG, 40.0 * up));
    }

    void staysWithinTheConeOverEdgesCornersAndFans_data()
    {
        QTest::addColumn<geometry::TriangleMesh>("mesh");
        QTest::addColumn<double>("radius_mm");
        QTest::addColumn<double>("mu");
        for (const double mu : {0.3, 1.0}) {
            for (const double radius : {0.0, 3.0}) {
                const QByteArray name = QString(", mu %1, radius %2").arg(mu).arg(radius).toLatin1();
                QTest::newRow("box" + name) << box(Vec3(-15, -15, -15), Vec3(15, 15, 15), 3) << radius << mu;
                QTest::newRow("groove" + name) << groove(1.0) << radius << mu;
                QTest::newRow("bumpy" + name) << bumpySphere(16, 20.0, 0.05) << radius << mu;
            }
        }
    }
    void staysWithinTheConeOverEdgesCornersAndFans()
    {
        QFETCH(geometry::TriangleMesh, mesh);
        QFETCH(double, radius_mm);
        QFETCH(double, mu);
        Rough feel(mesh, rough(mu, mu), radius_mm);
        std::mt19937_64 random(11);
        std::normal_distribution<double> normal;
        Vec3 hip(0, 0, 40), goal = hip;
        double input = 0.0;
        Vec3 before = hip;
        int outside = 0, touching = 0;
        for (int i = 0; i < 40000; ++i) {
            if ((hip - goal).norm() < 0.2) {
                goal = 17.0 * Vec3(normal(random), normal(random), normal(random)).normalized();
            }
            hip += 0.1 * (goal - hip).normalized();
            const TickResult t = feel.at(hip);
            QVERIFY(t.iterations < 512);
            QVERIFY(t.status == haptics::TickStatus::Converged);
            input -= t.f_W.dot(hip - before);
            before = hip;
            if (t.constraints == 0) {
                QVERIFY(t.f_W == Vec3::Zero() && t.p_WG == hip);
                continue;
            }
            ++touching;
            QVERIFY((t.f_W - kStiffness * (t.p_WG - hip)).norm() <= 1e-12 * (1.0 + t.f_W.norm()));
            QVERIFY(std::abs(t.n_W.norm() - 1.0) < 1e-12);
            if (t.constraints == 1) {
                const FrictionCone cone = coneOf(t, hip, mu);
                outside += cone.r_mm > cone.radius_mm + 1e-5 ? 1 : 0;
            }
        }
        QVERIFY(touching > 4000);
        QCOMPARE(outside, 0);
        QVERIFY(input >= 0.0);
    }

    void neverMakesEnergyInAnyTickOnOneSetOfContacts()
    {
        for (const double mu : {0.1, 0.7}) {
            Rough feel(groove(1.2), rough(1.3 * mu, mu));
            std::mt19937_64 random(3);
            std::normal_distribution<double> normal;
            Vec3 hip(0, 0, 4), goal = hip, before = hip;
            TickResult last = feel.at(hip);
            int judged = 0;
            for (int i = 0; i < 100000; ++i) {
                if ((hip - goal).norm() < 0.2) {
                    goal = Vec3(2.0 * normal(random), 6.0 * normal(random), 2.0 * normal(random) - 1.0);
                }
                hip += 0.05 * (goal - hip).normalized();
                const TickResult t = feel.at(hip);
                const auto energy = [](const Vec3& f) { return 0.5 * f.squaredNorm() / kStiffness; };
                const bool isSame =
                    t.constraints == last.constraints && t.constraints > 0 && (t.n_W - last.n_W).norm() < 1e-9;
                if (isSame) {
                    ++judged;
                    const double gained = energy(t.f_W) - energy(last.f_W) + t.f_W.dot(hip - before);
                    QVERIFY2(gained <= 1e-12 * (1.0 + energy(t.f_W)),
                             qPrintable(QString("tick %1: %2 mJ").arg(i).arg(gained)));
                }
                last = t;
                before = hip;
            }
            QVERIFY(judged > 20000);
        }
    }

    void isTheSameElsewhereLargerAndTurned()
    {
        const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 2).normalized());
        const Vec3 by(3e3, -2e3, 1e3);
        const auto map = [&](const Vec3& p, double scale) { return Vec3(scale * (turn * p) + by * scale); };
        const auto mesh = bumpySphere(10, 30.0, 0.05);
        for (const double scale : {1.0, 1000.0}) {
            Rough here(mesh, rough(0.4, 0.3));
            Rough there(transformed(mesh, [&](const Vec3& p) { return map(p, scale); }), rough(0.4, 0.3));
            std::mt19937_64 random(5);
            std::normal_distribution<double> normal;
            Vec3 hip(0, 0, 33), goal = hip;
            for (int i = 0; i < 3000; ++i) {
                if ((hip - goal).norm() < 0.2) {
                    goal = 28.0 * Vec3(normal(random), normal(random), normal(random)).normalized();
                }
                hip += 0.1 * (goal - hip).normalized();
                hip *= 28.5 / std::max(28.5, hip.norm()); // never deep: for equally near paths rounding decides
                hip *= std::max(27.5, hip.norm()) / hip.norm();
                const TickResult a = here.at(hip), b = there.at(map(hip, scale));
                const double off = (map(a.p_WG, scale) - b.p_WG).norm() / scale;
                QVERIFY2(off < 1e-9, qPrintable(QString("tick %1: %2 mm").arg(i).arg(off)));
            }
        }
    }

    void ballSaysWhereItIsHeld()
    {
        // On the edge of a block: the plane that holds a ball passes through the contact point and is not parallel to
        // the facet.
        Rough feel(block(), rough(2.0, 2.0), 4.0);
        (void)feel.at(Vec3(54, 0, 6));
        TickResult t = feel.at(Vec3(51, 0, 1));
        for (int i = 0; i < 3; ++i) {
            t = feel.at(Vec3(51, 0.1 * i, 1));
            QCOMPARE(int(t.constraints), 1);
            const Vec3 fromEdge = t.p_WG - Vec3(50, t.p_WG.y(), 0);
            QVERIFY((t.active[0].n_W - fromEdge.normalized()).norm() < 1e-9);
            QVERIFY((t.active[0].n_W - t.n_W).norm() < 1e-9);
        }
        QCOMPARE(t.friction(), Friction::Holds);
    }

    void restoresBitForBitWhileItSlidesAndWhileItHolds()
    {
        for (const double radius : {0.0, 3.0}) {
            Rough one(bumpySphere(12, 25.0, 0.04), rough(0.5, 0.3, 0.001), radius);
            Palpator other;
            other.borrowScene(&one.scene);
            const auto hipAt = [](int i) {
                return Vec3(24.0 * std::sin(0.01 * i), 5.0 * std::sin(0.003 * i), 20.0 + 6.0 * std::cos(0.02 * i));
            };
            for (int i = 0; i < 3000; ++i) {
                if (i % 37 == 0) {
                    other.restore(one.palpator.state());
                }
                const TickResult a = one.at(hipAt(i)), b = other.step(hipAt(i), kTick_s);
                QVERIFY(isBitEqual(a.p_WG, b.p_WG) && isBitEqual(a.f_W, b.f_W) && a.friction() == b.friction());
            }
        }
    }

    void withoutCoefficientsNothingChanges()
    {
        Tissue none;
        none.stiffness_N_per_mm = kStiffness;
        Tissue dynamicAlone = rough(0.0, 0.0);
        Rough a(bumpySphere(12, 25.0, 0.04), none), b(bumpySphere(12, 25.0, 0.04), dynamicAlone);
        for (int i = 0; i < 3000; ++i) {
            const Vec3 hip(24.0 * std::sin(0.01 * i), 5.0 * std::sin(0.003 * i), 20.0 + 6.0 * std::cos(0.02 * i));
            const TickResult s = a.at(hip), t = b.at(hip);
            QVERIFY(isBitEqual(s.p_WG, t.p_WG) && isBitEqual(s.f_W, t.f_W) && isBitEqual(s.n_W, t.n_W));
            QCOMPARE(s.friction(), Friction::None);
        }
    }

    void outerTissueSlidesWhileTheInnerOneHolds()
    {
        HapticStructure outer{"liver", indexed(block()), rough(0.1, 0.1), 0};
        HapticStructure inner{"lump", indexed(box(Vec3(-20, -20, -40), Vec3(20, 20, -2), 3)), rough(1.0, 1.0), 1};
        const HapticScene scene({outer, inner});
        Palpator palpator;
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(0, 0, 1), kTick_s);
        (void)palpator.step(Vec3(0, 0, -5), kTick_s);
        const TickResult t = palpator.step(Vec3(1, 0, -5), kTick_s);
        QCOMPARE(int(t.contactCount), 2);
        QCOMPARE(t.contacts[0].friction, Friction::Slides);
        QCOMPARE(t.contacts[1].friction, Friction::Holds);
        QVERIFY(std::abs(-t.contacts[0].f_W.x() / t.contacts[0].f_W.z() - 0.1) < 1e-9);
        QVERIFY(std::abs(-t.contacts[1].f_W.x() - kStiffness * 1.0) < 1e-9);
    }
};

PALPATE_TEST_NAMED("Friction", TestFriction)
#include "tst_Friction.moc"
