// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/buried/FeltSurface.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/vtk/PolyData.h>

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStripper.h>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using core::StatusCode;
using geometry::RepairedMesh;

namespace {

/// Returns the surface of a ball that VTK's textbook way gives: contour of a signed distance, negative inside.
vtkSmartPointer<vtkPolyData> contouredBall(double radius_mm)
{
    constexpr int kSide = 24;
    const vtkNew<vtkImageData> image;
    image->SetDimensions(kSide, kSide, kSide);
    image->SetOrigin(-12.0, -12.0, -12.0);
    image->SetSpacing(24.0 / (kSide - 1), 24.0 / (kSide - 1), 24.0 / (kSide - 1));
    image->AllocateScalars(VTK_FLOAT, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
        Vec3 p;
        image->GetPoint(i, p.data());
        static_cast<float*>(image->GetScalarPointer())[i] = float(p.norm() - radius_mm);
    }
    const vtkNew<vtkMarchingCubes> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.0);
    contour->Update();
    return contour->GetOutput();
}

vtkSmartPointer<vtkPolyData> polygon(const std::vector<Vec3>& points, const std::vector<vtkIdType>& corners)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    const vtkNew<vtkPoints> all;
    for (const Vec3& p : points) {
        all->InsertNextPoint(p.data());
    }
    const vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    data->SetPoints(all);
    data->SetPolys(cells);
    return data;
}

double pressFromOutside_N(const RepairedMesh& surface)
{
    const auto index = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(surface));
    haptics::Palpator palpator;
    palpator.setScene(haptics::HapticScene::make({{"ball", index, {0.5, 0.0}, 0}}).value());
    haptics::TickResult tick;
    for (int i = 0; i <= 30; ++i) {
        tick = palpator.step({0.1, 0.2, 11.0 - 0.1 * i}, 1e-3);
    }
    return tick.f_W.norm();
}

} // namespace

