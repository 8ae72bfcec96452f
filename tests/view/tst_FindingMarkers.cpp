// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"
#include "TestRunner.h"

#include <palpate/view/FindingMarkers.h>

#include <vtkActor2D.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPropCollection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

using namespace palpate;
using core::Vec3;
using test::frameAt;

namespace {

int drawn(vtkRenderer& renderer)
{
    int count = 0;
    vtkPropCollection* all = renderer.GetViewProps();
    all->InitTraversal();
    while (vtkProp* one = all->GetNextProp()) {
        count += one->GetVisibility() != 0 ? 1 : 0;
    }
    return count;
}

std::vector<view::FindingMark> at(const std::vector<Vec3>& places_W)
{
    std::vector<view::FindingMark> marks;
    for (const Vec3& p_W : places_W) {
        marks.push_back({p_W, core::FindingType::Lump, marks.size() + 1, {}});
    }
    return marks;
}

/// Returns the data of a 2D actor: 0 shapes, 1 numbers.
vtkPolyData* flat(vtkRenderer& renderer, int i)
{
    auto* actor = vtkActor2D::SafeDownCast(renderer.GetViewProps()->GetItemAsObject(i));
    return vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper())->GetInput();
}

int trianglesOf(vtkRenderer& renderer, int i)
{
    return static_cast<int>(flat(renderer, i)->GetNumberOfPolys());
}

/// Returns the smallest opacity of the shapes, without the backgrounds of the numbers.
int leastOpacity(vtkRenderer& renderer)
{
    int least = 255;
    vtkDataArray* colours = flat(renderer, 0)->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i) {
        const bool isGround = colours->GetComponent(i, 0) == 20.0;
        least = isGround ? least : std::min(least, static_cast<int>(colours->GetComponent(i, 3)));
    }
    return least;
}

} // namespace

