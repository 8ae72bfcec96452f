// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/evaluation/Shapes.h>
#include <palpate/evaluation/Stability.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/servo/PassivityController.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace palpate::evaluation::stability;
using palpate::device::DevicePreset;
using palpate::device::devicePresets;
using palpate::device::findDevicePreset;

namespace {

constexpr double kSearch = 1.04; ///< precision of `largestStiffness`

Setup setupOf(const DevicePreset& preset, bool isControlled = true)
{
    Setup setup;
    setup.preset = preset;
    setup.isControlled = isControlled;
    return setup;
}

const std::vector<Shape>& touchedShapes()
{
    static const std::vector<Shape> kShapes = standardShapes();
    return kShapes;
}

/// A wall with a map that rises from one half to one between two lines of triangles.
/// @param isRound  as an S on triangles of 0.5 mm; else straight between its two corners
Shape stepOver(double width_mm, bool isRound)
{
    using palpate::core::Vec3;
    const int cells = isRound ? 120 : 6;
    const double cell_mm = 60.0 / cells;
    auto box = palpate::evaluation::shapes::box(Vec3(-30, -30, -30), Vec3(30, 30, 0), cells);
    if (!isRound) { // moves the line at 10 mm to the end of the step, and the further lines by the same distance
        for (Vec3& v : box.vertices) {
            v.x() = v.x() < 0.5 * cell_mm ? v.x() : width_mm + (v.x() - cell_mm) * (30.0 - width_mm) / (30.0 - cell_mm);
        }
    }
    const auto mesh = palpate::geometry::repair(box);
    auto surface =
        std::make_shared<const palpate::geometry::SurfaceIndex>(palpate::geometry::SurfaceIndex::build(mesh));
    std::vector<float> values;
    for (const Vec3& v : mesh.mesh.vertices) {
        const double t = std::clamp(v.x() / width_mm, 0.0, 1.0);
        values.push_back(static_cast<float>(0.5 + 0.5 * (isRound ? t * t * (3.0 - 2.0 * t) : t)));
    }
    palpate::haptics::HapticStructure wall;
    wall.name = "wall";
    wall.maps.stiffness = palpate::haptics::TissueMap::atVertices(*surface, mesh, values);
    wall.surface = std::move(surface);
    Shape shape;
    shape.structures = {std::move(wall)};
    shape.share = {1.0};
    for (const double share : {0.1, 0.5, 0.9}) {
        shape.holds.push_back({Vec3(share * width_mm, 0.2, 0), -Vec3::UnitZ(), Vec3::Zero()});
    }
    return shape;
}

/// The same rise by lumps that are felt below instead of by a map, from 1 to 2 where the hand presses deep.
/// @param light  fraction at the lightest press
Shape lumpsOver(double width_mm, bool isRound, double light)
{
    Shape shape = stepOver(width_mm, isRound);
    palpate::haptics::TissueMaps& maps = shape.structures[0].maps;
    for (std::size_t j = 0; j < maps.felt.size(); ++j) {
        const double share = std::min(1.0, light + (1.0 - light) * palpate::haptics::kFeltPress_mm[j] / 4.0);
        auto corners = *maps.stiffness.corners; // 0.5 to 1
        for (auto& at : corners) {
            for (float& value : at) {
                value = static_cast<float>(1.0 + share * (2.0 * double{value} - 1.0));
            }
        }
        maps.felt[j].corners = std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners));
    }
    maps.stiffness = {};
    return shape;
}

/// The same rise by a number per triangle: a step, at x = 0.
Shape stepsAtTriangles(double low, double high)
{
    Shape shape = stepOver(5.0, false);
    palpate::haptics::HapticStructure& wall = shape.structures[0];
    std::vector<std::array<float, 3>> corners;
    for (std::uint32_t i = 0; i < wall.surface->triangleCount(); ++i) {
        const palpate::geometry::Triangle t = wall.surface->triangle(i);
        const double x =
            wall.surface->vertex(t[0]).x() + wall.surface->vertex(t[1]).x() + wall.surface->vertex(t[2]).x();
        const auto s = static_cast<float>(x < 0.0 ? low : high);
        corners.push_back({s, s, s});
    }
    wall.maps.stiffness.corners = std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners));
    using palpate::core::Vec3;
    shape.holds.clear();
    for (const double x : {-0.3, -0.05, 0.05, 0.3}) {
        shape.holds.push_back({Vec3(x, 0.2, 0), -Vec3::UnitZ(), Vec3::Zero()});
    }
    for (const double x : {-5.0, 5.0}) {
        shape.holds.push_back({Vec3(0.02, 0.2, 0), -Vec3::UnitZ(), Vec3(x, 0, 0)});
    }
    return shape;
}

