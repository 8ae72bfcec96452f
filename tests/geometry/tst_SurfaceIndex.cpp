// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <set>

using namespace palpate;
using namespace palpate::test;
using geometry::RepairedMesh;

class SurfaceIndexTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void refusesWhatFloatsCannotHold()
    {
        for (const double radius_mm : {1e37, 1e38, 1e150}) {
            const geometry::SurfaceIndex index = geometry::SurfaceIndex::build(geometry::repair(sphere(6, radius_mm)));
            QCOMPARE(index.triangleCount(), 0u);
            QCOMPARE(index.status().code(), core::StatusCode::OutOfRange);
            QVERIFY(index.status().message().find("expected at most 10³⁶ mm") != std::string::npos);
        }
        const geometry::SurfaceIndex large = geometry::SurfaceIndex::build(geometry::repair(sphere(6, 9e35)));
        QVERIFY(large.status().isOk());
        QCOMPARE(large.triangleCount(), 720u);
    }

    void holdsEveryTriangleOnceWithItsWinding()
    {
        const RepairedMesh r = geometry::repair(bumpySphere(12, 40.0, 0.05));
        const geometry::SurfaceIndex index = geometry::SurfaceIndex::build(r);
        QCOMPARE(std::size_t{index.triangleCount()}, r.mesh.triangles.size());
        QCOMPARE(std::size_t{index.vertexCount()}, r.mesh.vertices.size());
        std::set<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < index.triangleCount(); ++i) {
            const std::uint32_t source = index.sourceTriangle(i);
            QVERIFY(seen.insert(source).second);
            for (std::size_t k = 0; k < 3; ++k) {
                QVERIFY(index.vertex(index.triangle(i)[k]) == r.mesh.vertices[r.mesh.triangles[source][k]]);
            }
            QVERIFY(!index.isTwoSided(i));
        }
    }

    void remembersWhichTrianglesAreTwoSided()
    {
        geometry::TriangleMesh mesh = sheet(5.0, 3);
        append(mesh, transformed(sphere(3, 2.0), [](const Vec3& v) { return Vec3(v + Vec3(0, 0, 20)); }));
        const RepairedMesh r = geometry::repair(mesh);
        const geometry::SurfaceIndex index = geometry::SurfaceIndex::build(r);
        std::size_t twoSided = 0;
        for (std::uint32_t i = 0; i < index.triangleCount(); ++i) {
            QCOMPARE(index.isTwoSided(i), r.twoSided[index.sourceTriangle(i)] == 1);
            twoSided += index.isTwoSided(i) ? 1 : 0;
        }
        QCOMPARE(twoSided, std::size_t{18});
    }

    void numbersTheConnectedParts()
    {
        geometry::TriangleMesh two = box(Vec3(0, 0, 0), Vec3(1, 1, 1), 2);
        QVERIFY(!indexed(two)->hasSeveralParts());
        QCOMPARE(indexed(two)->part(3), 0U);
        append(two, box(Vec3(0.5, 0.5, 0.5), Vec3(3, 3, 3), 2));
        const auto index = indexed(two);
        QVERIFY(index->hasSeveralParts());
        const std::uint32_t first = index->part(0);
        const bool isFirstBox = index->sourceTriangle(0) < 48;
        for (std::uint32_t i = 0; i < index->triangleCount(); ++i) {
            QVERIFY(index->part(i) <= 1);
            QCOMPARE(index->part(i) == first, (index->sourceTriangle(i) < 48) == isFirstBox);
        }
    }

    void costsAtMost64BytesATriangle()
    {
        const auto index = indexed(sphere(64, 50.0));
        const double bytes = double(index->byteSize()) / index->triangleCount();
        QVERIFY2(bytes <= 64.0, qPrintable(QString::number(bytes)));
    }

    void keepsTheSkinFarBelowWhatCanBeFelt_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("offset");
        QTest::newRow("organ") << 1.0 << 0.0;
        QTest::newRow("in metres") << 1e-3 << 0.0;
        QTest::newRow("far away") << 1.0 << 1e6;
        QTest::newRow("huge") << 1e3 << 0.0;
    }
    void keepsTheSkinFarBelowWhatCanBeFelt()
    {
        QFETCH(double, scale);
        QFETCH(double, offset);
        const auto index = indexed(
            transformed(sphere(16, 50.0), [&](const Vec3& v) { return Vec3(v * scale + Vec3::Constant(offset)); }));
        const double extent = index->bounds().diagonal().norm();
        QVERIFY(index->skin_mm() <= 1e-4);
        QVERIFY(index->skin_mm() <= 1e-6 * extent);
        // Above the spacing of doubles at the surface, so that a gap of one skin is representable.
        QVERIFY(index->skin_mm() > 4 * 2.2e-16 * (offset + extent));
    }

    void survivesNothing() { QCOMPARE(indexed({})->triangleCount(), 0u); }
};

PALPATE_TEST_NAMED("SurfaceIndex", SurfaceIndexTest)
#include "tst_SurfaceIndex.moc"