class FindingMarkers : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void thereIsOneForEachFindingAndNoneWithout()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set({});
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 0);
        QVERIFY(markers.bounds().isEmpty());
        markers.set(at({Vec3(1, 2, 3), Vec3(-10, 0, 5)}));
        markers.place(frameAt(300));
        QCOMPARE(markers.count(), std::size_t{2});
        QCOMPARE(drawn(*overlay), 2); // shapes and numbers, for any count
        QVERIFY(trianglesOf(*overlay, 0) > 0 && trianglesOf(*overlay, 1) == 2 * 2);
        QVERIFY(markers.bounds().contains(Vec3(1, 2, 3)) && markers.bounds().contains(Vec3(-10, 0, 5)));
        markers.setVisible(false);
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 0);
        QVERIFY(markers.bounds().isEmpty());
        markers.setVisible(true);
        markers.set({});
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 0);
    }

    void numbersCloseTogetherMoveApart()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set(at({Vec3(0, 0, 0), Vec3(2, 0, 0)})); // 8 pixels
        markers.place(frameAt(300));
        QVERIFY(!markers.labelOf(0).isMoved && markers.labelOf(1).isMoved); // with a leader line
        const int withLine = trianglesOf(*overlay, 0);
        const Eigen::Vector2d apart_px =
            (Eigen::Vector2d(8, 0) + markers.labelOf(1).offset_px - markers.labelOf(0).offset_px).cwiseAbs();
        QVERIFY2(apart_px.maxCoeff() > 13, qPrintable(QString::number(apart_px.maxCoeff()))); // the font size
        markers.place(frameAt(30));
        QVERIFY(!markers.labelOf(0).isMoved && !markers.labelOf(1).isMoved);
        QCOMPARE(trianglesOf(*overlay, 0), withLine - 2);
    }

    void numbersAreTheFindingsOwnAndTheSelectedHasItsName()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        auto marks = at({Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), Vec3(4, 5, 6)});
        marks[1].name = "hard as a pea";
        markers.set(marks);
        QCOMPARE(markers.count(), std::size_t{1});
        QCOMPARE(markers.textOf(0), std::string("2"));
        markers.place(frameAt(300));
        const double narrow_px = markers.labelOf(0).size_px.x();
        markers.select(2);
        QCOMPARE(markers.textOf(0), std::string("2  hard as a pea"));
        markers.place(frameAt(300));
        QVERIFY(markers.labelOf(0).size_px.x() > 3.0 * narrow_px);
        markers.select(0);
        QCOMPARE(markers.textOf(0), std::string("2"));
    }

    void aLargerFontMakesLargerNumbers()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set(at({Vec3::Zero()}));
        view::ViewFrame frame = frameAt(300);
        frame.text.size_px = 13.0;
        markers.place(frame);
        const double small_px = markers.labelOf(0).size_px.y();
        frame.text.size_px = 26.0;
        markers.place(frame);
        QVERIFY(markers.labelOf(0).size_px.y() > 1.5 * small_px);
    }

    void whatIsBehindTissueIsHollowAndFaint()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set(at({Vec3::Zero(), Vec3(40, 0, 0)}));
        markers.place(frameAt(300));
        const int filled = trianglesOf(*overlay, 0);
        QCOMPARE(leastOpacity(*overlay), 255);
        markers.updateHidden([](const Vec3& p_W) { return p_W.x() > 0.0; });
        QVERIFY(!markers.isHidden(0) && markers.isHidden(1));
        markers.place(frameAt(300));
        QVERIFY(trianglesOf(*overlay, 0) < filled);
        QCOMPARE(leastOpacity(*overlay), 89); // 35 %
        markers.updateHidden([](const Vec3&) { return false; });
        markers.place(frameAt(300));
        QCOMPARE(trianglesOf(*overlay, 0), filled);
    }

    void eachTypeHasItsShapeAndColour()
    {
        std::set<std::pair<int, std::array<unsigned char, 3>>> looks;
        std::set<std::array<unsigned char, 3>> colours;
        for (std::size_t i = 0; i < core::kFindingTypeNames.size(); ++i) {
            vtkNew<vtkRenderer> overlay;
            view::FindingMarkers markers;
            markers.addTo(*overlay);
            markers.set({{Vec3::Zero(), static_cast<core::FindingType>(i), 1, {}}});
            markers.place(frameAt(300));
            vtkPolyData* shapes = flat(*overlay, 0);
            // The last corner of the shape, before twice four corners of the number's background.
            double last[4];
            shapes->GetPointData()->GetScalars()->GetTuple(shapes->GetNumberOfPoints() - 7, last);
            const std::array<unsigned char, 3> colour{static_cast<unsigned char>(last[0]),
                                                      static_cast<unsigned char>(last[1]),
                                                      static_cast<unsigned char>(last[2])};
            colours.insert(colour);
            looks.emplace(trianglesOf(*overlay, 0), colour);
        }
        QCOMPARE(colours.size(), core::kFindingTypeNames.size());
        QCOMPARE(looks.size(), core::kFindingTypeNames.size());
    }

    void theShapeHasOneSizeOnScreenFromAnyDistance()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set(at({Vec3::Zero()}));
        double width[2];
        for (int i = 0; i < 2; ++i) {
            markers.place(frameAt(300.0 * (1 + i)));
            double bounds[6];
            flat(*overlay, 0)->GetPoints()->ComputeBounds();
            flat(*overlay, 0)->GetPoints()->GetBounds(bounds);
            width[i] = bounds[1] - bounds[0];
        }
        QVERIFY(width[0] > 10.0 && std::abs(width[1] - width[0]) < 1e-3);
    }

    /// Markers behind the camera are not drawn.
    void behindTheEyeNothingIsDrawn()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set(at({Vec3(0, 0, 400)}));
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 0);
    }
};

PALPATE_TEST(FindingMarkers)
#include "tst_FindingMarkers.moc"