/// Returns the largest stable stiffness of the plain wall, to the precision of the search; searched once per setup of a
/// preset as built. [N/mm]
double wallStiffness(const char* id, bool isControlled)
{
    static std::map<std::pair<std::string, bool>, double> found;
    const auto [at, isNew] = found.emplace(std::pair(std::string(id), isControlled), 0.0);
    if (isNew) {
        at->second = largestStiffness(touchedShapes()[0], setupOf(*findDevicePreset(id), isControlled));
    }
    return at->second;
}

palpate::haptics::HapticScene sceneAt(const Shape& shape, double stiffness_N_per_mm)
{
    auto structures = shape.structures;
    structures[0].tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    return palpate::haptics::HapticScene(std::move(structures));
}

} // namespace

class Stability : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void everyPresetHoldsItsStatedStiffnessOnEveryShape_data()
    {
        QTest::addColumn<QByteArray>("id");
        for (const DevicePreset& preset : devicePresets()) {
            QTest::newRow(preset.id.data()) << QByteArray(preset.id.data());
        }
    }
    void everyPresetHoldsItsStatedStiffnessOnEveryShape()
    {
        QFETCH(QByteArray, id);
        const Setup setup = setupOf(*findDevicePreset(id.constData()));
        for (const Shape& shape : touchedShapes()) {
            const double moved = restOscillation_mm(shape, setup.preset.maxStiffness_N_per_mm, setup);
            QVERIFY2(moved < kLimitCycle_mm, qPrintable(QString("%1: %2 mm").arg(shape.name.c_str()).arg(moved)));
        }
    }

    /// The stiffness that the window permits is stable at every rate and delay of the device.
    void whatTheWindowAllowsIsHeld_data() { everyPresetHoldsItsStatedStiffnessOnEveryShape_data(); }
    void whatTheWindowAllowsIsHeld()
    {
        QFETCH(QByteArray, id);
        Setup setup = setupOf(*findDevicePreset(id.constData()));
        const auto isHeld = [&setup](std::initializer_list<std::size_t> which) {
            const double held = palpate::servo::heldStiffness_N_per_mm(
                palpate::device::deviceInfo(setup.preset), setup.rate_Hz, setup.isControlled, setup.delayTicks);
            for (const std::size_t n : which) {
                const double moved = restOscillation_mm(touchedShapes()[n], held, setup);
                QVERIFY2(moved < kLimitCycle_mm, qPrintable(QString("%1: %2 N/mm at %3 Hz, %4 ticks late: %5 mm")
                                                                .arg(touchedShapes()[n].name.c_str())
                                                                .arg(held)
                                                                .arg(setup.rate_Hz)
                                                                .arg(setup.delayTicks)
                                                                .arg(moved)));
            }
        };
        for (const double rate : {250.0, 500.0, 1000.0, 2000.0, 4000.0}) {
            setup.rate_Hz = rate;
            for (const int delay : {1, 2, 4}) {
                setup.delayTicks = delay;
                setup.isControlled = true;
                isHeld({0});
            }
            setup.isControlled = false;
            isHeld({0});
        }
        // As most devices on USB are.
        setup.rate_Hz = 1000.0;
        setup.delayTicks = 2;
        setup.isControlled = true;
        isHeld({0, 1, 2, 3, 4, 5, 6, 7, 8});
        // A sensor twice as coarse.
        setup.delayTicks = 1;
        setup.preset.mechanics.resolution_mm *= 2.0;
        isHeld({0});
    }

    /// A conservative map and friction do not reduce the stable stiffness.
    void aMapAndFrictionHoldNoLessThanTheWall_data()
    {
        QTest::addColumn<QByteArray>("id");
        for (const char* id : {"touch", "omega", "woodenhaptics"}) {
            QTest::newRow(id) << QByteArray(id);
        }
    }
    void aMapAndFrictionHoldNoLessThanTheWall()
    {
        QFETCH(QByteArray, id);
        for (const bool isControlled : {false, true}) {
            const Setup setup = setupOf(*findDevicePreset(id.constData()), isControlled);
            const double wall = wallStiffness(id.constData(), isControlled);
            for (const double stiffness : {0.25 * wall, 0.5 * wall, wall / kSearch}) {
                for (const std::size_t n : {7, 8}) {
                    const double moved = restOscillation_mm(touchedShapes()[n], stiffness, setup);
                    QVERIFY2(moved < kLimitCycle_mm, qPrintable(QString("%1%2: %3 mm at %4 N/mm, the wall holds %5")
                                                                    .arg(touchedShapes()[n].name.c_str())
                                                                    .arg(isControlled ? ", controlled" : "")
                                                                    .arg(moved)
                                                                    .arg(stiffness)
                                                                    .arg(wall)));
                }
            }
        }
    }

    /// The formula for a map's edge predicts the behaviour of the loop: above the bound the loop oscillates by about
    /// the predicted amplitude; below it, it rests.
    void aMapsEdgeSwingsAsFar_data()
    {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<double>("width_mm");
        QTest::addColumn<bool>("isRound");
        for (const char* id : {"omega", "woodenhaptics"}) {
            for (const double width_mm : {2.0, 5.0, 20.0}) {
                for (const bool isRound : {false, true}) {
                    QTest::newRow(
                        qPrintable(QString("%1, %2 mm%3").arg(id).arg(width_mm).arg(isRound ? ", round" : "")))
                        << QByteArray(id) << width_mm << isRound;
                }
            }
        }
    }
    void aMapsEdgeSwingsAsFar()
    {
        QFETCH(QByteArray, id);
        QFETCH(double, width_mm);
        QFETCH(bool, isRound);
        constexpr double kTissue_N_per_mm = 0.2;
        const Shape shape = stepOver(width_mm, isRound);
        for (const bool isControlled : {false, true}) {
            const Setup setup = setupOf(*findDevicePreset(id.constData()), isControlled);
            const auto edge = worstMapEdge(sceneAt(shape, kTissue_N_per_mm), setup);
            QVERIFY(edge && edge->structure == 0 && edge->jump_N > 0.0);
            if (!isRound) { // at the foot of the rise
                QVERIFY2(std::abs(edge->p_W.x()) < 1e-9, qPrintable(QString::number(edge->p_W.x())));
            }
            const double moved = restOscillation_mm(shape, kTissue_N_per_mm, setup);
            const QString both = QString("said %1 mm, moved %2 mm").arg(edge->swing_mm).arg(moved);
            if (edge->swing_mm < kLimitCycle_mm) {
                QVERIFY2(moved < kLimitCycle_mm, qPrintable(both));
            }
            if (moved > 0.1) { // motion that is large beside a count of the sensors
                QVERIFY2(edge->swing_mm > 0.4 * moved, qPrintable(both));
            }
        }
    }

    /// Transmitted lumps cause lateral forces like a map, by their effect on the law at the depth of the resting hand.
    void lumpsFeltBelowSwingAsFar_data()
    {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<double>("width_mm");
        QTest::addColumn<bool>("isRound");
        QTest::addColumn<double>("light");
        for (const char* id : {"omega", "woodenhaptics"}) {
            for (const double width_mm : {2.0, 10.0}) {
                for (const bool isRound : {false, true}) {
                    for (const double light : {0.2, 1.0}) {
                        QTest::newRow(qPrintable(QString("%1, %2 mm%3, light %4")
                                                     .arg(id)
                                                     .arg(width_mm)
                                                     .arg(isRound ? ", round" : "")
                                                     .arg(light)))
                            << QByteArray(id) << width_mm << isRound << light;
                    }
                }
            }
        }
    }
    void lumpsFeltBelowSwingAsFar()
    {
        QFETCH(QByteArray, id);
        QFETCH(double, width_mm);
        QFETCH(bool, isRound);
        QFETCH(double, light);
        constexpr double kTissue_N_per_mm = 0.2;
        const Shape shape = lumpsOver(width_mm, isRound, light);
        for (const bool isControlled : {false, true}) {
            const Setup setup = setupOf(*findDevicePreset(id.constData()), isControlled);
            const auto edge = worstMapEdge(sceneAt(shape, kTissue_N_per_mm), setup);
            QVERIFY(edge && edge->isOfLumps && edge->jump_N > 0.0);
            if (light == 1.0) { // as a map of the same numbers
                Shape mapped = stepOver(width_mm, isRound);
                mapped.structures[0].maps.stiffness = shape.structures[0].maps.felt[0];
                const auto same = worstMapEdge(sceneAt(mapped, kTissue_N_per_mm), setup);
                QVERIFY(same && !same->isOfLumps && std::abs(edge->jump_N / same->jump_N - 1.0) < 1e-9);
                continue; // how far the loop swings there, `aMapsEdgeSwingsAsFar` shows
            }
            const double moved = restOscillation_mm(shape, kTissue_N_per_mm, setup);
            const QString both = QString("said %1 mm, moved %2 mm").arg(edge->swing_mm).arg(moved);
            if (edge->swing_mm < kLimitCycle_mm) {
                QVERIFY2(moved < kLimitCycle_mm, qPrintable(both));
            }
            if (moved > 0.1) {
                QVERIFY2(edge->swing_mm > 0.4 * moved, qPrintable(both));
            }
        }
    }

    /// A number per triangle steps without a push aside: where a hand rests on the step it comes to rest, and nothing
    /// is reported.
    void aNumberPerTriangleKeepsNothingSwinging_data()
    {
        QTest::addColumn<QByteArray>("id");
        for (const char* id : {"touch", "omega", "woodenhaptics", "phantom-premium-1.5"}) {
            QTest::newRow(id) << QByteArray(id);
        }
    }
    void aNumberPerTriangleKeepsNothingSwinging()
    {
        QFETCH(QByteArray, id);
        for (const bool isControlled : {false, true}) {
            Setup setup = setupOf(*findDevicePreset(id.constData()), isControlled);
            setup.settle_s = 7.0; // a light grip rings for seconds, as does the step
            for (const double stiffness : {0.1, 0.4}) {
                const Shape shape = stepsAtTriangles(0.5, 1.0);
                QVERIFY(!worstMapEdge(sceneAt(shape, stiffness), setup));
                const double moved = restOscillation_mm(shape, stiffness, setup);
                QVERIFY2(moved < kLimitCycle_mm, qPrintable(QString::number(moved)));
            }
        }
    }

    /// Near the top of an S of 5 mm an arm is stable up to the stiffness of the wall, except for the effect of sensor
    /// counts on both: with counts of half the size the wall gains a step of the search sooner (measured: 0.82 of the
    /// wall), with a tenth the S permits more. The stated stiffness of the arm is stable by a wide margin.
    void aRoundStepHoldsWhatTheWallDoesButForTheSensor_data()
    {
        QTest::addColumn<double>("counts");
        QTest::addColumn<double>("share");
        QTest::newRow("as built") << 1.0 << 1.0;
        QTest::newRow("half the size") << 0.5 << 0.8;
        QTest::newRow("a tenth") << 0.1 << 1.0;
    }
    void aRoundStepHoldsWhatTheWallDoesButForTheSensor()
    {
        QFETCH(const double, counts);
        QFETCH(const double, share);
        Shape step = stepOver(5.0, true);
        step.holds.erase(step.holds.begin(), step.holds.begin() + 2); // at 0.9 of the height
        Setup setup = setupOf(*findDevicePreset("woodenhaptics"));
        setup.preset.mechanics.resolution_mm *= counts;
        const double wall =
            counts == 1.0 ? wallStiffness("woodenhaptics", true) : largestStiffness(touchedShapes()[0], setup);
        for (const double stiffness : {2.0 * setup.preset.maxStiffness_N_per_mm, share * wall / kSearch}) {
            const double moved = restOscillation_mm(step, stiffness, setup);
            QVERIFY2(moved < kLimitCycle_mm,
                     qPrintable(QString("%1 mm at %2 N/mm, the wall %3 N/mm").arg(moved).arg(stiffness).arg(wall)));
        }
    }

    void aWarningNamesStructureAndPlace()
    {
        Options options;
        options.presets = {*findDevicePreset("touch"), *findDevicePreset("omega")};
        const auto scene = sceneAt(stepOver(5.0, false), 0.2);
        const auto lines = mapWarnings(scene, options);
        QCOMPARE(lines.size(), std::size_t{1}); // a Touch, with more friction, rests there
        const QString line = QString::fromStdString(lines[0]);
        QVERIFY2(line.startsWith("wall: its map of stiffness bends too sharply for omega at (0.0, "), qPrintable(line));
        const auto edge = worstMapEdge(scene, setupOf(options.presets[1]));
        QVERIFY2(
            line.contains(QString("jumps by %1 N").arg(edge->jump_N, 0, 'f', 2)) &&
                line.contains(QString("swinging by %1 mm, expected less than 0.05;").arg(edge->swing_mm, 0, 'f', 2)),
            qPrintable(line));
        QVERIFY(mapWarnings(sceneAt(stepOver(20.0, true), 0.2), options).empty());
    }

    void aMapsEdgeIsNoneWithoutABend()
    {
        const Setup setup = setupOf(*findDevicePreset("omega"));
        Shape flat = stepOver(5.0, false);
        auto corners = *flat.structures[0].maps.stiffness.corners;
        for (auto& at : corners) {
            at = {0.7F, 0.7F, 0.7F};
        }
        flat.structures[0].maps.stiffness.corners =
            std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners));
        QVERIFY(!worstMapEdge(sceneAt(flat, 0.2), setup));
        Shape rough = stepOver(5.0, false);
        QVERIFY(worstMapEdge(sceneAt(rough, 0.2), setup));
        rough.structures[0].tissue.friction_static = rough.structures[0].tissue.friction_dynamic = 0.1;
        QVERIFY(!worstMapEdge(sceneAt(rough, 0.2), setup)); // takes the push
        QVERIFY(!worstMapEdge(sceneAt(touchedShapes().front(), 0.2), setup));
    }

    /// The omega's stated 5 N/mm oscillates at 1 kHz without the controller: the loop can, and this sees it.
    void withoutTheControllerAStiffWallOscillates()
    {
        QVERIFY(restOscillation_mm(touchedShapes().front(), 5.0, setupOf(*findDevicePreset("omega"), false)) > 1.0);
    }

    /// A mass with a damper, no friction and an exact sensor: K = (b + B) / (T/2 + delay), as Hulin found.
    void theLoopAgreesWithTheory_data()
    {
        QTest::addColumn<int>("delay");
        QTest::newRow("at once") << 0;
        QTest::newRow("one tick late") << 1;
        QTest::newRow("two ticks late") << 2;
    }
    void theLoopAgreesWithTheory()
    {
        QFETCH(int, delay);
        Setup setup = setupOf(*findDevicePreset("phantom-desktop"), false);
        setup.delayTicks = delay;
        setup.preset.mechanics.friction_N = 0.0;
        setup.preset.mechanics.resolution_mm = 0.0;
        const double b = setup.preset.mechanics.damping_Ns_per_mm + grips().front().damping_Ns_per_mm;
        const double bound = palpate::servo::stableStiffness_N_per_mm(b, 0.001, 0.001 * delay);
        // Nearer below it a motion dies out, but not within the second that it is given.
        QVERIFY(restOscillation_mm(touchedShapes().front(), 0.6 * bound, setup) < kLimitCycle_mm);
        QVERIFY(restOscillation_mm(touchedShapes().front(), 1.15 * bound, setup) > 0.5);
    }

    /// Down on the soft side, up on the stiff side: the border generates energy at any rate.
    void theBorderOfALumpOscillatesWithoutTheController()
    {
        const Shape& lump = touchedShapes()[4];
        QVERIFY(lump.structures.size() == 2);
        const DevicePreset& delta = *findDevicePreset("delta");
        QVERIFY(restOscillation_mm(lump, 1.0, setupOf(delta, false)) > 0.5);
        QVERIFY(restOscillation_mm(lump, 1.0, setupOf(delta)) < kLimitCycle_mm);
    }

    /// Layers add up: a stable stiffness oscillates through another layer of the same stiffness, unless the layers
    /// share it.
    void theLimitHoldsForTheSumOfTheLayers()
    {
        const Setup setup = setupOf(*findDevicePreset("omega"), false);
        const Shape& layers = touchedShapes()[6];
        QCOMPARE(layers.name, std::string("two layers"));
        const double held = wallStiffness("omega", false);
        QVERIFY(restOscillation_mm(layers, 0.8 * held, setup) < kLimitCycle_mm);
        Shape each = layers;
        each.share = {1.0, 1.0};
        QVERIFY(restOscillation_mm(each, 0.8 * held, setup) > kLimitCycle_mm);
    }

    /// A scene's tissues are scaled together: a soft one stays as much softer as it is.
    void aSceneKeepsTheProportionsOfItsStiffnesses()
    {
        using palpate::core::Vec3;
        std::vector<palpate::haptics::HapticStructure> structures(3, touchedShapes().front().structures.front());
        structures[0].tissue.stiffness_N_per_mm = 0.2;
        structures[1].tissue.stiffness_N_per_mm = 2.0;
        structures[1].layer = 1;
        structures[2].tissue.stiffness_N_per_mm = 8.0; // not felt
        structures[2].surface = nullptr;
        const Shape shape = shapeOf("unequal", palpate::haptics::HapticScene(structures));
        QCOMPARE(shape.own_N_per_mm, 2.0);
        QCOMPARE(shape.share[0], 0.1);
        QCOMPARE(shape.share[1], 1.0);
        // Both layers push at the same place: together they equal the wall alone.
        const Setup setup = setupOf(*findDevicePreset("touch"));
        const double wall = wallStiffness("touch", true);
        QVERIFY(restOscillation_mm(shape, 0.9 / 1.1 * wall, setup) < kLimitCycle_mm);
        QVERIFY(restOscillation_mm(shape, kSearch * wall, setup) >= kLimitCycle_mm);
    }

    void theControllerLeavesSoftTissueAlone()
    {
        for (const DevicePreset& preset : devicePresets()) {
            const Cost cost = controllerCost(touchedShapes().front(), 0.3, setupOf(preset));
            QVERIFY2(cost.mean_percent < 0.7, preset.id.data()); // a tenth of the perception threshold
        }
    }

    /// A hand that ends at rest in the air, slipped off or beside the surface, is not a limit cycle and does not hide a
    /// limit cycle.
    void aHandInTheAirCountsForNothing()
    {
        using palpate::core::Vec3;
        const Setup setup = setupOf(*findDevicePreset("omega"), false);
        const Shape& wall = touchedShapes().front();
        Shape beside = wall;
        beside.holds.push_back({Vec3(40, 0, 0), -Vec3::UnitZ(), Vec3::Zero()});
        QCOMPARE(restOscillation_mm(beside, 1.0, setup), restOscillation_mm(wall, 1.0, setup));
        QVERIFY(restOscillation_mm(beside, 5.0, setup) > kLimitCycle_mm);
        QCOMPARE(largestStiffness(beside, setup), wallStiffness("omega", false));
        beside.holds.erase(beside.holds.begin());
        QVERIFY(std::isinf(restOscillation_mm(beside, 1.0, setup)));
        QCOMPARE(largestStiffness(beside, setup), 0.0);
    }

    void givesTheSameBitsTwice()
    {
        const Setup setup = setupOf(*findDevicePreset("falcon"), false);
        const double a = restOscillation_mm(touchedShapes().front(), 4.0, setup);
        const double b = restOscillation_mm(touchedShapes().front(), 4.0, setup);
        QVERIFY(std::memcmp(&a, &b, sizeof a) == 0);
    }
};

PALPATE_TEST(Stability)
#include "tst_Stability.moc"
