// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Reshape.h>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using geometry::orientedOutwards;
using geometry::repair;
using geometry::RepairedMesh;

namespace {

TriangleMesh flipped(TriangleMesh mesh)
{
    geometry::flip(mesh);
    return mesh;
}

/// Checks that each triangle has the corners of its source, reversed where `turned` is set.
bool refersToItsSource(const RepairedMesh& surface, const TriangleMesh& input)
{
    for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i) {
        geometry::Triangle from = input.triangles[surface.source[i]];
        if (!surface.turned.empty() && surface.turned[i] != 0) {
            std::swap(from[1], from[2]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (surface.mesh.vertices[surface.mesh.triangles[i][k]] != input.vertices[from[k]]) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

class Reshape : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void turnsWhatIsInsideOut()
    {
        const TriangleMesh input = flipped(soup(box(Vec3::Zero(), Vec3(1, 2, 3), 2)));
        const RepairedMesh before = repair(input, geometry::Facing::AsGiven);
        QCOMPARE(before.report.insideOutComponents, std::size_t{1});
        const auto after = orientedOutwards(before);
        QVERIFY(after.has_value());
        QCOMPARE(after->report.insideOutComponents, std::size_t{0});
        QVERIFY(std::abs(after->report.volume_mm3 - 6.0) < 1e-12);
        QCOMPARE(after->report.inputVertices, before.report.inputVertices);
        QCOMPARE(after->report.weldedVertices, before.report.weldedVertices);
        // no triangle was reversed for a consistent orientation
        QCOMPARE(after->report.reorientedTriangles, std::size_t{0});
        QVERIFY(refersToItsSource(*after, input));
    }

    void leavesWhatIsRight()
    {
        QVERIFY(!orientedOutwards(repair(sphere(4, 10.0))));
        TriangleMesh shell = sphere(4, 10.0); // a cavity faces inwards
        append(shell, flipped(sphere(4, 5.0)));
        QVERIFY(!orientedOutwards(repair(shell, geometry::Facing::AsGiven)));
        QVERIFY(!orientedOutwards(repair(flipped(sheet(1.0, 3)), geometry::Facing::AsGiven))); // open: no inside
    }

    /// A shell that was written inside out keeps its cavity; neighbouring parts stay.
    void turnsACavityWithItsShell()
    {
        TriangleMesh mesh = flipped(sphere(6, 10.0));
        append(mesh, sphere(6, 5.0));
        append(mesh, moved(sphere(6, 3.0), Vec3(40, 0, 0)));
        const RepairedMesh before = repair(mesh, geometry::Facing::AsGiven);
        QCOMPARE(before.report.insideOutComponents, std::size_t{1});
        const auto after = orientedOutwards(before);
        QVERIFY(after.has_value());
        QCOMPARE(after->report.insideOutComponents, std::size_t{0});
        const double expected_mm3 = repair(sphere(6, 10.0)).report.volume_mm3 -
                                    repair(sphere(6, 5.0)).report.volume_mm3 + repair(sphere(6, 3.0)).report.volume_mm3;
        QVERIFY(std::abs(after->report.volume_mm3 - expected_mm3) < 1e-9);
        QVERIFY(refersToItsSource(*after, mesh));
    }

    void movedVerticesKeepWhatWasRepaired()
    {
        TriangleMesh input = soup(sphere(5, 10.0));
        std::swap(input.triangles[7][1], input.triangles[7][2]); // reversed by `repair`
        const RepairedMesh before = repair(input, geometry::Facing::AsGiven);
        std::vector<Vec3> vertices = before.mesh.vertices;
        for (Vec3& p : vertices) {
            p *= 2.0;
        }
        const RepairedMesh after = geometry::withVertices(before, vertices);
        QCOMPARE(after.source, before.source);
        QCOMPARE(after.turned, before.turned);
        QCOMPARE(after.report.reorientedTriangles, std::size_t{1});
        QCOMPARE(after.report.weldedVertices, before.report.weldedVertices);
        QVERIFY(std::abs(after.report.volume_mm3 - 8.0 * before.report.volume_mm3) < 1e-6);
    }

    void verticesThatComeTogetherAreRepaired()
    {
        const RepairedMesh before = repair(sphere(5, 10.0));
        std::vector<Vec3> vertices = before.mesh.vertices;
        const geometry::Triangle& t = before.mesh.triangles[0];
        vertices[t[1]] = vertices[t[0]];
        const RepairedMesh after = geometry::withVertices(before, vertices);
        QVERIFY(after.report.triangles < before.report.triangles);
        QVERIFY(after.report.isClosed());
        QCOMPARE(after.source.size(), after.mesh.triangles.size());
    }
};

PALPATE_TEST(Reshape)
#include "tst_Reshape.moc"
