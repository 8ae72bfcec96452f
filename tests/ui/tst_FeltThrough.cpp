// SPDX-License-Identifier: BSD-3-Clause
// Tests lumps that are transmitted through their organ: switching, computing, and the update of the hand.
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/ui/LumpAtContact.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchMode.h>

#include <QComboBox>
#include <QSignalSpy>

using namespace palpate;
using meshio::BuriedTouch;
using ui::StructureModel;

namespace {

const haptics::Tissue kAny{5.0, 0.02};
constexpr int kLimit_ms = 30000;

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

    void thePanelOffersAllThree()
    {
        StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(liverWithLump());
        auto* felt = test::boxNamed(panel, "Felt, in order from outside");
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
        QCOMPARE(felt->currentText(), QStringLiteral("on its own surface, outermost"));
        choose(QStringLiteral("through liver (felt from above)"));
        QVERIFY(model.isTransmitted(1));
        choose(QStringLiteral("as a layer, below liver"));
        QVERIFY(model.buried() == BuriedTouch::Layers && model.structure(1).layer == 1);
        QVERIFY(model.structure(1).inside.empty()); // a file may not contain both
        choose(QStringLiteral("on its own surface, outermost"));
        QCOMPARE(model.undoStack().count(), 3);
        model.undoStack().undo();
        model.undoStack().undo();
        QCOMPARE(felt->currentText(), QStringLiteral("through liver (felt from above)"));
    }
};

PALPATE_TEST(FeltThrough)
#include "tst_FeltThrough.moc"