class PolyData : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void contourOfASignedDistanceIsFelt()
    {
        const auto ball = contouredBall(10.0);
        const auto given = palpate::vtk::surfaceOf(ball, {.repair = {.facing = geometry::Facing::AsGiven}});
        QVERIFY2(given.isOk(), given.status().message().c_str());
        QCOMPARE(given.value().report.insideOutComponents, std::size_t{1}); // VTK's normals point inwards
        QCOMPARE(pressFromOutside_N(given.value()), 0.0);

        const auto surface = palpate::vtk::surfaceOf(ball);
        QVERIFY2(surface.isOk(), surface.status().message().c_str());
        QCOMPARE(surface.value().report.turnedComponents, std::size_t{1});
        QVERIFY(surface.value().report.isClosed());
        QVERIFY(std::abs(pressFromOutside_N(surface.value()) - 1.0) < 0.05); // 2 mm at 0.5 N/mm
    }

    void stripsAndPolygonsGiveTheSameSurface()
    {
        const auto ball = contouredBall(10.0);
        const vtkNew<vtkStripper> stripper;
        stripper->SetInputData(ball);
        stripper->Update();
        QVERIFY(stripper->GetOutput()->GetNumberOfStrips() > 0);
        const auto a = palpate::vtk::surfaceOf(ball), b = palpate::vtk::surfaceOf(stripper->GetOutput());
        QVERIFY(b.isOk());
        QCOMPARE(b.value().report.triangles, a.value().report.triangles);
        QVERIFY(std::abs(b.value().report.volume_mm3 - a.value().report.volume_mm3) < 1e-9);

        // An L, concave, in metres.
        const auto concave = palpate::vtk::surfaceOf(
            polygon({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 1, 2, 3, 4, 5}),
            {.unit_mm = 1000.0});
        QVERIFY(concave.isOk());
        QCOMPARE(concave.value().report.triangles, std::size_t{4});
        QVERIFY(std::abs(concave.value().report.area_mm2 - 3e6) < 1e-3);
    }

    void refusesWhatHasNoSurface()
    {
        const auto code = [](vtkPolyData* data, double unit_mm = 1.0) {
            return palpate::vtk::surfaceOf(data, {.unit_mm = unit_mm}).status().code();
        };
        QCOMPARE(code(nullptr), StatusCode::Empty);
        QCOMPARE(code(vtkNew<vtkPolyData>()), StatusCode::Empty);
        const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        QCOMPARE(code(polygon(points, {0, 1, 2})), StatusCode::Ok);
        QCOMPARE(code(polygon(points, {0, 1})), StatusCode::BadFormat);
        QCOMPARE(code(polygon(points, {0, 1, 3})), StatusCode::OutOfRange);
        QCOMPARE(code(polygon(points, {0, 1, -1})), StatusCode::OutOfRange);
        QCOMPARE(code(polygon({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {0, 1, 2})), StatusCode::NonFinite);
        QCOMPARE(code(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2})), StatusCode::Empty); // no area
        QCOMPARE(code(polygon(points, {0, 1, 2}), 0.0), StatusCode::OutOfRange);
        QCOMPARE(code(polygon(points, {0, 1, 2}), std::nan("")), StatusCode::OutOfRange);
    }

    void carriesValuesToThePoints()
    {
        geometry::TriangleMesh loose = soup(sphere(6, 10.0)); // every point several times
        loose.vertices.push_back({0, 0, 0});                  // of no triangle
        const auto data = palpate::vtk::polyDataOf(loose);
        const auto surface = palpate::vtk::surfaceOf(data);
        QVERIFY(surface.isOk());
        QVERIFY(surface.value().mesh.vertices.size() < loose.vertices.size() / 4);
        std::vector<float> values;
        for (const Vec3& p : surface.value().mesh.vertices) {
            values.push_back(float(p.x() + 2.0 * p.y()));
        }
        const auto array = palpate::vtk::atPoints(surface.value(), values, "height");
        QVERIFY2(array.isOk(), array.status().message().c_str());
        QCOMPARE(array.value()->GetNumberOfValues(), data->GetNumberOfPoints());
        QCOMPARE(QString(array.value()->GetName()), QStringLiteral("height"));
        for (std::size_t i = 0; i + 1 < loose.vertices.size(); ++i) {
            QCOMPARE(array.value()->GetValue(vtkIdType(i)), float(loose.vertices[i].x() + 2.0 * loose.vertices[i].y()));
        }
        QVERIFY(std::isnan(array.value()->GetValue(vtkIdType(loose.vertices.size() - 1))));

        values.pop_back();
        QCOMPARE(palpate::vtk::atPoints(surface.value(), values, "height").status().code(), StatusCode::Mismatch);
    }

    /// The palpability map of a lump, computed on a refined surface, on the points of the contour.
    void putsAFeltMapOnTheCallersPoints()
    {
        const auto organ = contouredBall(10.0);
        const auto surface = palpate::vtk::surfaceOf(organ);
        const auto lump = std::make_shared<const RepairedMesh>(geometry::repair(moved(sphere(4, 2.0), {0, 0, 7.0})));
        buried::FeltOptions options;
        options.radius_mm = 1.0; // finer than the contour
        options.press_mm = {0.0};
        const auto felt =
            buried::feltSurface("ball", surface.value(), {{"lump", lump, buried::RatioRange(10.0)}}, options);
        QVERIFY2(felt.isOk(), felt.status().message().c_str());
        QVERIFY(felt.value().surface.vertices.size() > surface.value().mesh.vertices.size());
        const auto array = palpate::vtk::atPoints(surface.value(), felt.value().press[0].ratio, "k/k0");
        QVERIFY(array.isOk());
        float top = 0.0F, bottom = 0.0F;
        for (vtkIdType i = 0; i < organ->GetNumberOfPoints(); ++i) {
            const double z = organ->GetPoint(i)[2];
            float& most = z > 9.5 ? top : bottom;
            most = z > 9.5 || z < 0.0 ? std::max(most, array.value()->GetValue(i)) : most;
        }
        QVERIFY(top > 1.05F);
        QVERIFY(bottom < 1.01F);
    }
};

PALPATE_TEST(PolyData)
#include "tst_PolyData.moc"
