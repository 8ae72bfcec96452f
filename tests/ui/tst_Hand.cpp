// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/ui/HandPanel.h>
#include <palpate/ui/LiveTouch.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <limits>

using namespace palpate;
using core::Vec3;
using ui::ButtonUse;
using ui::HandSettings;
using ui::MapFill;
using ui::MapTurn;

namespace {

device::DeviceInfo touch()
{
    return device::deviceInfo(*device::findDevicePreset("touch"));
}

/// Returns a view from the patient's front, as in radiology: the patient's left is to the right.
ui::HandPlace fromTheFront()
{
    ui::HandPlace place;
    place.right_W = Vec3(1, 0, 0);
    place.up_W = Vec3(0, 0, 1);
    place.filled = core::Box(Vec3(-100, -50, 0), Vec3(100, 50, 60));
    return place;
}

bool mentions(const QWidget& widget, const QString& part)
{
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        if (label->text().contains(part)) {
            return true;
        }
    }
    return false;
}

} // namespace

class Hand : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void settingsAreKeptForEachDeviceByItself()
    {
        const QTemporaryDir folder;
        QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        HandSettings settings;
        settings.turn = MapTurn::Patient;
        settings.fill = MapFill::Scale;
        settings.scale = 0.25;
        settings.rate_kHz = 4;
        settings.cpu = 1;
        settings.isLeftHanded = true;
        settings.isByEffort = true;
        settings.effort_N = 7.5;
        settings.preset = "omega";
        settings.buttons = {ButtonUse::Nothing, ButtonUse::Clutch, ButtonUse::Centre, ButtonUse::Nothing};
        settings.save(store, QStringLiteral("touch"));
        const HandSettings back = HandSettings::load(store, QStringLiteral("touch"));
        QVERIFY(back.turn == settings.turn && back.fill == settings.fill && back.isLeftHanded);
        QCOMPARE(back.scale, 0.25);
        QCOMPARE(back.rate_kHz, 4);
        QCOMPARE(back.cpu, 1);
        QVERIFY(back.isByEffort && !HandSettings().isByEffort);
        QCOMPARE(back.effort_N, 7.5);
        QCOMPARE(back.preset, std::string("omega"));
        QVERIFY(back.buttons == settings.buttons);
        QVERIFY(!HandSettings::load(store, QStringLiteral("omega")).isLeftHanded);
        store.setValue(QStringLiteral("devices/touch/fill"), 77);
        store.setValue(QStringLiteral("devices/touch/scale"), QStringLiteral("nan"));
        store.setValue(QStringLiteral("devices/touch/rate_kHz"), 3);
        store.setValue(QStringLiteral("devices/touch/effort_N"), 900);
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).effort_N, ui::Effort::kUsual_N);
        store.setValue(QStringLiteral("devices/touch/preset"), QStringLiteral("none such"));
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).preset, std::string("touch"));
        store.setValue(QStringLiteral("devices/touch/cpu"), QStringLiteral("all"));
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).cpu, -1);
        QVERIFY(HandSettings::load(store, QStringLiteral("touch")).fill == MapFill::Scene);
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).scale, 1.0);
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).rate_kHz, 1);
        settings.fill = MapFill::Lump; // for this scene; the next scene starts with the whole model
        settings.save(store, QStringLiteral("touch"));
        QVERIFY(HandSettings::load(store, QStringLiteral("touch")).fill == MapFill::Scene);
    }

    void aLeftHandHasTheFirstTwoButtonsChanged()
    {
        HandSettings settings;
        settings.buttons = {ButtonUse::Clutch, ButtonUse::Centre, ButtonUse::Clutch, ButtonUse::Nothing};
        QCOMPARE(settings.buttonsFor(ButtonUse::Clutch), 5U);
        QCOMPARE(settings.buttonsFor(ButtonUse::Centre), 2U);
        settings.isLeftHanded = true;
        QCOMPARE(settings.buttonsFor(ButtonUse::Clutch), 6U);
        QCOMPARE(settings.buttonsFor(ButtonUse::Centre), 1U);
    }

    void theMouseStaysDirect() { QVERIFY(ui::mapFor({}, device::PointerDevice().info(), fromTheFront()).isDirect); }

    void theDeviceTurnsWithThePictureOrThePatient()
    {
        HandSettings settings;
        ui::HandPlace place = fromTheFront();
        servo::MapSettings map = ui::mapFor(settings, touch(), place);
        QVERIFY(!map.isDirect);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitY() - Vec3(0, 0, 1)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitZ() - Vec3(0, -1, 0)).norm() < 1e-12); // towards the user: the patient's front
        place.right_W = Vec3(0, -1, 0);                                      // seen from the patient's left
        map = ui::mapFor(settings, touch(), place);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(0, -1, 0)).norm() < 1e-12);
        settings.turn = MapTurn::None;
        QVERIFY(ui::mapFor(settings, touch(), place).isDirect);
        settings.turn = MapTurn::Patient; // for any rotation of the view
        map = ui::mapFor(settings, touch(), place);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitY() - Vec3(0, 0, 1)).norm() < 1e-12);
        device::DeviceInfo lying = touch(); // x towards the user, z up
        Eigen::Matrix3d R_UD;
        R_UD << 0, 1, 0, 0, 0, 1, 1, 0, 0;
        lying.q_UD = core::Quaternion(R_UD);
        map = ui::mapFor(settings, lying, place);
        QVERIFY((map.q_WD * Vec3::UnitZ() - Vec3(0, 0, 1)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(0, -1, 0)).norm() < 1e-12);
    }

    void anOrganOrALumpFillsTheWorkspaceWithRoomAroundIt()
    {
        HandSettings settings;                 // defaults for an unknown device
        const double reach = 2.0 * 67.5 / 1.2; // nine tenths of the Touch's 75 mm, in both directions, minus the margin
        servo::MapSettings map = ui::mapFor(settings, touch(), fromTheFront());
        QVERIFY(std::abs(map.scale * reach - 200.0) < 1e-9);
        QVERIFY((map.centre_W - Vec3(0, 0, 30)).norm() < 1e-12);
        QCOMPARE(map.edge_mm, 67.5);
        ui::HandPlace place = fromTheFront();
        place.filled = ui::lumpAt(Vec3(16, 12, 13));
        settings.fill = MapFill::Lump;
        map = ui::mapFor(settings, touch(), place);
        QVERIFY(std::abs(map.scale * reach - 10.0) < 1e-9);
        QVERIFY((map.centre_W - Vec3(16, 12, 13)).norm() < 1e-12);
        settings.fill = MapFill::Scale;
        settings.scale = 3.0;
        QCOMPARE(ui::mapFor(settings, touch(), fromTheFront()).scale, 3.0);
    }

    void whatIsASpeedHasNoEdgeAndBeginsBeforeTheScene()
    {
        device::DeviceInfo puck = touch();
        puck.isRateControlled = true;
        const servo::MapSettings map = ui::mapFor({}, puck, fromTheFront());
        QCOMPARE(map.edge_mm, 0.0);
        QVERIFY(map.centre_W.y() < -50.0 - 5.0); // on the viewer's side of the scene
        QVERIFY(std::abs(map.centre_W.x()) < 1e-12 && std::abs(map.centre_W.z() - 30.0) < 1e-12);
        // From there the workspace reaches through the scene.
        QVERIFY(map.centre_W.y() + map.scale * 75.0 > 50.0);
    }

    void thePanelShowsWhatTheDeviceCanShow()
    {
        ui::HandPanel panel;
        panel.setDevice(touch(), {});
        ui::HandStatus status;
        status.held_N_per_mm = 0.4;
        status.scale = 1.5;
        status.isMapped = true;
        status.filled = QStringLiteral("liver");
        status.force_N = 1.25;
        panel.show(status);
        QVERIFY(mentions(panel, QStringLiteral("This device can render tissue up to 0.40 N/mm.")));
        QVERIFY(mentions(panel, QStringLiteral("Force on the hand 1.25 N of 3.3 N")));
        QVERIFY(mentions(panel, QStringLiteral("liver fills the workspace: 1 mm of the device is 1.5 mm")));
        QCOMPARE(panel.findChild<QDoubleSpinBox*>()->value(), 1.5);
        QVERIFY(!panel.findChild<QCheckBox*>()->isHidden());
        status.clutch = ui::HandStatus::Clutch::Asked;
        panel.show(status);
        QVERIFY(mentions(panel, QStringLiteral("Lifted")));
        status.clutch = ui::HandStatus::Clutch::AtEdge;
        panel.show(status);
        QVERIFY(mentions(panel, QStringLiteral("Edge of the workspace")));
        status.clutch = ui::HandStatus::Clutch::None;
        status.inside = QStringLiteral("liver");
        panel.show(status);
        QVERIFY(mentions(panel, QStringLiteral("The hand is inside liver")));
        panel.resize(300, 420);
        if (const QByteArray to = qgetenv("PALPATE_HAND_PICTURE"); !to.isEmpty()) {
            panel.grab().save(QString::fromLocal8Bit(to)); // for visual inspection
        }
    }

    void thePanelTellsWhatWasChosen()
    {
        ui::HandPanel panel;
        panel.setDevice(touch(), {});
        QSignalSpy changed(&panel, &ui::HandPanel::settingsChanged);
        auto* turn = panel.findChildren<QComboBox*>().front();
        turn->setCurrentIndex(1);
        Q_EMIT turn->activated(1);
        QCOMPARE(changed.count(), 1);
        QVERIFY(panel.settings().turn == MapTurn::Patient);
        panel.findChild<QDoubleSpinBox*>()->setValue(0.5);
        QCOMPARE(changed.count(), 2);
        QVERIFY(panel.settings().fill == MapFill::Scale && panel.settings().scale == 0.5);
        std::vector<MapFill> wanted;
        connect(&panel, &ui::HandPanel::fitWanted, this, [&](MapFill one) { wanted.push_back(one); });
        const auto buttons = panel.findChildren<QPushButton*>();
        for (const QString& name : {QStringLiteral("Everything"), QStringLiteral("Organ"), QStringLiteral("Lump")}) {
            for (QPushButton* button : buttons) {
                if (button->text() == name) {
                    button->click();
                }
            }
        }
        QVERIFY(wanted == (std::vector{MapFill::Scene, MapFill::Organ, MapFill::Lump}));
        QSignalSpy clutch(&panel, &ui::HandPanel::clutchWanted);
        for (QPushButton* button : buttons) {
            if (button->text() == QStringLiteral("Lift the hand")) {
                Q_EMIT button->pressed();
                Q_EMIT button->released();
            }
        }
        QCOMPARE(clutch.count(), 2);
        // The simulated hand has the limits of a device.
        auto* presets = panel.findChild<QComboBox*>(QStringLiteral("preset"));
        QVERIFY(presets->isHidden() || presets->parentWidget()->isHidden());
        device::DeviceInfo simulated = touch();
        simulated.id = "simulated-hand";
        panel.setDevice(simulated, {});
        QVERIFY(!presets->parentWidget()->isHidden());
        QCOMPARE(presets->currentText(), QStringLiteral("Touch"));
        QSignalSpy preset(&panel, &ui::HandPanel::presetChanged);
        presets->setCurrentIndex(presets->findText(QStringLiteral("omega")));
        Q_EMIT presets->activated(presets->currentIndex());
        QCOMPARE(preset.count(), 1);
        QCOMPARE(panel.settings().preset, std::string("omega"));
    }

    /// The latency of a device is measured, and lowers the stable stiffness from then on.
    void aLateDeviceHoldsLess()
    {
        struct Late final : palpate::device::HapticDevice
        {
            palpate::device::DeviceInfo info() const override
            {
                return palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
            }
            palpate::core::Status start() override { return {}; }
            void stop() noexcept override {}
            palpate::device::DeviceState read(std::int64_t now_ns) noexcept override
            {
                palpate::device::DeviceState state;
                state.time_ns = now_ns;
                state.isPresent = true;
                return state;
            }
            void write(const palpate::core::Vec3&) noexcept override {}
            palpate::device::DeviceReport report() const override
            {
                palpate::device::DeviceReport report;
                report.latency.count = 5000;
                report.latency.p99_ns = 2'300'000;
                return report;
            }
        };
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(live.useDevice(std::make_unique<Late>()).isOk());
        QVERIFY(live.start().isOk());
        QCOMPARE(live.heldStiffness_N_per_mm(), 5.0);
        QVERIFY(live.limitText().contains(QStringLiteral("manufacturer")));
        QSignalSpy changed(&live, &ui::LiveTouch::greatestChanged);
        PALPATE_TRY_COMPARE(live.delayTicks(), 3);
        QVERIFY(live.heldStiffness_N_per_mm() < 3.0);
        QCOMPARE(changed.count(), 1);
        for (const char* part : {"omega", "delayed by 3 ms", "vibrate"}) {
            QVERIFY2(live.limitText().contains(QLatin1String(part)), qPrintable(live.limitText()));
        }
        live.stop();
        QVERIFY(live.useDevice(nullptr).isOk());
        QCOMPARE(live.delayTicks(), 1);
    }

    void theLoopRunsOnTheCpuAskedForOrAsBefore()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(live.start().isOk());
        const int cpu = servo::allowedCpus().back();
        QVERIFY(live.setLoop(2000.0, cpu).isOk());
        bool isGranted = false;
        for (const servo::RealtimeItem& item : live.realtime().items) {
            isGranted = isGranted || (item.name.english() == "own CPU" && item.isGranted);
        }
        QVERIFY(isGranted);
        QVERIFY(!live.setLoop(1000.0, 100'000).isOk());
        QCOMPARE(live.cpu(), cpu);
        QCOMPARE(live.rate_Hz(), 2000.0);
        QVERIFY(live.setLoop(1000.0, -1).isOk());
        for (const servo::RealtimeItem& item : live.realtime().items) {
            QVERIFY(item.name.english() != "own CPU");
        }
    }

    void aStifferTissueThanIsHeldIsRefusedInWords()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(std::isinf(live.heldStiffness_N_per_mm())); // the mouse: no limit
        QSignalSpy refused(&live, &ui::LiveTouch::stiffnessRefused);
        std::vector<ui::StructureRow> rows = test::twoRows();
        rows.front().loaded.description.palpable = true;
        rows.front().loaded.description.tissue.stiffness_N_per_mm = 50.0;
        model.setRows(std::move(rows));
        QVERIFY(live.start().isOk());
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.front().front().toString().contains(QStringLiteral("50")));
        QVERIFY(refused.front().front().toString().contains(QStringLiteral("5 N/mm")));
    }
};

PALPATE_TEST(Hand)
#include "tst_Hand.moc"
