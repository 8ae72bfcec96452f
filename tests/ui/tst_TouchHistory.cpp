// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/TouchHistory.h>

using namespace palpate;

class TouchHistory : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void keepsTheLastTenSeconds()
    {
        ui::TouchHistory history;
        for (int i = 0; i <= 300; ++i) {
            history.add({0.1 * i, i == 150 ? 9.0 : 1.0, 2.0});
        }
        QVERIFY(history.samples().front().time_s >= 20.0 - 1e-9);
        QCOMPARE(history.samples().size(), std::size_t{101});
        QCOMPARE(history.peakForce_N(), 1.0); // the impact at 15 s has expired
        QCOMPARE(history.peakDepth_mm(), 2.0);
    }
    void tellsWhetherSomethingRubbed()
    {
        ui::TouchHistory history;
        history.add({1.0, 2.0, 1.0, {}, 1e-9}); // rounding
        QVERIFY(!history.hasFriction());
        history.add({1.1, 2.0, 1.0, {}, 0.3});
        QVERIFY(history.hasFriction());
        history.add({15.0, 2.0, 1.0, {}, 0.0});
        QVERIFY(!history.hasFriction());
    }
    void startsAnewWhenTimeRunsBackwards()
    {
        ui::TouchHistory history;
        history.add({8.0, 1.0, 1.0});
        history.add({2.0, 3.0, 1.0});
        QCOMPARE(history.samples().size(), std::size_t{1});
    }
    void axisEndsAtARoundNumber()
    {
        QCOMPARE(ui::axisTop(4.81), 5.0);
        QCOMPARE(ui::axisTop(5.0), 5.0);
        QCOMPARE(ui::axisTop(5.1), 10.0);
        QCOMPARE(ui::axisTop(0.013), 0.02);
        QCOMPARE(ui::axisTop(0.0), 1.0);
    }
};

PALPATE_TEST(TouchHistory)
#include "tst_TouchHistory.moc"
