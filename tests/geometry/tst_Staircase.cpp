// SPDX-License-Identifier: BSD-3-Clause
#include "Masks.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Staircase.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using geometry::findStaircase;

class Staircase : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void findsTheVoxelsOfMasks_data()
    {
        QTest::addColumn<double>("inPlane_mm");
        QTest::addColumn<double>("slice_mm");
        QTest::addColumn<bool>("isFaces");
        const struct
        {
            double inPlane_mm, slice_mm;
        } sizes[] = {{1.0, 3.0}, {0.8, 2.5}, {1.0, 1.0}, {0.4, 0.4}};
        for (const auto& size : sizes) {
            for (const bool isFaces : {false, true}) {
                QTest::addRow("%g x %g, %s", size.inPlane_mm, size.slice_mm, isFaces ? "voxel faces" : "cubes")
                    << size.inPlane_mm << size.slice_mm << isFaces;
            }
        }
    }
    void findsTheVoxelsOfMasks()
    {
        QFETCH(double, inPlane_mm);
        QFETCH(double, slice_mm);
        QFETCH(bool, isFaces);
        const Vec3 voxel_mm(inPlane_mm, inPlane_mm, slice_mm);
        const Mask mask = ballMask(12.0, voxel_mm);
        const auto found = findStaircase(isFaces ? voxelFaces(mask) : maskSurface(mask));
        QVERIFY(found.has_value());
        QVERIFY((found->voxel_mm - voxel_mm).norm() < 1e-9);
        QVERIFY((found->axes - Eigen::Matrix3d::Identity()).norm() < 1e-9);
        QCOMPARE(found->areaShare, 1.0);
    }

    void saysWhatItFound()
    {
        const auto found = findStaircase(maskSurface(ballMask(12.0, Vec3(1, 1, 3))));
        QVERIFY(found.has_value());
        QCOMPARE(found->sentence().english(),
                 std::string("staircase of about 1 × 1 × 3 mm voxels (100 % of the area in 60 "
                             "directions)"));
    }

    /// As in oblique acquisitions: rotated, far from the origin, in floats or with two decimals.
    void findsTurnedAndRoundedMasks()
    {
        const Eigen::Matrix3d turn =
            (Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Eigen::AngleAxisd(0.5, Vec3::UnitZ())).toRotationMatrix();
        for (const bool hasTwoDecimals : {false, true}) {
            const TriangleMesh mesh = transformed(maskSurface(ballMask(15.0, Vec3(0.8, 0.8, 2.5))), [&](const Vec3& p) {
                const Vec3 q = turn * p + Vec3(100.0, -200.0, 700.0);
                return hasTwoDecimals ? Vec3((100.0 * q).array().round() / 100.0)
                                      : Vec3(q.cast<float>().cast<double>());
            });
            const auto found = findStaircase(soup(mesh));
            QVERIFY(found.has_value());
            QVERIFY((found->voxel_mm - Vec3(0.8, 0.8, 2.5)).norm() < 0.01);
            QVERIFY((found->axes.col(2) - turn.col(2)).norm() < 0.01);
        }
    }

    void findsSmallAndThinMasks()
    {
        QVERIFY(findStaircase(maskSurface(ballMask(3.0, Vec3::Ones()))));
        const Mask vessel{Vec3::Ones(), Vec3(8, 8, 22), [](const Vec3& p) {
                              return (p - Vec3(0.1, 0.2, 0.0)).head<2>().norm() < 3.3 && std::abs(p.z()) < 19.5;
                          }};
        QVERIFY(findStaircase(maskSurface(vessel)));
    }

    void leavesOtherSurfacesAlone_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::newRow("nothing") << TriangleMesh();
        QTest::newRow("box") << box(Vec3::Zero(), Vec3(10, 20, 30));
        QTest::newRow("box in squares of a voxel") << box(Vec3::Zero(), Vec3(20, 20, 20), 20);
        TriangleMesh corner; // perpendicular faces, corners 0 or one edge apart
        corner.vertices = {{0, 0, 0}, {24, 0, 0}, {0, 24, 0}, {0, 0, 24}};
        corner.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        QTest::newRow("cut corner") << corner;
        QTest::newRow("sheet") << sheet(10.0, 20);
        QTest::newRow("groove") << groove(1.0);
        QTest::newRow("coarse sphere") << sphere(1, 10.0);
        QTest::newRow("sphere") << sphere(20, 10.0);
        QTest::newRow("organ-like") << bumpySphere(40, 40.0, 0.05);
        QTest::newRow("one voxel") << maskSurface(ballMask(0.6, Vec3::Ones()));
        QTest::newRow("face of one voxel") << voxelFaces(ballMask(0.6, Vec3::Ones()));
        const auto isInBracket = [](const Vec3& p) {
            return p.head<2>().cwiseAbs().maxCoeff() < 20.2 && std::abs(p.z()) < 5.5 && (p.x() < -9.7 || p.y() < -9.7);
        };
        QTest::newRow("bracket in squares") << voxelFaces({Vec3::Ones(), Vec3(25, 25, 15), isInBracket});
    }
    void leavesOtherSurfacesAlone()
    {
        QFETCH(TriangleMesh, mesh);
        const auto found = findStaircase(mesh);
        QVERIFY2(!found, found ? found->sentence().english().c_str() : "");
    }
};

PALPATE_TEST(Staircase)
#include "tst_Staircase.moc"
