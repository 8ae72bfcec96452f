// SPDX-License-Identifier: BSD-3-Clause
// Tests which structures contain which, their stiffness ratios, and that lumps are palpable through the surface of the
// organ.
#include "../meshio/Samples.h"
#include "English.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/DeviceLimit.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/HapticCopy.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace palpate;
using core::Vec3;

class BuriedLumps : public QObject
{
    Q_OBJECT

    static void add(meshio::LoadedScene& scene, const char* name, const geometry::TriangleMesh& mesh, double k)
    {
        meshio::LoadedStructure& one = scene.structures.emplace_back();
        one.description.name = name;
        one.description.tissue.stiffness_N_per_mm = k;
        one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
        scene.scene.structures.push_back(one.description);
    }
    /// A lump of 20 mm, 8 mm below the top of an organ of 160 mm.
    static meshio::LoadedScene scene()
    {
        meshio::LoadedScene scene;
        add(scene, "organ", test::sphere(48, 80.0), 0.2);
        add(scene, "lump", test::moved(test::sphere(12, 10.0), Vec3(0, 0, 62)), 0.6);
        add(scene, "apart", test::moved(test::sphere(12, 10.0), Vec3(0, 0, 162)), 0.6);
        return scene;
    }

  private Q_SLOTS:
    void lumpsAreFoundByShapeAndByName()
    {
        meshio::LoadedScene s = scene();
        const auto found = study::organsWithLumps(s);
        QVERIFY(found.isOk() && found.value().size() == 1);
        const study::OrganWithLumps& organ = found.value()[0];
        QVERIFY(organ.organ == 0 && organ.lumps.size() == 1 && organ.lumps[0].structure == 1);
        QVERIFY(std::abs(organ.lumps[0].ratio->typical - 3.0) < 1e-12 && organ.radius_mm == 5.0);
        QVERIFY(organ.lumps[0].ratio->source == study::RatioSource::Tissue);

        s.structures[0].description.young_kPa = 7.0;
        s.structures[1].description.young_kPa = 35.0;
        QCOMPARE(study::organsWithLumps(s).value()[0].lumps[0].ratio->typical, 5.0);
        s.structures[1].description.young_ratio = 4.4;
        QCOMPARE(study::organsWithLumps(s).value()[0].lumps[0].ratio->typical, 4.4);
        QCOMPARE(study::organsWithLumps(s, {{"lump", 2.5}}).value()[0].lumps[0].ratio->typical, 2.5);
        s.structures[0].description.felt_contact_radius_mm = 8.0;
        QCOMPARE(study::organsWithLumps(s).value()[0].radius_mm, 8.0);

        s.structures[2].description.inside = "organ";
        QCOMPARE(study::organsWithLumps(s).value()[0].lumps.size(), std::size_t{2});
        QVERIFY(study::organsWithLumps(s, {{"organ", 2.0}}).status().code() == core::StatusCode::NotFound);
        s = scene();
        s.structures[1].description.palpable = false;
        QVERIFY(study::organsWithLumps(s).status().code() == core::StatusCode::Empty);
    }

    /// A lump whose organ cannot be felt is reported with the reason, to `palpate felt` and when a scene is opened.
    void aMissingOrganIsExplained()
    {
        const auto contains = [](const std::string& text, const char* part) {
            return text.find(part) != std::string::npos;
        };
        meshio::LoadedScene s = scene();
        s.structures[0].description.visible = false;
        std::string why = study::organsWithLumps(s).status().message();
        QVERIFY2(contains(why, "lump: not felt through an organ: it lies in no closed surface that can be felt"),
                 why.c_str());
        s.structures[1].description.inside = "organ";
        why = study::organsWithLumps(s).status().message();
        QVERIFY2(contains(why, "lump: not felt through an organ: organ is hidden or not palpable"), why.c_str());
        why = study::organsWithLumps(s, {{"apart", 2.0}}).status().message();
        QVERIFY2(contains(why, "apart: not felt through an organ: it lies in no closed surface"), why.c_str());
        s.structures[1].description.inside = "spleen";
        why = study::organsWithLumps(s).status().message();
        QVERIFY2(contains(why, "the scene has no structure \"spleen\", which it names as the organ"), why.c_str());

        // Another lump with an organ does not silence the reason.
        add(s, "cyst", test::moved(test::sphere(8, 3.0), Vec3(0, 0, 62)), 0.3);
        s.structures[3].description.inside = "lump";
        s.scene.buried = meshio::BuriedTouch::Felt;
        QVERIFY(study::applyBuriedLumps(s).isOk());
        QVERIFY(test::mentions(s.warnings, "lump: not felt through an organ: the scene has no structure \"spleen\""));
    }

