// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/CameraFlight.h>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;

class CameraFlight : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void endsWhereItIsSent()
    {
        const core::ViewPose from{{0, -200, 0}, {0, 0, 0}, {0, 0, 1}, 30.0},
            to{{90, 0, 10}, {0, 0, 10}, {0, 0, 1}, 20.0};
        for (const auto& [share, end] : {std::pair(0.0, from), std::pair(1.0, to)}) {
            const core::ViewPose pose = ui::poseBetween(from, to, share);
            QVERIFY((pose.position_W - end.position_W).norm() < 1e-12);
            QVERIFY((pose.focus_W - end.focus_W).norm() < 1e-12);
            QVERIFY((pose.up_W - end.up_W).norm() < 1e-12);
            QCOMPARE(pose.viewAngle_deg, end.viewAngle_deg);
        }
    }

    void turnsAboutWhatItLooksAt()
    {
        const core::ViewPose from{{0, -200, 0}, {0, 0, 0}, {0, 0, 1}, 30.0},
            left{{200, 0, 0}, {0, 0, 0}, {0, 0, 1}, 30.0};
        const core::ViewPose half = ui::poseBetween(from, left, 0.5);
        QVERIFY((half.position_W - 200.0 * std::numbers::sqrt2 / 2.0 * Vec3(1, -1, 0)).norm() < 1e-9);
    }

    void passesByTheSideOnItsWayToTheBack_data()
    {
        QTest::addColumn<double>("aside_mm");
        QTest::newRow("opposite") << 0.0;
        QTest::newRow("opposite but for rounding") << 1e-14;
        QTest::newRow("opposite but for a wink") << 1e-6;
    }
    void passesByTheSideOnItsWayToTheBack()
    {
        QFETCH(double, aside_mm);
        const core::ViewPose front{{0, -200, 0}, {0, 0, 0}, {0, 0, 1}, 30.0};
        const core::ViewPose back{{0, 200, aside_mm}, {0, 0, 0}, {0, 0, 1}, 30.0};
        for (int step = 1; step < 10; ++step) {
            const core::ViewPose pose = ui::poseBetween(front, back, 0.1 * step);
            QVERIFY(std::abs(pose.position_W.norm() - 200.0) < 1e-9);
            QVERIFY(std::abs(pose.position_W.z()) < 1e-4); // neither over the head nor below the feet
            QVERIFY((pose.up_W - Vec3(0, 0, 1)).norm() < 1e-6);
        }
        QVERIFY(std::abs(std::abs(ui::poseBetween(front, back, 0.5).position_W.x()) - 200.0) < 1e-6);
    }
};

PALPATE_TEST(CameraFlight)
#include "tst_CameraFlight.moc"
