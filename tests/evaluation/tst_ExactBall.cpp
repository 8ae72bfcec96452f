// SPDX-License-Identifier: BSD-3-Clause
// Tests the exact solver for a fingertip against closed forms, and the engine against the exact solver.
#include "TestRunner.h"

#include <palpate/evaluation/ExactSolver.h>
#include <palpate/evaluation/ProductSolver.h>
#include <palpate/evaluation/Shapes.h>

#include <cmath>
#include <memory>
#include <numbers>

using namespace palpate;
using namespace palpate::evaluation;

namespace {

constexpr double kBound_mm = 1e-9;

/// A hand that moves in straight lines between positions.
class Feel
{
  public:
    Feel(const geometry::TriangleMesh& mesh, double radius_mm, const Vec3& start)
        : m_surface(geometry::repair(mesh, geometry::Facing::AsGiven))
        , m_solver(m_surface, 1, radius_mm)
        , m_hip(start)
    {
        m_solver.start(start);
    }
    SolverStep to(const Vec3& end, int ticks)
    {
        SolverStep s;
        const Vec3 from = m_hip;
        for (int i = 1; i <= ticks; ++i) {
            s = m_solver.step(i == ticks ? end : Vec3(from + (end - from) * (double(i) / ticks)));
            m_isConverged = m_isConverged && s.isConverged;
            m_worst_mm = std::max(m_worst_mm, m_solver.intrusion_mm(s.p_WG));
        }
        m_hip = end;
        return s;
    }
    /// Returns whether every tick so far converged, with no facet nearer than the radius.
    bool isGood() const { return m_isConverged && m_worst_mm <= 1e-12; }

  private:
    Surface m_surface;
    ExactSolver m_solver;
    Vec3 m_hip;
    bool m_isConverged = true;
    double m_worst_mm = 0.0;
};

#define QVERIFY_AT(step, expected)                                                                                     \
    do {                                                                                                               \
        const Vec3 p_WG = (step).p_WG;                                                                                 \
        QVERIFY2((p_WG - (expected)).norm() <= kBound_mm,                                                              \
                 qPrintable(QString("off by %1 mm").arg((p_WG - (expected)).norm())));                                 \
    } while (false)

} // namespace