    void whatIsFeltRisesSmoothlyOverTheLump()
    {
        meshio::LoadedScene s = scene();
        QVERIFY(study::applyBuriedLumps(s).isOk() && s.structures[0].feltBelow.empty()); // by layers, as in old files
        s.scene.buried = meshio::BuriedTouch::Felt;
        s.structures[1].description.layer = 1; // ignored in this mode
        QVERIFY(study::applyBuriedLumps(s).isOk());
        QVERIFY(s.structures[1].isTransmitted && !s.structures[2].isTransmitted);
        const auto felt = study::hapticScene(s);
        QVERIFY(felt->structures()[1].surface == nullptr && felt->structures()[2].surface != nullptr);

        haptics::Palpator palpator;
        palpator.setScene(felt.get());
        const auto forceAt = [&](const Vec3& direction, double depth) {
            palpator.reset();
            (void)palpator.step(82.0 * direction, 1e-3);
            return palpator.step((80.0 - depth) * direction, 1e-3).f_W.norm();
        };
        const Vec3 over = Vec3::UnitZ(), beside = Vec3::UnitX();
        // The sphere's facets are up to 0.02 mm below 80 mm: compare at equal depths.
        const double light = forceAt(over, 2.0) / forceAt(beside, 2.0),
                     deep = forceAt(over, 8.0) / forceAt(beside, 8.0);
        const auto organs = study::organsWithLumps(s);
        const auto map = study::feltSurface(s, organs.value()[0], {});
        const auto& press = map.value().lumps[0].press;
        QVERIFY2(std::abs(light / press[1].felt.estimate - 1.0) < 0.02, qPrintable(QString::number(light)));
        QVERIFY2(std::abs(deep / press[3].felt.estimate - 1.0) < 0.02, qPrintable(QString::number(deep)));
        // No step on entry: 0.01 mm changes the force by no more than 0.01 mm times the steepest slope.
        palpator.reset();
        (void)palpator.step(Vec3(0, 0, 82), 1e-3);
        const double slope = study::maxStiffness(felt->structures()[0]);
        double before = 0.0;
        for (double z = 80.0; z > 60.0; z -= 0.01) {
            const double now = palpator.step(Vec3(0, 0, z), 1e-3).f_W.norm();
            QVERIFY(std::abs(now - before) <= 0.01 * slope * 1.001);
            before = now;
        }
    }

    void aDeviceBoundsWhatLumpsAdd()
    {
        meshio::LoadedScene s = scene();
        s.scene.buried = meshio::BuriedTouch::Felt;
        QVERIFY(study::applyBuriedLumps(s).isOk());
        const auto felt = study::hapticScene(s);
        std::vector<haptics::HapticStructure> structures = felt->structures();
        const double asked = study::maxStiffness(structures[0]);
        QVERIFY(asked > 0.3);
        haptics::Tissue most = core::unbounded();
        most.stiffness_N_per_mm = 0.25;
        study::limitTissues(most, structures);
        QVERIFY(study::maxStiffness(structures[0]) <= 0.25);
        QVERIFY(study::maxStiffness(structures[0]) > 0.249);
        QVERIFY(structures[0].maps.felt[3].greatest() > 1.0);
    }

