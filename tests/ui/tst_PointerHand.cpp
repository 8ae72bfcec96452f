// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/PointerHand.h>

using namespace palpate;
using core::Vec3;
using Phase = ui::PointerHand::Phase;

namespace {

const Vec3 kEye(0, 0, 100);
const Vec3 kDown(0, 0, -1); // looking along -z on a surface at z = 0

ui::PointerHand over(const Vec3& surface_W)
{
    ui::PointerHand hand;
    hand.pointAt(kEye, kDown, surface_W);
    return hand;
}

} // namespace

class PointerHand : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void isAwayUntilItPointsAtSomething()
    {
        ui::PointerHand hand;
        QCOMPARE(hand.phase(0.0), Phase::Away);
        hand.press(0.0);
        QCOMPARE(hand.phase(0.0), Phase::Away);
        hand.pointAt(kEye, kDown, std::nullopt);
        QVERIFY(!hand.hip(0.0).has_value());
        QVERIFY(!hand.state(0.0, 0).isPresent);
    }
    void hoversJustOutsideTheSurface()
    {
        const ui::PointerHand hand = over(Vec3(3, 4, 0));
        QCOMPARE(hand.phase(1.0), Phase::Hovering);
        QCOMPARE(*hand.hip(1.0), Vec3(3, 4, hand.settings().hover_mm));
        QVERIFY(!hand.state(1.0, 0).isPresent); // a pointer jumps; the device must not be dragged through tissue
    }
    void waitsOutsideUntilTheDeviceFeltIt()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(1.0);
        QVERIFY(hand.state(1.0, 0).isPresent);
        QVERIFY(hand.hip(5.0)->z() > 0.0);
        hand.land(5.0);
        QVERIFY(hand.hip(5.0 + hand.settings().pressTime_s)->z() < 0.0);
    }
    void pressGoesInSmoothlyToTheSetDepth()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(1.0);
        hand.land(1.0);
        const double time_s = hand.settings().pressTime_s;
        double before = hand.settings().hover_mm + 1e-12;
        double steepest = 0.0;
        for (int i = 0; i <= 100; ++i) {
            const double z = hand.hip(1.0 + time_s * i / 100.0)->z();
            QVERIFY(z <= before);
            steepest = std::max(steepest, before - z);
            before = z;
        }
        QVERIFY(std::abs(before + hand.settings().depth_mm) < 1e-9);
        QVERIFY(steepest < 0.02 * (hand.settings().depth_mm + hand.settings().hover_mm)); // no knock
        QVERIFY(!hand.isMoving(1.0 + 2.0 * time_s));
        QCOMPARE(hand.state(2.0, 77).buttons, 1u);
        QCOMPARE(hand.state(2.0, 77).time_ns, std::int64_t{77});
    }
    void wheelSetsTheDepthWithinItsBounds()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(0.0);
        hand.land(0.0);
        hand.turnDepth(4);
        QVERIFY(std::abs(hand.hip(1.0)->z() + 4.0 + 4 * 0.5) < 1e-9);
        hand.turnDepth(1000);
        QCOMPARE(hand.settings().depth_mm, hand.settings().deepest_mm);
        hand.turnDepth(-1000);
        QCOMPARE(hand.settings().depth_mm, 0.0);
    }
    void dragSlidesAtTheSameDepth()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(0.0);
        hand.land(0.0);
        for (int x = 1; x <= 20; ++x) {
            hand.pointAt(kEye, kDown, Vec3(x, 0, 0.3 * x)); // a slope
            QVERIFY((*hand.hip(1.0) - Vec3(x, 0, 0.3 * x - 4.0)).norm() < 1e-9);
        }
    }
    void runsOnInItsPlaneOffTheRim()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(0.0);
        hand.land(0.0);
        const Vec3 aside = Vec3(0.1, 0, -1).normalized();
        hand.pointAt(kEye, aside, Vec3(kEye + 300.0 * aside)); // 200 mm behind: another organ
        QVERIFY(std::abs((*hand.hip(1.0) - 4.0 * aside).z()) < 1e-6);
        hand.pointAt(kEye, aside, std::nullopt);
        QVERIFY(std::abs((*hand.hip(1.0) - 4.0 * aside).z()) < 1e-6);
    }
    void releaseLiftsOffAndLetsGo()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(0.0);
        hand.land(0.0);
        hand.release(1.0);
        QCOMPARE(hand.phase(1.0 + 0.5 * hand.settings().liftTime_s), Phase::Lifting);
        QVERIFY(hand.state(1.0 + 0.5 * hand.settings().liftTime_s, 0).isPresent);
        QCOMPARE(hand.phase(1.0 + 1.01 * hand.settings().liftTime_s), Phase::Hovering);
        hand.goAway();
        QCOMPARE(hand.phase(3.0), Phase::Away);
    }
    void nextPressWaitsForTheDeviceAgain()
    {
        ui::PointerHand hand = over(Vec3::Zero());
        hand.press(0.0);
        hand.land(0.0);
        hand.release(1.0);
        hand.press(2.0); // the hand was gone in between
        QVERIFY(hand.hip(9.0)->z() > 0.0);
    }
    void depthsSuitTheSceneSize()
    {
        QCOMPARE(ui::settingsForSize(1700.0).depth_mm, 4.0);
        QCOMPARE(ui::settingsForSize(20.0).depth_mm, 0.4);
        QVERIFY(ui::settingsForSize(0.0).depth_mm > 0.0);
    }
};

PALPATE_TEST(PointerHand)
#include "tst_PointerHand.moc"
