// SPDX-License-Identifier: BSD-3-Clause
#include "Palpation.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/evaluation/Subject.h>
#include <palpate/geometry/Repair.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>
#include <palpate/ui/StructureModel.h>

#include <QTemporaryDir>
#include <QTest>

using namespace palpate;
using core::Vec3;

class HapticCopy : public QObject
{
    Q_OBJECT

    /// Two palpable structures, in layers with a gap, and an impalpable one in between.
    static meshio::LoadedScene scene()
    {
        meshio::LoadedScene loaded;
        for (int i = 0; i < 3; ++i) {
            meshio::LoadedStructure& one = loaded.structures.emplace_back();
            one.description.name = std::string(1, static_cast<char>('a' + i));
            one.description.mesh = "/somewhere/" + one.description.name + ".stl";
            one.description.part = "part";
            one.description.unit_mm = 10.0;
            one.description.flipped = i == 2;
            one.description.X_WM.translation() = Vec3(0, 0, i);
            one.description.palpable = i != 1;
            one.description.tissue.stiffness_N_per_mm = 0.25 * (i + 1);
            one.description.tissue.damping_Ns_per_mm = 0.001 * (i + 1);
            one.description.layer = static_cast<std::uint32_t>(2 * i);
            const Vec3 half = Vec3::Constant(20.0 - 5.0 * i);
            one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(test::box(-half, half, 2)));
            loaded.scene.structures.push_back(one.description);
        }
        return loaded;
    }

    static void compare(const haptics::HapticStructure& is, const meshio::SceneStructure& was)
    {
        QCOMPARE(is.name, was.name);
        QCOMPARE(is.tissue.stiffness_N_per_mm, was.tissue.stiffness_N_per_mm);
        QCOMPARE(is.tissue.damping_Ns_per_mm, was.tissue.damping_Ns_per_mm);
        QCOMPARE(is.surface != nullptr, was.palpable);
    }

  private Q_SLOTS:
    void allFeelTheSameTissue()
    {
        const meshio::LoadedScene loaded = scene();
        const auto direct = study::hapticScene(loaded);
        QCOMPARE(direct->structures().size(), std::size_t{3});
        QCOMPARE(study::triangleCount(*direct), std::size_t{2 * 48});

        ui::StructureModel model; // the window
        std::vector<ui::StructureRow> rows;
        for (const meshio::LoadedStructure& one : loaded.structures) {
            ui::StructureRow& row = rows.emplace_back();
            row.loaded = one;
            row.touch = study::indexed(*one.surface);
            row.sha256 = session::geometryHash(one.surface->mesh);
        }
        model.setRows(std::move(rows));
        const auto window = model.hapticScene({100.0, 100.0});
        for (std::size_t i = 0; i < 3; ++i) {
            compare(direct->structures()[i], loaded.structures[i].description);
            compare(window->structures()[i], loaded.structures[i].description);
            QCOMPARE(direct->structures()[i].layer, loaded.structures[i].description.layer);
            QCOMPARE(window->structures()[i].layer, loaded.structures[i].description.layer);
        }
        const auto bounded = model.hapticScene({0.5, 0.0015});
        QCOMPARE(bounded->structures()[0].tissue.damping_Ns_per_mm, 0.001);
        // Layers add up: the inner layer gets the remainder of the outer one.
        QCOMPARE(bounded->structures()[2].tissue.damping_Ns_per_mm, 0.0015 - 0.001);
        QCOMPARE(bounded->structures()[2].tissue.stiffness_N_per_mm, 0.5 - 0.25);

        const auto subject = evaluation::subjectOf("boxes", loaded); // the report, with palpable structures only
        QCOMPARE(subject->scene->structures().size(), std::size_t{2});
        compare(subject->scene->structures()[0], loaded.structures[0].description);
        compare(subject->scene->structures()[1], loaded.structures[2].description);
        QCOMPARE(subject->scene->layerCount(), direct->layerCount());

        const QTemporaryDir folder; // the generator of recordings
        const std::filesystem::path file = folder.filePath("r.palpate").toStdString();
        const auto script = device::HandScript::make({{0.0, Vec3(0, 0, 30)}, {0.05, Vec3(0, 0, 15)}});
        QVERIFY(phantom::recordPalpation(loaded, script.value(), file).isOk());
        const auto reader = session::RecordingReader::open(file);
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        for (std::size_t i = 0; i < 3; ++i) {
            const session::StructureRecord& record = reader.value()->scenes().at(0).structures.at(i);
            QCOMPARE(record.tissue.stiffness_N_per_mm, loaded.structures[i].description.tissue.stiffness_N_per_mm);
            QCOMPARE(record.tissue.damping_Ns_per_mm, loaded.structures[i].description.tissue.damping_Ns_per_mm);
            QCOMPARE(record.palpable, loaded.structures[i].description.palpable);
        }
    }

    void aHiddenTargetIsFeltButNotDrawn()
    {
        meshio::LoadedScene loaded = scene();
        loaded.structures[2].description.isHiddenTarget = true;
        loaded.structures[2].description.visible = false;
        loaded.structures[0].description.visible = false; // hidden by the user: no invisible wall
        const auto direct = study::hapticScene(loaded);
        QVERIFY(direct->structures()[0].surface == nullptr && direct->structures()[2].surface != nullptr);
        QCOMPARE(evaluation::subjectOf("boxes", loaded)->scene->structures().size(), std::size_t{1});
        loaded.structures[2].description.visible = true;

        ui::StructureModel model;
        std::vector<ui::StructureRow> rows;
        for (const meshio::LoadedStructure& one : loaded.structures) {
            ui::StructureRow& row = rows.emplace_back();
            row.loaded = one;
            row.touch = study::indexed(*one.surface);
        }
        model.setRows(std::move(rows), meshio::BuriedTouch::Layers, meshio::Exercise{{"c"}, {}, {}, {}});
        const auto isFelt = [&model](std::size_t i) {
            return model.hapticScene({100.0, 100.0})->structures()[i].surface != nullptr;
        };
        QVERIFY(!isFelt(0) && isFelt(2));
        QVERIFY(!model.isListed(2) && !model.appearanceOf(2).isVisible);
        QCOMPARE(model.scene().hiddenTargets(), std::size_t{1});

        // Only files, recordings and computations know the name.
        QCOMPARE(model.structure(2).name, std::string(study::kUnnamed));
        QCOMPARE(model.data(model.index(2, ui::StructureModel::Name), Qt::DisplayRole).toString(),
                 ui::readableName(study::kUnnamed));
        QCOMPARE(model.scene().described(2).name, std::string("c"));
        QCOMPARE(model.scene().sceneFile({}).structures[2].name, std::string("c"));
        QCOMPARE(model.scene().loadedScene().structures[2].description.name, std::string("c"));
        QCOMPARE(model.hapticScene({100.0, 100.0})->structures()[2].name, std::string("c"));
        QVERIFY(model.scene().givesTargetAway("part C: open") && !model.scene().givesTargetAway("a, b"));

        // Neither edits nor undo reveal it; a saved scene names it.
        meshio::SceneStructure changed = model.structure(2);
        changed.name = "d";
        changed.isHiddenTarget = false;
        model.edit(2, changed);
        QVERIFY(!model.isListed(2) && isFelt(2));
        QVERIFY(model.scene().sceneFile({}).exercise->targets == std::vector<std::string>{"c"});
        QCOMPARE(model.structure(2).name, std::string(study::kUnnamed));
        model.undoStack().undo();
        QVERIFY(!model.isListed(2) && isFelt(2));
        QVERIFY(model.scene().exercise()->targets == std::vector<std::string>{"c"});

        model.setTargetsHidden(false);
        QVERIFY(model.isListed(2) && model.appearanceOf(2).isVisible && isFelt(2));
        QCOMPARE(model.structure(2).name, std::string("c"));
        QVERIFY(!model.scene().givesTargetAway("part C: open"));
        model.setTargetsHidden(true);
        QVERIFY(!model.isListed(2) && !model.appearanceOf(2).isVisible && isFelt(2));

        // A scene file names no target that is no longer in the scene.
        model.removeRows({2});
        QCOMPARE(model.scene().hiddenTargets(), std::size_t{0});
        QVERIFY(!model.scene().sceneFile({}).exercise);

        // A name as displayed gives a target away, too.
        rows.clear();
        rows.emplace_back().loaded = loaded.structures[2];
        rows.front().loaded.description.name = "VH_F_polyp_2";
        rows.front().touch = study::indexed(*loaded.structures[2].surface);
        model.setRows(std::move(rows), meshio::BuriedTouch::Layers, meshio::Exercise{{"VH_F_polyp_2"}, {}, {}, {}});
        model.setTargetsHidden(true);
        QVERIFY(model.scene().givesTargetAway("Polyp 2: open") && !model.scene().givesTargetAway("Polyp 3: open"));
    }

    void whatARecordingKeepsOfAStructureComesBack()
    {
        const meshio::LoadedScene loaded = scene();
        const auto sources = study::sourcesOf(loaded, true);
        const session::SceneRecord record = session::describeScene(1, *study::hapticScene(loaded), sources);
        for (std::size_t i = 0; i < 3; ++i) {
            const meshio::SceneStructure& was = loaded.structures[i].description;
            const meshio::SceneStructure is = study::descriptionOf(record.structures[i]);
            QCOMPARE(is.mesh, was.mesh);
            QCOMPARE(is.part, was.part);
            QCOMPARE(is.unit_mm, was.unit_mm);
            QCOMPARE(is.flipped, was.flipped);
            QCOMPARE(is.X_WM.matrix(), was.X_WM.matrix());
            QCOMPARE(is.name, was.name);
            QCOMPARE(is.palpable, was.palpable);
            QCOMPARE(is.layer, was.layer);
            QCOMPARE(is.tissue.stiffness_N_per_mm, was.tissue.stiffness_N_per_mm);
            QCOMPARE(is.tissue.damping_Ns_per_mm, was.tissue.damping_Ns_per_mm);
            QCOMPARE(sources[i].embed, loaded.structures[i].surface);
        }
        const auto scene = session::rebuildScene(record, study::indexedByHash(study::meshesByHash(loaded)));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(study::surfacesByHash(*scene.value(), sources).size(), std::size_t{2});
    }
};

PALPATE_TEST(HapticCopy)
#include "tst_HapticCopy.moc"
