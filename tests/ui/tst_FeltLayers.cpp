// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/FeltLayers.h>

#include <QTest>

using namespace palpate;
using core::Vec3;

/// Tests the tick data for the cursor.
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
    /// A map, a transmitted lump and a lump as a layer: each as a ratio to the outermost tissue.
    void stiffnessIsToldByThatOfTheOutermostTissue()
    {
        core::Tissue liver, lump;
        liver.stiffness_N_per_mm = 0.2;
        lump.stiffness_N_per_mm = 0.6;
        const auto tissueOf = [&](std::uint32_t number) -> const core::Tissue* {
            return number == 0 ? &liver : number == 1 ? &lump : nullptr;
        };
        servo::TickRecord tick = touching();
        QCOMPARE(ui::contactStiffness(tick, tissueOf).ratio, 1.0); // no contact
        tick.felt.contactCount = 1;
        tick.felt.contacts[0].structure = tick.felt.contacts[0].layer = 0;
        tick.felt.contacts[0].depth_mm = 3.0;
        tick.felt.contacts[0].stiffnessScale = 1.5;
        QCOMPARE(ui::contactStiffness(tick, tissueOf).whole_N_per_mm, 1.5 * 0.2);
        QCOMPARE(ui::contactStiffness(tick, tissueOf).ratio, 1.5);
        tick.felt.contactCount = 2;
        tick.felt.contacts[1].structure = tick.felt.contacts[1].layer = 1;
        tick.felt.contacts[1].depth_mm = 1.0;
        tick.felt.contacts[1].stiffnessScale = 1.0;
        QCOMPARE(ui::contactStiffness(tick, tissueOf).ratio, (1.5 * 0.2 + 0.6) / 0.2);
        tick.felt.contacts[1].layer = 0; // beside the liver, not below: the liver has the larger force
        QCOMPARE(ui::contactStiffness(tick, tissueOf).ratio, 1.5);
        tick.felt.contacts[1].layer = 1;
        tick.felt.contacts[0].structure = 7; // a structure with unknown tissue
        QCOMPARE(ui::contactStiffness(tick, tissueOf).ratio, 1.0);
    }
    void softTissueBendsAndBoneDoesNot()
    {
        QVERIFY(bends(0.2));
        QVERIFY(bends(2.0));
        QVERIFY(!bends(2.01));
        QVERIFY(!ui::touchState(touching(), Vec3::Zero(), 0.0, {}, nullptr).bends); // without tissue information
    }
};

PALPATE_TEST(FeltLayers)
#include "tst_FeltLayers.moc"
