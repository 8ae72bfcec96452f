// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/PointerHand.h>

#include <cmath>

using namespace palpate;
using core::Vec3;
using Phase = ui::PointerHand::Phase;

namespace {

const Vec3 kEye(0, 0, 100);
const Vec3 kDown(0, 0, -1); // looking along -z at a surface at z = 0

ui::PointerHand over(const Vec3& surface_W)
{
    ui::PointerHand hand;
    hand.pointAt(kEye, kDown, surface_W);
    return hand;
}

/// A hand and the device under its control.
struct Touch
{
    ui::PointerHand hand = over(Vec3::Zero());
    device::PointerDevice device;

    /// Runs one tick of the device.
    device::DeviceState tick(double now_s)
    {
        device.setState(hand.state(now_s));
        return device.read(std::llround(now_s * 1e9));
    }
    Vec3 hip(double now_s) { return tick(now_s).p_D; }
    void press(double now_s)
    {
        hand.press();
        (void)tick(now_s);
    }
};

} // namespace

class PointerHand : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void isAwayUntilItPointsAtSomething()
    {
        ui::PointerHand hand;
        QCOMPARE(hand.phase(0.0), Phase::Away);
        hand.press();
        QCOMPARE(hand.phase(0.0), Phase::Away);
        hand.pointAt(kEye, kDown, std::nullopt);
        QVERIFY(!hand.hoverPoint().has_value());
        QVERIFY(!hand.state(0.0).isPresent);
    }
    void hoversJustOutsideTheSurface()
    {
        const ui::PointerHand hand = over(Vec3(3, 4, 0));
        QCOMPARE(hand.phase(1.0), Phase::Hovering);
        QCOMPARE(*hand.hoverPoint(), Vec3(3, 4, hand.settings().hover_mm));
        QVERIFY(!hand.state(1.0).isPresent); // a pointer jumps; the device must not be dragged through tissue
    }
    void waitsOutsideUntilTheDeviceFeltIt()
    {
        Touch touch;
        touch.hand.press(); // at 1 s; the first device tick with the press is late
        QVERIFY(touch.hand.state(1.0).isPresent);
        QVERIFY(touch.hip(5.0).z() > 0.0);
        QVERIFY(touch.hip(5.0 + touch.hand.settings().pressTime_s).z() < 0.0);
    }
    void pressGoesInSmoothlyToTheSetDepth()
    {
        Touch touch;
        touch.press(1.0);
        const ui::PointerHandSettings& settings = touch.hand.settings();
        const double time_s = settings.pressTime_s;
        double before = settings.hover_mm + 1e-12;
        double steepest = 0.0;
        for (int i = 0; i <= 100; ++i) {
            const double z = touch.hip(1.0 + time_s * i / 100.0).z();
            QVERIFY(z <= before);
            steepest = std::max(steepest, before - z);
            before = z;
        }
        QVERIFY(std::abs(before + settings.depth_mm) < 1e-9);
        QVERIFY(steepest < 0.02 * (settings.depth_mm + settings.hover_mm)); // no impact
        QVERIFY(touch.hip(1.0 + 2.0 * time_s).z() == before);
        QCOMPARE(touch.tick(2.0).buttons, 1u);
        QCOMPARE(touch.tick(2.0).time_ns, std::int64_t{2'000'000'000});
    }
    /// The press is signalled once, then the window is busy with rendering: the press proceeds tick by tick
    /// nevertheless.
    void aBusyWindowMakesNoKnock()
    {
        Touch touch;
        touch.hand.press();
        touch.device.setState(touch.hand.state(0.0));
        double before = touch.hand.settings().hover_mm;
        for (int tick = 0; tick <= 150; ++tick) {
            const double z = touch.device.read(tick * 1'000'000LL).p_D.z();
            QVERIFY2(z <= before && before - z < 0.08, qPrintable(QString::number(before - z))); // of 6 mm
            before = z;
        }
        QVERIFY(before == -touch.hand.settings().depth_mm);
        touch.hand.release(0.2);
        touch.device.setState(touch.hand.state(0.2));
        bool isPresent = true;
        for (int tick = 200; tick <= 310; ++tick) {
            const auto state = touch.device.read(tick * 1'000'000LL);
            QVERIFY(!state.isPresent || state.p_D.z() - before < 0.12);
            QVERIFY(isPresent || !state.isPresent); // stays absent after leaving
            isPresent = state.isPresent;
            before = state.p_D.z();
        }
        QVERIFY(!isPresent);
    }
    void wheelSetsTheDepthWithinItsBounds()
    {
        Touch touch;
        touch.press(0.0);
        QVERIFY(std::abs(touch.hip(1.0).z() + 4.0) < 1e-9);
        touch.hand.turnDepth(4);
        QVERIFY(std::abs(touch.hip(1.0).z() + 4.0) < 1e-9); // moves there gradually
        const double halfway = touch.hip(1.0 + 0.5 * touch.hand.settings().pressTime_s).z();
        QVERIFY(halfway < -4.5 && halfway > -5.5);
        QVERIFY(std::abs(touch.hip(2.0).z() + 4.0 + 4 * 0.5) < 1e-9);
        touch.hand.turnDepth(1000);
        QCOMPARE(touch.hand.settings().depth_mm, touch.hand.settings().deepest_mm);
        touch.hand.turnDepth(-1000);
        QCOMPARE(touch.hand.settings().depth_mm, 0.0);
    }
    void anAimStandsForTheDepthThatIsSet()
    {
        Touch touch;
        touch.press(0.0);
        touch.hand.setAim(7.0);
        (void)touch.tick(1.0);
        QVERIFY(std::abs(touch.hip(2.0).z() + 7.0) < 1e-9);
        QCOMPARE(touch.hand.settings().depth_mm, 4.0);
        touch.hand.setAim(-50.0); // at most the hover height
        QCOMPARE(touch.hand.state(2.0).depth_mm, -touch.hand.settings().hover_mm);
        touch.hand.setAim(1e9);
        QCOMPARE(touch.hand.state(2.0).depth_mm, touch.hand.settings().deepest_mm);
        touch.hand.setAim(std::nullopt);
        (void)touch.tick(3.0);
        QVERIFY(std::abs(touch.hip(60.0).z() + 4.0) < 1e-9);
    }
    void dragSlidesAtTheSameDepth()
    {
        Touch touch;
        touch.press(0.0);
        for (int x = 1; x <= 20; ++x) {
            touch.hand.pointAt(kEye, kDown, Vec3(x, 0, 0.3 * x)); // a slope
            QVERIFY((touch.hip(1.0) - Vec3(x, 0, 0.3 * x - 4.0)).norm() < 1e-9);
        }
    }
    void runsOnInItsPlaneOffTheRim()
    {
        Touch touch;
        touch.press(0.0);
        const Vec3 aside = Vec3(0.1, 0, -1).normalized();
        touch.hand.pointAt(kEye, aside, Vec3(kEye + 300.0 * aside)); // 200 mm behind: a different organ
        QVERIFY(std::abs((touch.hip(1.0) - 4.0 * aside).z()) < 1e-6);
        touch.hand.pointAt(kEye, aside, std::nullopt);
        QVERIFY(std::abs((touch.hip(1.0) - 4.0 * aside).z()) < 1e-6);
    }
    void releaseLiftsOffAndLetsGo()
    {
        Touch touch;
        touch.press(0.0);
        (void)touch.tick(0.9);
        touch.hand.release(1.0);
        const double lift_s = touch.hand.settings().liftTime_s;
        (void)touch.tick(1.0);
        QCOMPARE(touch.hand.phase(1.0 + 0.5 * lift_s), Phase::Lifting);
        QVERIFY(touch.tick(1.0 + 0.5 * lift_s).isPresent);
        QVERIFY(touch.hip(1.0 + 0.5 * lift_s).z() > -2.0);
        QCOMPARE(touch.hand.phase(1.0 + 1.01 * lift_s), Phase::Hovering);
        QVERIFY(!touch.tick(1.0 + 1.01 * lift_s).isPresent);
        touch.hand.goAway();
        QCOMPARE(touch.hand.phase(3.0), Phase::Away);
    }
    void nextPressWaitsForTheDeviceAgain()
    {
        Touch touch;
        touch.press(0.0);
        (void)touch.tick(0.9);
        touch.hand.release(1.0);
        (void)touch.tick(1.0);
        (void)touch.tick(1.5); // the hand was absent in between
        touch.hand.press();
        QVERIFY(touch.hip(9.0).z() > 0.0);
    }
    void pressedAgainWhileItLiftsGoesOnFromThere()
    {
        Touch touch;
        touch.press(0.0);
        (void)touch.tick(0.9);
        touch.hand.release(1.0);
        (void)touch.tick(1.0);
        const double lifted = touch.hip(1.05).z();
        touch.hand.press();
        QVERIFY(std::abs(touch.hip(1.05).z() - lifted) < 1e-12);
        QVERIFY(std::abs(touch.hip(1.3).z() + 4.0) < 1e-12);
    }
    void depthsSuitTheSceneSize()
    {
        QCOMPARE(ui::settingsForSize(1700.0).depth_mm, 4.0);
        QCOMPARE(ui::settingsForSize(20.0).depth_mm, 0.4);
        QVERIFY(ui::settingsForSize(0.0).depth_mm > 0.0);
        QCOMPARE(ui::settingsForSize(1700.0).deepest_mm, 1700.0);              // through the whole model
        QVERIFY(ui::settingsForSize(40.0 * std::sqrt(3.0)).deepest_mm > 12.0); // a ball of 40 mm diameter
    }
    void aNotchGrowsWithTheDepth()
    {
        ui::PointerHand hand;
        hand.setSettings(ui::settingsForSize(300.0));
        const auto depthAfter = [&hand](double notches) {
            (void)hand.turnDepth(notches);
            return hand.settings().depth_mm;
        };
        QCOMPARE(depthAfter(12), 10.0); // 0.5 mm per step
        QCOMPARE(depthAfter(1), 11.0);
        QCOMPARE(depthAfter(-1), 10.0);
        QCOMPARE(depthAfter(-1), 9.5);
        QCOMPARE(depthAfter(1 + 10 + 1), 22.0); // 1 mm per step, then 2
        QCOMPARE(depthAfter(14 + 1), 55.0);     // then 5
        QCOMPARE(depthAfter(0.5), 57.5);        // a touch pad's step
        QVERIFY(hand.turnDepth(40));
        QVERIFY(!hand.turnDepth(40));
        QCOMPARE(hand.settings().depth_mm, 300.0);
        QCOMPARE(depthAfter(-4.0), 280.0);
        QVERIFY(!hand.turnDepth(-1000));
        QCOMPARE(hand.settings().depth_mm, 0.0);
        QVERIFY(hand.stepDepth(3));
        QCOMPARE(hand.settings().depth_mm, 1.5);
        QVERIFY(!hand.stepDepth(-4));
    }
    /// A click with a preset depth of 27 mm: the press starts at the surface, ramps gently and continues while the
    /// button is held.
    void aDeepPressGoesInOverTime()
    {
        Touch touch;
        while (touch.hand.settings().depth_mm < 27.0) {
            (void)touch.hand.stepDepth(1);
        }
        touch.press(1.0);
        double before = touch.hand.settings().hover_mm;
        double fastest_mm_per_s = 0.0;
        for (int tick = 1; tick <= 2000; ++tick) {
            const double z = touch.hip(1.0 + 1e-3 * tick).z();
            fastest_mm_per_s = std::max(fastest_mm_per_s, (before - z) / 1e-3);
            before = z;
            QVERIFY2(tick != 150 || z > -6.0, qPrintable(QString::number(z)));
        }
        QVERIFY(std::abs(before + 27.0) < 1e-9);
        QVERIFY2(fastest_mm_per_s < 61.0, qPrintable(QString::number(fastest_mm_per_s))); // of 4 mm: 60
        // Released and pressed again: starts at the surface.
        touch.hand.release(3.0);
        (void)touch.tick(3.0);
        (void)touch.tick(3.5);
        touch.press(4.0);
        QVERIFY(touch.hip(4.001).z() > 0.0);
        QVERIFY(touch.hip(4.15).z() > -6.0);
        // Wheel steps during the press: no jump.
        double z = touch.hip(4.5).z();
        (void)touch.hand.turnDepth(3);
        for (int tick = 1; tick <= 2500; ++tick) {
            const double next = touch.hip(4.5 + 1e-3 * tick).z();
            QVERIFY(next <= z + 1e-12 && z - next < 0.061);
            z = next;
        }
        QVERIFY(std::abs(z + 33.0) < 1e-9);
    }
    void saysHowFarItPresses()
    {
        ui::PointerHand hand = over(Vec3(3, 4, 0));
        QCOMPARE(hand.pressedDepth_mm(Vec3(3, 4, -7)), 7.0);
        hand.goAway();
        QCOMPARE(hand.pressedDepth_mm(Vec3(3, 4, -7)), 0.0);
    }
};

PALPATE_TEST(PointerHand)
#include "tst_PointerHand.moc"
