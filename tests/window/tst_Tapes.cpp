// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/DistancesPanel.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TapesModel.h>
#include <palpate/ui/VtkViewport.h>

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>

#include <QAbstractItemView>
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QTableView>
#include <QTableWidget>
#include <QUndoStack>

#include <algorithm>
#include <cmath>

using namespace palpate;
using core::Vec3;

/// Tests distances and tapes in the whole window.
class Tapes : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::filesystem::path m_scene;
    QStringList m_meshes;

    ui::VtkViewport& viewport() { return m_desk->window().viewport(); }
    QTableWidget& table() { return *m_desk->window().findChild<QTableWidget*>("distanceTable"); }
    QString detail() { return m_desk->window().findChild<QLabel*>("distanceDetail")->text(); }
    ui::TapesModel& tapes()
    {
        return dynamic_cast<ui::TapesModel&>(*m_desk->window().findChild<QTableView*>("tapes")->model());
    }
    void click(const QPoint& place) { QTest::mouseClick(&viewport(), Qt::LeftButton, {}, place); }
  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        meshio::SceneFile scene;
        for (const auto& [name, mesh] : {std::pair("liver", test::box(Vec3(-50, -50, -50), Vec3(50, 50, 50), 4)),
                                         std::pair("tumour", test::box(Vec3(-5, -5, 30), Vec3(5, 5, 40), 2)),
                                         std::pair("vessel", test::box(Vec3(-20, -2, 23), Vec3(20, 2, 27), 2))}) {
            meshio::SceneStructure one;
            one.mesh = m_desk->writeStl((std::string(name) + ".stl").c_str(), mesh);
            one.name = name;
            one.opacity = one.name == "liver" ? 0.4 : 1.0;
            scene.structures.push_back(one);
            m_meshes << QString::fromStdString(one.mesh.string());
        }
        m_scene = m_desk->folder() / "case.palpate.json";
        QVERIFY(meshio::writeScene(m_scene, scene).isOk());
    }
    void init()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_scene}));
        viewport().setFocus();
        PALPATE_TRY_VERIFY(viewport().palpablePlace().has_value()); // ready for touch
    }
    void cleanupTestCase() { m_desk.reset(); }

    void tableHasTheNumbersOfTheCommandLine()
    {
        m_desk->pressKeyOf("distances");
        PALPATE_TRY_COMPARE(table().rowCount(), 2);
        QProcess program;
        program.start(QStringLiteral(PALPATE_EXECUTABLE), QStringList{"info", "--distances"} + m_meshes);
        QVERIFY(program.waitForFinished());
        const QString out = QString::fromUtf8(program.readAllStandardOutput());
        QStringList places;
        for (int row = 0; row < 2; ++row) {
            table().selectRow(row);
            const QStringList lines = detail().split(QLatin1Char('\n'));
            QCOMPARE(lines.size(), 2);
            QVERIFY2(out.contains("  distance: " + lines[0] + "\n"), qPrintable(lines[0] + "\n" + out));
            QVERIFY2(out.contains(": " + lines[1] + "\n"), qPrintable(lines[1] + "\n" + out));
            places << lines[0].section(QLatin1Char(':'), 0, 0);
        }
        QCOMPARE(places, QStringList({"tumour to vessel", "tumour to liver"})); // the nearest first
        auto* size = m_desk->window().findChild<QLabel*>("size");
        m_desk->window().findChild<ui::StructurePanel*>()->select(1);
        QVERIFY2(out.contains("  size: tumour: " + size->text() + "\n"), qPrintable(size->text() + "\n" + out));
    }

    void theChosenPairIsDrawn()
    {
        m_desk->pressKeyOf("distances");
        PALPATE_TRY_COMPARE(table().rowCount(), 2);
        view::SceneView& view = viewport().view();
        PALPATE_TRY_VERIFY(view.legend().isShown());
        viewport().grabFramebuffer();
        QCOMPARE(view.measures().texts(), std::vector<std::string>({"3.0 mm"}));
        const std::vector<std::string> marks = view.legend().markTexts();
        QCOMPARE(marks.size(), std::size_t{3});
        QVERIFY(detail().contains(QString::fromStdString(marks[0])));
        auto* mapper = vtkPolyDataMapper::SafeDownCast(view.structure(1).picture.actor()->GetMapper());
        vtkDataArray* distances = mapper->GetInput()->GetPointData()->GetArray("MarginDistance_mm");
        QVERIFY(distances != nullptr);
        QVERIFY(std::abs(distances->GetRange()[0] - 3.0) < 1e-5);

        auto* bands = m_desk->window().findChild<QLineEdit*>("bands");
        bands->setText(QStringLiteral("4"));
        Q_EMIT bands->editingFinished();
        PALPATE_TRY_COMPARE(view.legend().markTexts().size(), std::size_t{2});
        m_desk->window().findChild<ui::StructurePanel*>()->select(2);
        m_desk->command("remove").trigger();
        PALPATE_TRY_COMPARE(table().rowCount(), 1);
        m_desk->pressKeyOf("undo");
        PALPATE_TRY_COMPARE(table().rowCount(), 2);
        m_desk->pressKeyOf("distances");
        QVERIFY(!view.legend().isShown());
        QVERIFY(view.measures().lines().empty());
    }

    void bandsAreAscending()
    {
        using Limits = std::vector<double>;
        QCOMPARE(ui::DistancesPanel::limitsFrom("5; 10").value_or(Limits()), Limits({5.0, 10.0}));
        QCOMPARE(ui::DistancesPanel::limitsFrom("2.5,5 , 20").value_or(Limits()), Limits({2.5, 5.0, 20.0}));
        for (const char* bad : {"", "0", "10; 5", "5; 5", "a", "-1", "1 2 3 4 5", "nan", "1e9"}) {
            QVERIFY2(!ui::DistancesPanel::limitsFrom(bad), bad);
        }
    }

    void tapeIsClickedUndoneAndSaved()
    {
        // The tumour is opaque behind the translucent liver; the other end is on the liver alone.
        const QPoint from = viewport().placeOf(Vec3(0, 0, 35)).toPoint();
        const QPoint to = viewport().placeOf(Vec3(-42, -50, -40)).toPoint();
        const auto hit = viewport().view().pick(viewport().rayAt(to));
        QVERIFY(hit && hit->structure == 0);
        const Vec3 q = hit->hit.p_W;
        m_desk->pressKeyOf("tape");
        click(from);
        click(to);
        QCOMPARE(tapes().rowCount(), 1);
        const core::Tape tape = tapes().tapes()[0];
        QCOMPARE(tape.fromOn, std::string("tumour"));
        QCOMPARE(tape.toOn, std::string("liver"));
        QVERIFY((tape.to_W - q).norm() < 1e-9);
        const Vec3 inside = (tape.from_W - Vec3(0, 0, 35)).cwiseAbs(); // on the faces of the tumour
        QVERIFY(std::abs(inside.maxCoeff() - 5.0) < 1e-6);
        viewport().grabFramebuffer();
        QCOMPARE(viewport().view().measures().texts().size(), std::size_t{1});
        click(from); // the tape is put away after the second end
        QCOMPARE(tapes().rowCount(), 1);

        // The next end snaps to a finding a few pixels away.
        auto* table = m_desk->window().findChild<QAbstractItemView*>("findingsTable");
        dynamic_cast<ui::FindingsModel&>(*table->model()).add({{.name = "hard", .p_W = q}}, "test");
        QCoreApplication::processEvents();
        viewport().grabFramebuffer();
        m_desk->pressKeyOf("tape");
        click(from);
        click(to + QPoint(4, 3));
        QVERIFY((tapes().tapes()[1].to_W - q).norm() < 1e-12);
        QCOMPARE(tapes().tapes()[1].toOn, std::string("hard"));
        m_desk->pressKeyOf("undo");
        QCOMPARE(tapes().rowCount(), 1);
        m_desk->pressKeyOf("redo");
        m_desk->pressKeyOf("save");
        const auto saved = meshio::readScene(m_scene);
        QVERIFY(saved.isOk());
        QVERIFY(saved.value().tapes == tapes().tapes());
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_scene}));
        QCOMPARE(tapes().rowCount(), 2);
    }

    /// A click presses the hand and is an end, too; a press that moves or during which the key is pressed is none.
    void tapeIsClickedWhilePalpating()
    {
        const QPoint from = viewport().placeOf(Vec3(0, 0, 35)).toPoint();
        const QPoint to = viewport().placeOf(Vec3(-20, -50, -40)).toPoint();
        m_desk->pressKeyOf("palpate");
        viewport().setFocus();
        const int before = tapes().rowCount();
        click(from); // no tape is chosen
        m_desk->pressKeyOf("tape");
        click(from);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&viewport(), to);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
        QCOMPARE(tapes().rowCount(), before);
        click(to);
        QCOMPARE(tapes().rowCount(), before + 1);
        QCOMPARE(tapes().tapes().back().fromOn, std::string("tumour"));
        QCOMPARE(tapes().tapes().back().toOn, std::string("liver"));
        click(from); // the tape is put away
        QCOMPARE(tapes().rowCount(), before + 1);

        m_desk->pressKeyOf("tape");
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, to);
        PALPATE_TRY_VERIFY(viewport().view().cursor().state().isInContact);
        m_desk->pressKeyOf("tape");
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
        QCOMPARE(tapes().rowCount(), before + 1);
        PALPATE_TRY_VERIFY(!viewport().view().cursor().state().isInContact);
        m_desk->press(Qt::Key_Escape);
    }

    /// The hand touches two places by keys.
    void tapeIsTouchedByKeys()
    {
        const int before = tapes().rowCount();
        m_desk->pressKeyOf("palpate");
        viewport().setFocus();
        for (int end = 0; end < 2; ++end) {
            m_desk->press(Qt::Key_Return);
            PALPATE_TRY_VERIFY(viewport().view().cursor().state().isInContact);
            m_desk->pressKeyOf("tape");
            QCOMPARE(tapes().rowCount(), before + end);
            m_desk->press(Qt::Key_Return);
            PALPATE_TRY_VERIFY(!viewport().view().cursor().state().isInContact);
            for (int step = 0; step < 5; ++step) {
                m_desk->press(Qt::Key_Right, Qt::ControlModifier);
            }
        }
        const double length_mm = tapes().tapes().back().length_mm();
        QVERIFY2(length_mm > 5.0 && length_mm < 20.0, qPrintable(QString::number(length_mm)));
        m_desk->pressKeyOf("tape");
        m_desk->press(Qt::Key_Escape);
        QVERIFY(!m_desk->command("tape").isChecked());
    }
};

PALPATE_TEST(Tapes)

#include "tst_Tapes.moc"
