// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"
#include "TestRunner.h"

#include <palpate/view/TouchCursor.h>

#include <vtkNew.h>
#include <vtkProperty.h>

using namespace palpate;
using core::Vec3;
using test::frameAt;

namespace {

double width(vtkActor* actor)
{
    const double* b = actor->GetBounds();
    return b[1] - b[0];
}

view::TouchState contact(const Vec3& f_W)
{
    view::TouchState state;
    state.p_WG = Vec3(1, 2, 3);
    state.p_WH = Vec3(1, 2, -1);
    state.f_W = f_W;
    state.isInContact = true;
    state.isPresent = true;
    return state;
}

} // namespace

class TouchCursor : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void nothingIsDrawnWithoutAHand()
    {
        view::TouchCursor cursor;
        cursor.place(frameAt(300));
        QVERIFY(!cursor.ball()->GetVisibility());
        QVERIFY(!cursor.hipRing()->GetVisibility());
        QVERIFY(cursor.bounds().isEmpty());
    }
    void freeSpaceShowsAFaintBallAndTheRing()
    {
        view::TouchCursor cursor;
        view::TouchState state;
        state.isPresent = true;
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(cursor.ball()->GetVisibility());
        QVERIFY(cursor.ball()->GetProperty()->GetOpacity() < 0.5);
        QVERIFY(cursor.hipRing()->GetVisibility());
        QVERIFY(!cursor.springLine()->GetVisibility());
    }
    void contactShowsSpringAndForce()
    {
        view::TouchCursor cursor;
        cursor.setForceLimit(10.0);
        cursor.setState(contact(Vec3(0, 0, 2.314)));
        cursor.place(frameAt(3000));
        QCOMPARE(cursor.ball()->GetProperty()->GetOpacity(), 1.0);
        QVERIFY(cursor.springLine()->GetVisibility());
        QCOMPARE(QString::fromStdString(cursor.arrow().label()), QStringLiteral("2.31 N"));
        QVERIFY(std::abs(cursor.arrow().length_mm() - 8.0 * 2.314) < 1e-9);
    }
    void colourIsTheForceOfTheLimit()
    {
        view::TouchCursor cursor;
        cursor.setForceLimit(10.0);
        cursor.setState(contact(Vec3(0, 3, 4)));
        QCOMPARE(cursor.ballColour(), view::cividis(0.5));
        cursor.setForceLimit(5.0);
        QCOMPARE(cursor.ballColour(), view::cividis(1.0));
    }
    void ballKeepsItsSizeOnScreen()
    {
        view::TouchCursor cursor;
        cursor.setState(contact(Vec3(0, 0, 1)));
        for (const double distance_mm : {50.0, 500.0, 5000.0}) {
            const view::ViewFrame frame = frameAt(distance_mm);
            cursor.place(frame);
            const double width_px = width(cursor.ball()) / frame.mmPerPixel(cursor.state().p_WG);
            QVERIFY2(std::abs(width_px - view::TouchCursor::kBall_px) < 0.2, qPrintable(QString::number(width_px)));
        }
    }
    void hardPushDoesNotLeaveTheView()
    {
        view::TouchCursor cursor;
        cursor.setState(contact(Vec3(0, 0, 500)));
        const view::ViewFrame frame = frameAt(300);
        cursor.place(frame);
        const double height_mm = frame.height_px * frame.mmPerPixel(cursor.state().p_WG);
        QVERIFY(std::abs(cursor.arrow().length_mm() - view::ForceArrow::kLongest * height_mm) < 1e-9);
    }
    void innerGodObjectsHaveTheColoursOfTheirStructures()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 2));
        state.innerCount = 1;
        state.inner[0] = {Vec3(1, 2, 1), {0.25, 0.5, 0.75}};
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(cursor.innerMark(0)->GetVisibility());
        QVERIFY(!cursor.innerMark(1)->GetVisibility());
        const double* colour = cursor.innerMark(0)->GetProperty()->GetColor();
        QVERIFY(colour[0] == 0.25 && colour[1] == 0.5 && colour[2] == 0.75);
        const double* b = cursor.innerMark(0)->GetBounds();
        QVERIFY(std::abs(0.5 * (b[0] + b[1]) - 1.0) < 0.01 && std::abs(0.5 * (b[2] + b[3]) - 2.0) < 0.01);
        state.inner[0].p_WG = Vec3(1, 2, -30);
        cursor.setState(state);
        QVERIFY(cursor.bounds().contains(state.inner[0].p_WG));
        state.isInContact = false;
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(!cursor.innerMark(0)->GetVisibility());
    }
    void frictionHoldsWithinADiscOnTheSurface()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 2));
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(!cursor.frictionDisc()->GetVisibility());
        state.friction = {Vec3(3, 4, 5), Vec3::UnitX(), 1.5};
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(cursor.frictionDisc()->GetVisibility());
        const double* b = cursor.frictionDisc()->GetBounds();
        QVERIFY(std::abs(b[0] - 3.0) < 1e-6 && std::abs(b[1] - 3.0) < 1e-6); // flat along the normal
        QVERIFY(std::abs(b[3] - b[2] - 3.0) < 0.02 && std::abs(b[5] - b[4] - 3.0) < 0.02);
        QVERIFY(cursor.bounds().contains(Vec3(3, 5.4, 5)));
    }

    void nonFiniteTickIsNotDrawn()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 1));
        state.p_WG.x() = std::numeric_limits<double>::quiet_NaN();
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(!cursor.ball()->GetVisibility());
    }
};

PALPATE_TEST(TouchCursor)
#include "tst_TouchCursor.moc"
