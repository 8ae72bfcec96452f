// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"
#include "touch/DeviceTests.h"

#include <palpate/device/SimulatedHand.h>
#include <palpate/ui/LiveTouch.h>

#include <QLabel>
#include <QPushButton>

#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

/// Device whose handle follows targets, if `isRigid` whatever the force is.
std::unique_ptr<device::HapticDevice> moved(const std::vector<device::HandTarget>& targets, bool isRigid)
{
    device::SimulatedHandOptions options;
    options.isRigid = isRigid;
    return std::make_unique<device::SimulatedHand>(device::HandScript::make(targets).value(), options);
}

QPushButton* buttonOf(QDialog& dialog, const QString& text)
{
    for (QPushButton* one : dialog.findChildren<QPushButton*>()) {
        if (one->text() == text) {
            return one;
        }
    }
    return nullptr;
}

QString textOf(const QDialog& dialog)
{
    return dialog.findChild<QLabel*>()->text();
}

void keep(QDialog& dialog, const QString& name)
{
    if (const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES"); !folder.isEmpty()) {
        dialog.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
}

} // namespace

/// The dialogs of the device test and of the check of axes.
class DeviceTests : public QObject
{
    Q_OBJECT

    test::Desk m_desk; // only for the folder of the settings

  private Q_SLOTS:
    void checksTheAxesOnce()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        const Vec3 right(50, 0, 0), away(50, 0, -50), up(50, 50, -50);
        QVERIFY(live.useDevice(moved({{0.0, {0, 0, 0}},
                                      {0.8, {0, 0, 0}},
                                      {1.1, right},
                                      {1.8, right},
                                      {2.1, away},
                                      {2.8, away},
                                      {3.1, up},
                                      {9.0, up}},
                                     true))
                    .isOk());
        QVERIFY(!app::AxisCheckDialog::wasDone(live.deviceInfo()));
        QVERIFY(live.start().isOk());
        app::AxisCheckDialog dialog(live, nullptr);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        PALPATE_TRY_VERIFY(dialog.check().isDone());
        QVERIFY2(dialog.check().isRight(), qPrintable(textOf(dialog)));
        QVERIFY(textOf(dialog).endsWith(QStringLiteral("All axes follow the hand.")));
        QVERIFY(app::AxisCheckDialog::wasDone(live.deviceInfo()));
        keep(dialog, QStringLiteral("axes"));
    }

    void stopsATestAndGivesTheDeviceBack()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(live.useDevice(moved({{0.0, {0, 0, 0}}}, false)).isOk());
        QVERIFY(live.start().isOk());
        {
            app::SelfTestDialog dialog(live, nullptr);
            dialog.setAttribute(Qt::WA_DeleteOnClose, false);
            QVERIFY(textOf(dialog).contains(QStringLiteral("3.3 N"))); // 40 % of its maximum, 2.5 times
            buttonOf(dialog, QStringLiteral("Start the test"))->click();
            QVERIFY(!live.isRunning());
            PALPATE_TRY_VERIFY(textOf(dialog).startsWith(QStringLiteral("Put the handle into the middle")));
            keep(dialog, QStringLiteral("test"));
            dialog.reject(); // as Esc: stops the test, and keeps the dialog
            PALPATE_TRY_VERIFY(dialog.result().has_value());
            QCOMPARE(dialog.result()->stopped, servo::SelfTestStop::Cancelled);
            QVERIFY(textOf(dialog).startsWith(QStringLiteral("The test was stopped.")));
            QVERIFY(!buttonOf(dialog, QStringLiteral("Save the page…"))->isEnabled());
            QVERIFY(live.isRunning());
            buttonOf(dialog, QStringLiteral("Start the test"))->click();
            QVERIFY(!live.isRunning());
        }
        QVERIFY2(live.isRunning(), "the end of the dialog ends the test");
    }
};

PALPATE_TEST(DeviceTests)
#include "tst_DeviceTests.moc"
