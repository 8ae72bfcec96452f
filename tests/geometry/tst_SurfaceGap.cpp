// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/SurfaceGap.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using geometry::nearestWithin;

class SurfaceGap : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void measuresTheGapOfTwoBoxes_data()
    {
        QTest::addColumn<double>("gap_mm");
        QTest::addColumn<bool>("isSwapped");
        for (const double gap_mm : {0.001, 0.05, 0.19}) {
            for (const bool isSwapped : {false, true}) {
                QTest::addRow("%g%s", gap_mm, isSwapped ? " swapped" : "") << gap_mm << isSwapped;
            }
        }
    }
    void measuresTheGapOfTwoBoxes()
    {
        QFETCH(double, gap_mm);
        QFETCH(bool, isSwapped);
        const auto few = indexed(box(Vec3::Zero(), Vec3(10, 10, 10)));
        const auto many = indexed(box(Vec3(10 + gap_mm, 2, 3), Vec3(20, 12, 13), 7));
        const auto found = isSwapped ? nearestWithin(*many, *few, 0.2, 1e-4) : nearestWithin(*few, *many, 0.2, 1e-4);
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->distance_mm - gap_mm) < 1e-12);
        QVERIFY(std::abs(found->at.x() - (10.0 + 0.5 * gap_mm)) < 1e-9);
        QVERIFY(!found->isBounded);
    }

    void findsNothingFartherApart()
    {
        const auto a = indexed(sphere(8, 10.0));
        QVERIFY(!nearestWithin(*a, *indexed(moved(sphere(8, 10.0), Vec3(20.3, 0, 0))), 0.2, 1e-4));
    }

    void touchingAndCrossingIsZero()
    {
        const auto a = indexed(box(Vec3::Zero(), Vec3(10, 10, 10)));
        const auto wall = nearestWithin(*a, *indexed(box(Vec3(10, 0, 0), Vec3(20, 10, 10), 3)), 0.2, 1e-4);
        QVERIFY(wall.has_value() && wall->distance_mm <= 1e-4);
        const auto across = nearestWithin(*a, *indexed(moved(sphere(6, 4.0), Vec3(10.5, 5.2, 4.9))), 0.2, 1e-4);
        QVERIFY(across.has_value() && across->distance_mm == 0.0);
    }

    /// An edge above an edge: neither has a corner near the other's face.
    void edgesAreMeasured()
    {
        const auto low = indexed(box(Vec3(-5, -1, -2), Vec3(5, 1, 0)));
        const Eigen::Matrix3d turn =
            (Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()) * Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()))
                .toRotationMatrix();
        const double half_mm = std::sqrt(2.0);
        const auto high = indexed(transformed(box(Vec3(-5, -1, -1), Vec3(5, 1, 1)), [&](const Vec3& p) {
            return Vec3(turn * p + Vec3(0, 0, half_mm + 0.1));
        }));
        const auto found = nearestWithin(*low, *high, 0.2, 1e-4);
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->distance_mm - 0.1) < 1e-9);
    }

    void boundIsKeptAndSaid()
    {
        const auto a = indexed(box(Vec3::Zero(), Vec3(10, 10, 10), 6));
        const auto found = nearestWithin(*a, *indexed(box(Vec3(10.1, 0, 0), Vec3(20, 10, 10), 6)), 0.2, 1e-4, 3);
        QVERIFY(!found || found->isBounded);
    }
};

PALPATE_TEST(SurfaceGap)
#include "tst_SurfaceGap.moc"
