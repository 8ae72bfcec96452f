// SPDX-License-Identifier: BSD-3-Clause
// Tests the released SpaceMouse plugin against emulated pucks of both kinds, in virtual time.
#include "EmulatedArm.h"
#include "TestRunner.h"

using namespace palpate;
using namespace palpate::test;

class SpaceMouse : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedBench> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    std::unique_ptr<device::HapticDevice> make()
    {
        auto made = m_host->make("spacemouse");
        return made.isOk() ? std::move(made).value() : nullptr;
    }

    /// Reads like the servo loop.
    static device::DeviceState readFor(device::HapticDevice& mouse, double seconds)
    {
        device::DeviceState state;
        for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
            pass(0.001);
            state = mouse.read(core::monotonicNow_ns());
        }
        return state;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedBench>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
    }

    void movesAtARate_data()
    {
        QTest::addColumn<int>("product");
        QTest::addColumn<bool>("hasSixAxisReport");
        QTest::newRow("7-byte reports") << 0xc635 << false;
        QTest::newRow("13-byte report") << 0xc652 << true;
    }

    void movesAtARate()
    {
        QFETCH(const int, product);
        QFETCH(const bool, hasSixAxisReport);
        m_bench->with([&](standin::Bench& b) {
            b.puck = {};
            b.puck.product = static_cast<std::uint16_t>(product);
            b.puck.hasSixAxisReport = hasSixAxisReport;
            standin::plugPuck(b, true);
        });
        const auto mouse = make();
        QVERIFY(mouse != nullptr);
        QVERIFY(mouse->start().isOk());
        device::DeviceState state = readFor(*mouse, 0.5);
        QVERIFY(state.isPresent);
        QCOMPARE(state.p_D.norm(), 0.0);
        m_bench->with([](standin::Bench& b) { QCOMPARE(b.puck.light, 1); });
        // Pushed fully to the right and towards the user, and rotated by half about the vertical.
        m_bench->with([](standin::Bench& b) { b.puck.axes = {350, 350, 0, 0, 0, -185}; });
        state = readFor(*mouse, 1.0);
        QVERIFY2(std::abs(state.p_D.x() - 60.0) < 2.0 && std::abs(state.p_D.y() + 60.0) < 2.0,
                 qPrintable(QStringLiteral("%1 %2").arg(state.p_D.x()).arg(state.p_D.y())));
        QCOMPARE(state.p_D.z(), 0.0);
        const Eigen::AngleAxisd turn(state.q_D);
        QVERIFY2(std::abs(turn.angle() - 0.5) < 0.03 && turn.axis().z() > 0.99,
                 qPrintable(QString::number(turn.angle())));
        // No motion within the dead zone and after release.
        m_bench->with([](standin::Bench& b) { b.puck.axes = {15, -15, 10, 5, 5, 5}; });
        readFor(*mouse, 0.05);
        const core::Vec3 before = mouse->read(core::monotonicNow_ns()).p_D;
        QCOMPARE(readFor(*mouse, 0.5).p_D, before);
        // Buttons, and the light goes off at the end.
        m_bench->with([](standin::Bench& b) { b.puck.buttons = 2; });
        QCOMPARE(readFor(*mouse, 0.1).buttons, 2U);
        mouse->stop();
        m_bench->with([](standin::Bench& b) { QCOMPARE(b.puck.light, 0); });
    }

    void comesAnewFromItsOriginWhenAsked()
    {
        m_bench->with([](standin::Bench& b) {
            b.puck = {};
            standin::plugPuck(b, true);
        });
        const auto mouse = make();
        const device::DeviceInfo info = mouse->info();
        QVERIFY(info.isRateControlled && info.workspaceRadius_mm == 250.0);
        QVERIFY((info.q_UD * core::Vec3::UnitZ() - core::Vec3::UnitY()).norm() < 1e-12); // its up direction is up
        QVERIFY(mouse->start().isOk());
        m_bench->with([](standin::Bench& b) { b.puck.axes = {350, 0, 0, 0, 0, 350}; });
        QVERIFY(readFor(*mouse, 0.5).p_D.x() > 20.0);
        m_bench->with([](standin::Bench& b) { b.puck.axes = {}; });
        readFor(*mouse, 0.2);
        QVERIFY(mouse->calibrate().isOk());
        const device::DeviceState first = mouse->read(core::monotonicNow_ns());
        QVERIFY(!first.isPresent); // not mistaken for a jump of the hand
        const device::DeviceState next = readFor(*mouse, 0.01);
        QVERIFY(next.isPresent && next.p_D == core::Vec3(0, 0, 0));
        QVERIFY(next.q_D.isApprox(core::Quaternion::Identity()));
        mouse->stop();
    }

    void standsStillWhenItIsPulledWhilePushed()
    {
        m_bench->with([](standin::Bench& b) {
            b.puck = {};
            standin::plugPuck(b, true);
        });
        const auto mouse = make();
        QVERIFY(mouse->start().isOk());
        m_bench->with([](standin::Bench& b) { b.puck.axes = {350, 0, 0, 0, 0, 0}; });
        readFor(*mouse, 0.5);
        m_bench->with([](standin::Bench& b) { standin::plugPuck(b, false); });
        const double pulled_mm = readFor(*mouse, 0.2).p_D.x();
        QVERIFY(pulled_mm > 20.0 && pulled_mm < 40.0);
        QCOMPARE(readFor(*mouse, 1.0).p_D.x(), pulled_mm);
        QCOMPARE(mouse->report().condition, device::DeviceCondition::Lost);
        m_bench->with([](standin::Bench& b) { standin::plugPuck(b, true); });
        QVERIFY(readFor(*mouse, 1.0).p_D.x() > pulled_mm + 20.0); // reconnected, still pushed
        QCOMPARE(mouse->report().condition, device::DeviceCondition::Working);
        mouse->stop();
    }

    void leavesTheVendorsOtherDevicesAlone_data()
    {
        QTest::addColumn<int>("vendor");
        QTest::addColumn<int>("product");
        for (const int product :
             {0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657, 0xc658, 0xc664, 0xc665, 0xc668, 0xc62c}) {
            QTest::newRow(qPrintable(QString::number(product, 16))) << 0x256f << product;
        }
        QTest::newRow("a keyboard of the old vendor") << 0x046d << 0xc31c;
    }

    void leavesTheVendorsOtherDevicesAlone()
    {
        QFETCH(const int, vendor);
        QFETCH(const int, product);
        m_bench->with([&](standin::Bench& b) {
            b.puck = {};
            b.puck.vendor = static_cast<std::uint16_t>(vendor);
            b.puck.product = static_cast<std::uint16_t>(product);
            standin::plugPuck(b, true);
        });
        const auto found = m_host->find("spacemouse");
        QVERIFY(found.isOk() && found.value().empty());
        QCOMPARE(make()->start().code(), core::StatusCode::NotFound);
    }
};

PALPATE_TEST(SpaceMouse)
#include "tst_SpaceMouse.moc"
