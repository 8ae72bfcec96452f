// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "probe/ConstrainedPoint.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

using palpate::core::Vec3;
using palpate::haptics::internal::ConstrainedPoint;
using palpate::haptics::internal::constrainedPoint;
using palpate::haptics::internal::HalfSpace;

namespace {

/// The paper's full (3 + k) × (3 + k) Lagrange system, solved densely.
Vec3 lagrange(const Vec3& wanted, const std::vector<HalfSpace>& planes)
{
    const auto k = static_cast<Eigen::Index>(planes.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 + k, 3 + k);
    Eigen::VectorXd b(3 + k);
    a.topLeftCorner(3, 3).setIdentity();
    b.head(3) = wanted;
    for (Eigen::Index i = 0; i < k; ++i) {
        a.block(0, 3 + i, 3, 1) = planes[static_cast<std::size_t>(i)].n;
        a.block(3 + i, 0, 1, 3) = planes[static_cast<std::size_t>(i)].n.transpose();
        b[3 + i] = planes[static_cast<std::size_t>(i)].offset_mm;
    }
    return a.fullPivLu().solve(b).head(3);
}

} // namespace

class ConstrainedPointTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void withoutPlanesIsTheWantedPoint()
    {
        const ConstrainedPoint p = constrainedPoint(Vec3(1, 2, 3), {}, 1e-12);
        QCOMPARE(p.count, 0);
        QVERIFY(p.u == Vec3(1, 2, 3));
    }

    void solvesThePapersSystem()
    {
        std::mt19937 random(11);
        std::normal_distribution<double> normal;
        int withThree = 0;
        for (int round = 0; round < 20000; ++round) {
            std::vector<HalfSpace> planes;
            for (int i = 0; i < 1 + round % 4; ++i) {
                planes.push_back(
                    {Vec3(normal(random), normal(random), normal(random)).normalized(), 0.01 * normal(random)});
            }
            const Vec3 wanted = 5.0 * Vec3(normal(random), normal(random), normal(random));
            const ConstrainedPoint p = constrainedPoint(wanted, planes, 1e-12);
            std::vector<HalfSpace> active;
            bool isFeasible = true;
            for (const HalfSpace& plane : planes) {
                isFeasible = isFeasible && plane.n.dot(p.u) >= plane.offset_mm - 1e-9;
            }
            if (!isFeasible) {
                continue; // four planes may leave no point, or only an ill-conditioned point
            }
            for (int i = 0; i < p.count; ++i) {
                active.push_back(planes[p.active[static_cast<std::size_t>(i)]]);
            }
            Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
            for (const HalfSpace& plane : active) {
                squares += plane.n * plane.n.transpose();
            }
            // The dense system is as badly conditioned as the square of its normals' smallest singular value.
            // It is an eigenvalue of the normals' squares; the smaller ones, in directions of no normal, are 0.
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
            eigen.computeDirect(squares, Eigen::EigenvaluesOnly);
            const double square = p.count == 0 ? 1.0 : std::max(eigen.eigenvalues()[3 - p.count], 1e-15);
            const double conditioned = 1e-14 / square * (wanted.norm() + p.u.norm());
            QVERIFY((lagrange(wanted, active) - p.u).norm() < conditioned);
            withThree += p.count == 3 ? 1 : 0;
        }
        QVERIFY(withThree > 500);
    }

    void releasesAPlaneThatPullsTheWrongWay()
    {
        const std::array planes{HalfSpace{Vec3::UnitZ(), 0.0}, HalfSpace{Vec3::UnitX(), 0.0}};
        const ConstrainedPoint p = constrainedPoint(Vec3(1, 0, -1), planes, 1e-12);
        QCOMPARE(p.count, 1);
        QCOMPARE(int(p.active[0]), 0);
        QVERIFY((p.u - Vec3(1, 0, 0)).norm() < 1e-15);
    }

    void staysAccurateOnNearParallelPlanes_data()
    {
        QTest::addColumn<double>("angle");
        for (int k = 2; k <= 7; ++k) {
            QTest::addRow("1e-%d rad", k) << std::pow(10.0, -k);
        }
    }
    void staysAccurateOnNearParallelPlanes()
    {
        QFETCH(double, angle);
        // A shallow valley along y with its bottom at x = z = 0, pushed straight down next to it.
        const std::array planes{HalfSpace{Vec3(std::sin(angle), 0, std::cos(angle)), 0.0},
                                HalfSpace{Vec3(-std::sin(angle), 0, std::cos(angle)), 0.0}};
        const ConstrainedPoint p = constrainedPoint(Vec3(0.1 * angle, 2, -5), planes, 1e-12);
        // The valley's position is the planes' offsets over their angle: rounding and the allowed violation over it.
        QVERIFY2((p.u - Vec3(0, 2, 0)).norm() < 1.1e-12 / angle,
                 qPrintable(QString::number((p.u - Vec3(0, 2, 0)).norm())));
    }

    void neverDividesByZero_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {0.0, 1e-9, 1e-12, 3e-16}) {
            QTest::addRow("%g rad", angle) << angle;
        }
    }
    void neverDividesByZero()
    {
        QFETCH(double, angle);
        const Vec3 n(std::sin(angle), 0, std::cos(angle));
        const std::array repeated{HalfSpace{Vec3::UnitZ(), 0.0}, HalfSpace{n, 0.0}, HalfSpace{n, 1e-3}};
        const ConstrainedPoint p = constrainedPoint(Vec3(0, 0, -5), repeated, 1e-12);
        QVERIFY(p.u.allFinite());
        QVERIFY(std::abs(p.u.z() - 1e-3) < 1e-8);
        const std::array opposed{HalfSpace{Vec3::UnitZ(), 1e-9}, HalfSpace{-n, 1e-9}};
        QVERIFY(constrainedPoint(Vec3(0, 0, -5), opposed, 1e-12).u.allFinite());
    }
};

PALPATE_TEST_NAMED("ConstrainedPoint", ConstrainedPointTest)
#include "tst_ConstrainedPoint.moc"