    void filesSayWhatIsInside()
    {
        test::Folder folder;
        meshio::SceneFile file;
        file.structures.resize(2);
        file.structures[0].name = "liver";
        file.structures[0].mesh = folder.path("liver.stl");
        file.structures[0].felt_contact_radius_mm = 6.0;
        file.structures[0].young_kPa = 7.0;
        file.structures[1].name = "lump";
        file.structures[1].mesh = folder.path("lump.stl");
        file.structures[1].inside = "liver";
        file.structures[1].young_ratio = 4.4;
        file.buried = meshio::BuriedTouch::Felt;
        const auto path = folder.path("s.palpate.json");
        QVERIFY(meshio::writeScene(path, file).isOk());
        const auto back = meshio::readScene(path);
        QVERIFY2(back.isOk(), back.status().message().c_str());
        QVERIFY(back.value().buried == meshio::BuriedTouch::Felt && back.value().structures[1].inside == "liver");
        QVERIFY(back.value().structures[1].young_ratio == 4.4 && back.value().structures[0].young_kPa == 7.0);
        QVERIFY(back.value().structures[0].felt_contact_radius_mm == 6.0);

        const auto refused = [&](const char* named) {
            (void)meshio::writeScene(path, file);
            const core::Status status = meshio::readScene(path).status();
            return !status.isOk() && status.message().find(named) != std::string::npos;
        };
        file.structures[1].layer = 1;
        QVERIFY(refused("structures[1].layer"));
        file.structures[1].layer = 0;
        file.structures[1].inside = "spleen";
        QVERIFY(refused("structures[1].inside"));
        file.structures[1].inside = "liver";
        file.structures[1].young_ratio = 2e4;
        QVERIFY(refused("structures[1].young_ratio"));
        file.structures[1].young_ratio = 4.4;
        file.structures[0].felt_contact_radius_mm = 31.0;
        QVERIFY(refused("structures[0].felt_contact_radius_mm"));
    }

    /// A structure without a ratio from its name has no verdict, whatever surrounds it, and is not transmitted through
    /// the organ.
    void withoutARatioThereIsNoVerdict()
    {
        meshio::LoadedScene s = scene();
        for (meshio::LoadedStructure& one : s.structures) {
            one.description.tissue = core::Tissue(); // no known stiffness
        }
        s.structures[1].description.name = "thing";
        const auto organs = study::organsWithLumps(s);
        QVERIFY(organs.isOk() && organs.value().size() == 1 && !organs.value()[0].lumps[0].ratio);
        const auto felt = study::computePalpability(s);
        QVERIFY(felt.isOk() && felt.value().size() == 1);
        const buried::FeltSurface::Lump& lump = felt.value()[0].felt.lumps[0];
        QVERIFY(!lump.ratio && std::abs(lump.minCover_mm - 8.0) < 0.2);
        for (const auto& press : lump.press) {
            QVERIFY(press.verdict == buried::Verdict::NotKnown && !press.best);
        }
        const QJsonObject json = study::lumpsJson(s, felt.value())[0].toObject();
        QVERIFY(json["young_ratio"].isNull() && json["press"].toArray()[3].toObject()["verdict"].isNull());
        QCOMPARE(test::english(study::ratioQuestions(s, felt.value())),
                 std::vector{study::ratioQuestion("thing", "organ").english()});
        s.scene.buried = meshio::BuriedTouch::Felt;
        QVERIFY(study::applyBuriedLumps(s).isOk());
        QVERIFY(!s.structures[1].isTransmitted && s.structures[0].feltBelow.empty());
        QCOMPARE(s.warnings.back().english(), study::ratioQuestion("thing", "organ").english());
    }

