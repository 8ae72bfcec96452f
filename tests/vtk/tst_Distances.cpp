// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/SurfaceDistance.h>
#include <palpate/geometry/SurfaceMargin.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDistancePolyDataFilter.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace palpate;
using namespace palpate::test;

namespace {

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh)
{
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : mesh.vertices) {
        points->InsertNextPoint(p.data());
    }
    const vtkNew<vtkCellArray> cells;
    for (const geometry::Triangle& t : mesh.triangles) {
        const vtkIdType corners[3] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

} // namespace

/// Compares distances with VTK's.
class Distances : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void nearestPointEqualsImplicitDistance()
    {
        const TriangleMesh organ = bumpySphere(16, 40.0, 0.15);
        const auto surface = indexed(organ);
        const vtkNew<vtkImplicitPolyDataDistance> implicit;
        implicit->SetInput(polyData(organ));
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-60.0, 60.0);
        for (int i = 0; i < 500; ++i) {
            Vec3 p(place(random), place(random), place(random));
            const double signed_mm = implicit->EvaluateFunction(p.data());
            QVERIFY(std::abs(geometry::nearestPoint(*surface, p)->distance_mm - std::abs(signed_mm)) < 1e-9);
            QCOMPARE(geometry::isInside(*surface, p), signed_mm < 0.0);
        }
    }

    /// The lump's vertices have the distances of vtkDistancePolyDataFilter, and the least distance of the surfaces is
    /// at most the least of those.
    void lumpEqualsDistanceFilter()
    {
        const TriangleMesh organ = bumpySphere(16, 40.0, 0.15);
        const TriangleMesh lump = moved(bumpySphere(8, 8.0, 0.1), Vec3(24, 9, -5));
        const vtkNew<vtkDistancePolyDataFilter> filter;
        filter->SetInputData(0, polyData(lump));
        filter->SetInputData(1, polyData(organ));
        filter->SignedDistanceOff();
        filter->ComputeSecondDistanceOff();
        filter->Update();
        vtkDataArray* distances = filter->GetOutput()->GetPointData()->GetArray("Distance");
        QVERIFY(distances != nullptr);
        QCOMPARE(static_cast<std::size_t>(distances->GetNumberOfTuples()), lump.vertices.size());
        const auto surface = indexed(organ);
        double least_mm = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < lump.vertices.size(); ++i) {
            const double expected_mm = distances->GetTuple1(static_cast<vtkIdType>(i));
            QVERIFY(std::abs(geometry::nearestPoint(*surface, lump.vertices[i])->distance_mm - expected_mm) < 1e-9);
            least_mm = std::min(least_mm, expected_mm);
        }
        const auto found = geometry::surfaceDistance(*indexed(lump), *surface);
        QCOMPARE(found->relation, geometry::Relation::Inside);
        QVERIFY(found->surface_mm <= least_mm + 1e-9);
        QVERIFY(found->surface_mm > least_mm - 2.0); // an edge's length
    }
};

PALPATE_TEST(Distances)
#include "tst_Distances.moc"
