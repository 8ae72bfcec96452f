// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/geometry/Reshape.h>

#include <algorithm>
#include <numbers>

using namespace palpate;
using namespace palpate::test;
using geometry::MeshReport;
using geometry::repair;
using geometry::RepairedMesh;

class Repair : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void weldsASoupIntoAClosedSurface()
    {
        const RepairedMesh r = repair(soup(box(Vec3(0, 0, 0), Vec3(1, 2, 3), 4)));
        QCOMPARE(r.report.inputVertices, std::size_t{6 * 32 * 3});
        QCOMPARE(r.report.vertices, std::size_t{6 * 16 + 2});
        QCOMPARE(r.report.weldedVertices, r.report.inputVertices - r.report.vertices);
        QVERIFY(r.report.isClosed());
        QVERIFY(r.report.isClean());
        QVERIFY(std::abs(r.report.volume_mm3 - 6.0) < 1e-12);
        QVERIFY(std::abs(r.report.area_mm2 - 22.0) < 1e-12);
    }

    void takesMinusZeroForZero()
    {
        geometry::TriangleMesh mesh = sheet(1.0, 2);
        mesh = soup(mesh);
        for (Vec3& v : mesh.vertices) {
            if (v.x() == 0.0) {
                v.x() = -0.0;
                break;
            }
        }
        QCOMPARE(repair(mesh).report.vertices, std::size_t{9});
    }

    void dropsZeroAreaButKeepsSlivers()
    {
        geometry::TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0},       {1, 0, 0},       {2, 0, 0},      {1, 1e-6, 0},
                         {0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}, {0.3, 0.9, 2.1}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}, {4, 5, 6}};
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.report.zeroAreaTriangles, std::size_t{3});
        QCOMPARE(r.report.triangles, std::size_t{1});
        QCOMPARE(r.source, std::vector<std::uint32_t>{1});
    }

    void mergesDuplicatesWhateverTheirWinding()
    {
        geometry::TriangleMesh mesh = sheet(1.0);
        mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][2], mesh.triangles[0][0]});
        mesh.triangles.push_back({mesh.triangles[1][1], mesh.triangles[1][0], mesh.triangles[1][2]});
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.report.duplicateTriangles, std::size_t{2});
        QCOMPARE(r.report.triangles, std::size_t{2});
    }

    void keepsAConsistentOrientation()
    {
        geometry::TriangleMesh cavity = sphere(4, 10.0);
        geometry::flip(cavity);
        const RepairedMesh r = repair(cavity, geometry::Facing::AsGiven);
        QCOMPARE(r.report.reorientedTriangles, std::size_t{0});
        QCOMPARE(r.report.insideOutComponents, std::size_t{1});
        QVERIFY(r.report.volume_mm3 < 0.0);
    }

    void knowsACavityFromAnInsideOutSurface()
    {
        geometry::TriangleMesh cavity = sphere(4, 5.0);
        geometry::flip(cavity);
        geometry::TriangleMesh mesh = sphere(4, 10.0);
        append(mesh, cavity);
        const RepairedMesh r = repair(mesh, geometry::Facing::AsGiven);
        QCOMPARE(r.report.components, std::size_t{2});
        QCOMPARE(r.report.insideOutComponents, std::size_t{0});
    }

    void makesAnInconsistentClosedSurfaceFaceOutwards_data()
    {
        QTest::addColumn<int>("stride");
        QTest::newRow("every triangle but one turned") << 1;
        QTest::newRow("every third turned") << 3;
        QTest::newRow("one turned") << 1000000;
    }
    void makesAnInconsistentClosedSurfaceFaceOutwards()
    {
        QFETCH(int, stride);
        geometry::TriangleMesh mesh = sphere(5, 10.0);
        for (std::size_t i = stride == 1000000 ? 7 : 1; i < mesh.triangles.size();
             i += static_cast<std::size_t>(stride)) {
            std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
        }
        const RepairedMesh r = repair(mesh);
        QVERIFY(r.report.inconsistentEdges > 0);
        QVERIFY(r.report.isClosed());
        for (const geometry::Triangle& t : r.mesh.triangles) {
            const Vec3 &a = r.mesh.vertices[t[0]], &b = r.mesh.vertices[t[1]], &c = r.mesh.vertices[t[2]];
            QVERIFY((b - a).cross(c - a).dot(a) > 0.0);
        }
    }

    void everyCornerIsOneOfItsSource()
    {
        geometry::TriangleMesh mesh = sphere(5, 10.0);
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 5) {
            std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
        }
        mesh.triangles.insert(mesh.triangles.begin() + 3, {7, 7, 8}); // dropped
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.turned.size(), r.mesh.triangles.size());
        std::size_t turned = 0;
        for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i) {
            geometry::Triangle source = mesh.triangles[r.source[i]];
            turned += r.turned[i];
            if (r.turned[i] != 0) {
                std::swap(source[1], source[2]);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                QVERIFY(r.mesh.vertices[r.mesh.triangles[i][k]] == mesh.vertices[source[k]]);
            }
        }
        QVERIFY(turned > 0 && turned < r.mesh.triangles.size());
        QCOMPARE(r.report.reorientedTriangles, turned);
        QVERIFY(repair(sphere(5, 10.0)).turned.empty());
    }

    void callsAnOpenSurfaceTwoSided()
    {
        const RepairedMesh r = repair(sheet(1.0, 3));
        QCOMPARE(r.report.openEdges, std::size_t{12});
        QCOMPARE(r.report.openComponents, std::size_t{1});
        QCOMPARE(r.twoSided, std::vector<std::uint8_t>(18, 1));
    }

    void callsAMoebiusStripNotOrientable()
    {
        geometry::TriangleMesh mesh;
        constexpr int kSteps = 24;
        for (int i = 0; i < kSteps; ++i) {
            const double angle = 2 * std::numbers::pi * i / kSteps;
            for (const double w : {-1.0, 1.0}) {
                const double r = 10 + w * std::cos(angle / 2);
                mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), w * std::sin(angle / 2));
            }
        }
        for (std::uint32_t i = 0; i < kSteps; ++i) {
            const bool isLast = i + 1 == kSteps;
            const std::uint32_t a = 2 * i, b = 2 * i + 1, c = isLast ? 1 : 2 * i + 2, d = isLast ? 0 : 2 * i + 3;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({b, d, c});
        }
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.report.nonOrientableComponents, std::size_t{1});
        QCOMPARE(r.report.reorientedTriangles, std::size_t{0});
    }

    void takesTwoBoxesOnOneEdgeForClosed()
    {
        geometry::TriangleMesh mesh = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
        append(mesh, box(Vec3(1, 1, 0), Vec3(2, 2, 1)));
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.report.nonManifoldEdges, std::size_t{1});
        QCOMPARE(r.report.components, std::size_t{1});
        QVERIFY(r.report.isClosed());
    }

    void takesAFinForOpen()
    {
        geometry::TriangleMesh mesh = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
        const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 1}, {1, 0, 1}, {0.5, -1, 2}});
        mesh.triangles.push_back({n, n + 1, n + 2});
        const RepairedMesh r = repair(mesh);
        QCOMPARE(r.report.nonManifoldEdges, std::size_t{1});
        QCOMPARE(r.report.openComponents, std::size_t{1});
    }

    void isTheSameInAnyUnit()
    {
        const geometry::TriangleMesh mesh = sphere(3, 10.0);
        for (const double unit : {1e-6, 1.0, 1e6}) {
            const MeshReport r = repair(transformed(mesh, [unit](const Vec3& v) { return Vec3(v * unit); })).report;
            QCOMPARE(r.triangles, mesh.triangles.size());
            QVERIFY(r.isClean());
        }
    }

    void turnsMeshesFromMemoryOutwards()
    {
        geometry::TriangleMesh inward = sphere(4, 5.0);
        geometry::flip(inward);
        geometry::TriangleMesh mesh = inward; // of vtkMarchingCubes, for example, beside one that faces outwards
        append(mesh, moved(sphere(4, 5.0), Vec3(20, 0, 0)));
        const RepairedMesh r = repair(mesh, geometry::Facing::Outward);
        QCOMPARE(r.report.insideOutComponents, std::size_t{0});
        QCOMPARE(r.report.turnedComponents, std::size_t{1});
        QVERIFY(std::abs(r.report.volume_mm3 - 2.0 * repair(sphere(4, 5.0)).report.volume_mm3) < 1e-9);
        QCOMPARE(test::english(r.report.sentences()),
                 std::vector<std::string>{"1 closed part was inside out and turned to face outwards"});
        QCOMPARE(std::size_t(std::count(r.turned.begin(), r.turned.end(), 1)), inward.triangles.size());
        for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i) {
            QCOMPARE(r.source[i], std::uint32_t(i));
        }
    }

    void facingChangesNothingThatFacesOutwards()
    {
        geometry::TriangleMesh cavity = sphere(4, 5.0);
        geometry::flip(cavity);
        geometry::TriangleMesh mesh = sphere(4, 10.0);
        append(mesh, cavity);
        append(mesh, sheet(30.0, 2)); // open: has no outside
        const RepairedMesh given = repair(mesh, geometry::Facing::AsGiven),
                           out = repair(mesh, geometry::Facing::Outward);
        QVERIFY(given.mesh.vertices == out.mesh.vertices && given.mesh.triangles == out.mesh.triangles);
        QCOMPARE(out.report.turnedComponents, std::size_t{0});
    }

    void weldsWithinTheDistance()
    {
        geometry::TriangleMesh mesh = soup(sphere(6, 10.0)); // each corner moved on its own, as by rounding
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            mesh.vertices[i] += 4e-7 * Vec3(double(i % 3) - 1.0, double(i % 5) / 2.0 - 1.0, double(i % 7) / 3.0 - 1.0);
        }
        QVERIFY(repair(mesh).report.openEdges > 0);
        const RepairedMesh welded = repair(mesh, {.weldWithin_mm = 2e-6});
        QVERIFY(welded.report.isClosed());
        QCOMPARE(welded.report.vertices, repair(sphere(6, 10.0)).report.vertices);
        QVERIFY(repair(mesh, {.weldWithin_mm = 1e-8}).report.openEdges > 0);
    }

    /// Vertices of a chain are welded to a representative, never farther than the distance.
    void weldingDoesNotGrowAlongAChain()
    {
        geometry::TriangleMesh mesh;
        for (int i = 0; i < 10; ++i) {
            mesh.vertices.push_back({0.6 * i, 0, 0});
        }
        mesh.vertices.push_back({0, 100, 0});
        for (std::uint32_t i = 0; i + 1 < 10; ++i) {
            mesh.triangles.push_back({i, i + 1, 10});
        }
        const RepairedMesh r = repair(mesh, {.weldWithin_mm = 1.0});
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const std::uint32_t vertex = r.vertexOfSource[i];
            QVERIFY(vertex != geometry::kNoVertex);
            QVERIFY((r.mesh.vertices[vertex] - mesh.vertices[i]).norm() <= 1.0);
        }
        QCOMPARE(r.report.vertices, std::size_t{6}); // 0, 1.2, 2.4, 3.6, 4.8 and the tip
    }

    void relatesVerticesToTheInput()
    {
        geometry::TriangleMesh mesh = soup(sphere(4, 10.0));
        geometry::flip(mesh);                                          // turned again: the maps survive the second pass
        mesh.vertices.insert(mesh.vertices.begin(), Vec3(99, 99, 99)); // of no triangle
        for (geometry::Triangle& t : mesh.triangles) {
            for (std::uint32_t& v : t) {
                ++v;
            }
        }
        const RepairedMesh r = repair(mesh, geometry::Facing::Outward);
        QCOMPARE(r.report.turnedComponents, std::size_t{1});
        QCOMPARE(r.vertexSource.size(), r.mesh.vertices.size());
        QCOMPARE(r.vertexOfSource.size(), mesh.vertices.size());
        QCOMPARE(r.vertexOfSource[0], geometry::kNoVertex);
        for (std::uint32_t i = 1; i < mesh.vertices.size(); ++i) {
            QCOMPARE(r.mesh.vertices[r.vertexOfSource[i]], mesh.vertices[i]);
            QVERIFY(r.vertexSource[r.vertexOfSource[i]] <= i);
        }
        for (std::uint32_t v = 0; v < r.mesh.vertices.size(); ++v) {
            QCOMPARE(r.vertexOfSource[r.vertexSource[v]], v);
        }
    }

    void leavesUnknownVertexMapsUnknown()
    {
        geometry::TriangleMesh mesh = sphere(4, 10.0);
        geometry::flip(mesh);
        RepairedMesh recorded = repair(mesh, geometry::Facing::AsGiven);
        recorded.vertexSource.clear();
        recorded.vertexOfSource.clear();
        const auto turned = geometry::orientedOutwards(recorded);
        QVERIFY(turned && turned->vertexSource.empty() && turned->vertexOfSource.empty());
        QVERIFY(geometry::withVertices(recorded, recorded.mesh.vertices).vertexSource.empty());
    }

    void survivesNothing() { QCOMPARE(repair({}).report.triangles, std::size_t{0}); }

    void sentencesCountWithSeparators()
    {
        MeshReport report;
        report.openEdges = 52114;
        QCOMPARE(report.sentences().size(), std::size_t{1});
        QCOMPARE(report.sentences()[0].english(), std::string("52,114 open edges: the surface has holes or a rim"));
    }
};

PALPATE_TEST(Repair)
#include "tst_Repair.moc"
