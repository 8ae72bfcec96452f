// SPDX-License-Identifier: BSD-3-Clause
#include "../app/Program.h"
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "exercise/ExerciseDialog.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/ExerciseBar.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/MessageList.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QTextEdit>
#include <QUndoStack>

#include <vtkActor2DCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>

#include <algorithm>

using namespace palpate;
using core::Vec3;

/// Tests the exercise in the whole window: an organ of 80 mm with three targets, one felt through the organ, whose
/// names and files contain "quokka".
class Exercise : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::filesystem::path m_scene;
    ui::TouchReading m_reading;

    MainWindow& window() { return m_desk->window(); }
    ui::VtkViewport& viewport() { return window().viewport(); }
    QAction& command(const char* id) { return m_desk->command(id); }
    ui::ExerciseBar& bar() { return *window().findChild<ui::ExerciseBar*>(); }
    ui::MessageBar& messages() { return *window().findChild<ui::MessageBar*>(); }
    const ui::Messages& messageList()
    {
        return *qobject_cast<ui::Messages*>(window().findChild<ui::MessageList*>()->model());
    }
    app::ExerciseDialog* results() { return window().findChild<app::ExerciseDialog*>(); }

    /// Texts of everything that a user, a screen reader or a test program can read in the window, with their places.
    struct Text
    {
        QString place, text;
    };
    std::vector<Text> allTexts()
    {
        std::vector<Text> all;
        const auto add = [&all](const QString& place, const QString& text) {
            if (!text.isEmpty()) {
                all.push_back({place, text});
            }
        };
        for (QWidget* one : QApplication::allWidgets()) {
            const QString who =
                QStringLiteral("%1 %2").arg(QLatin1String(one->metaObject()->className()), one->objectName());
            for (const QString& text : {one->windowTitle(), one->toolTip(), one->statusTip(), one->whatsThis(),
                                        one->accessibleName(), one->accessibleDescription()}) {
                add(who, text);
            }
            for (const char* property : {"text", "plainText", "title", "placeholderText", "html"}) {
                add(who + QLatin1Char('.') + QLatin1String(property), one->property(property).toString());
            }
            if (const auto* box = qobject_cast<QComboBox*>(one)) {
                addModel(who, *box->model(), {}, add);
            }
            if (const auto* view = qobject_cast<QAbstractItemView*>(one); view != nullptr && view->model() != nullptr) {
                addModel(who, *view->model(), {}, add);
            }
            if (QAccessibleInterface* read = QAccessible::queryAccessibleInterface(one)) {
                for (const QAccessible::Text what : {QAccessible::Name, QAccessible::Description, QAccessible::Value}) {
                    add(who + QStringLiteral(" read"), read->text(what));
                }
            }
        }
        for (const QAction* one : window().findChildren<QAction*>()) {
            for (const QString& text : {one->text(), one->toolTip(), one->iconText(), one->statusTip()}) {
                add(QStringLiteral("command ") + one->objectName(), text);
            }
        }
        for (const auto* model : window().findChildren<QAbstractItemModel*>()) {
            addModel(QLatin1String(model->metaObject()->className()), *model, {}, add);
        }
        addModel(QStringLiteral("model"), window().model(), {}, add);
        const QUndoStack& undo = const_cast<ui::StructureModel&>(window().model()).undoStack();
        for (int i = 0; i < undo.count(); ++i) {
            add(QStringLiteral("undo"), undo.text(i));
        }
        addDrawn(add);
        return all;
    }
    template<class Add>
    void addModel(const QString& who, const QAbstractItemModel& model, const QModelIndex& parent, const Add& add)
    {
        for (int row = 0; row < model.rowCount(parent); ++row) {
            for (int column = 0; column < model.columnCount(parent); ++column) {
                const QModelIndex index = model.index(row, column, parent);
                for (const int role :
                     {int(Qt::DisplayRole), int(Qt::EditRole), int(Qt::ToolTipRole), int(Qt::StatusTipRole),
                      int(Qt::WhatsThisRole), int(Qt::AccessibleTextRole), int(Qt::AccessibleDescriptionRole)}) {
                    add(who, index.data(role).toString());
                }
            }
            addModel(who, model, model.index(row, 0, parent), add);
        }
    }
    /// Texts that the view draws.
    template<class Add>
    void addDrawn(const Add& add)
    {
        viewport().grabFramebuffer(); // lays the labels out
        vtkRendererCollection& renderers = *viewport().view().renderer().GetRenderWindow()->GetRenderers();
        for (int i = 0; i < renderers.GetNumberOfItems(); ++i) {
            auto* renderer = vtkRenderer::SafeDownCast(renderers.GetItemAsObject(i));
            vtkActor2DCollection& actors = *renderer->GetActors2D();
            for (int k = 0; k < actors.GetNumberOfItems(); ++k) {
                if (auto* text = vtkTextActor::SafeDownCast(actors.GetItemAsObject(k));
                    text != nullptr && text->GetVisibility() != 0 && text->GetInput() != nullptr) {
                    add(QStringLiteral("drawn"), QString::fromUtf8(text->GetInput()));
                }
            }
        }
        view::FindingMarkers& markers = viewport().view().findings();
        for (std::size_t i = 0; i < markers.marks().size(); ++i) {
            add(QStringLiteral("marker"), QString::fromStdString(markers.marks()[i].name));
        }
    }

    /// Returns the places of texts that contain the names of targets or their stand-in.
    QStringList leaks()
    {
        QStringList found;
        for (const Text& one : allTexts()) {
            if (one.text.contains(QStringLiteral("quokka"), Qt::CaseInsensitive) ||
                one.text.contains(QLatin1String(study::kUnnamed))) {
                // the models' own data of hidden rows, which no view lists, have the stand-in only
                if (!(one.place == QStringLiteral("model") && !one.text.contains(QStringLiteral("quokka")))) {
                    found << QStringLiteral("%1: %2").arg(one.place, one.text);
                }
            }
        }
        found.removeDuplicates();
        return found;
    }
    bool isAnyTargetDrawn()
    {
        const auto& rows = window().model().rows();
        for (std::size_t i = 1; i < rows.size(); ++i) { // the organ is first
            if (viewport().view().structure(i).picture.appearance().isVisible) {
                return true;
            }
        }
        return false;
    }

    /// Presses 9 mm in the middle of the view, over the first target.
    void press()
    {
        ui::PalpationController& hand = window().palpation();
        window().setPalpating(true);
        viewport().view().look(view::ViewFrom::Front);
        QTest::qWait(100);
        for (int i = 0; i < 8 && std::abs(hand.depth_mm() - 9.0) > 1e-9; ++i) {
            const double before_mm = hand.depth_mm();
            Q_EMIT viewport().depthTurned(1.0);
            Q_EMIT viewport().depthTurned((9.0 - hand.depth_mm()) / (hand.depth_mm() - before_mm));
        }
        m_reading = {};
        hand.pressAt({0.5 * viewport().width(), 0.5 * viewport().height()});
        PALPATE_TRY_VERIFY(std::abs(m_reading.depth_mm - 9.0) < 0.05);
    }
    void release()
    {
        window().palpation().letGo();
        PALPATE_TRY_COMPARE(m_reading.depth_mm, 0.0);
    }

    void picture(const char* name)
    {
        const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES");
        if (!folder.isEmpty()) {
            m_desk->picture().save(folder + QLatin1Char('/') + QLatin1String(name));
        }
    }

    void writeScene()
    {
        const auto write = [this](const char* name, const geometry::TriangleMesh& mesh) {
            (void)m_desk->writeStl(name, mesh);
        };
        write("organ.stl", test::sphere(12, 40.0));
        write("quokka_front.stl", test::moved(test::sphere(5, 6.0), Vec3(0, -32, 0)));
        write("quokka_left.stl", test::moved(test::sphere(5, 5.0), Vec3(30, 0, 0)));
        write("quokka_head.stl", test::moved(test::sphere(5, 5.0), Vec3(0, 0, 31)));
        m_scene = m_desk->folder() / "search.palpate.json";
        QFile file(QString::fromStdString(m_scene.string()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"version": 1, "structures": [
            {"name": "organ", "mesh": "organ.stl", "opacity": 0.5, "stiffness_N_per_mm": 0.2},
            {"name": "quokka one", "mesh": "quokka_front.stl", "layer": 1, "stiffness_N_per_mm": 0.8},
            {"name": "quokka_two", "mesh": "quokka_left.stl", "layer": 1, "stiffness_N_per_mm": 0.8},
            {"name": "quokka three", "mesh": "quokka_head.stl", "layer": 1, "stiffness_N_per_mm": 0.8}],
          "findings": [{"name": "old", "structure": "quokka one", "position": [0, -40, 0]}],
          "exercise": {"targets": ["quokka one", "quokka_two", "quokka three"], "time_s": 300, "force_ceiling_N": 2,
                       "coverage_goal": 0.5}})");
    }
    void openScene()
    {
        QVERIFY(m_desk->show());
        connect(&window().palpation(), &ui::PalpationController::touched, this,
                [this](const ui::TouchReading& reading) { m_reading = reading; });
        QVERIFY(m_desk->open({m_scene}));
        viewport().setFocus();
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        writeScene();
    }
    void cleanupTestCase() { m_desk.reset(); }

    void namesNoTargetUntilTheEndAndScoresAsTheCommand()
    {
        openScene();
        picture("exercise-1-waiting.png");
        QCOMPARE(window().model().scene().hiddenTargets(), std::size_t{3});
        QCOMPARE(leaks(), QStringList());
        QVERIFY(!isAnyTargetDrawn());
        const auto* count = window().findChild<QLabel*>(QStringLiteral("hiddenTargets"));
        QVERIFY(count->isVisible() && count->text().contains(QLatin1Char('3')));
        QVERIFY(!command("record").isEnabled() && command("exercise").isEnabled());

        // Before and during the search, no command gives a target away.
        command("exercise").trigger();
        PALPATE_TRY_VERIFY(command("record").isChecked());
        press();
        picture("exercise-2-running.png");
        QCOMPARE(m_reading.structure, QStringLiteral("organ"));
        QCOMPARE(m_reading.layers.size(), std::size_t{1});
        QVERIFY2(m_reading.force_N > 1.2 * 0.2 * 9.0, qPrintable(QString::number(m_reading.force_N))); // felt
        QVERIFY(std::abs(m_reading.layers.front().along_N - m_reading.force_N) < 0.01);
        QCOMPARE(viewport().view().cursor().state().innerCount, 0);
        QVERIFY(bar().texts().isAbove);
        m_desk->pressKeyOf("mark");
        for (const char* id :
             {"section", "peek", "felt", "distances", "tape", "touch-map-next", "measures", "report"}) {
            QVERIFY2(!command(id).isEnabled(), id);
            QVERIFY2(command(id).toolTip().startsWith(QStringLiteral("Off until")), id);
            if (!command(id).shortcut().isEmpty()) {
                m_desk->pressKeyOf(id);
            }
            command(id).setChecked(true); // as another command might
            QVERIFY2(!command(id).isChecked(), id);
        }
        QTest::qWait(600); // computations that a command would have started
        QCOMPARE(leaks(), QStringList());
        QVERIFY(!isAnyTargetDrawn());
        release();
        m_desk->pressKeyOf("undo"); // reverts the finding
        m_desk->pressKeyOf("redo");
        QCOMPARE(leaks(), QStringList());

        command("exercise").trigger(); // the end
        PALPATE_TRY_VERIFY(results() != nullptr && results()->scored().has_value());
        QVERIFY(isAnyTargetDrawn());
        picture("exercise-3-targets.png");
        QVERIFY(!leaks().isEmpty()); // the search for leaks finds names
        const study::ExerciseScore& score = results()->scored()->score;
        QCOMPARE(score.targets.size(), std::size_t{3});
        QCOMPARE(score.found(), std::size_t{1});
        QVERIFY(score.targets[0].found_s && score.above->time_s > 0.0 && *score.coverage() > 0.0);
        QCOMPARE(viewport().view().targets().texts().size(), std::size_t{3});

        // The numbers are those of the command line.
        const std::filesystem::path json = m_desk->folder() / "score.json";
        results()->saveTo(json);
        QFile written(QString::fromStdString(json.string()));
        QVERIFY(written.open(QIODevice::ReadOnly));
        const test::Outcome printed = test::runProgram(
            QString::fromStdString(m_desk->folder().string()),
            {"session", "exercise",
             QString::fromStdString((recordings() / results()->scored()->facts.recording).string()), "--json", "-"});
        QCOMPARE(printed.error, QByteArray());
        QCOMPARE(written.readAll(), printed.out);
        for (const char* name : {"page.html", "page.pdf"}) {
            results()->saveTo(m_desk->folder() / name);
            QVERIFY2(std::filesystem::file_size(m_desk->folder() / name) > 5000, name);
        }
        if (const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES"); !folder.isEmpty()) {
            results()->grab().save(folder + QStringLiteral("/exercise-4-results.png"));
            QFile::copy(QString::fromStdString((m_desk->folder() / "page.pdf").string()),
                        folder + QStringLiteral("/exercise.pdf"));
        }

        // Again: hidden as before, also after displays that named targets.
        command("felt").setChecked(true);
        command("distances").setChecked(true);
        QTest::qWait(500);
        messages().showError(QStringLiteral("Quokka_Two: open"));
        messages().offer(
            QStringLiteral("quokka one is inside out"), QStringLiteral("Turn"), [] {},
            ui::MessageBar::Keep::UntilAnswered);
        messages().showError(QStringLiteral("organ: open"));
        command("exercise-again").trigger();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(window().model().scene().hiddenTargets(), std::size_t{3});
        QTest::qWait(300);
        picture("exercise-5-again.png");
        QCOMPARE(leaks(), QStringList());
        QCOMPARE(messageList().text(messageList().rowCount() - 1), QStringLiteral("organ: open")); // no target
        QVERIFY(!isAnyTargetDrawn() && viewport().view().targets().marks().empty());
        QVERIFY(viewport().view().findings().marks().empty());
        QVERIFY(window().playback().recording() == nullptr);
    }
    /// Folder of new recordings.
    std::filesystem::path recordings() const
    {
        return std::filesystem::path(QDir::homePath().toStdString()) / "Documents" / "Palpate";
    }
};

PALPATE_TEST(Exercise)
#include "tst_Exercise.moc"
