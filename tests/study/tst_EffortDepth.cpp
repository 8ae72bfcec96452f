// SPDX-License-Identifier: BSD-3-Clause
// Tests the depth of a press with a given force: the inverse of the surfaces' response.
#include "../support/Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>
#include <palpate/study/EffortDepth.h>
#include <palpate/ui/Effort.h>

#include <cmath>

using namespace palpate;
using core::Vec3;
using haptics::HapticStructure;
using study::PressedSurface;

namespace {

const view::Ray kDown{Vec3(0.3, 0.2, 2.0), Vec3(0, 0, -1)}; // 2 mm above a block whose top is z = 0

HapticStructure block(double stiffness_N_per_mm, double top_mm = 0.0, std::uint32_t layer = 0)
{
    HapticStructure one;
    one.surface = test::indexed(test::box(Vec3(-40, -40, top_mm - 80.0), Vec3(40, 40, top_mm), 4));
    one.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    one.layer = layer;
    return one;
}

/// Returns a uniform map.
haptics::TissueMap all(const geometry::SurfaceIndex& surface, float value)
{
    haptics::TissueMap map;
    map.corners = std::make_shared<const std::vector<std::array<float, 3>>>(surface.triangleCount(),
                                                                            std::array<float, 3>{value, value, value});
    return map;
}

/// Checks that force and depth are inverse functions and that depth rises with force.
bool isInverse(const std::vector<PressedSurface>& press, double most_N)
{
    double before_mm = study::pressTravel_mm(press, 0.0, 202.0);
    for (int i = 1; i <= 100; ++i) {
        const double force_N = most_N * i / 100.0;
        const double way_mm = study::pressTravel_mm(press, force_N, 202.0);
        if (!(way_mm > before_mm) || std::abs(study::pressForce_N(press, way_mm) - force_N) > 1e-9) {
            return false;
        }
        before_mm = way_mm;
    }
    return true;
}

} // namespace

