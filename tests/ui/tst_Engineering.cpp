// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/EngineeringPanel.h>
#include <palpate/ui/LiveTouch.h>

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace palpate;
using ui::EngineeringReading;

/// Tests the engineering panel, and the short status for all other users.
class Engineering : public QObject
{
    Q_OBJECT

    static bool says(const QWidget& panel, const char* text)
    {
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* one) { return one->text() == QString::fromUtf8(text); });
    }

    static EngineeringReading good()
    {
        EngineeringReading reading;
        reading.isRunning = true;
        reading.hasMotors = true;
        reading.rate_Hz = 2000.0;
        reading.measured_Hz = 1990.0;
        reading.realtime.isRealtime = true;
        return reading;
    }

  private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void eachNumberHasItsUnit()
    {
        EngineeringReading reading = good();
        reading.constraints = 2;
        reading.delayTicks = 3;
        reading.energy_mJ = 2.69;
        reading.damping_N = 0.25;
        reading.dropped = 4;
        reading.timing.ticks = 6752;
        reading.timing.overruns = 6;
        reading.timing.skipped = 7;
        reading.timing.solve = {100, 900, 3300, 0, 0};
        reading.timing.periodError.p999_ns = 997'000;
        reading.roundTrip = {10, 1'250'000, 1'530'000, 0, 0};
        reading.reports = 500;
        reading.refused = 1;
        ui::EngineeringPanel panel;
        panel.show(reading);
        for (const char* text :
             {"2", "median 0.9 µs, 99 % below 3.3 µs", "1.99 kHz", "99.9 % below 997 µs", "6 of 6752, 7 skipped", "4",
              "2.69 mJ", "0.25 N", "1.5 ms", "median 1.25 ms, 99 % below 1.53 ms", "500, 1 rejected, 0 dropouts"}) {
            QVERIFY2(says(panel, text), text);
        }
        reading.hasMotors = false;
        panel.show(reading);
        QVERIFY(!says(panel, "2.69 mJ"));
    }

    void whatThePanelIsToldIsNotToldBack()
    {
        ui::EngineeringPanel panel;
        QSignalSpy chosen(&panel, &ui::EngineeringPanel::loopChosen);
        panel.show(good());
        auto* rate = panel.findChildren<QComboBox*>().front();
        QCOMPARE(rate->currentData().toInt(), 2);
        QCOMPARE(chosen.count(), 0);
        rate->setCurrentIndex(2);
        Q_EMIT rate->activated(2);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.first(), (QVariantList{4, -1}));
    }

    void oneSentenceSaysWhetherItRunsWell()
    {
        EngineeringReading reading;
        QCOMPARE(ui::runningState(reading).text, QString());
        reading = good();
        QVERIFY(ui::runningState(reading).isWell);
        QCOMPARE(ui::runningState(reading).text, QStringLiteral("running well"));
        reading.measured_Hz = 0.0; // the first half second
        QVERIFY(ui::runningState(reading).isWell);
        reading.measured_Hz = 1880.0;
        QVERIFY(!ui::runningState(reading).isWell);
        QCOMPARE(ui::runningState(reading).text, QStringLiteral("computer too busy"));
        QVERIFY(ui::runningState(reading).tip.contains(QStringLiteral("1880 updates per second instead of 2000")));
        reading = good();
        reading.realtime.isRealtime = false;
        QCOMPARE(ui::runningState(reading).text, QStringLiteral("force may stutter"));
        reading.hasMotors = false; // a device without force output
        QVERIFY(ui::runningState(reading).isWell);
    }

    void itReadsTheLoopThatRuns()
    {
        ui::StructureModel model;
        ui::LiveTouch live(model);
        QVERIFY(!ui::engineeringReading(live, {}).isRunning);
        QVERIFY(live.start().isOk());
        ui::TouchReading shown;
        shown.constraints = 3;
        PALPATE_TRY_VERIFY(ui::engineeringReading(live, shown).measured_Hz > 0.0);
        const EngineeringReading reading = ui::engineeringReading(live, shown);
        QVERIFY(reading.isRunning && !reading.hasMotors);
        QCOMPARE(reading.constraints, 3);
        QCOMPARE(reading.rate_Hz, 1000.0);
        QVERIFY(reading.timing.ticks > 0);
        QVERIFY(!reading.realtime.items.empty());
    }
};

PALPATE_TEST(Engineering)
#include "tst_Engineering.moc"
