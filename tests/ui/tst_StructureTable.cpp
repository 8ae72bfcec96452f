// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/ui/StructureTree.h>

using namespace palpate;
using ui::StructureModel;

namespace {

const haptics::Tissue kGreatest{5.0, 0.02};

} // namespace

class StructureTable : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    /// Many structures of several kinds are listed in groups until the user chooses otherwise; a few are not.
    void manyStructuresAreGroupedByAnatomy()
    {
        const auto rowsOf = [](const std::vector<std::string>& names) {
            std::vector<ui::StructureRow> rows;
            for (const std::string& name : names) {
                rows.push_back(test::row(name, test::ball(5.0, 1)));
            }
            return rows;
        };
        std::vector<std::string> many{"label 7",     "aorta",      "liver", "gluteus_maximus_left",
                                      "liver_tumor", "spinal_cord"};
        for (int i = 1; i <= 30; ++i) {
            many.push_back("rib_left_" + std::to_string(i));
        }
        StructureModel model;
        ui::StructureTree tree(model);
        model.setRows(rowsOf(many));
        QVERIFY(tree.grouping() == ui::StructureTree::Grouping::Anatomy);
        QStringList titles;
        for (int group = 0; group < tree.rowCount(); ++group) {
            titles << tree.index(group, StructureModel::Name).data().toString();
        }
        QCOMPARE(titles, (QStringList{"Lumps (1)", "Organs (1)", "Vessels (1)", "Brain and nerves (1)", "Bones (30)",
                                      "Muscles (1)", "Other (1)"}));
        QCOMPARE(tree.rowOf(tree.index(0, StructureModel::Name, tree.index(1, 0))), 2); // the liver
        model.setRows(rowsOf({"liver", "aorta", "rib_left_1"}));
        QVERIFY(tree.grouping() == ui::StructureTree::Grouping::None);
        tree.setGrouping(ui::StructureTree::Grouping::Layer);
        model.setRows(rowsOf(many));
        QVERIFY(tree.grouping() == ui::StructureTree::Grouping::Layer);
    }
    void namesReadAsAPersonWritesThem()
    {
        QCOMPARE(ui::readableName("VH_F_liver_capsule"), QStringLiteral("liver capsule"));
        QCOMPARE(ui::readableName("left  hepatic_vein"), QStringLiteral("left hepatic vein"));
    }
    void hiddenStructureIsNotFelt()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        QVERIFY(model.hapticScene(kGreatest)->structures()[0].surface != nullptr);
        model.setData(model.index(0, StructureModel::Shown), Qt::Unchecked, Qt::CheckStateRole);
        QVERIFY(model.hapticScene(kGreatest)->structures()[0].surface == nullptr);
        QVERIFY(model.hapticScene(kGreatest)->structures()[1].surface != nullptr); // keeps its index
    }
    void tellsTheViewOfLooksAndTheHandOfTissue()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        QList<StructureModel::Change> changes;
        connect(&model, &StructureModel::edited, this, [&](int, StructureModel::Change change) { changes << change; });
        meshio::SceneStructure one = model.structure(0);
        one.opacity = 0.4;
        model.edit(0, one);
        QCOMPARE(changes, QList<StructureModel::Change>{StructureModel::Change::Look});
        changes.clear();
        one.tissue.stiffness_N_per_mm = 1.3;
        model.edit(0, one);
        QCOMPARE(changes, QList<StructureModel::Change>{StructureModel::Change::Touch});
        QCOMPARE(model.hapticScene(kGreatest)->structures()[0].tissue.stiffness_N_per_mm, 1.3);
    }
    void stiffnessIsBoundedByTheDevice()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        meshio::SceneStructure one = model.structure(0);
        one.tissue.stiffness_N_per_mm = 40.0;
        model.edit(0, one);
        QCOMPARE(model.hapticScene(kGreatest)->structures()[0].tissue.stiffness_N_per_mm, 5.0);
    }
    void editsAreUndone()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        model.setData(model.index(1, StructureModel::Felt), Qt::Unchecked, Qt::CheckStateRole);
        QVERIFY(!model.structure(1).palpable);
        model.undoStack().undo();
        QVERIFY(model.structure(1).palpable);
        model.undoStack().redo();
        QVERIFY(!model.structure(1).palpable);
    }
    void layersOfAllAreOneStep()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        QSignalSpy edited(&model, &StructureModel::edited);
        model.setLayers({0, 1}, QStringLiteral("Feel below"));
        QCOMPARE(edited.count(), 1); // of the moved structure
        QCOMPARE(model.hapticScene(kGreatest)->layerCount(), std::size_t{2});
        QCOMPARE(model.undoStack().undoText(), QStringLiteral("Feel below"));
        model.undoStack().undo();
        QCOMPARE(model.hapticScene(kGreatest)->layerCount(), std::size_t{1});
        model.undoStack().redo();
        QCOMPARE(model.structure(1).layer, 1u);
    }
    /// The enclosing organ, and not an impalpable vessel in between.
    void whatItIsBelowIsTheOrganThatIsFelt()
    {
        StructureModel model;
        std::vector<ui::StructureRow> rows = test::twoRows();
        rows.push_back(test::row("portal vein", test::ball(20.0, 3)));
        rows[2].in = 0;
        rows[1].in = 2;
        model.setRows(std::move(rows));
        model.setLayers({0, 2, 1}, QStringLiteral("Feel below"));
        QCOMPARE(model.touchOrderText(1, 2), QStringLiteral("below portal vein"));
        model.setData(model.index(2, StructureModel::Felt), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(model.touchOrderText(1, 2), QStringLiteral("below liver capsule"));
        QCOMPARE(model.touchOrderText(1, 1), QStringLiteral("below liver capsule"));
        QCOMPARE(model.touchOrderText(1, 3), QStringLiteral("3 below surface")); // another structure must be in between
        QCOMPARE(model.touchOrderText(2, 1), QStringLiteral("below liver capsule"));
    }
    void stepsOfOneDragUndoTogether()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        for (const double opacity : {0.9, 0.7, 0.5}) {
            meshio::SceneStructure one = model.structure(0);
            one.opacity = opacity;
            model.edit(0, one);
        }
        model.undoStack().undo();
        QCOMPARE(model.structure(0).opacity, 1.0);
    }
    void badgeIsForDefectsNotForRims()
    {
        geometry::TriangleMesh rim = test::ball(10.0, 2);
        rim.triangles.pop_back();
        geometry::TriangleMesh twice = test::ball(10.0, 2);
        twice.triangles.push_back(twice.triangles.front());
        std::vector<ui::StructureRow> rows;
        rows.push_back(test::row("vessel", rim));
        rows.push_back(test::row("broken", twice));
        StructureModel model;
        model.setRows(std::move(rows));
        const auto badge = [&](int row) {
            return model.data(model.index(row, StructureModel::Health), Qt::DecorationRole);
        };
        QVERIFY(!badge(0).isValid());
        QVERIFY(!model.findings(0).isEmpty());
        QCOMPARE(model.defects(0), QStringList{QStringLiteral("The mesh is open: feels like a sheet")});
        QVERIFY(badge(1).isValid());
        const QString tip = model.data(model.index(1, StructureModel::Health), Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(QStringLiteral("broken")) && tip.contains(QStringLiteral("repaired")), qPrintable(tip));
    }
    void aMeshIsSpokenOfAsItFeels()
    {
        geometry::TriangleMesh turned = test::ball(10.0, 2);
        geometry::flip(turned);
        geometry::TriangleMesh both = test::ball(10.0, 2);
        const auto count = static_cast<std::uint32_t>(both.vertices.size());
        both.vertices.insert(both.vertices.end(), {{50, 0, 0}, {51, 0, 0}, {50, 1, 0}});
        both.triangles.push_back({count, count + 1, count + 2});
        std::vector<ui::StructureRow> rows;
        rows.push_back(test::row("whole", test::ball(10.0, 2)));
        rows.push_back(test::row("turned", turned));
        rows.push_back(test::row("both", both));
        StructureModel model;
        model.setRows(std::move(rows));
        QCOMPARE(model.defects(0), QStringList());
        QCOMPARE(model.defects(1), QStringList{QStringLiteral("The mesh is inside out: palpable only from inside")});
        QCOMPARE(model.defects(2), QStringList{QStringLiteral("Part of the mesh is open: feels like a sheet there")});
    }
    void everyCellSaysItselfAloud()
    {
        StructureModel model;
        model.setRows(test::twoRows());
        for (const int column : {StructureModel::Shown, StructureModel::Name, StructureModel::Felt}) {
            QVERIFY(
                model.data(model.index(1, column), Qt::AccessibleTextRole).toString().contains(QStringLiteral("lump")));
        }
    }
};

PALPATE_TEST(StructureTable)
#include "tst_StructureTable.moc"