class ExactBall : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void restsOnAPlane()
    {
        Feel feel(shapes::box({-10, -10, -10}, {10, 10, 0}, 3), 1.5, {1, 2, 8});
        SolverStep s = feel.to({1.2, 1.7, -3}, 40);
        QVERIFY_AT(s, Vec3(1.2, 1.7, 1.5));
        QCOMPARE(s.constraints, 1);
        QVERIFY((s.spring_mm - Vec3(0, 0, 4.5)).norm() <= kBound_mm);
        s = feel.to({1.2, 1.7, 4}, 10);
        QCOMPARE(s.p_WG, Vec3(1.2, 1.7, 4));
        QCOMPARE(s.constraints, 0);
        QVERIFY(feel.isGood());
    }

    void aGrooveHoldsItAboveItsBottom_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {150.0, 90.0, 40.0, 10.0, 1.0}) {
            QTest::newRow(qPrintable(QString("%1 degrees").arg(degrees))) << degrees;
        }
    }
    void aGrooveHoldsItAboveItsBottom()
    {
        QFETCH(double, degrees);
        const double half = degrees * std::numbers::pi / 360.0, radius = std::min(0.5, 10.0 * std::tan(half));
        const double height = radius / std::sin(half);
        Feel feel(shapes::groove(2.0 * half, 20.0, 12.0), radius, {0, 0, 19});
        SolverStep s = feel.to({0, 0, -5}, 60);
        QVERIFY_AT(s, Vec3(0, 0, height));
        QCOMPARE(s.constraints, 2);
        s = feel.to({0, 6, -5}, 30);
        QVERIFY_AT(s, Vec3(0, 6, height));
        QVERIFY(feel.isGood());
    }

    void aPocketOfThreePlanesHoldsIt()
    {
        geometry::TriangleMesh cavity = shapes::box({0, 0, 0}, {30, 30, 30}, 3);
        geometry::flip(cavity);
        Feel feel(cavity, 2.0, {15, 15, 15});
        const SolverStep s = feel.to({-5, -3, -4}, 60);
        QVERIFY_AT(s, Vec3(2, 2, 2));
        QCOMPARE(s.constraints, 3);
        QVERIFY(feel.isGood());
    }

    void rollsRoundAnEdge()
    {
        Feel feel(shapes::box({-10, -10, -10}, {0, 10, 0}, 2), 2.0, {-3, 1, 5});
        feel.to({-3, 1, 1}, 20);
        for (const double depth : {0.7, 1.3, 1.9, 1.99}) {
            for (const double angle : {0.2, 0.6, 1.0, 1.4}) {
                const Vec3 out(std::sin(angle), 0, std::cos(angle));
                const SolverStep s = feel.to(Vec3(0, 1, 0) + (2.0 - depth) * out, 40);
                QVERIFY(std::abs(s.spring_mm.norm() - depth) <= kBound_mm);
                // The nearer the HIP to the edge itself, the less the pull determines the position on the circle.
                const double off = (s.p_WG - Vec3(0, 1, 0) - 2.0 * out).norm();
                QVERIFY2(off <= 3e-8 / (2.0 - depth), qPrintable(QString("%1 deep: off by %2").arg(depth).arg(off)));
            }
            feel.to({-1, 1, 1}, 20);
        }
        QVERIFY(feel.isGood());
    }

    void rollsRoundACorner()
    {
        const Vec3 out = Vec3(1, 2, 3).normalized();
        Feel feel(shapes::box({-10, -10, -10}, {0, 0, 0}, 2), 2.0, Vec3(5, 5, 6));
        QVERIFY_AT(feel.to(1.2 * out, 60), 2.0 * out);
        const Vec3 other = Vec3(3, 1, 1).normalized();
        QVERIFY_AT(feel.to(0.1 * other, 60), 2.0 * other);
        QVERIFY(feel.isGood());
    }

    void liesOnTwoEdges()
    {
        // Two boxes with a gap of 2 mm: a ball of 2 mm rests on both rims, with its centre sqrt(3) above them.
        geometry::TriangleMesh mesh = shapes::box({-11, -10, -10}, {-1, 10, 0}, 2);
        shapes::append(mesh, shapes::box({1, -10, -10}, {11, 10, 0}, 2));
        Feel feel(mesh, 2.0, {0.3, 1, 6});
        const SolverStep s = feel.to({0.1, 1.5, -4}, 60);
        QVERIFY_AT(s, Vec3(0, 1.5, std::sqrt(3.0)));
        QCOMPARE(s.constraints, 2);
        QVERIFY(feel.isGood());
    }

    void doesNotStandOnAnEdge()
    {
        // The pull goes through the edge and out below: the ball could balance on the edge, but rolls off.
        Feel feel(shapes::prism({{0, 0}, {-10, -10}, {10, -10}}, 10.0), 1.0, {0, 0.3, 4});
        const SolverStep s = feel.to({0, 0.3, -3}, 60);
        // On either wall at a distance of one radius: x + z = sqrt(2), nearest to the HIP.
        QVERIFY_AT(s, Vec3(std::copysign(1.5 + std::sqrt(0.5), s.p_WG.x()), 0.3, -1.5 + std::sqrt(0.5)));
        QVERIFY(feel.isGood());
    }

    void feelsASheetFromBothSidesAndIsNotPassed()
    {
        for (const double side : {1.0, -1.0}) {
            Feel feel(shapes::sheet(10.0, 4), 1.0, {0.3, 0.2, 6 * side});
            QVERIFY_AT(feel.to({0.3, 0.2, -40 * side}, 1), Vec3(0.3, 0.2, side));
        }
    }

    void theProductAgrees_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("bump");
        for (const double radius : {0.05, 0.5, 2.0}) {
            for (const double bump : {0.0, 0.02}) {
                QTest::newRow(qPrintable(QString("%1 mm, bumps of %2").arg(radius).arg(bump))) << radius << bump;
            }
        }
    }
    void theProductAgrees()
    {
        QFETCH(double, radius);
        QFETCH(double, bump);
        const Surface surface(geometry::repair(shapes::bumpySphere(8, 20.0, bump)));
        ExactSolver exact(surface, 1, radius);
        ProductSolver product(sceneOf(surface.repaired(), radius), "product");
        Vec3 hip(0, 0, 25), god = hip;
        product.start(hip);
        double worst = 0.0, intrusion = 0.0;
        int contacts = 0;
        for (int i = 0; i < 800; ++i) {
            const Vec3 before = hip;
            const double a = 3e-3 * i;
            hip = std::max(17.0, 25.0 - 0.1 * i) *
                  Vec3(std::sin(a), std::sin(0.7 * a + 0.2), std::cos(1.3 * a)).normalized();
            exact.resume(god, before);
            god = product.step(hip).p_WG;
            worst = std::max(worst, (exact.step(hip).p_WG - god).norm());
            intrusion = std::max(intrusion, exact.intrusion_mm(god));
            contacts += (god - hip).norm() > 1e-3 ? 1 : 0;
        }
        QVERIFY(contacts > 500);
        QVERIFY2(worst <= 1e-6, qPrintable(QString("%1 mm").arg(worst)));
        QVERIFY2(intrusion <= 1e-9, qPrintable(QString("%1 mm").arg(intrusion)));
    }
};

PALPATE_TEST(ExactBall)
#include "tst_ExactBall.moc"
