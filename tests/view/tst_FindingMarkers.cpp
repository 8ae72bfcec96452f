// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"
#include "TestRunner.h"

#include <palpate/view/FindingMarkers.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>

#include <limits>

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
        markers.set({Vec3(1, 2, 3), Vec3(-10, 0, 5)});
        markers.place(frameAt(300));
        QCOMPARE(markers.count(), std::size_t{2});
        QCOMPARE(drawn(*overlay), 6); // rim, disc and number
        QVERIFY(markers.bounds().contains(Vec3(1, 2, 3)) && markers.bounds().contains(Vec3(-10, 0, 5)));
        markers.setVisible(false);
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 0);
        QVERIFY(markers.bounds().isEmpty());
        markers.set({});
        QCOMPARE(overlay->GetViewProps()->GetNumberOfItems(), 0);
    }

    void numbersCloseTogetherMoveApart()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set({Vec3(0, 0, 0), Vec3(2, 0, 0)}); // 8 pixels
        markers.place(frameAt(300));
        QCOMPARE(drawn(*overlay), 7); // and the line of the second
        int offset[2][2];
        for (int i = 0; i < 2; ++i) {
            vtkBillboardTextActor3D::SafeDownCast(overlay->GetViewProps()->GetItemAsObject(2 + 4 * i))
                ->GetDisplayOffset(offset[i]);
        }
        const int apart_px = std::max(std::abs(8 + offset[1][0] - offset[0][0]), std::abs(offset[1][1] - offset[0][1]));
        QVERIFY2(apart_px > 13, qPrintable(QString::number(apart_px))); // the font's size
        markers.place(frameAt(30));
        QCOMPARE(drawn(*overlay), 6);
    }

    void numbersAreTheFindingsOwn()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set({Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), Vec3(4, 5, 6)});
        QCOMPARE(markers.count(), std::size_t{1});
        auto* number = vtkBillboardTextActor3D::SafeDownCast(overlay->GetViewProps()->GetItemAsObject(2));
        QVERIFY(number != nullptr);
        QCOMPARE(QString::fromUtf8(number->GetInput()).trimmed(), QStringLiteral("2"));
        QVERIFY(Vec3(number->GetPosition()) == Vec3(4, 5, 6));
    }

    void theDiscHasOneSizeOnScreenFromAnyDistance()
    {
        vtkNew<vtkRenderer> overlay;
        view::FindingMarkers markers;
        markers.addTo(*overlay);
        markers.set({Vec3::Zero()});
        auto* disc = vtkActor::SafeDownCast(overlay->GetViewProps()->GetItemAsObject(1));
        double width[2];
        for (int i = 0; i < 2; ++i) {
            markers.place(frameAt(300.0 * (1 + i)));
            width[i] = disc->GetBounds()[1] - disc->GetBounds()[0];
        }
        QVERIFY(std::abs(width[1] - 2.0 * width[0]) < 1e-6 * width[1]);
    }
};

PALPATE_TEST(FindingMarkers)
#include "tst_FindingMarkers.moc"