class EffortDepth : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void aSpringGivesWayByForceOverStiffness()
    {
        const haptics::HapticScene scene({block(0.25)});
        const auto press = ui::surfacesAlongPress(scene, kDown);
        QCOMPARE(press.size(), std::size_t{1});
        QVERIFY(std::abs(study::pressTravel_mm(press, 3.0, 202.0) - (2.0 + 12.0)) < 1e-9);
        QVERIFY(isInverse(press, 10.0));
        QCOMPARE(study::pressTravel_mm(press, 0.0, 202.0), 2.0);  // contact without penetration
        QCOMPARE(study::pressTravel_mm(press, 10.0, 22.0), 22.0); // no contact: not beyond the limit
        QCOMPARE(study::pressTravel_mm({}, 10.0, 22.0), 22.0);    // no surface in the path
        QCOMPARE(study::pressForce_N(press, 1.0), 0.0);           // in front of the surface
    }
    void whatIsStifferSinksLess()
    {
        const haptics::HapticScene soft({block(0.2)}), stiff({block(0.2), block(0.6, -5.0, 1)});
        const auto aside = ui::surfacesAlongPress(soft, kDown), over = ui::surfacesAlongPress(stiff, kDown);
        QCOMPARE(over.size(), std::size_t{2});
        QVERIFY(isInverse(over, 10.0));
        // 3 N: 15 mm; over the inner block 0.2 d + 0.6 (d - 5) = 3.
        QVERIFY(std::abs(study::pressTravel_mm(aside, 3.0, 202.0) - 17.0) < 1e-9);
        QVERIFY(std::abs(study::pressTravel_mm(over, 3.0, 202.0) - (2.0 + 6.0 / 0.8)) < 1e-9);
    }
    /// Combines a force law, a stiffness map and transmitted lumps.
    void lawsAndMapsAreInIt()
    {
        HapticStructure one = block(0.2);
        one.tissue.law = core::usualLaw(core::LawKind::Exponential);
        one.maps.stiffness = all(*one.surface, 1.5F);
        const float felt[] = {1.0F, 1.2F, 1.6F, 2.5F};
        for (std::size_t j = 0; j < one.maps.felt.size(); ++j) {
            one.maps.felt[j] = all(*one.surface, felt[j]);
        }
        const haptics::HapticScene scene({one});
        const auto press = ui::surfacesAlongPress(scene, kDown);
        QVERIFY(isInverse(press, 10.0));
        const HapticStructure& made = scene.structures()[0];
        QVERIFY(made.law != nullptr);
        const auto isAt = [&](double depth_mm, double scale) {
            const double force_N = 1.5 * scale * made.lawAt(depth_mm).force_N;
            return force_N > 0.0 && std::abs(press[0].force_N(depth_mm) - force_N) < 1e-6 * force_N;
        };
        QVERIFY(isAt(1.0, 1.1) && isAt(2.0, 1.2) && isAt(3.0, 1.4) && isAt(6.0, 2.05) && isAt(20.0, 2.5));
    }
    /// The predicted force equals the force from the god-object in the same scene.
    void theHandThenFeelsThatForce()
    {
        HapticStructure mapped = block(0.2);
        mapped.maps.stiffness = all(*mapped.surface, 1.5F);
        for (std::size_t j = 0; j < mapped.maps.felt.size(); ++j) {
            mapped.maps.felt[j] = all(*mapped.surface, 1.0F + 0.3F * static_cast<float>(j));
        }
        for (const double fingertip_mm : {0.0, 5.0}) {
            const haptics::HapticScene scene({mapped, block(0.6, -5.0, 1)}, fingertip_mm);
            const view::Ray slanted{Vec3(0.3, 0.2, 12.0), Vec3(0.3, 0.1, -1).normalized()};
            const auto press = ui::surfacesAlongPress(scene, slanted);
            const double way_mm = study::pressTravel_mm(press, 4.0, 202.0);
            haptics::Palpator palpator;
            palpator.borrowScene(&scene);
            haptics::TickResult felt;
            for (int i = 0; i <= 2000; ++i) {
                felt = palpator.step(slanted.p_W + std::min(1.0, i / 1000.0) * way_mm * slanted.d_W, 1e-3);
            }
            QVERIFY2(std::abs(felt.f_W.norm() - 4.0) < 1e-3, qPrintable(QString::number(felt.f_W.norm())));
        }
    }
    void fromInsideNothingIsInTheWay()
    {
        const haptics::HapticScene scene({block(0.2)});
        QVERIFY(ui::surfacesAlongPress(scene, {Vec3(0, 0, -10), Vec3(0, 0, -1)}).empty());
        QVERIFY(ui::surfacesAlongPress(scene, {Vec3(0, 0, 10), Vec3(0, 0, 1)}).empty());
        QVERIFY(ui::surfacesAlongPress(haptics::HapticScene({}), kDown).empty());
    }
    void theLongerTheHarderUpToABound()
    {
        ui::Effort effort;
        QCOMPARE(effort.force_N(9.0), 0.0);
        effort.setMost(3.0);
        effort.begin(10.0);
        QCOMPARE(effort.force_N(9.9), 0.0);
        QCOMPARE(effort.force_N(12.0), 2.0);
        QCOMPARE(effort.force_N(20.0), 3.0);
        effort.setShare(0.5); // share of the force bound
        QCOMPARE(effort.force_N(20.0), 1.5);
        effort.setShare(7.0);
        QCOMPARE(effort.force_N(20.0), 3.0);
        effort.end();
        QCOMPARE(effort.force_N(20.0), 0.0);
        effort.begin(30.0); // pen lifted: the force ramps over time again
        QCOMPARE(effort.force_N(31.0), 1.0);
        QVERIFY(effort.turn(2.0));
        QCOMPARE(effort.most_N(), 4.0);
        QVERIFY(!effort.turn(100.0));
        QCOMPARE(effort.most_N(), 10.0);
        effort.setMost(std::nan(""));
        QVERIFY(effort.most_N() == ui::Effort::kUsual_N);
    }
};

PALPATE_TEST(EffortDepth)
#include "tst_EffortDepth.moc"
