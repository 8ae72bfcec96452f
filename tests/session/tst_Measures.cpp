// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/session/Measures.h>

using namespace palpate;

class Measures : public QObject
{
    Q_OBJECT

    static servo::TickRecord tick(int number, double hip_z, double god_z, double force_z)
    {
        servo::TickRecord record;
        record.tick = number;
        record.p_WH = core::Vec3(0, 0, hip_z);
        record.p_WG = core::Vec3(0, 0, god_z);
        record.f_W = core::Vec3(0, 0, force_z);
        record.structure = force_z > 0.0 ? 0 : -1;
        return record;
    }

  private slots:
    /// Down 1 mm a tick from 2 mm above to 3 mm below a plane at 0, with 0.5 N/mm: worked out by hand.
    void agreeWithASessionWorkedOutByHand()
    {
        session::MeasureAccumulator measures(1e-3);
        for (int i = 0; i < 6; ++i) {
            const double z = 2.0 - i;
            measures.add(tick(i, z, std::max(z, 0.0), 0.5 * std::max(-z, 0.0)), z < 0.0 ? "liver" : "");
        }
        const session::Measures m = measures.result();
        QCOMPARE(m.ticks, std::int64_t{6});
        QCOMPARE(m.contactTicks, std::int64_t{3});
        QCOMPARE(m.duration_s, 6e-3);
        QCOMPARE(m.contactTime_s, 3e-3);
        QCOMPARE(m.pathLength_mm, 5.0);
        QCOMPARE(m.contactPath_mm, 0.0);
        QCOMPARE(m.peakForce_N, 1.5);
        QCOMPARE(m.meanForce_N, 1.0);
        QCOMPARE(m.p95Force_N, 1.5);
        QCOMPARE(m.peakDepth_mm, 3.0);
        QCOMPARE(m.structures.size(), std::size_t{1});
        QCOMPARE(m.structures.begin()->first, std::string("liver"));
        QCOMPARE(m.structures.begin()->second.contactTime_s, 3e-3);
        QCOMPARE(m.structures.begin()->second.meanForce_N, 1.0);
    }

    void doNotCountMovesAcrossALoss()
    {
        session::MeasureAccumulator measures(1e-3);
        measures.add(tick(0, 0, 0, 0), "");
        measures.add(tick(5, 100, 100, 0), ""); // 4 ticks are missing
        servo::TickRecord reset = tick(6, 200, 200, 0);
        reset.flags = servo::kReset;
        measures.add(reset, "");
        measures.add(tick(7, 201, 201, 0), "");
        QCOMPARE(measures.result().pathLength_mm, 1.0);
    }

    void takeThePercentileByNearestRank()
    {
        session::MeasureAccumulator measures(1e-3);
        for (int i = 1; i <= 100; ++i) {
            measures.add(tick(i, -1, 0, i), "a");
        }
        QCOMPARE(measures.result().p95Force_N, 95.0);
    }

    void ofNothingAreZero()
    {
        const session::Measures m = session::MeasureAccumulator(1e-3).result();
        QCOMPARE(m.ticks, std::int64_t{0});
        QCOMPARE(m.p95Force_N, 0.0);
    }
};

PALPATE_TEST(Measures)
#include "tst_Measures.moc"
