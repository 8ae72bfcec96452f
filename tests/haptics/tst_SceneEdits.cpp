// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace palpate;
using namespace palpate::test;
using core::StatusCode;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;

namespace {

HapticStructure plate(double z_mm, const char* name)
{
    return {name, indexed(box({-10, -10, z_mm - 5}, {10, 10, z_mm})), {0.5, 0.0}, 0};
}

/// Returns the force of a press 1 mm into z = 0, without the 1e-11 mm of the skin.
double press_N(Palpator& palpator)
{
    (void)palpator.step({1, 2, 0.5}, 1e-3);
    return 1e-6 * std::round(1e6 * palpator.step({1, 2, -1.0}, 1e-3).f_W.norm());
}

} // namespace

class SceneEdits : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void refusesWhatCannotBeFelt()
    {
        const auto code = [](HapticStructure one, double fingertip_mm = 0.0) {
            return HapticScene::make({plate(0, "good"), std::move(one)}, fingertip_mm).status().code();
        };
        QCOMPARE(code(plate(0, "b")), StatusCode::Ok);
        for (const double stiffness : {-5.0, 1e300}) {
            HapticStructure one = plate(0, "b");
            one.tissue.stiffness_N_per_mm = stiffness;
            QCOMPARE(code(one), StatusCode::OutOfRange);
        }
        HapticStructure unknown = plate(0, "b");
        unknown.tissue.damping_Ns_per_mm = std::nan("");
        QCOMPARE(code(unknown), StatusCode::NonFinite);
        for (const double fingertip_mm : {-1.0, 1e9, std::nan("")}) {
            QCOMPARE(code(plate(0, "b"), fingertip_mm), StatusCode::OutOfRange);
        }
        HapticStructure none = plate(0, "liver");
        none.surface = nullptr;
        QCOMPARE(HapticScene::make({none}).status().message(),
                 std::string("structure 0 (liver): found no surface, expected at least one triangle"));
        none.surface = indexed({});
        QCOMPARE(code(none), StatusCode::Empty);
    }

    void editsMakeANewSceneThatSharesTheSurfaces()
    {
        const auto made = HapticScene::make({plate(0, "upper"), plate(-0.5, "lower")});
        QVERIFY(made.isOk());
        const auto& scene = made.value();
        const auto softer = scene->with(0, {0.2, 0.0});
        const auto hidden = softer.value()->without(0);
        QVERIFY(softer.isOk() && hidden.isOk());
        QCOMPARE(scene->structures()[0].tissue.stiffness_N_per_mm, 0.5);
        QCOMPARE(softer.value()->structures()[0].surface, scene->structures()[0].surface);

        Palpator palpator;
        palpator.setScene(scene);
        QCOMPARE(press_N(palpator), 0.5);
        palpator.setScene(softer.value());
        QCOMPARE(press_N(palpator), 0.2);
        palpator.setScene(hidden.value()); // number 1 keeps its number
        QCOMPARE(press_N(palpator), 0.25);
        QCOMPARE(palpator.step({1, 2, -1.0}, 1e-3).structure, 1);

        QCOMPARE(scene->with(2, {}).status().code(), StatusCode::OutOfRange);
        QCOMPARE(scene->without(2).status().code(), StatusCode::OutOfRange);
        QCOMPARE(scene->with(0, {-1.0, 0.0}).status().code(), StatusCode::OutOfRange);
    }

    /// The tissue's law replaces the table that the scene was built with.
    void withTakesTheLawOfTheTissue()
    {
        HapticStructure one = plate(0, "liver");
        one.tissue.law = core::usualLaw(core::LawKind::Exponential);
        const auto scene = HapticScene::make({one});
        QVERIFY(scene.value()->structures()[0].law != nullptr);
        const auto linear = scene.value()->with(0, {0.3, 0.0});
        Palpator palpator;
        palpator.setScene(linear.value());
        QCOMPARE(press_N(palpator), 0.3);
    }

    void setSceneSharesAndBorrowSceneDoesNot()
    {
        auto scene = HapticScene::make({plate(0, "a")}).value();
        const std::weak_ptr<const HapticScene> watch = scene;
        Palpator palpator;
        palpator.borrowScene(scene.get());
        QCOMPARE(watch.use_count(), 1L);
        palpator.setScene(std::move(scene));
        scene.reset();
        QVERIFY(!watch.expired()); // the Palpator shares it
        QCOMPARE(press_N(palpator), 0.5);
        palpator.setScene(nullptr);
        QVERIFY(watch.expired());
        QCOMPARE(press_N(palpator), 0.0);
    }
};

PALPATE_TEST(SceneEdits)
#include "tst_SceneEdits.moc"