    /// A range of ratios gives a range of verdicts, each equal to the verdict of that single ratio.
    void aRangeOfRatiosHasARangeOfVerdicts()
    {
        meshio::LoadedScene s = scene();
        for (meshio::LoadedStructure& one : s.structures) {
            one.description.tissue = core::Tissue();
        }
        s.structures[0].description.name = "liver";
        s.structures[1].description.name = "tumour";
        const auto whole = study::computePalpability(s);
        const auto& lump = whole.value()[0].felt.lumps[0];
        const auto verdictsAt = [&](double ratio) {
            meshio::LoadedScene one = s;
            one.structures[1].description.young_ratio = ratio;
            return study::computePalpability(one).value()[0].felt.lumps[0].press;
        };
        const auto low = verdictsAt(lump.ratio->low), typical = verdictsAt(lump.ratio->typical),
                   high = verdictsAt(lump.ratio->high);
        for (std::size_t i = 0; i < lump.press.size(); ++i) {
            QVERIFY(lump.press[i].verdictAtLow == low[i].verdict && lump.press[i].verdict == typical[i].verdict &&
                    lump.press[i].verdictAtHigh == high[i].verdict);
        }
        QCOMPARE(buried::verdictText(lump.press[3], lump.ratio),
                 std::string("plainly (at 1: not by hand; at 5.2: plainly)"));
        QCOMPARE(buried::verdictText(typical[3], buried::RatioRange(4.4)), std::string("plainly"));
    }

    /// A structure whose name rules out a lump is no lump by shape either: a kidney in the skin. A lump belongs to the
    /// innermost enclosing organ.
    void anOrganInTheSkinIsNoLump()
    {
        meshio::LoadedScene s;
        add(s, "skin", test::sphere(24, 120.0), 0.5);
        add(s, "liver", test::sphere(24, 80.0), 0.5);
        add(s, "portal vein", test::sphere(12, 10.0), 0.5);
        add(s, "tumour", test::moved(test::sphere(12, 10.0), Vec3(0, 0, 62)), 0.5);
        const auto organs = study::organsWithLumps(s);
        QVERIFY(organs.isOk() && organs.value().size() == 1 && organs.value()[0].organ == 1);
        QVERIFY(organs.value()[0].lumps.size() == 1 && organs.value()[0].lumps[0].structure == 3);
        const auto asked = study::organsWithLumps(s, {{"portal vein", 0.5}});
        QCOMPARE(asked.value()[0].lumps.size(), std::size_t{2});
    }

    void theJsonSaysWhatTheDesignSays()
    {
        const meshio::LoadedScene s = scene();
        const auto organs = study::organsWithLumps(s);
        auto map = study::feltSurface(s, organs.value()[0], {});
        const std::vector<study::OrganPalpability> felt{{organs.value()[0], std::move(map).value()}};
        const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(study::feltJson(s, felt))).object();
        const QJsonObject lump = all["lumps"].toArray().at(0).toObject();
        QCOMPARE(lump["name"].toString(), QStringLiteral("lump"));
        QCOMPARE(lump["inside"].toString(), QStringLiteral("organ"));
        QVERIFY(std::abs(lump["young_ratio"].toDouble() - 3.0) < 1e-12);
        QVERIFY(std::abs(lump["least_cover_mm"].toDouble() - 8.0) < 0.2);
        const QJsonArray presses = lump["press"].toArray();
        QCOMPARE(presses.size(), 4);
        const QJsonObject last = presses.at(3).toObject();
        QCOMPARE(last["press_mm"].toDouble(), 8.0);
        QVERIFY(last["low"].toDouble() < last["ratio"].toDouble() &&
                last["ratio"].toDouble() < last["high"].toDouble());
        QVERIFY(last["area_over_7_mm2"].toDouble() >= last["area_over_14_mm2"].toDouble());
        QVERIFY(last["area_over_28_mm2"].isDouble() && last["best_p_mm"].toArray().size() == 3);
        QCOMPARE(last["verdict"].toString(), QStringLiteral("plainly"));
        const auto vtp = study::feltVtp(felt);
        QVERIFY(vtp.isOk());
        for (const char* name : {"FeltRatio", "FeltRatioLow", "FeltRatioHigh", "Cover_mm", "Lump", "NotJudged"}) {
            QVERIFY2(vtp.value().find("Name=\"" + std::string(name) + "\"") != std::string::npos, name);
        }
    }
};

PALPATE_TEST(BuriedLumps)
#include "tst_BuriedLumps.moc"
