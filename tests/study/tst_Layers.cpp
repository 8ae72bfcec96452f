// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/study/DeviceLimit.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>

#include <QTest>

#include <cmath>

using namespace palpate;
using core::Vec3;
using study::Layering;

class Layers : public QObject
{
    Q_OBJECT

    struct Part
    {
        std::string name;
        geometry::TriangleMesh mesh;
    };

    static meshio::LoadedScene sceneOf(const std::vector<Part>& parts)
    {
        meshio::LoadedScene scene;
        for (const Part& part : parts) {
            meshio::LoadedStructure& one = scene.structures.emplace_back();
            one.description.name = part.name;
            one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(part.mesh));
            scene.scene.structures.push_back(one.description);
        }
        return scene;
    }

    static Part ball(const char* name, double radius_mm, const Vec3& at = Vec3::Zero(), int n = 6)
    {
        return {name, test::moved(test::sphere(n, radius_mm), at)};
    }

    struct Found
    {
        std::vector<std::uint32_t> layers;
        std::vector<std::string> lines;
        std::size_t layerCount = 0;
    };
    static Found find(const std::vector<Part>& parts)
    {
        meshio::LoadedScene scene = sceneOf(parts);
        auto felt = study::hapticScene(scene);
        Found found;
        found.lines = test::english(study::setLayers(scene, felt));
        found.layerCount = felt->layerCount();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::uint32_t layer = scene.structures[i].description.layer;
            found.layers.push_back(layer);
            if (felt->structures()[i].layer != layer || scene.scene.structures[i].layer != layer) {
                qFatal("three places disagree about a layer");
            }
        }
        return found;
    }

    using Numbers = std::vector<std::uint32_t>;
    using Lines = std::vector<std::string>;

    static haptics::HapticStructure tissue(double k, double b, std::uint32_t layer)
    {
        static const auto surface = test::indexed(test::sphere(2, 10.0));
        haptics::HapticStructure out;
        out.surface = surface;
        out.tissue.stiffness_N_per_mm = k;
        out.tissue.damping_Ns_per_mm = b;
        out.layer = layer;
        return out;
    }

  private Q_SLOTS:
    void whatLiesInAnotherIsFeltBelowIt()
    {
        const Found found = find({ball("liver", 40.0), ball("tumour", 5.0, {20, 0, 0})});
        QCOMPARE(found.layers, (Numbers{0, 1}));
        QCOMPARE(found.lines, Lines{"tumour lies in liver and is felt below it"});
        QCOMPARE(found.layerCount, std::size_t{2});
    }

    void chainsGoDeeperInWhateverOrderTheyCome()
    {
        const Found found = find({ball("lump", 4.0, {20, 0, 0}), ball("skin", 100.0), ball("bone", 8.0, {-60, 0, 0}),
                                  ball("liver", 40.0, {10, 0, 0})});
        QCOMPARE(found.layers, (Numbers{2, 0, 1, 1}));
        QCOMPARE(found.lines,
                 (Lines{"lump lies in liver and is felt below it", "bone lies in skin and is felt below it",
                        "liver lies in skin and is felt below it"}));
    }

    void besideOrPokingOutIsNotInside()
    {
        // Bounding boxes overlap but surfaces do not; half outside; a rod with 5 % and 20 % outside.
        QCOMPARE(find({ball("liver", 40.0), ball("kidney", 10.0, Vec3::Constant(29.0))}).layers, (Numbers{0, 0}));
        QCOMPARE(find({ball("liver", 40.0), ball("cyst", 10.0, {40, 0, 0})}).layers, (Numbers{0, 0}));
        QVERIFY(find({ball("liver", 40.0), ball("cyst", 10.0, {40, 0, 0})}).lines.empty());
        const auto rod = [](double at_mm) {
            return Part{"vessel", test::transformed(test::sphere(8, 1.0), [at_mm](const Vec3& v) {
                            return Vec3(30.0 * v.x() + at_mm, 2.0 * v.y(), 2.0 * v.z());
                        })};
        };
        QCOMPARE(find({{"liver", test::box({-30, -30, -30}, {30, 30, 30})}, rod(3.0)}).layers, (Numbers{0, 1}));
        QCOMPARE(find({{"liver", test::box({-30, -30, -30}, {30, 30, 30})}, rod(12.0)}).layers, (Numbers{0, 0}));
        // The threshold is nine tenths: 8 % and 12 % outside.
        QCOMPARE(find({{"liver", test::box({-30, -30, -30}, {30, 30, 30})}, rod(4.8)}).layers, (Numbers{0, 1}));
        QCOMPARE(find({{"liver", test::box({-30, -30, -30}, {30, 30, 30})}, rod(7.2)}).layers, (Numbers{0, 0}));
    }

    void openVesselsLieInOrgansButNothingLiesInThem()
    {
        geometry::TriangleMesh open = test::sphere(8, 40.0);
        open.triangles.pop_back();
        const Found found = find({{"liver", open}, ball("tumour", 5.0, {20, 0, 0})});
        QCOMPARE(found.layers, (Numbers{0, 0}));
        QCOMPARE(found.lines, Lines{"tumour seems to lie in liver, whose surface is open or inside out: it is not felt "
                                    "below it"});
        geometry::TriangleMesh vessel = test::sphere(4, 5.0);
        vessel.triangles.pop_back();
        QCOMPARE(find({ball("liver", 40.0), {"vessel", vessel}}).layers, (Numbers{0, 1}));
    }

    void insideOutIsNotLayered()
    {
        geometry::TriangleMesh turned = test::sphere(8, 40.0);
        geometry::flip(turned);
        const Found found = find({{"liver", turned}, ball("tumour", 5.0, {20, 0, 0})});
        QCOMPARE(found.layers, (Numbers{0, 0}));
        QCOMPARE(found.lines.size(), std::size_t{1});
    }

    void theSameSurfaceTwiceIsInOneLayer()
    {
        Part again = ball("liver again", 40.0);
        std::reverse(again.mesh.triangles.begin(), again.mesh.triangles.end());
        const Found found = find({ball("liver", 40.0), ball("tumour", 5.0, {20, 0, 0}), again, ball("skin", 90.0)});
        QCOMPARE(found.layers, (Numbers{1, 2, 1, 0}));
        QCOMPARE(found.lines,
                 (Lines{"liver lies in skin and is felt below it", "tumour lies in liver and is felt below it",
                        "liver again and liver are the same surface twice"}));
    }

    void sixDeepTheLastAreMergedAndThatIsSaid()
    {
        std::vector<Part> parts;
        const char* const names[]{"a", "b", "c", "d", "e", "f"};
        for (int i = 0; i < 6; ++i) {
            parts.push_back(ball(names[i], 60.0 - 8.0 * i));
        }
        const Found found = find(parts);
        QCOMPARE(found.layers, (Numbers{0, 1, 2, 3, 3, 3}));
        QCOMPARE(found.layerCount, haptics::HapticScene::kMaxLayers);
        QCOMPARE(found.lines[2], std::string("d lies in c and is felt below it"));
        QCOMPARE(found.lines[3],
                 std::string("e lies in d, which is felt in the last of 4 layers: both are felt in that one"));
        QCOMPARE(found.lines.size(), std::size_t{5});
    }

    void theListFollowsTheNesting()
    {
        Layering found;
        found.structures.resize(6);
        found.structures[0].in = 3; // lump in liver
        found.structures[1].in = 4; // bone in skin
        found.structures[3].in = 4; // liver in skin
        found.structures[5].twin = 2;
        const std::vector<std::size_t> order = found.order();
        QCOMPARE(order, (std::vector<std::size_t>{2, 4, 1, 3, 0, 5}));
        const Layering sorted = found.inOrder(order);
        QCOMPARE(*sorted.structures[2].in, std::size_t{1});
        QCOMPARE(*sorted.structures[4].in, std::size_t{3});
        QCOMPARE(*sorted.structures[5].twin, std::size_t{0});
        QVERIFY(!sorted.structures[1].in);
    }

    void whatIsNotFeltHoldsNothing()
    {
        meshio::LoadedScene scene = sceneOf({ball("skin", 90.0), ball("liver", 40.0)});
        scene.structures[0].description.palpable = false;
        auto felt = study::hapticScene(scene);
        const auto before = felt;
        QVERIFY(study::setLayers(scene, felt).empty());
        QCOMPARE(felt, before);
    }

    /// Impalpable vessels are inside the liver too, but are not reported as palpable through the liver.
    void whatIsPassedThroughIsNotNamed()
    {
        meshio::LoadedScene scene =
            sceneOf({ball("liver", 40.0), ball("vein", 20.0), ball("tumour", 5.0), ball("node", 5.0, {30, 0, 0})});
        scene.structures[1].description.palpable = false;
        auto felt = study::hapticScene(scene);
        QCOMPARE(test::english(study::setLayers(scene, felt)),
                 (Lines{"tumour lies in liver and is felt below it", "node lies in liver and is felt below it"}));
        // The layering in the window before names decide on contact: the tumour is inside the vein.
        Layering found;
        found.structures.resize(4);
        found.structures[1].in = 0;
        found.structures[2].in = 1;
        found.structures[3].unreliableParent = 1;
        const std::vector<std::string> names{"liver", "vein", "tumour", "node"};
        QCOMPARE(test::english(found.sentences(names, {true, false, true, true})),
                 Lines{"tumour lies in liver and is felt below it"});
        QCOMPARE(test::english(found.sentences(names, {true, true, false, false})),
                 Lines{"vein lies in liver and is felt below it"});
        QVERIFY(found.sentences(names, {false, false, true, true}).empty());
        QCOMPARE(found.sentences(names, {true, true, true, true}).size(), std::size_t{3});
    }

    void theNumberOfCoresDecidesNothing()
    {
        std::vector<Part> parts{ball("skin", 100.0)};
        for (int i = 0; i < 30; ++i) {
            parts.push_back(ball("node", 2.0, Vec3(80.0 * std::sin(i), 80.0 * std::cos(i), 10.0), 2));
        }
        const Found found = find(parts);
        QCOMPARE(std::count(found.layers.begin(), found.layers.end(), 1U), std::ptrdiff_t{30});
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(find(parts).layers, found.layers);
        }
    }

    /// A hand in the lump touches liver and lump: their total stiffness is at most the stable stiffness of the device.
    void theDeviceHoldsTheSumOfTheLayers()
    {
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = 1.2;
        greatest.damping_Ns_per_mm = 0.003;
        std::vector structures{tissue(0.8, 0.002, 0), tissue(0.3, 0.0, 0), tissue(0.8, 0.002, 1), tissue(0.1, 0.0, 1),
                               tissue(5.0, 0.0, 7)};
        study::limitTissues(greatest, structures);
        const double felt[]{0.8, 0.3, 1.2 - 0.8, 0.1, 0.0};
        for (std::size_t i = 0; i < structures.size(); ++i) {
            QVERIFY(std::abs(structures[i].tissue.stiffness_N_per_mm - felt[i]) < 1e-15);
        }
        QVERIFY(std::abs(structures[2].tissue.damping_Ns_per_mm - 0.001) < 1e-15);
        const auto taken = study::usedByOtherLayers(structures, 2);
        QCOMPARE(taken.by, (std::vector<std::size_t>{0, 4}));
        QCOMPARE(taken.tissue.stiffness_N_per_mm, 0.8);
        QCOMPARE(taken.tissue.damping_Ns_per_mm, 0.002);
    }

    void oneLayerIsBoundedAsItWas()
    {
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = 1.2;
        std::vector structures{tissue(0.8, 0.002, 3), tissue(5.0, 0.0, 3), tissue(1.2, 0.5, 3)};
        study::limitTissues(greatest, structures);
        QCOMPARE(structures[0].tissue.stiffness_N_per_mm, 0.8);
        QCOMPARE(structures[1].tissue.stiffness_N_per_mm, 1.2);
        QCOMPARE(structures[2].tissue.stiffness_N_per_mm, 1.2);
        QCOMPARE(structures[2].tissue.damping_Ns_per_mm, 0.5);
        // A missing surface has no share.
        structures[0].surface = nullptr;
        structures[0].layer = 0;
        study::limitTissues(greatest, structures);
        QCOMPARE(structures[1].tissue.stiffness_N_per_mm, 1.2);
        QVERIFY(study::usedByOtherLayers(structures, 1).by.empty());
    }
};

PALPATE_TEST(Layers)
#include "tst_Layers.moc"
