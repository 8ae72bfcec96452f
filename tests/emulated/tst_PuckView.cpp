// SPDX-License-Identifier: BSD-3-Clause
// The released SpaceMouse plugin moves the window's view or presses, as chosen in the device menu, with an emulated
// puck. In real time, so only directions and standstills are checked, never speeds.
#include "EmulatedArm.h"
#include "TestRunner.h"

#include <palpate/ui/ConnectedDevices.h>
#include <palpate/ui/DeviceChoice.h>

#include <vtkCamera.h>

#include <QFile>
#include <QMenu>
#include <QSignalSpy>

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

class PuckView : public QObject
{
    Q_OBJECT

    struct Window
    {
        ui::StructureModel model;
        ui::LiveTouch live{model};
        ui::VtkViewport viewport;
        ui::SessionPanel session;
        ui::TouchPanel touch;
        ui::Playback playback{viewport, model, session, touch};
        ui::DeviceChoice devices{live, viewport, playback};
        QMenu menu;
        QAction* movesView = nullptr;
        QAction* presses = nullptr;

        Window()
        {
            devices.setPlugins(shippingPlugins());
            devices.fill(menu);
            for (QAction* action : menu.actions()) {
                movesView = action->text() == QStringLiteral("SpaceMouse moves the view") ? action : movesView;
                presses = action->text() == QStringLiteral("SpaceMouse presses") ? action : presses;
            }
            vtkCamera& camera = viewport.view().camera(); // from the front, half a metre away
            camera.SetPosition(0, -500, 0);
            camera.SetFocalPoint(0, 0, 0);
            camera.SetViewUp(0, 0, 1);
        }
        Vec3 focus() { return Vec3(viewport.view().camera().GetFocalPoint()); }
        Vec3 eye() { return Vec3(viewport.view().camera().GetPosition()); }
    };

    std::unique_ptr<EmulatedBench> m_bench;
    std::unique_ptr<Window> m_window;

    void hold(const std::array<std::int16_t, 6>& axes)
    {
        m_bench->with([&](standin::Bench& b) { b.puck.axes = axes; });
    }
    int light()
    {
        int light = -1;
        m_bench->with([&](standin::Bench& b) { light = b.puck.light; });
        return light;
    }
    void letGo()
    {
        hold({});
        QTest::qWait(200); // the last reports and the timeout are over
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedBench>();
        // A workspace that a second of pushing exhausts: the view moves beyond.
        QFile settings(QString::fromStdString(
            (std::filesystem::path(m_bench->file()).parent_path() / "spacemouse.json").string()));
        QVERIFY(settings.open(QIODevice::WriteOnly));
        settings.write(R"({"reach_mm": 20, "speed_mm_per_s": 200, "dead_zone": 0.1})");
    }
    void init()
    {
        m_bench->with([](standin::Bench& b) {
            b.puck = {};
            standin::plugPuck(b, true);
        });
        m_window = std::make_unique<Window>();
        QVERIFY(m_window->movesView != nullptr);
        m_window->movesView->trigger();
        QVERIFY(m_window->movesView->isChecked());
    }
    void cleanup() { m_window.reset(); }

    void theAnatomyFollowsThePuck()
    {
        hold({350, 0, 0, 0, 0, 0}); // to the right
        PALPATE_TRY_VERIFY(m_window->focus().x() < -10.0);
        letGo();
        QVERIFY(std::abs(m_window->focus().z()) < 1e-9 && std::abs(m_window->focus().y()) < 1e-9);
        const double distance = (m_window->eye() - m_window->focus()).norm();
        hold({0, 350, 0, 0, 0, 0}); // towards the user
        PALPATE_TRY_VERIFY((m_window->eye() - m_window->focus()).norm() < distance - 10.0);
        letGo();
        const Vec3 before = m_window->eye() - m_window->focus();
        hold({0, 0, 0, 0, 0, 350}); // rotated about the vertical
        PALPATE_TRY_VERIFY((m_window->eye() - m_window->focus()).normalized().dot(before.normalized()) < 0.99);
        letGo();
        QVERIFY(std::abs((m_window->eye() - m_window->focus()).norm() - before.norm()) < 1e-6 * before.norm());
    }

    void theViewGoesOnWhereTheHandsReachEnds()
    {
        hold({350, 0, 0, 0, 0, 0});
        PALPATE_TRY_VERIFY(m_window->focus().x() < -200.0); // 20 mm of hand motion are 40 mm here
        letGo();
    }

    void standsStillInTheDeadZoneAndWhenLetGo()
    {
        hold({30, -30, 20, 30, 30, 30}); // less than a tenth of 350
        QTest::qWait(300);
        QVERIFY(m_window->focus() == Vec3::Zero() && m_window->eye() == Vec3(0, -500, 0));
        hold({350, 0, 0, 0, 0, 0});
        PALPATE_TRY_VERIFY(m_window->focus().x() < -1.0);
        letGo();
        const Vec3 there = m_window->focus();
        QTest::qWait(200);
        QVERIFY(m_window->focus() == there);
    }

