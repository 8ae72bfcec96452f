// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/SurfaceMesh.h>

#include <vtkPointData.h>
#include <vtkPolyData.h>

using namespace palpate;

class SurfaceMesh : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void smoothSurfaceKeepsItsPoints()
    {
        const auto ball = geometry::repair(test::ball(20.0, 3));
        const auto picture = view::makeSurface(ball);
        QCOMPARE(picture->GetNumberOfPoints(), static_cast<vtkIdType>(ball.mesh.vertices.size()));
        QCOMPARE(picture->GetNumberOfPolys(), static_cast<vtkIdType>(ball.mesh.triangles.size()));
    }
    void smoothNormalsPointAwayFromTheCentre()
    {
        const auto picture = view::makeSurface(geometry::repair(test::ball(20.0, 4)));
        vtkDataArray* normals = picture->GetPointData()->GetNormals();
        for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i) {
            const core::Vec3 out = core::Vec3(picture->GetPoint(i)).normalized();
            const core::Vec3 normal(normals->GetTuple(i));
            // The normals of neighbouring facets of 5120 triangles differ by about 4 degrees.
            QVERIFY(normal.dot(out) > std::cos(0.02));
        }
    }
    void edgesOfACubeStaySharp()
    {
        const auto picture = view::makeSurface(geometry::repair(test::block(10.0)));
        QCOMPARE(picture->GetNumberOfPoints(), vtkIdType{24}); // three per corner
        vtkDataArray* normals = picture->GetPointData()->GetNormals();
        for (vtkIdType i = 0; i < 24; ++i) {
            QCOMPARE(core::Vec3(normals->GetTuple(i)).cwiseAbs().maxCoeff(), 1.0);
        }
    }
    void trianglesKeepTheirOrder()
    {
        const auto box = geometry::repair(test::block(10.0));
        const auto picture = view::makeSurface(box);
        for (vtkIdType t = 0; t < picture->GetNumberOfPolys(); ++t) {
            vtkIdType count = 0;
            const vtkIdType* corners = nullptr;
            picture->GetCellPoints(t, count, corners);
            QCOMPARE(count, vtkIdType{3});
            for (int c = 0; c < 3; ++c) {
                const core::Vec3 drawn(picture->GetPoint(corners[c]));
                const auto& triangle = box.mesh.triangles[static_cast<std::size_t>(t)];
                QVERIFY((drawn - box.mesh.vertices[triangle[static_cast<std::size_t>(c)]]).norm() < 1e-5);
            }
        }
    }
};

PALPATE_TEST(SurfaceMesh)
#include "tst_SurfaceMesh.moc"
