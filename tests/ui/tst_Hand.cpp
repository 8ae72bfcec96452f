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

/// A picture from the patient's front, as radiologists look: the patient's left is to the right.
ui::HandPlace fromTheFront()
{
    ui::HandPlace place;
    place.right_W = Vec3(1, 0, 0);
    place.up_W = Vec3(0, 0, 1);
    place.scene = core::Box(Vec3(-100, -50, 0), Vec3(100, 50, 60));
    place.selection = core::Box(Vec3(10, 10, 10), Vec3(22, 14, 16));
    return place;
}

bool says(const QWidget& widget, const QString& part)
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

  private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void settingsAreKeptForEachDeviceByItself()
    {
        const QTemporaryDir folder;
        QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        HandSettings settings;
        settings.turn = MapTurn::Patient;
        settings.fill = MapFill::Scale;
        settings.scale = 0.25;
        settings.isLeftHanded = true;
        settings.buttons = {ButtonUse::Nothing, ButtonUse::Clutch, ButtonUse::Centre, ButtonUse::Nothing};
        settings.save(store, QStringLiteral("touch"));
        const HandSettings back = HandSettings::load(store, QStringLiteral("touch"));
        QVERIFY(back.turn == settings.turn && back.fill == settings.fill && back.isLeftHanded);
        QCOMPARE(back.scale, 0.25);
        QVERIFY(back.buttons == settings.buttons);
        QVERIFY(!HandSettings::load(store, QStringLiteral("omega")).isLeftHanded);
        store.setValue(QStringLiteral("devices/touch/fill"), 77);
        store.setValue(QStringLiteral("devices/touch/scale"), QStringLiteral("nan"));
        QVERIFY(HandSettings::load(store, QStringLiteral("touch")).fill == MapFill::Direct);
        QCOMPARE(HandSettings::load(store, QStringLiteral("touch")).scale, 1.0);
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
        QVERIFY(ui::mapFor(settings, touch(), fromTheFront()).isDirect); // until somebody asks for more
        settings.fill = MapFill::Scene;
        ui::HandPlace place = fromTheFront();
        servo::MapSettings map = ui::mapFor(settings, touch(), place);
        QVERIFY(!map.isDirect);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitY() - Vec3(0, 0, 1)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitZ() - Vec3(0, -1, 0)).norm() < 1e-12); // towards the user: the patient's front
        place.right_W = Vec3(0, -1, 0);                                      // seen from the patient's left
        map = ui::mapFor(settings, touch(), place);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(0, -1, 0)).norm() < 1e-12);
        settings.turn = MapTurn::Patient; // however the picture is turned
        map = ui::mapFor(settings, touch(), place);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitY() - Vec3(0, 0, 1)).norm() < 1e-12);
        device::DeviceInfo lying = touch(); // its x comes towards the user, its z goes up
        Eigen::Matrix3d R_UD;
        R_UD << 0, 1, 0, 0, 0, 1, 1, 0, 0;
        lying.q_UD = core::Quaternion(R_UD);
        map = ui::mapFor(settings, lying, place);
        QVERIFY((map.q_WD * Vec3::UnitZ() - Vec3(0, 0, 1)).norm() < 1e-12);
        QVERIFY((map.q_WD * Vec3::UnitX() - Vec3(0, -1, 0)).norm() < 1e-12);
    }

    void anOrganOrALumpFillsTheWorkspace()
    {
        HandSettings settings;
        settings.fill = MapFill::Scene;
        const double reach = 2.0 * 67.5; // nine tenths of the Touch's 75 mm, both ways
        servo::MapSettings map = ui::mapFor(settings, touch(), fromTheFront());
        QVERIFY(std::abs(map.scale * reach - 200.0) < 1e-9);
        QVERIFY((map.centre_W - Vec3(0, 0, 30)).norm() < 1e-12);
        QCOMPARE(map.edge_mm, 67.5);
        settings.fill = MapFill::Selection;
        map = ui::mapFor(settings, touch(), fromTheFront());
        QVERIFY(std::abs(map.scale * reach - 12.0) < 1e-9);
        QVERIFY((map.centre_W - Vec3(16, 12, 13)).norm() < 1e-12);
        settings.fill = MapFill::Lump;
        QVERIFY(std::abs(ui::mapFor(settings, touch(), fromTheFront()).scale * reach - 10.0) < 1e-9);
        settings.fill = MapFill::Scale;
        settings.scale = 3.0;
        QCOMPARE(ui::mapFor(settings, touch(), fromTheFront()).scale, 3.0);
    }

    void thePanelShowsWhatIsHeldAndTheEnergy()
    {
        ui::HandPanel panel;
        panel.setDevice(touch(), {});
        ui::HandStatus status;
        status.held_N_per_mm = 0.4;
        status.rate_Hz = 1000.0;
        status.scale = 1.5;
        status.energy_mJ = 2.125;
        status.damping_N = 0.25;
        panel.show(status);
        QVERIFY(says(panel, QStringLiteral("0.40 N/mm at 1,000 Hz")) ||
                says(panel, QStringLiteral("0.40 N/mm at 1000")));
        QVERIFY(says(panel, QStringLiteral("2.1")));
        QCOMPARE(panel.findChild<QDoubleSpinBox*>()->value(), 1.5);
        QVERIFY(!panel.findChild<QCheckBox*>()->isHidden());
        status.isClutched = true;
        panel.show(status);
        QVERIFY(says(panel, QStringLiteral("Clutched")));
        panel.resize(300, 420);
        if (const QByteArray to = qgetenv("PALPATE_HAND_PICTURE"); !to.isEmpty()) {
            panel.grab().save(QString::fromLocal8Bit(to)); // to be looked at
        }
    }

    void thePanelTellsWhatWasChosen()
    {
        ui::HandPanel panel;
        panel.setDevice(touch(), {});
        QSignalSpy changed(&panel, &ui::HandPanel::settingsChanged);
        auto* fill = panel.findChildren<QComboBox*>().front();
        fill->setCurrentIndex(2);
        emit fill->activated(2);
        QCOMPARE(changed.count(), 1);
        QVERIFY(panel.settings().fill == MapFill::Lump);
        QSignalSpy clutch(&panel, &ui::HandPanel::clutchWanted);
        auto* button = panel.findChildren<QPushButton*>().front();
        emit button->pressed();
        emit button->released();
        QCOMPARE(clutch.count(), 2);
    }

    /// A device whose answers come late is measured, and holds less from then on.
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
        QVERIFY(live.limitText().contains(QStringLiteral("makers")));
        QSignalSpy changed(&live, &ui::LiveTouch::greatestChanged);
        QTRY_COMPARE(live.delayTicks(), 3);
        QVERIFY(live.heldStiffness_N_per_mm() < 3.0);
        QCOMPARE(changed.count(), 1);
        for (const char* part : {"omega", "3 ms late", "oscillate"}) {
            QVERIFY2(live.limitText().contains(QLatin1String(part)), qPrintable(live.limitText()));
        }
        live.stop();
        QVERIFY(live.useDevice(nullptr).isOk());
        QCOMPARE(live.delayTicks(), 1);
    }

    void aStifferTissueThanIsHeldIsRefusedInWords()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(std::isinf(live.heldStiffness_N_per_mm())); // the mouse: no bound of its own
        QSignalSpy refused(&live, &ui::LiveTouch::stiffnessRefused);
        std::vector<ui::StructureRow> rows = test::twoRows();
        rows.front().loaded.description.palpable = true;
        rows.front().loaded.description.stiffness_N_per_mm = 50.0;
        model.setRows(std::move(rows));
        QVERIFY(live.start().isOk());
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.front().front().toString().contains(QStringLiteral("50")));
        QVERIFY(refused.front().front().toString().contains(QStringLiteral("5 N/mm")));
    }
};

PALPATE_TEST(Hand)
#include "tst_Hand.moc"
