// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/FeltLayers.h>

#include <QTest>

using namespace palpate;
using core::Vec3;

/// What the cursor is told of a tick.
class FeltLayers : public QObject
{
    Q_OBJECT

    static servo::TickRecord touching()
    {
        servo::TickRecord tick;
        tick.p_WH = Vec3(0, 0, -3);
        tick.felt.structure = 0;
        tick.felt.n_W = Vec3::UnitZ();
        return tick;
    }
    static bool bends(double stiffness_N_per_mm)
    {
        core::Tissue tissue;
        tissue.stiffness_N_per_mm = stiffness_N_per_mm;
        return ui::touchState(touching(), Vec3::Zero(), 0.0, {}, &tissue).bends;
    }

  private Q_SLOTS:
    void softTissueBendsAndBoneDoesNot()
    {
        QVERIFY(bends(0.2));
        QVERIFY(bends(2.0));
        QVERIFY(!bends(2.01));
        QVERIFY(!ui::touchState(touching(), Vec3::Zero(), 0.0, {}, nullptr).bends); // of what it is nobody says
    }
};

PALPATE_TEST(FeltLayers)
#include "tst_FeltLayers.moc"
