// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/session/RecordingWriter.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/SearchedLumps.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;

/// Tests whether a lump of 20 mm, 8 mm below the top of an organ of 160 mm, was searched thoroughly, on recordings with
/// synthetic presses.
class SearchedLumps : public QObject
{
    Q_OBJECT

    static constexpr double kRadius_mm = 80.0, kDistance_mm = 5.0;
    meshio::LoadedScene m_scene;

    static void add(meshio::LoadedScene& scene, const char* name, const geometry::TriangleMesh& mesh, double k)
    {
        meshio::LoadedStructure& one = scene.structures.emplace_back();
        one.description.name = name;
        one.description.tissue.stiffness_N_per_mm = k;
        one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
        scene.scene.structures.push_back(one.description);
    }
    static Vec3 onOrgan(const Vec3& towards) { return kRadius_mm * towards.normalized(); }

    /// @param places  press positions on the organ, one per tick
    /// @param lump_N  additional force of the lump's own layer, if simulated as a layer
    session::LumpSearch searched(const std::vector<Vec3>& places, double depth_mm, std::uint32_t structure = 0,
                                 double lump_N = 0.0)
    {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("a.palpate")).toStdString();
        session::SceneRecord record;
        record.generation = 1;
        for (const char* name : {"organ", "lump"}) {
            record.structures.emplace_back().name = name;
            record.structures.back().tissue.stiffness_N_per_mm = 0.2;
        }
        auto writer = session::RecordingWriter::create(file, {});
        if (!writer.isOk() || !writer.value()->addScene(record).isOk()) {
            return {};
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            servo::TickRecord tick;
            tick.tick = static_cast<std::int64_t>(i);
            tick.scene = 1;
            const Vec3 n_W = places[i].normalized();
            tick.p_WH = places[i] - depth_mm * n_W;
            tick.felt.p_WG = places[i];
            tick.felt.n_W = n_W;
            tick.felt.f_W = 0.2 * depth_mm * n_W;
            tick.felt.structure = static_cast<std::int32_t>(structure);
            tick.felt.constraints = 1;
            tick.felt.contactCount = 1;
            tick.felt.contacts[0] = {places[i], n_W, tick.felt.f_W, depth_mm, 1.0, structure, 0, 0, {}};
            if (lump_N > 0.0) {
                tick.felt.contacts[1] = {places[i] - 8.0 * n_W, n_W, lump_N * n_W, depth_mm - 8.0, 1.0, 1, 0, 1, {}};
                tick.felt.contactCount = 2;
                tick.felt.f_W += lump_N * n_W;
            }
            if (!writer.value()->append(tick).isOk()) {
                return {};
            }
        }
        if (!writer.value()->finish().isOk()) {
            return {};
        }
        const auto reader = session::RecordingReader::open(file);
        const auto organs = study::computePalpability(m_scene);
        const auto found = study::measureSearch(*reader.value(), {}, m_scene, organs.value(), {kDistance_mm});
        return found.isOk() && found.value().lumps.size() == 1 ? found.value().lumps[0] : session::LumpSearch();
    }
    /// Positions 3 mm apart that cover the top.
    static std::vector<Vec3> lattice()
    {
        std::vector<Vec3> places;
        for (int i = -15; i <= 15; ++i) {
            for (int j = -15; j <= 15; ++j) {
                places.push_back(onOrgan(Vec3(3.0 * i, 3.0 * j, kRadius_mm)));
            }
        }
        return places;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        add(m_scene, "organ", test::sphere(48, kRadius_mm), 0.2);
        add(m_scene, "lump", test::moved(test::sphere(12, 10.0), Vec3(0, 0, 62)), 0.6);
    }

    void aSearchThatIsTooLightFindsNothing()
    {
        const auto light = searched(lattice(), 0.5);
        QCOMPARE(light.lump, std::string("lump"));
        QCOMPARE(light.organ, std::string("organ"));
        QVERIFY2(light.detectable_mm2 > 200.0, qPrintable(QString::number(light.detectable_mm2)));
        QCOMPARE(light.share().value(), 0.0);
        QVERIFY(light.predicted_percent.value() > 1.0 && light.predicted_percent.value() < 14.0);
        QVERIFY(!light.recorded_percent); // no tick is deep enough
    }

    void onePressFeelsItWhereItWasMade()
    {
        const auto one = searched({Vec3(0, 0, kRadius_mm)}, 8.0);
        // The lump is detectable from all of its surroundings.
        QVERIFY2(std::abs(one.pressed_mm2 / (std::numbers::pi * kDistance_mm * kDistance_mm) - 1.0) < 0.15,
                 qPrintable(QString::number(one.pressed_mm2)));
        buried::FeltOptions how;
        how.press_mm = {0.0, 2.0, 4.0, 8.0};
        const auto felt = study::feltSurface(m_scene, study::organsWithLumps(m_scene).value()[0], how);
        const double best = 100.0 * (felt.value().lumps[0].press[3].felt.estimate - 1.0);
        QVERIFY2(std::abs(one.predicted_percent.value() / best - 1.0) < 0.02,
                 qPrintable(QString::number(one.predicted_percent.value())));
        QVERIFY(std::abs(one.recorded_percent.value()) < 1e-9); // recorded without the lump
        QVERIFY(std::abs(one.detectable_mm2 / felt.value().lumps[0].press[3].area_mm2[1] - 1.0) < 1e-4);
    }

    void aSearchEverywhereMissesNoPlace()
    {
        QCOMPARE(searched(lattice(), 8.0).share().value(), 1.0);
        QCOMPARE(searched(lattice(), 12.0).share().value(), 1.0); // deeper than the largest evaluated depth
        const double half = searched(lattice(), 4.0).share().value();
        QVERIFY2(half > 0.1 && half < 0.9, qPrintable(QString::number(half)));
    }

    void elsewhereOrOnTheLumpItselfIsNoSearch()
    {
        QCOMPARE(searched({onOrgan(Vec3(1, 0, 0))}, 8.0).share().value(), 0.0);
        QCOMPARE(searched({Vec3(0, 0, kRadius_mm)}, 8.0, 1).share().value(), 0.0); // of its own layer
        QCOMPARE(searched({Vec3(0, 0, kRadius_mm)}, 8.0, 1).predicted_percent.value(), 0.0);
    }

    /// Reports the recorded force, regardless of the lump model: a lump as a layer adds its own force.
    void whatWasRecordedIsSaidBesideThePrediction()
    {
        const auto layered = searched({Vec3(0, 0, kRadius_mm)}, 12.0, 0, 2.16);
        QVERIFY(std::abs(layered.recorded_percent.value() - 90.0) < 1e-9); // 2.16 N relative to 0.2 N/mm x 12 mm
        QVERIFY(layered.predicted_percent.value() > 10.0 && layered.predicted_percent.value() < 60.0);
        m_scene.structures[1].description.tissue = core::Tissue();
        m_scene.structures[0].description.tissue = core::Tissue();
        const auto unknown = searched({Vec3(0, 0, kRadius_mm)}, 12.0, 0, 2.16);
        m_scene.structures[0].description.tissue.stiffness_N_per_mm = 0.2;
        m_scene.structures[1].description.tissue.stiffness_N_per_mm = 0.6;
        QVERIFY(!unknown.predicted_percent && !unknown.share()); // unknown stiffness ratio
        QVERIFY(std::abs(unknown.recorded_percent.value() - 90.0) < 1e-9);
    }

    void whatNoHandTellsHasNoShare()
    {
        m_scene.structures[1].description.young_ratio = 1.0;
        const auto none = searched({Vec3(0, 0, kRadius_mm)}, 8.0);
        m_scene.structures[1].description.young_ratio.reset();
        QVERIFY(none.lump == "lump" && !none.share());
    }
};

PALPATE_TEST(SearchedLumps)
#include "tst_SearchedLumps.moc"
