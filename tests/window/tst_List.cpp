// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include "../support/Shapes.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QTreeView>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace palpate;
using core::Vec3;

/// Tests the structure list by keyboard and pointer: add, rename, filter, group, select, remove, undo. Requires a
/// display.
class List : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::filesystem::path m_liver, m_tumour, m_vein;

    MainWindow& window() { return m_desk->window(); }
    QTreeView& list() { return *window().findChild<ui::StructurePanel*>()->findChild<QTreeView*>(); }
    QLineEdit& filter() { return *window().findChild<QLineEdit*>(QStringLiteral("filter")); }
    ui::MessageBar& message() { return *window().findChild<ui::MessageBar*>(); }

    QStringList names()
    {
        QStringList names;
        for (int row = 0; row < list().model()->rowCount(); ++row) {
            names << list().model()->index(row, ui::StructureModel::Name).data().toString();
        }
        return names;
    }

    /// Presses the command's shortcut and types a file path into the dialog.
    bool add(const std::filesystem::path& file)
    {
        QSignalSpy ready(&window(), &MainWindow::ready);
        QTimer typist;
        connect(&typist, &QTimer::timeout, this, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                auto* field = dialog->findChild<QLineEdit*>();
                field->setText(QString::fromStdString(file.string()));
                QTest::keyClick(field, Qt::Key_Return);
            }
        });
        typist.start(100);
        m_desk->pressKeyOf("add");
        typist.stop();
        window().activateWindow(); // without a window manager nothing activates the window after a dialog
        return QTest::qWaitFor([&] { return ready.count() > 0 && window().isActiveWindow(); }, 60000);
    }

    void drop(const std::filesystem::path& file)
    {
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
        QDragEnterEvent enter({400, 400}, Qt::CopyAction, &files, Qt::LeftButton,
                              Qt::NoModifier); // selects the drop target
        QApplication::sendEvent(&window(), &enter);
        QDropEvent drop(QPointF(400, 400), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &drop);
    }

    void answer(const char* text)
    {
        for (QPushButton* button : message().findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == QLatin1String(text)) {
                button->click();
                return;
            }
        }
    }

    /// Writes a scene with many structures in one file, 4 triangles each.
    std::filesystem::path writeMany(int count) const
    {
        const std::filesystem::path path = m_desk->folder() / "many.obj";
        std::ofstream out(path);
        for (int i = 0; i < count; ++i) {
            const double x = 20.0 * (i % 20), z = 20.0 * (i / 20);
            out << "g part_" << i << (i % 3 == 0 ? "_rib" : "_node") << '\n';
            for (const Vec3& p : {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0), Vec3(0, 0, 10)}) {
                out << "v " << p.x() + x << ' ' << p.y() << ' ' << p.z() + z << '\n';
            }
            for (const char* face : {"-4 -2 -3", "-4 -3 -1", "-3 -2 -1", "-4 -1 -2"}) {
                out << "f " << face << '\n';
            }
        }
        return path;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        m_desk = std::make_unique<test::Desk>();
        m_liver = m_desk->writeStl("one/liver.stl", test::sphere(16, 20.0));
        m_tumour = m_desk->writeStl("two/tumour.stl", test::moved(test::sphere(8, 5.0), Vec3(0, -7, 0)));
        m_vein = m_desk->writeStl("two/portal_vein.stl", test::moved(test::sphere(8, 5.0), Vec3(60, 0, 0)));
    }
    void cleanup()
    {
        if (m_desk != nullptr) {
            m_desk->close();
        }
    }
    void cleanupTestCase() { m_desk.reset(); }

    void aForgottenFileIsAddedRenamedFoundAndRemoved()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver}));
        window().viewport().setFocus();
        QVERIFY(add(m_tumour));
        QCOMPARE(names(), QStringList({"liver", "tumour"}));
        QCOMPARE(window().viewport().view().structureCount(), std::size_t{2});
        QCOMPARE(test::newest(message().text()), QStringLiteral("tumour lies in liver and is felt through it, 4.4 (1 … "
                                                                "5.2) times as stiff (published for such lumps)."));
        QVERIFY(window().isWindowModified());

        list().setFocus();
        m_desk->press(Qt::Key_F2);
        auto* editor = list().viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, "lesion in IV");
        QTest::keyClick(editor, Qt::Key_Return);
        PALPATE_TRY_COMPARE(names(), QStringList({"liver", "lesion in IV"}));

        PALPATE_TRY_VERIFY(list().hasFocus()); // the filter field returned the focus
        m_desk->pressKeyOf("filter");
        QVERIFY(filter().hasFocus());
        QTest::keyClicks(&filter(), "iv les");
        QCOMPARE(names(), QStringList({"lesion in IV"}));
        m_desk->press(Qt::Key_Escape);
        QCOMPARE(names().size(), 2);
        QVERIFY(list().hasFocus());

        m_desk->press(Qt::Key_Delete);
        QCOMPARE(names(), QStringList({"liver"}));
        QVERIFY(!window().viewport().view().structure(1).picture.appearance().isVisible);
        QVERIFY(window().viewport().view().structure(1).touchable == nullptr);
        m_desk->pressKeyOf("undo");
        QCOMPARE(names(), QStringList({"liver", "lesion in IV"}));
        QVERIFY(window().viewport().view().structure(1).picture.appearance().isVisible);
        m_desk->pressKeyOf("undo");
        QCOMPARE(names(), QStringList({"liver", "tumour"}));
        m_desk->pressKeyOf("undo"); // added, with layer and tissue, in one step
        QCOMPARE(names(), QStringList({"liver"}));
        QVERIFY(!window().isWindowModified());
        m_desk->pressKeyOf("redo");
        QCOMPARE(names(), QStringList({"liver", "tumour"}));
    }

    void aDropAsksWhetherToAddOrToOpen()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver}));
        QSignalSpy ready(&window(), &MainWindow::ready);
        drop(m_vein);
        QCOMPARE(test::newest(message().text()), QStringLiteral("Add portal_vein.stl to the open scene?"));
        answer("Add");
        PALPATE_TRY_COMPARE(ready.count(), 1);
        QCOMPARE(names(), QStringList({"liver", "portal vein"}));
    }

    void severalAreChangedAsOneStep()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver, m_tumour, m_vein}));
        list().setFocus();
        list().selectAll();
        m_desk->press(Qt::Key_E, Qt::ControlModifier);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(!window().viewport().view().structure(i).picture.appearance().isVisible);
        }
        m_desk->pressKeyOf("undo");
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(window().viewport().view().structure(i).picture.appearance().isVisible);
        }
        list().selectAll();
        m_desk->press(Qt::Key_Delete);
        QCOMPARE(list().model()->rowCount(), 0);
        m_desk->pressKeyOf("undo");
        QCOMPARE(list().model()->rowCount(), 3);
    }

    /// Names that determine a colour also determine tissue, opacity and contact, and one undo reverts this.
    void namesChooseTissue()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver, m_vein}));
        QCOMPARE(test::newest(message().text()),
                 QStringLiteral(
                     "The tissue of liver was chosen by its name. Vessels, nerves and ducts that are not felt: 1."));
        QVERIFY(!window().isWindowModified());
        const view::SceneView& view = window().viewport().view();
        PALPATE_TRY_VERIFY(view.structure(1).touchable == nullptr);
        QVERIFY(view.structure(0).touchable != nullptr);
        m_desk->pressKeyOf("undo");
        PALPATE_TRY_VERIFY(view.structure(1).touchable != nullptr);
    }

    /// One choice gives all palpable structures with unknown names a tissue, as one undo step.
    void unknownNamesGetATissueAtOnce()
    {
        const geometry::TriangleMesh ball = test::sphere(8, 15.0);
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver, m_desk->writeStl("u/thing_a.stl", test::moved(ball, Vec3(60, 0, 0))),
                              m_desk->writeStl("u/thing_b.stl", test::moved(ball, Vec3(120, 0, 0)))}));
        QVERIFY2(test::newest(message().text()).contains(QStringLiteral("No preset matches the name of 2: ")),
                 qPrintable(message().text()));
        QPushButton* all = nullptr;
        for (QPushButton* one : message().findChildren<QPushButton*>()) {
            all = one->text() == QStringLiteral("Choose for all…") ? one : all;
        }
        QVERIFY(all != nullptr);
        all->click();
        auto* menu = message().findChild<QMenu*>(QStringLiteral("tissueForAll"));
        QVERIFY(menu != nullptr);
        const auto actions = menu->actions();
        const auto kidney = std::find_if(actions.begin(), actions.end(), [](const QAction* one) {
            return one->text().startsWith(QStringLiteral("Kidney"));
        });
        QVERIFY(kidney != actions.end());
        const auto stiffness = [this](int row) { return window().model().structure(row).tissue.stiffness_N_per_mm; };
        const double liver_N_per_mm = stiffness(0);
        (*kidney)->trigger();
        menu->close();
        QVERIFY(stiffness(1) != 0.5 && stiffness(1) == stiffness(2));
        QCOMPARE(stiffness(0), liver_N_per_mm);
        m_desk->pressKeyOf("undo");
        QCOMPARE(stiffness(1), 0.5);
        QCOMPARE(stiffness(2), 0.5);
    }

    void clickingAnatomySelectsIt()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver, m_tumour,
                              m_desk->writeStl("two/spleen.stl", test::moved(test::sphere(8, 15.0), Vec3(60, 0, 0)))}));
        ui::VtkViewport& viewport = window().viewport();
        viewport.view().look(view::ViewFrom::Front);
        viewport.view().fitAll();
        viewport.update();
        QTest::qWait(50);
        std::vector<QPoint> places; // centres of liver and spleen
        for (const std::size_t wanted : {std::size_t{0}, std::size_t{2}}) {
            for (int x = 5; x < viewport.width(); x += 5) {
                const auto pick = viewport.view().pick(viewport.rayAt(QPointF(x, 0.5 * viewport.height())));
                if (pick && pick->structure == wanted) {
                    places.emplace_back(x + 10, viewport.height() / 2);
                    break;
                }
            }
        }
        QCOMPARE(places.size(), std::size_t{2});
        const auto selected = [this] {
            QStringList names;
            for (const QModelIndex& one : list().selectionModel()->selectedRows(ui::StructureModel::Name)) {
                names << one.data().toString();
            }
            names.sort();
            return names;
        };
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, places[1]);
        QCOMPARE(selected(), QStringList({"spleen"}));
        QTest::mouseClick(&viewport, Qt::LeftButton, Qt::ControlModifier, places[0]);
        QCOMPARE(selected(), QStringList({"liver", "spleen"}));
        QTest::mousePress(&viewport, Qt::LeftButton, {}, places[1]); // dragging the view does not select
        QTest::mouseMove(&viewport, places[1] + QPoint(40, 0));
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, places[1] + QPoint(40, 0));
        QCOMPARE(selected(), QStringList({"liver", "spleen"}));
    }

    /// A concurrent recording has every tick and describes the scene at each time.
    void aRecordingRunsThroughAddingAndRemoving()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver}));
        ui::PalpationController& hand = window().palpation();
        double force_N = 0.0;
        connect(&hand, &ui::PalpationController::touched, this,
                [&](const ui::TouchReading& touch) { force_N = touch.force_N; });
        window().viewport().setFocus();
        m_desk->pressKeyOf("record");
        hand.pressAt({0.5 * window().viewport().width(), 0.5 * window().viewport().height()});
        PALPATE_TRY_VERIFY(force_N > 0.05);
        QSignalSpy ready(&window(), &MainWindow::ready);
        drop(m_vein);
        answer("Add");
        PALPATE_TRY_COMPARE(ready.count(), 1);
        list().setFocus();
        list().setCurrentIndex(list().model()->index(0, ui::StructureModel::Name));
        m_desk->press(Qt::Key_Delete); // under the hand
        PALPATE_TRY_COMPARE(force_N, 0.0);
        m_desk->pressKeyOf("undo");
        QTest::qWait(200);
        hand.letGo();
        window().viewport().setFocus(); // in the list, letters select by name
        m_desk->pressKeyOf("record");
        const ui::RecordedTouch* recorded = window().playback().recording();
        QVERIFY(recorded != nullptr);
        const auto reader = session::RecordingReader::open(recorded->path());
        QVERIFY(reader.isOk());
        QCOMPARE(reader.value()->extent().dropped, 0);
        std::vector<std::size_t> counts;
        std::size_t removed = 0;
        for (const session::SceneRecord& scene : reader.value()->scenes()) {
            counts.push_back(scene.structures.size());
            removed += scene.structures.front().palpable ? 0 : 1;
        }
        QCOMPARE(counts.front(), std::size_t{1});
        QCOMPARE(counts.back(), std::size_t{2});
        QCOMPARE(removed, std::size_t{1});
        QVERIFY(reader.value()->verify().isOk());
    }

    void whatIsSavedIsWhatIsThere()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver, m_tumour, m_vein}));
        list().setFocus();
        list().setCurrentIndex(list().model()->index(1, ui::StructureModel::Name));
        m_desk->press(Qt::Key_Delete);
        const std::filesystem::path file = m_desk->folder() / "saved.palpate.json";
        QTimer typist;
        connect(&typist, &QTimer::timeout, this, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                auto* field = dialog->findChild<QLineEdit*>();
                field->setText(QString::fromStdString(file.string()));
                QTest::keyClick(field, Qt::Key_Return);
            }
        });
        typist.start(100);
        m_desk->pressKeyOf("save-as");
        typist.stop();
        const auto saved = meshio::readScene(file);
        QVERIFY(saved.isOk());
        QCOMPARE(saved.value().structures.size(), std::size_t{2});
        QCOMPARE(saved.value().structures[0].name, std::string("liver"));
        QCOMPARE(saved.value().structures[1].name, std::string("portal_vein"));
        QVERIFY(!saved.value().structures[1].sha256.empty());
        QVERIFY(!window().isWindowModified());
    }

    void threeHundredAreFilteredAtOnce()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({writeMany(300)}));
        QCOMPARE(list().model()->rowCount(), 300);
        m_desk->pressKeyOf("filter");
        QElapsedTimer timer;
        timer.start();
        QTest::keyClicks(&filter(), "rib");
        QCOMPARE(list().model()->rowCount(), 100);
        qInfo("filtered 300 by three letters in %lld ms", static_cast<long long>(timer.elapsed()));
        timer.restart();
        m_desk->press(Qt::Key_Escape);
        QCoreApplication::processEvents();
        QCOMPARE(list().model()->rowCount(), 300);
        qInfo("listed 300 in %lld ms", static_cast<long long>(timer.elapsed()));
        list().selectAll();
        timer.restart();
        m_desk->press(Qt::Key_E, Qt::ControlModifier);
        qInfo("hid 300 in %lld ms", static_cast<long long>(timer.elapsed()));
        QVERIFY(!window().viewport().view().structure(299).picture.appearance().isVisible);
    }

    void closingGoesBackToTheStart()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_liver}));
        m_desk->pressKeyOf("close");
        QVERIFY(!window().viewport().isVisible());
        QCOMPARE(list().model()->rowCount(), 0);
        QVERIFY(!m_desk->command("add").isEnabled());
        QVERIFY(m_desk->open({m_tumour}));
        QCOMPARE(names(), QStringList({"tumour"}));
    }
};

PALPATE_TEST(List)
#include "tst_List.moc"
