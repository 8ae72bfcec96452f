// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/Transport.h>

#include <limits>

using namespace palpate;

class Transport : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void nothingPlaysWithoutARecording()
    {
        ui::Transport transport;
        transport.play();
        QVERIFY(!transport.isPlaying());
    }
    void timePassesAtItsSpeed()
    {
        ui::Transport transport;
        transport.setDuration(20.0);
        QVERIFY(!transport.advance(1.0)); // paused
        QCOMPARE(transport.position_s(), 0.0);
        transport.play();
        transport.setSpeed(0.25);
        QVERIFY(!transport.advance(4.0));
        QCOMPARE(transport.position_s(), 1.0);
        transport.setSpeed(-3.0); // invalid speed: unchanged
        QVERIFY(!transport.advance(4.0));
        QCOMPARE(transport.position_s(), 2.0);
    }
    void pausesAtTheEndAndStartsAgain()
    {
        ui::Transport transport;
        transport.setDuration(2.0);
        transport.play();
        QVERIFY(transport.advance(5.0));
        QCOMPARE(transport.position_s(), 2.0);
        QVERIFY(!transport.isPlaying());
        transport.play();
        QCOMPARE(transport.position_s(), 0.0);
        QVERIFY(transport.isPlaying());
    }
    void seekStaysInside()
    {
        ui::Transport transport;
        transport.setDuration(2.0);
        transport.seek(9.0);
        QCOMPARE(transport.position_s(), 2.0);
        transport.seek(-1.0);
        QCOMPARE(transport.position_s(), 0.0);
        transport.seek(1.0);
        transport.seek(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(transport.position_s(), 1.0);
    }
    void clockReadsInMinutes()
    {
        QLocale::setDefault(QLocale::c());
        QCOMPARE(ui::clockText(0.0), QStringLiteral("00:00.0"));
        QCOMPARE(ui::clockText(62.34), QStringLiteral("01:02.3"));
        QCOMPARE(ui::clockText(59.94), QStringLiteral("00:59.9"));
        QCOMPARE(ui::clockText(59.999), QStringLiteral("01:00.0"));
        QCOMPARE(ui::clockText(12.977), QStringLiteral("00:13.0"));
        QCOMPARE(ui::clockText(-1.0), QStringLiteral("00:00.0"));
    }
    void timelineSeeksWhereItIsClicked()
    {
        ui::SessionPanel panel;
        panel.resize(700, 120);
        panel.transport().setDuration(20.0);
        panel.timeline().setPeaks(std::vector<float>(100, 1.0f), 20.0);
        panel.show();
        QSignalSpy sought(&panel, &ui::SessionPanel::sought);
        const auto click = [&panel](int x) {
            QTest::mouseClick(&panel.timeline(), Qt::LeftButton, {}, QPoint(x, 10));
            return panel.transport().position_s();
        };
        const int width = panel.timeline().width();
        QCOMPARE(click(0), 0.0); // on the force axis
        QCOMPARE(sought.count(), 1);
        const double half_s = click(width / 2), most_s = click(3 * width / 4), all_s = click(width - 1);
        QVERIFY(all_s > 19.9);
        QVERIFY(half_s > 9.0 && half_s < 10.0); // the axis takes a little of the width
        QVERIFY(std::abs((all_s - most_s) - (most_s - half_s)) < 0.1);
        QTest::keyClick(&panel.timeline(), Qt::Key_End);
        QCOMPARE(panel.transport().position_s(), 20.0);
    }
    void growingRecordingCannotBeSought()
    {
        ui::SessionPanel panel;
        panel.show();
        panel.timeline().addLive(0.01, 1.0);
        panel.timeline().addLive(3.0, 2.0);
        QVERIFY(std::abs(panel.timeline().duration_s() - 3.05) < 1e-9);
        QSignalSpy sought(&panel, &ui::SessionPanel::sought);
        QTest::mouseClick(&panel.timeline(), Qt::LeftButton, {}, QPoint(5, 5));
        QCOMPARE(sought.count(), 0);
    }
};

PALPATE_TEST(Transport)
#include "tst_Transport.moc"
