// SPDX-License-Identifier: BSD-3-Clause
// Tests lumps that are transmitted through their organ: switching, computing, and the update of the hand.
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/ui/LumpAtContact.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchMode.h>

#include <palpate/study/BuriedLumps.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>

#include <QComboBox>
#include <QSignalSpy>

#include <functional>
#include <utility>
#include <vector>

using namespace palpate;
using meshio::BuriedTouch;
using ui::StructureModel;

namespace {

const haptics::Tissue kAny{5.0, 0.02};
constexpr int kLimit_ms = 30000;

using Rows = std::vector<ui::StructureRow>;
using Change = std::function<void(Rows&)>;
using EditRows = std::function<void(StructureModel&)>;

/// Determines the structure around each row, as the window does after loading.
void nest(Rows& rows)
{
    std::vector<study::LayeredSurface> surfaces;
    for (const ui::StructureRow& row : rows) {
        surfaces.push_back({row.loaded.surface.get(), row.touch.get()});
    }
    const study::Layering layers = study::layering(surfaces);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].in = layers.structures[i].in;
    }
}

/// The open scene as a file would describe it.
meshio::LoadedScene asLoaded(const StructureModel& model)
{
    meshio::LoadedScene scene;
    scene.scene.buried = model.buried();
    for (const study::OpenStructure& row : model.rows()) {
        if (!row.isRemoved) {
            meshio::LoadedStructure one;
            one.description = row.loaded.description;
            one.surface = row.loaded.surface;
            scene.structures.push_back(std::move(one));
        }
    }
    return scene;
}

bool isSame(const haptics::TissueMap& a, const haptics::TissueMap& b)
{
    return a.isEmpty() == b.isEmpty() && (a.isEmpty() || *a.corners == *b.corners);
}

void hide(StructureModel& model, int row)
{
    QVERIFY(model.setData(model.index(row, StructureModel::Shown), Qt::Unchecked, Qt::CheckStateRole));
}

void ignore(StructureModel& model, int row)
{
    QVERIFY(model.setData(model.index(row, StructureModel::Felt), Qt::Unchecked, Qt::CheckStateRole));
}

} // namespace

class FeltThrough : public QObject
{
    Q_OBJECT

    /// Returns a liver of 40 mm with a central lump that is by default large enough to be palpable from all sides.
    static std::vector<ui::StructureRow> liverWithLump(double radius_mm = 15.0)
    {
        std::vector<ui::StructureRow> rows;
        rows.push_back(test::row("liver", test::ball(20.0, 3)));
        rows.push_back(test::row("lump", test::ball(radius_mm, 2)));
        rows[0].loaded.description.tissue.stiffness_N_per_mm = 0.1;
        rows[1].loaded.description.tissue.stiffness_N_per_mm = 0.4;
        rows[1].in = 0;
        return rows;
    }
    static bool isLumpTouched(const StructureModel& model, int row = 1)
    {
        return model.hapticStructures(kAny)[static_cast<std::size_t>(row)].surface != nullptr;
    }
    static float most(const StructureModel& model)
    {
        const auto& below = model.rows()[0].loaded.feltBelow;
        return below.empty() ? 0.0F : *std::max_element(below.back().begin(), below.back().end());
    }
    static void through(StructureModel& model, int row = 1)
    {
        ui::feel(model, {{row, std::nullopt}}, QStringLiteral("Feel through"));
    }

  private Q_SLOTS:
    void isOneStepThatIsUndone()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        QVERIFY(maps.isHandUpToDate());
        through(model);
        QVERIFY(model.buried() == BuriedTouch::Felt && model.structure(1).inside == "liver");
        QCOMPARE(model.undoStack().count(), 1);
        // Simulated as a layer until the map is ready.
        QVERIFY(!maps.isHandUpToDate());
        QVERIFY(isLumpTouched(model));
        QCOMPARE(model.hapticStructures(kAny)[1].layer, 1U);
        QSignalSpy edited(&model, &StructureModel::edited);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        QVERIFY(!edited.isEmpty()); // the update of the hand uses the same path as other tissue changes
        QVERIFY(!isLumpTouched(model));
        QVERIFY(model.hapticStructures(kAny)[0].maps.hasFelt());
        QVERIFY(most(model) > 1.1F);
        QCOMPARE(model.undoStack().count(), 1);

