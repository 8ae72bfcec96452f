// SPDX-License-Identifier: BSD-3-Clause
// Tests the colouring of a surface: the range, the colours at points, triangles and feature edges, grey for unknown
// values.
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/MarginColours.h>
#include <palpate/view/SurfaceColours.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace palpate;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

view::Colour colourAt(vtkDataArray* colours, vtkIdType i)
{
    const double* c = colours->GetTuple3(i);
    return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
}

bool isNear(const view::Colour& a, const view::Colour& b)
{
    return std::abs(a[0] - b[0]) < 0.003 && std::abs(a[1] - b[1]) < 0.003 && std::abs(a[2] - b[2]) < 0.003;
}

} // namespace

class SurfaceColours : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void aFewWildNumbersDoNotTakeAllColours()
    {
        std::vector<float> values(1000);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(i);
        }
        values[500] = 1e9F;
        const view::ColourRange range = view::colourRange(values);
        QVERIFY(std::abs(range.low - 20.0) <= 1.0 && std::abs(range.high - 980.0) <= 2.0);
        QVERIFY(range.isLowCut && range.isHighCut && !range.hasUnknown);
    }
    void stepsKeepBothSidesAndOneValueIsNoError()
    {
        const std::vector<float> step{0.5F, 0.5F, 2.0F, 2.0F, kNan};
        const view::ColourRange range = view::colourRange(step);
        QVERIFY(range.low == 0.5 && range.high == 2.0 && !range.isLowCut && !range.isHighCut && range.hasUnknown);
        std::vector<float> nearlyOne(1000, 3.0F);
        nearlyOne[7] = 5.0F;
        QCOMPARE(view::colourRange(nearlyOne).high, 5.0); // the single different value is visible
        const std::vector<float> one{3.0F, 3.0F}, none{kNan};
        QCOMPARE(view::colourRange(one).low, 3.0);
        QCOMPARE(view::colourRange(none).high, 1.0);
        QVERIFY(view::colourRange({}).low == 0.0);
    }
    void everyPointHasItsVertexsColour()
    {
        const auto cube = geometry::repair(test::block(5.0)); // each vertex has three points: its edges are sharp
        const auto picture = view::makeSurface(cube);
        QVERIFY(picture->GetNumberOfPoints() > 8);
        std::vector<float> values;
        for (const core::Vec3& p : cube.mesh.vertices) {
            values.push_back(static_cast<float>(p.x() + 10.0 * p.y()));
        }
        values[2] = kNan;
        const view::ColourRange range = view::colourRange(values);
        const auto coloured = view::coloured(*picture, cube, values, false, range);
        vtkDataArray* colours = coloured->GetPointData()->GetScalars();
        QVERIFY(colours != nullptr && colours->GetNumberOfTuples() == picture->GetNumberOfPoints());
        int grey = 0;
        for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i) {
            const double* p = picture->GetPoint(i);
            std::size_t v = 0;
            while ((cube.mesh.vertices[v] - core::Vec3(p)).norm() > 1e-5) {
                ++v;
            }
            const view::Colour expected =
                v == 2 ? view::kUnknownColour : view::surfaceColour((values[v] - range.low) / (range.high - range.low));
            QVERIFY(isNear(colourAt(colours, i), expected));
            grey += v == 2 ? 1 : 0;
        }
        QCOMPARE(grey, 3);
        QVERIFY(picture->GetPointData()->GetScalars() == nullptr); // the rendered data set itself is unchanged
    }
    void trianglesHaveOneColourEach()
    {
        const auto cube = geometry::repair(test::block(5.0));
        const auto picture = view::makeSurface(cube);
        std::vector<float> values(cube.mesh.triangles.size(), 1.0F);
        values[3] = 2.0F;
        const auto coloured = view::coloured(*picture, cube, values, true, view::colourRange(values));
        vtkDataArray* colours = coloured->GetCellData()->GetScalars();
        QVERIFY(colours != nullptr && coloured->GetPointData()->GetScalars() == nullptr);
        QVERIFY(isNear(colourAt(colours, 2), view::surfaceColour(0.0)) &&
                isNear(colourAt(colours, 3), view::surfaceColour(1.0)));
    }
    void valuesOfAnotherSurfaceAreLeftOut()
    {
        const auto cube = geometry::repair(test::block(5.0));
        const auto picture = view::makeSurface(cube);
        const auto coloured = view::coloured(*picture, cube, std::vector<float>{1, 2, 3}, false, {});
        QVERIFY(coloured->GetPointData()->GetScalars() == nullptr && coloured->GetNumberOfPolys() == 12);
    }

    /// A split picture keeps its shape, and its values lie on the triangles.
    void splitPicturesKeepShapeAndArea()
    {
        vtkNew<vtkPoints> points;
        for (const core::Vec3& p :
             {core::Vec3(0, 0, 0), core::Vec3(10, 0, 0), core::Vec3(0, 10, 0), core::Vec3(1, 1, 5)}) {
            points->InsertNextPoint(p.data());
        }
        vtkNew<vtkCellArray> cells;
        for (const auto& corners : {std::array<vtkIdType, 3>{0, 2, 1}, std::array<vtkIdType, 3>{0, 1, 3}}) {
            cells->InsertNextCell(3, corners.data());
        }
        vtkNew<vtkPolyData> picture;
        picture->SetPoints(points);
        picture->SetPolys(cells);
        const auto areaOf = [](vtkPolyData& of) {
            double area = 0.0, longest = 0.0;
            vtkNew<vtkIdList> cell;
            for (vtkIdType i = 0; i < of.GetPolys()->GetNumberOfCells(); ++i) {
                of.GetPolys()->GetCellAtId(i, cell);
                const core::Vec3 a(of.GetPoint(cell->GetId(0))), b(of.GetPoint(cell->GetId(1))),
                    c(of.GetPoint(cell->GetId(2)));
                area += 0.5 * (b - a).cross(c - a).norm();
                longest = std::max({longest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
            }
            return std::pair(area, longest);
        };
        const auto fine = view::refinedPicture(*picture, 1.0);
        QVERIFY(std::abs(areaOf(*fine).first - areaOf(*picture).first) < 1e-4);
        QVERIFY(areaOf(*fine).second <= 1.0 + 1e-6);
        QCOMPARE(view::refinedPicture(*picture, 100.0).Get(), picture.Get());
        QVERIFY(view::refinedPicture(*picture, 0.01, 500)->GetPolys()->GetNumberOfCells() <= 500);
    }
    void bandsHaveColoursThatDarken()
    {
        vtkNew<vtkPolyData> picture;
        vtkNew<vtkPoints> points;
        points->SetNumberOfPoints(3);
        picture->SetPoints(points);
        const std::vector<float> distances{4.9F, 5.0F, 11.0F};
        const auto shown = view::marginColoured(*picture, distances, std::vector<double>{5.0, 10.0});
        for (std::size_t band = 0; band < 3; ++band) {
            QVERIFY(isNear(colourAt(shown->GetPointData()->GetScalars(), static_cast<vtkIdType>(band)),
                           view::marginColour(band, 3)));
            const view::Colour colour = view::marginColour(band, 3);
            const double light = 0.3 * colour[0] + 0.6 * colour[1] + 0.1 * colour[2];
            const view::Colour next = view::marginColour(std::min<std::size_t>(2, band + 1), 3);
            QVERIFY(band == 2 || light > 0.3 * next[0] + 0.6 * next[1] + 0.1 * next[2] + 0.1);
        }
        QCOMPARE(picture->GetPointData()->GetScalars(), static_cast<vtkDataArray*>(nullptr));
    }
};

PALPATE_TEST(SurfaceColours)
#include "tst_SurfaceColours.moc"
