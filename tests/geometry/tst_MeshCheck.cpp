// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/MeshCheck.h>
#include <palpate/geometry/Repair.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using core::StatusCode;
using geometry::MeshError;

using Damage = std::function<void(geometry::TriangleMesh&)>;
Q_DECLARE_METATYPE(Damage)
Q_DECLARE_METATYPE(MeshError)
Q_DECLARE_METATYPE(StatusCode)

class MeshCheckTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void namesCauseAndElement_data()
    {
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<MeshError>("error");
        QTest::addColumn<StatusCode>("code");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, Damage damage, MeshError error, StatusCode code, const char* message) {
            QTest::newRow(name) << damage << error << code << QString::fromUtf8(message);
        };
        using Mesh = geometry::TriangleMesh;
        row(
            "no triangle", [](Mesh& m) { m.triangles.clear(); }, MeshError::NoTriangles, StatusCode::Empty,
            "the mesh has no triangles, expected at least 1");
        row(
            "index", [](Mesh& m) { m.triangles[1][2] = 99; }, MeshError::IndexOutOfRange, StatusCode::OutOfRange,
            "triangle 1 uses vertex 99, expected a number below 4");
        row(
            "first index out of range", [](Mesh& m) { m.triangles[1][0] = 4; }, MeshError::IndexOutOfRange,
            StatusCode::OutOfRange, "triangle 1 uses vertex 4, expected a number below 4");
        row(
            "no vertex", [](Mesh& m) { m.vertices.clear(); }, MeshError::IndexOutOfRange, StatusCode::OutOfRange,
            "triangle 0 uses vertex 0, expected a number below 0");
        row(
            "NaN", [](Mesh& m) { m.vertices[2].y() = std::nan(""); }, MeshError::NonFiniteCoordinate,
            StatusCode::NonFinite, "vertex 2 has the coordinate nan, expected a finite number");
        row(
            "infinite", [](Mesh& m) { m.vertices[3].z() = std::numeric_limits<double>::infinity(); },
            MeshError::NonFiniteCoordinate, StatusCode::NonFinite,
            "vertex 3 has the coordinate inf, expected a finite number");
        row(
            "large", [](Mesh& m) { m.vertices[1].x() = -2e7; }, MeshError::CoordinateTooLarge, StatusCode::OutOfRange,
            "vertex 1 has the coordinate -20000000 mm, expected at most 10000000 mm; check the unit");
        row(
            "array of vertices",
            [](Mesh& m) {
                m.arrays.push_back({"a", false, {1.0F, 2.0F}});
            },
            MeshError::ArraySizeMismatch, StatusCode::Mismatch, "array 0 has 2 values, expected 4");
        row(
            "array of triangles",
            [](Mesh& m) {
                m.arrays.push_back({"a", true, {1.0F, 2.0F, 3.0F}});
            },
            MeshError::ArraySizeMismatch, StatusCode::Mismatch, "array 0 has 3 values, expected 2");
    }

    void namesCauseAndElement()
    {
        QFETCH(Damage, damage);
        QFETCH(MeshError, error);
        QFETCH(StatusCode, code);
        QFETCH(QString, message);
        geometry::TriangleMesh mesh = sheet(1.0);
        QVERIFY(geometry::check(mesh).isOk());
        QVERIFY(geometry::check(mesh).status().isOk());
        damage(mesh);
        const geometry::MeshCheck found = geometry::check(mesh);
        QCOMPARE(found.error, error);
        QCOMPARE(found.status().code(), code);
        QCOMPARE(QString::fromStdString(found.status().message()), message);
        const auto surface = geometry::surfaceOf(mesh);
        QVERIFY(!surface.isOk());
        QCOMPARE(surface.status().code(), code);
    }

    void refusesASurfaceWithoutArea()
    {
        geometry::TriangleMesh mesh = sheet(1.0);
        mesh.vertices.assign(mesh.vertices.size(), core::Vec3::Zero());
        QCOMPARE(geometry::surfaceOf(mesh).status().code(), StatusCode::Empty);
        QCOMPARE(geometry::surfaceOf(sheet(1.0), {.weldWithin_mm = -1.0}).status().code(), StatusCode::OutOfRange);
        QCOMPARE(geometry::surfaceOf(sheet(1.0), {.weldWithin_mm = std::nan("")}).status().code(),
                 StatusCode::OutOfRange);
    }
};

PALPATE_TEST_NAMED("MeshCheck", MeshCheckTest)
#include "tst_MeshCheck.moc"
