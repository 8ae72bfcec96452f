// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"
#include "TestRunner.h"

#include <palpate/view/StateOf.h>
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
    /// Along the line of sight an arrow would be a dot: the force is then a circle that grows with the force.
    void forceAtTheViewerIsACircle()
    {
        view::TouchCursor cursor;
        const auto radius_px = [&cursor](const Vec3& f_W) {
            cursor.setState(contact(f_W));
            cursor.place(frameAt(300));
            return cursor.arrow().circle()->GetVisibility() ? cursor.arrow().radius_px() : 0.0;
        };
        const Vec3 at = (Vec3(0, 0, 300) - contact(Vec3::Zero()).p_WG).normalized();
        const double one = radius_px(at), three = radius_px(3.0 * at);
        QVERIFY(!cursor.arrow().shaft()->GetVisibility());
        QVERIFY2(one > 0.5 * view::TouchCursor::kBall_px && three > one + 10.0, qPrintable(QString::number(three)));
        QVERIFY(radius_px(500.0 * at) < 0.15 * frameAt(300).height_px);
        QCOMPARE(radius_px(3.0 * Vec3::UnitX()), 0.0);
        QVERIFY(cursor.arrow().shaft()->GetVisibility());
        const double* b = cursor.arrow().shaft()->GetBounds();
        QVERIFY(b[1] - b[0] > 15.0); // 24 mm without the arrowhead
        // In between both are visible, and the transition is gradual.
        QVERIFY(radius_px(3.0 * (at + 0.6 * Vec3::UnitX()).normalized()) > 0.0);
        QVERIFY(cursor.arrow().shaft()->GetVisibility());
    }
    void contactIsADiscOnTheSurface()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 2));
        state.n_W = Vec3::UnitX();
        cursor.setState(state);
        cursor.place(frameAt(30)); // close view: a disc with a size in mm
        QVERIFY(cursor.contactDisc()->GetVisibility());
        const double* b = cursor.contactDisc()->GetBounds();
        QVERIFY(std::abs(b[0] - 1.0) < 1e-9 && std::abs(b[1] - 1.0) < 1e-9); // flat, through the god-object
        const double pixel_mm = frameAt(30).mmPerPixel(state.p_WG);
        const double radius_mm = 0.5 * (b[3] - b[2]);
        QVERIFY(radius_mm > 14.9 * pixel_mm && radius_mm < 40.1 * pixel_mm);
        QVERIFY(std::abs(0.5 * (b[3] + b[2]) - 2.0) < 0.01);
        // With a fingertip the god-object is the ball's centre: the disc has the ball's width and is at the contact
        // point.
        state.fingertip_mm = 8.0;
        cursor.setState(state);
        cursor.place(frameAt(300));
        b = cursor.contactDisc()->GetBounds();
        QVERIFY(std::abs(b[0] + 7.0) < 1e-9 && std::abs(b[3] - b[2] - 16.0) < 0.1);
        QVERIFY(cursor.bounds().contains(Vec3(-7, 9, 3)));
        state.isInContact = false;
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(!cursor.contactDisc()->GetVisibility());
    }
    void depthsAreSaidInMillimetres()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 2));
        state.p_WH = Vec3(1, 2, -15.1);
        state.innerCount = 1;
        state.inner[0] = {Vec3(1, 2, -6), {0.25, 0.5, 0.75}, 9.12};
        cursor.setState(state);
        cursor.place(frameAt(300));
        const std::vector<std::string> wanted{"2.00 N", "18.1 mm", "9.1 mm"};
        QCOMPARE(cursor.labels().texts(), wanted);
        // The line continues in the inner structure's colour from the inner contact.
        QVERIFY(cursor.innerLine(0)->GetVisibility());
        const double* b = cursor.innerLine(0)->GetBounds();
        QVERIFY(std::abs(b[5] - b[4] - 9.1) < 0.2);
        state.isInContact = false;
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(cursor.labels().texts().empty() && !cursor.innerLine(0)->GetVisibility());
    }
    /// For any position of the hand, including the border and the corners.
    void labelsStayOffTheLegend()
    {
        view::TouchCursor cursor;
        cursor.setState(contact(Vec3(0, 0, 2)));
        cursor.place(frameAt(300));
        const std::vector<Eigen::AlignedBox2d> before = cursor.labels().boxes();
        QVERIFY(!before.empty());
        for (const Eigen::AlignedBox2d& legend : before) {
            cursor.place(frameAt(300), {legend});
            for (const Eigen::AlignedBox2d& label : cursor.labels().boxes()) {
                QVERIFY(legend.intersection(label).isEmpty());
            }
        }
    }
    void labelsStayInTheViewAndOffTheCursor()
    {
        view::TouchCursor cursor;
        const view::ViewFrame frame = frameAt(300);
        const double pixel_mm = frame.mmPerPixel(Vec3::Zero());
        for (int x = -390; x <= 390; x += 65) {
            for (int y = -290; y <= 290; y += 58) {
                for (const Vec3& f_W : {Vec3(0, 0, 9), Vec3(9, 0, 0), Vec3(-6, 6, 0), Vec3(0, -9, 1)}) {
                    view::TouchState state = contact(f_W);
                    state.p_WG = pixel_mm * Vec3(x, y, 0);
                    state.p_WH = state.p_WG - 2.0 * f_W;
                    state.innerCount = 1;
                    state.inner[0] = {state.p_WG - f_W, {0.2, 0.4, 0.6}, 9.0};
                    cursor.setState(state);
                    cursor.place(frame);
                    const auto& boxes = cursor.labels().boxes();
                    QCOMPARE(boxes.size(), std::size_t{3});
                    for (std::size_t i = 0; i < boxes.size(); ++i) {
                        QVERIFY(Eigen::AlignedBox2d(Eigen::Vector2d(-400, -300), Eigen::Vector2d(400, 300))
                                    .contains(boxes[i]));
                        QVERIFY(!boxes[i].contains(frame.pixelOf(state.p_WG)));
                        QVERIFY(!boxes[i].contains(frame.pixelOf(state.p_WH)));
                        for (std::size_t k = 0; k < i; ++k) {
                            QVERIFY(boxes[i].intersection(boxes[k]).isEmpty());
                        }
                    }
                }
            }
        }
    }
    void aTouchOutsideTheViewHasNoNumbers()
    {
        view::TouchCursor cursor;
        view::TouchState state = contact(Vec3(0, 0, 9));
        state.p_WG = frameAt(300).mmPerPixel(Vec3::Zero()) * Vec3(600, 0, 0);
        state.p_WH = state.p_WG - Vec3(0, 0, 5);
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(cursor.labels().texts().empty());
    }
    void keysHaveACrosshair()
    {
        view::TouchCursor cursor;
        view::TouchState state;
        state.isPresent = true;
        cursor.setState(state);
        cursor.place(frameAt(300));
        QVERIFY(!cursor.crosshair(0)->GetVisibility());
        state.hasCrosshair = true;
        cursor.setState(state);
        cursor.place(frameAt(300));
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(cursor.crosshair(i)->GetVisibility());
        }
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

    void showsAServoTick()
    {
        servo::TickRecord tick;
        tick.p_WH = Vec3(0, 0, -3);
        tick.felt.p_WG = Vec3(0, 0, 0);
        tick.felt.n_W = Vec3::UnitZ();
        tick.felt.f_W = Vec3(0, 0, 1.5);
        tick.felt.structure = 0;
        tick.felt.contactCount = 4;
        // Layer, structure, depth: the second contact shares the god-object of the first.
        const std::array<std::array<std::uint32_t, 3>, 4> contacts{{{0, 0, 3}, {0, 4, 3}, {1, 1, 2}, {2, 9, 1}}};
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            haptics::Contact& contact = tick.felt.contacts[i];
            contact.n_W = Vec3::UnitZ();
            contact.f_W = Vec3::Zero();
            contact.layer = contacts[i][0];
            contact.structure = contacts[i][1];
            contact.depth_mm = contacts[i][2];
            contact.p_WG = Vec3(0, 0, -3.0 + contact.depth_mm);
        }
        const std::vector<view::Colour> colours{{1, 0, 0}, {0, 1, 0}};
        const view::TouchState state = view::stateOf(tick, 2.0, colours);
        QVERIFY(state.isInContact && state.isPresent);
        QCOMPARE(state.p_WG, tick.felt.p_WG);
        QCOMPARE(state.f_W, tick.felt.f_W);
        QCOMPARE(state.fingertip_mm, 2.0);
        QCOMPARE(state.innerCount, std::size_t{2});
        QCOMPARE(state.inner[0].colour, colours[1]);
        QCOMPARE(state.inner[1].colour, (view::Colour{1, 1, 1}));
        QCOMPARE(state.inner[1].depth_mm, 1.0);

        tick.felt.structure = -1;
        tick.flags = servo::kNoHand;
        QVERIFY(!view::stateOf(tick).isPresent && !view::stateOf(tick).isInContact);
        QCOMPARE(view::stateOf(tick).innerCount, std::size_t{0});
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