    void standsStillWhenPulledOutWhilePushed()
    {
        hold({350, 0, 0, 0, 0, 0});
        PALPATE_TRY_VERIFY(m_window->focus().x() < -1.0);
        m_bench->with([](standin::Bench& b) { standin::plugPuck(b, false); });
        QTest::qWait(400); // the last push stays valid for 0.1 s
        const Vec3 there = m_window->focus();
        QTest::qWait(300);
        QVERIFY(m_window->focus() == there);
    }

    /// Pushing down presses, harder means deeper; releasing or unplugging ends the press. The view stays still.
    void thePuckPresses()
    {
        QSignalSpy wanted(&m_window->devices, &ui::DeviceChoice::pressingWanted);
        double share = -1.0;
        connect(&m_window->devices, &ui::DeviceChoice::pushed, this, [&share](double now) { share = now; });
        m_window->presses->trigger();
        QVERIFY(m_window->presses->isChecked() && !m_window->movesView->isChecked());
        QCOMPARE(wanted.count(), 1);
        // Full deflection is 200 mm/s here, and 60 mm/s for a press: a fifth of the deflection minus the dead zone is
        // 0.37.
        hold({0, 0, 70, 0, 0, 0});
        PALPATE_TRY_VERIFY2(share > 0.2 && share < 0.6, qPrintable(QString::number(share)));
        hold({0, 0, 350, 0, 0, 0});
        PALPATE_TRY_COMPARE(share, 1.0);
        hold({0, 0, -350, 0, 0, 0}); // pulled
        PALPATE_TRY_COMPARE(share, 0.0);
        hold({0, 0, 350, 0, 0, 0});
        PALPATE_TRY_COMPARE(share, 1.0);
        m_bench->with([](standin::Bench& b) { standin::plugPuck(b, false); });
        PALPATE_TRY_COMPARE(share, 0.0);
        QVERIFY(m_window->focus() == Vec3::Zero() && m_window->eye() == Vec3(0, -500, 0));
        m_window->movesView->trigger();
        QVERIFY(!m_window->presses->isChecked() && m_window->movesView->isChecked());
    }

    /// Every family of devices has a state and a next step, with and without plugins.
    void theTableOfDevicesNamesStateAndNextStep()
    {
        using State = ui::DeviceFamily::State;
        const std::vector<device::OtherDevice> onBus{{"Novint Falcon", "a plugin", ""},
                                                     {"Haply Inverse3", "a service", "haply"}};
        const auto host = shippingPlugins();
        const auto families = ui::deviceFamilies(host.get(), onBus);
        const auto stateOf = [&families](const char* name) {
            const auto found = std::find_if(families.begin(), families.end(), [name](const ui::DeviceFamily& one) {
                return one.name.startsWith(QLatin1String(name));
            });
            return found != families.end() ? found->state : State::Unavailable;
        };
        QVERIFY(stateOf("SpaceMouse") == State::Ready && stateOf("Novint Falcon") == State::NotReady);
        for (const ui::DeviceFamily& one : families) {
            QVERIFY2(!one.stateText.isEmpty() && !one.nextStep.isEmpty(), qPrintable(one.name));
        }
        m_bench->with([](standin::Bench& b) { standin::plugPuck(b, false); });
        QVERIFY(ui::deviceFamilies(host.get(), {})[4].state == State::NotConnected);
        const auto without = ui::deviceFamilies(nullptr, {});
        QCOMPARE(without.size(), std::size_t{6});
        for (const ui::DeviceFamily& one : without) {
            QVERIFY2(one.state == State::Unavailable && !one.nextStep.isEmpty(), qPrintable(one.name));
        }
    }

    void oneDeviceIsNotTwo()
    {
        QSignalSpy refused(&m_window->devices, &ui::DeviceChoice::refused);
        QCOMPARE(m_window->devices.choose("spacemouse").code(), core::StatusCode::Unsupported);
        QVERIFY(m_window->live.usesPointer());
        PALPATE_TRY_COMPARE(light(), 1);
        m_window->movesView->trigger(); // off
        QCOMPARE(light(), 0);
        hold({350, 0, 0, 0, 0, 0});
        QTest::qWait(200);
        QVERIFY(m_window->focus() == Vec3::Zero());
        QVERIFY(m_window->devices.choose("spacemouse").isOk());
        m_window->movesView->trigger();
        QCOMPARE(refused.count(), 1);
        QVERIFY(!m_window->movesView->isChecked());
    }
};

PALPATE_TEST(PuckView)
#include "tst_PuckView.moc"