        model.undoStack().undo();
        QVERIFY(model.buried() == BuriedTouch::Layers && model.structure(1).inside.empty());
        QVERIFY(isLumpTouched(model) && !model.hapticStructures(kAny)[0].maps.hasFelt());
        QCOMPARE(model.hapticStructures(kAny)[1].layer, 0U);
        model.undoStack().redo();
        PALPATE_TRY_VERIFY(maps.isHandUpToDate() && !isLumpTouched(model));
    }

    /// The lump under the hand is named, with the change in stiffness from the map.
    void theLumpUnderTheHandIsNamed()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        QVERIFY(!ui::lumpAtContact(model, 0, {0.0, 0.0, 20.0}, 4.0)); // not yet transmitted through the liver
        through(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        const core::Vec3 place = model.rows()[0].loaded.surface->mesh.vertices.front();
        const auto& below = model.rows()[0].loaded.feltBelow;
        const auto under = ui::lumpAtContact(model, 0, place, 4.0);
        QVERIFY(under && under->row == 1);
        QCOMPARE(under->ratio, double{below[2].front()});
        QCOMPARE(ui::lumpAtContact(model, 0, place, 3.0)->ratio,
                 0.5 * double{below[1].front()} + 0.5 * double{below[2].front()});
        QCOMPARE(ui::lumpAtContact(model, 0, place, 30.0)->ratio, double{below[3].front()});
        QVERIFY(!ui::lumpAtContact(model, 1, place, 4.0));
    }

    void handAndPictureHaveTheSameNumbers()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        through(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        QVERIFY(maps.isUpToDate()); // no display was requested: the map is available without a new computation
        QCOMPARE(maps.organs().size(), std::size_t(1));
        const buried::FeltSurface& felt = maps.organs()[0]->organ.felt;
        const auto& below = model.rows()[0].loaded.feltBelow;
        QCOMPARE(below.size(), felt.press.size());
        for (std::size_t j = 0; j < below.size(); ++j) {
            QCOMPARE(below[j].size(), felt.organVertices);
            QVERIFY(std::equal(below[j].begin(), below[j].end(), felt.press[j].ratio.begin()));
        }
    }

    void whatIsChangedReachesTheHand()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        through(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        float before = most(model);
        const auto change = [&](int row, const std::function<void(meshio::SceneStructure&)>& how) {
            meshio::SceneStructure one = model.structure(row);
            how(one);
            model.editAll({{row, one}}, QStringLiteral("Change"));
            QVERIFY(!maps.isHandUpToDate());
            QVERIFY(!isLumpTouched(model)); // the previous map applies until the new map is ready
            PALPATE_TRY_VERIFY(maps.isHandUpToDate());
            QVERIFY2(std::abs(most(model) - before) > 0.01F, qPrintable(QString::number(most(model))));
            before = most(model);
        };
        change(1, [](auto& lump) { lump.young_ratio = 20.0; });
        change(1, [](auto& lump) { lump.young_ratio.reset(); });
        change(1, [](auto& lump) { lump.tissue.stiffness_N_per_mm = 1.0; });
        change(0, [](auto& organ) { organ.felt_contact_radius_mm = 10.0; });
    }

    /// In a scene file with "felt" but without organ names, all structures that are inside an organ by geometry are
    /// transmitted, in any layer; otherwise only those whose entry names an organ.
    void filesSayWhatIsFeltThrough()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        std::vector<ui::StructureRow> rows = liverWithLump();
        rows.push_back(test::row("deeper", test::ball(5.0, 2)));
        rows[2].in = 0;
        model.setRows(rows, BuriedTouch::Felt);
        QVERIFY(!model.isTransmitted(0) && model.isTransmitted(1) && model.isTransmitted(2));
        QCOMPARE(model.touchOrderText(1), QStringLiteral("through liver"));
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());

        rows[2].loaded.description.layer = 1;
        model.setRows(rows, BuriedTouch::Felt);
        QVERIFY(model.isTransmitted(1) && model.isTransmitted(2));
        rows[2].loaded.description.layer = 0;
        rows[2].loaded.description.inside = "liver";
        model.setRows(rows, BuriedTouch::Felt);
        QVERIFY(!model.isTransmitted(1) && model.isTransmitted(2));
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        QVERIFY(isLumpTouched(model, 1) && !isLumpTouched(model, 2));
    }

    /// One of several lumps goes back to its own surface; the others stay transmitted.
    void othersStayThrough()
    {
        StructureModel model;
        std::vector<ui::StructureRow> rows = liverWithLump(10.0);
        rows.push_back(test::row("deeper", test::ball(5.0, 2)));
        rows[2].in = 0;
        model.setRows(rows, BuriedTouch::Felt);
        ui::feel(model, {{1, 0}}, QStringLiteral("On its own"));
        QVERIFY(!model.isTransmitted(1) && model.isTransmitted(2));
        ui::feel(model, {{2, 1}}, QStringLiteral("As a layer"));
        QVERIFY(model.buried() == BuriedTouch::Layers);
        model.undoStack().undo();
        model.undoStack().undo();
        QVERIFY(model.buried() == BuriedTouch::Felt && model.structure(2).inside.empty());
        QVERIFY(model.isTransmitted(1) && model.isTransmitted(2));
    }

    void whatIsHiddenOrRemovedIsNotFeltThrough()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        through(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        model.setData(model.index(1, StructureModel::Shown), Qt::Unchecked, Qt::CheckStateRole);
        QVERIFY(!isLumpTouched(model));
        PALPATE_TRY_VERIFY(most(model) <= 1.0F);
        model.undoStack().undo();
        PALPATE_TRY_VERIFY(most(model) > 1.1F);
        model.removeRows({1});
        PALPATE_TRY_VERIFY(most(model) <= 1.0F);
        model.undoStack().undo();
        PALPATE_TRY_VERIFY(maps.isHandUpToDate() && most(model) > 1.1F);
    }

    void aRecordingsOwnMapsAreNotMadeAnew()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        std::vector<ui::StructureRow> rows = liverWithLump();
        const std::size_t count = rows[0].loaded.surface->mesh.vertices.size();
        const std::vector<std::vector<float>> recorded(4, std::vector<float>(count, 1.5F));
        rows[0].loaded.feltBelow = recorded;
        model.setRows(std::move(rows));
        maps.setWanted(true); // displaying the palpable area does not change the result
        PALPATE_TRY_VERIFY(maps.isUpToDate());
        QCOMPARE(model.rows()[0].loaded.feltBelow, recorded);
        through(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        QVERIFY(model.rows()[0].loaded.feltBelow != recorded);
        model.undoStack().undo();
        QCOMPARE(model.rows()[0].loaded.feltBelow, recorded);
        QVERIFY(model.hapticStructures(kAny)[0].maps.hasFelt());
    }

    void cancelledItIsFeltAsALayerUntilSomethingChanges()
    {
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(liverWithLump());
        through(model);
        QSignalSpy cancelled(&maps, &ui::LumpMaps::cancelled);
        maps.cancel();
        QCOMPARE(cancelled.count(), 1);
        QTest::qWait(600);
        QVERIFY(!maps.isHandUpToDate() && !maps.isBusy());
        QCOMPARE(model.hapticStructures(kAny)[1].layer, 1U);
        meshio::SceneStructure lump = model.structure(1);
        lump.young_ratio = 3.0;
        model.edit(1, lump);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate());
        QVERIFY(!isLumpTouched(model));
    }

    void windowAndCommandLineAgree_data()
    {
        QTest::addColumn<Change>("change"); // of the scene before it is opened: liver, lump in it, cyst in the lump
        QTest::addColumn<EditRows>("edit"); // in the window
        QTest::addColumn<int>("through");   // number of lumps that are felt through an organ
        const EditRows none = [](StructureModel&) {};
        const Change asItIs = [](Rows&) {};
        const auto add = [](const char* name, const Change& change, const EditRows& edit, int through) {
            QTest::newRow(name) << change << edit << through;
        };
        const auto named = [](std::size_t row, const char* organ) {
            return [row, organ](Rows& rows) { rows[row].loaded.description.inside = organ; };
        };
        const auto remeshed = [](std::size_t row, const geometry::TriangleMesh& mesh) {
            return [row, mesh](Rows& rows) {
                const meshio::SceneStructure is = rows[row].loaded.description;
                rows[row] = test::row(is.name.c_str(), mesh);
                rows[row].loaded.description = is;
            };
        };
        const auto opened = [](geometry::TriangleMesh mesh) {
            mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4);
            return mesh;
        };
        const auto turned = [](geometry::TriangleMesh mesh) {
            for (geometry::Triangle& one : mesh.triangles) {
                std::swap(one[0], one[1]);
            }
            return mesh;
        };
        add("nested lumps", asItIs, none, 2);
        add(
            "hidden lump", asItIs, [](StructureModel& m) { hide(m, 1); }, 1);
        add(
            "hidden cyst", asItIs, [](StructureModel& m) { hide(m, 2); }, 1);
        add(
            "hidden organ", asItIs, [](StructureModel& m) { hide(m, 0); }, 1); // the cyst in the lump
        add(
            "organ that is not palpable", asItIs, [](StructureModel& m) { ignore(m, 0); }, 1);
        add(
            "lump that is not palpable", asItIs, [](StructureModel& m) { ignore(m, 1); }, 1);
        add(
            "removed organ", asItIs, [](StructureModel& m) { m.removeRows({0}); }, 1);
        add(
            "removed lump", asItIs, [](StructureModel& m) { m.removeRows({1}); }, 1);
        add(
            "removed and brought back", asItIs,
            [](StructureModel& m) {
                m.removeRows({0});
                m.undoStack().undo();
            },
            2);
        add(
            "hidden in the file", [](Rows& rows) { rows[1].loaded.description.visible = false; }, none, 1);
        add(
            "shown again", [](Rows& rows) { rows[1].loaded.description.visible = false; },
            [](StructureModel& m) {
                QVERIFY(m.setData(m.index(1, StructureModel::Shown), Qt::Checked, Qt::CheckStateRole));
            },
            2);
        add("one is named", named(1, "liver"), none, 1);
        add(
            "named and hidden organ", named(1, "liver"), [](StructureModel& m) { hide(m, 0); }, 0);
        add(
            "named and removed organ", named(1, "liver"), [](StructureModel& m) { m.removeRows({0}); }, 0);
        add("named organ that is not there", named(1, "spleen"), none, 0);
        add(
            "named lump is removed", named(1, "liver"), [](StructureModel& m) { m.removeRows({1}); }, 1);
        add("open organ", remeshed(0, opened(test::ball(20.0, 2))), none, 1);
        add("organ inside out", remeshed(0, turned(test::ball(20.0, 2))), none, 1);
        add(
            "open organ that is named",
            [=](Rows& rows) {
                remeshed(0, opened(test::ball(20.0, 2)))(rows);
                named(1, "liver")(rows);
            },
            none, 0);
        add("open lump", remeshed(1, opened(test::ball(10.0, 2))), none, 1);
        add(
            "renamed to anatomy", asItIs,
            [](StructureModel& m) {
                QVERIFY(m.setData(m.index(1, StructureModel::Name), QStringLiteral("portal vein"), Qt::EditRole));
            },
            1);
        add(
            "in separate layers", asItIs,
            [](StructureModel& m) {
                ui::feel(m, {{1, 1}, {2, 2}}, QStringLiteral("Below"));
            },
            0);
    }
    void windowAndCommandLineAgree()
    {
        QFETCH(const Change, change);
        QFETCH(const EditRows, edit);
        QFETCH(const int, through);
        Rows rows;
        rows.push_back(test::row("liver", test::ball(20.0, 2)));
        rows.push_back(test::row("lump", test::ball(10.0, 2)));
        rows.push_back(test::row("cyst", test::ball(5.0, 1)));
        rows[0].loaded.description.tissue.stiffness_N_per_mm = 0.1;
        rows[1].loaded.description.tissue.stiffness_N_per_mm = 0.4;
        rows[2].loaded.description.tissue.stiffness_N_per_mm = 0.8;
        change(rows);
        nest(rows);
        StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(std::move(rows), BuriedTouch::Felt);
        edit(model);
        PALPATE_TRY_VERIFY(maps.isHandUpToDate() && !maps.isBusy());

        meshio::LoadedScene scene = asLoaded(model);
        QVERIFY(study::applyBuriedLumps(scene).isOk());
        const auto line = study::hapticScene(scene);
        const auto window = model.hapticStructures(kAny);
        std::size_t i = 0;
        int felt = 0;
        for (std::size_t row = 0; row < window.size(); ++row) {
            if (model.rows()[row].isRemoved) {
                QVERIFY(window[row].surface == nullptr);
                continue;
            }
            const haptics::HapticStructure &a = window[row], &b = line->structures()[i];
            const std::string& name = a.name;
            QCOMPARE(a.name, b.name);
            QVERIFY2((a.surface == nullptr) == (b.surface == nullptr), name.c_str());
            QVERIFY2(a.surface == nullptr || a.layer == b.layer, name.c_str());
            for (std::size_t j = 0; j < a.maps.felt.size(); ++j) {
                QVERIFY2(isSame(a.maps.felt[j], b.maps.felt[j]), name.c_str());
            }
            felt += scene.structures[i].isTransmitted ? 1 : 0;
            ++i;
        }
        QCOMPARE(felt, through);
    }

    void thePanelOffersAllThree()
    {
        StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(liverWithLump());
        auto* felt = test::boxNamed(panel, "Depth order, from outside");
        panel.select(0);
        QCOMPARE(felt->currentText(), QStringLiteral("outermost"));
        QVERIFY(felt->findText(QStringLiteral("through"), Qt::MatchStartsWith) < 0);
        panel.select(1);
        const auto choose = [&](const QString& text) {
            const int index = felt->findText(text);
            QVERIFY2(index >= 0, qPrintable(text));
            felt->setCurrentIndex(index);
            Q_EMIT felt->activated(index);
            QCOMPARE(felt->currentText(), text);
        };
        QCOMPARE(felt->currentText(), QStringLiteral("own surface, outermost"));
        choose(QStringLiteral("through liver (felt from above)"));
        QVERIFY(model.isTransmitted(1));
        choose(QStringLiteral("as a layer, below liver"));
        QVERIFY(model.buried() == BuriedTouch::Layers && model.structure(1).layer == 1);
        QVERIFY(model.structure(1).inside.empty()); // a file may not contain both
        choose(QStringLiteral("own surface, outermost"));
        QCOMPARE(model.undoStack().count(), 3);
        model.undoStack().undo();
        model.undoStack().undo();
        QCOMPARE(felt->currentText(), QStringLiteral("through liver (felt from above)"));
    }
};

PALPATE_TEST(FeltThrough)
#include "tst_FeltThrough.moc"
