// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Desk.h"
#include "TestRunner.h"
#include "scene/CoordinatesChoice.h"
#include "scene/SceneFiles.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/MessageList.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include <fstream>

using namespace palpate;
using core::Vec3;

namespace {

QString textOf(const std::filesystem::path& file)
{
    return QString::fromStdString(file.string());
}

QJsonObject jsonOf(const std::filesystem::path& file)
{
    QFile in(textOf(file));
    return in.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(in.readAll()).object() : QJsonObject();
}

QStringList said; // Qt messages since the start of the test

void hear(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& line)
{
    said << line;
}

} // namespace

/// Tests how the window opens and saves files, driven by its commands: axes, names, other windows, backups of unsaved
/// changes.
class OpenedFiles : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    std::filesystem::path folder() const { return m_desk->folder(); }
    CoordinatesChoice& coordinates() const { return *m_desk->window().findChild<CoordinatesChoice*>(); }
    view::SceneView& view() const { return m_desk->window().viewport().view(); }
    /// Returns all messages of the window since it opened, from its message list.
    QString told() const
    {
        QStringList lines;
        const QAbstractItemModel& all = *m_desk->window().findChild<ui::MessageList*>()->model();
        for (int row = 0; row < all.rowCount(); ++row) {
            lines << all.index(row, 0).data().toString();
        }
        return lines.join('\n');
    }

    std::filesystem::path write(const char* name, const std::string& text) const
    {
        std::ofstream(folder() / name) << text;
        return folder() / name;
    }
    std::filesystem::path writeScene(const char* name, const char* fields = "", const char* findings = "") const
    {
        return write(name, R"({"version": 1, "structures": [{"mesh": "liver.stl", "name": "liver",
                              "stiffness_N_per_mm": 0.3)" +
                               std::string(fields) + R"(}], "findings": [)" + findings + "]}");
    }

    /// Triggers a command and answers its question with the named button. An empty name means that no question may
    /// appear.
    void answer(const char* command, const QString& button) const
    {
        bool isAsked = false, isAnswered = false;
        QTimer look;
        connect(&look, &QTimer::timeout, &look, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                isAsked = true;
                for (QAbstractButton* one : box->buttons()) {
                    if (one->text().remove('&') == button) {
                        isAnswered = true;
                        one->click();
                        return;
                    }
                }
                box->reject();
            }
        });
        look.start(20);
        m_desk->command(command).trigger();
        QVERIFY2(isAsked == !button.isEmpty(), isAsked ? "asked" : "not asked");
        QCOMPARE(isAnswered, isAsked);
    }

    bool readAgain(const char* command) const
    {
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        m_desk->command(command).trigger();
        return QTest::qWaitFor([&] { return ready.count() > 0; }, test::kPatience_ms);
    }

    static QString copies()
    {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/unsaved";
    }
    /// Writes a backup of unsaved changes, as a crashed process leaves behind.
    QString leaveCopy(const std::filesystem::path& of) const
    {
        QDir().mkpath(copies());
        QJsonObject scene = jsonOf(of);
        scene["copy_of"] = textOf(of);
        QJsonArray structures = scene["structures"].toArray();
        QJsonObject one = structures[0].toObject();
        one["mesh"] = textOf(folder() / "liver.stl");
        structures[0] = one;
        scene["structures"] = structures;
        QFile file(copies() + "/1.palpate.json");
        if (file.open(QIODevice::WriteOnly)) {
            file.write(QJsonDocument(scene).toJson());
        }
        return file.fileName();
    }
    /// Returns the button that restores unsaved changes; null if restoring is not offered.
    QPushButton* offer() const
    {
        for (QPushButton* button : m_desk->window().findChild<ui::MessageBar*>()->findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == QStringLiteral("Restore")) {
                return button;
            }
        }
        return nullptr;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QDir(copies()).removeRecursively();
        // Longer in x, y and z by 10, 20 and 30 mm: no rotation maps the shape to itself.
        m_desk->writeStl("liver.stl", test::box(Vec3(-20, -20, -20), Vec3(30, 40, 50), 2));
        for (const char* name : {"a.stl", "b.stl", "c.stl"}) {
            m_desk->writeStl(name, test::box(Vec3(60, 0, 0), Vec3(80, 20, 20), 2));
        }
    }
    void init()
    {
        said.clear();
        QVERIFY(m_desk->show());
    }
    void cleanupTestCase()
    {
        m_desk.reset();
        QDir(copies()).removeRecursively();
    }

    /// Points of 3D Slicer open with the anatomy or onto it, and say what is missing without it.
    void pointsBecomeFindings()
    {
        const auto points = write("F.mrk.json", R"({"@schema": "markups-schema-v1.0.3.json",
            "markups": [{"type": "Fiducial", "controlPoints": [{"label": "A", "position": [1, 2, 3]}]}]})");
        QSignalSpy failed(&m_desk->window(), &MainWindow::openFailed);
        m_desk->window().open({points});
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains(QLatin1String("F.mrk.json has points of 3D Slicer")));
        QVERIFY(m_desk->open({folder() / "liver.stl", points}));
        const QAbstractItemModel& findings = *m_desk->window().findChild<QAbstractItemView*>("findingsTable")->model();
        QCOMPARE(findings.rowCount(), 1);
        QCOMPARE(failed.count(), 1);
        m_desk->window().open({points});
        QCOMPARE(findings.rowCount(), 2);
        m_desk->command("undo").trigger();
        QCOMPARE(findings.rowCount(), 1);
    }
    /// The first structures are in the view before all are read; cancelling shows the welcome page again.
    void structuresAreShownWhileOthersAreRead()
    {
        ui::SceneLoader& loader = m_desk->window().findChild<app::SceneFiles*>()->loader();
        const ui::VtkViewport& viewport = m_desk->window().viewport();
        bool isCancelled = false;
        const auto cancel = connect(&loader, &ui::SceneLoader::structuresReady, &loader, [&] {
            QVERIFY(viewport.isVisible());
            QVERIFY(view().structureCount() > 0);
            QVERIFY(!m_desk->command("close").isEnabled()); // the document is empty
            loader.cancel();
            isCancelled = true;
        });
        QSignalSpy cancelled(&loader, &ui::SceneLoader::cancelled);
        m_desk->window().open(std::vector<std::filesystem::path>(300, folder() / "a.stl"));
        PALPATE_TRY_COMPARE(cancelled.count(), 1);
        QVERIFY(isCancelled);
        QVERIFY(!viewport.isVisible());
        QCOMPARE(view().structureCount(), std::size_t{0});
        disconnect(cancel);
        QVERIFY(m_desk->open({folder() / "liver.stl", folder() / "a.stl"}));
        QCOMPARE(view().structureCount(), std::size_t{2});
        QVERIFY(m_desk->command("close").isEnabled());
        std::size_t most = 0; // an open scene stays in the view until the next is complete
        connect(&loader, &ui::SceneLoader::structuresReady, &loader, [&] { most = view().structureCount(); });
        QVERIFY(m_desk->open({folder() / "a.stl", folder() / "b.stl", folder() / "c.stl"}));
        QCOMPARE(most, std::size_t{2});
        QCOMPARE(view().structureCount(), std::size_t{3});
    }
    /// When opening ends, view, panels, title and commands show the new scene, and nothing of the scene before.
    void everythingShowsTheNewSceneWhenOpeningEnds()
    {
        QVERIFY(m_desk->openPhantom());
        m_desk->command("palpate").setChecked(true);
        PALPATE_TRY_VERIFY(m_desk->window().playback().recording() != nullptr);
        const auto scene = writeScene("s.palpate.json", R"(, "visible": false}, {"mesh": "a.stl", "name": "lump")",
                                      R"({"name": "F", "position": [30, 10, 5], "structure": "liver"})");
        QVERIFY(m_desk->open({scene})); // returns with the signal `ready`
        const MainWindow& window = m_desk->window();
        QVERIFY(window.windowTitle().startsWith("s.palpate.json"));
        QVERIFY(!window.isWindowModified());
        QVERIFY(m_desk->window().viewport().isVisible() && m_desk->window().viewport().hasFocus());
        QCOMPARE(view().structureCount(), std::size_t{2});
        QVERIFY(!view().structure(0).picture.appearance().isVisible);
        QVERIFY(view().bounds().max() == Vec3(80, 20, 20)); // of the visible structure
        QVERIFY(!view().section());
        QCOMPARE(view().findings().count(), std::size_t{1});
        QVERIFY((view().findings().marks()[0].p_W - Vec3(30, 10, 5)).norm() < 1e-9);
        const Vec3 focus(view().camera().GetFocalPoint());
        QVERIFY((focus - Vec3(70, 10, 10)).norm() < 1e-6); // the camera looks at its middle
        const QAbstractItemModel& list = *window.findChild<QTreeView*>()->model();
        QCOMPARE(list.rowCount(), 2);
        QCOMPARE(list.index(0, ui::StructureModel::Name).data().toString(), QStringLiteral("liver"));
        QVERIFY(window.findChild<QTreeView*>()->selectionModel()->isRowSelected(0));
        QCOMPARE(window.findChild<QAbstractItemView*>("findingsTable")->model()->rowCount(), 1);
        QVERIFY(m_desk->window().playback().recording() == nullptr);
        QVERIFY(m_desk->command("close").isEnabled() && m_desk->command("record").isEnabled());
        QVERIFY(!m_desk->command("measures").isEnabled()); // of the recording before
        QVERIFY(!window.findChild<app::SceneFiles*>()->loader().isBusy());
        for (const QProgressBar* bar : window.findChildren<QProgressBar*>()) {
            QVERIFY(!bar->isVisible());
        }
    }

    void axesThatNobodySaidAreQuestioned()
    {
        QVERIFY(!coordinates().button().isVisible());
        QVERIFY(m_desk->open({folder() / "liver.stl"}));
        QVERIFY(coordinates().button().isVisible());
        QCOMPARE(coordinates().button().text(), QStringLiteral("LPS assumed"));
        QCOMPARE(view().cube().left(), std::string("L?"));
        QVERIFY(!m_desk->command("frame-lps").isChecked());
        QVERIFY(readAgain("frame-lps")); // explicitly stated: nothing moves
        QCOMPARE(coordinates().button().text(), QStringLiteral("LPS"));
        QCOMPARE(view().cube().left(), std::string("L"));
        QVERIFY(view().bounds().max() == Vec3(30, 40, 50));
        QVERIFY(m_desk->command("frame-lps").isChecked());
    }

    void aTagIsNotQuestioned()
    {
        QVERIFY(m_desk->openPhantom());
        QCOMPARE(coordinates().button().text(), QStringLiteral("LPS"));
        QCOMPARE(view().cube().left(), std::string("L"));
    }

    void chosenAxesTurnTheSceneAndAreKept()
    {
        const auto scene =
            writeScene("s.palpate.json", "", R"({"name": "F", "position": [30, 10, 5], "structure": "liver",
                "camera": {"position": [300, 0, 50], "focus": [30, 10, 5], "up": [0, 0, 1], "viewAngle_deg": 30}})");
        QVERIFY(m_desk->open({scene}));
        QCOMPARE(coordinates().button().text(), QStringLiteral("LPS assumed"));
        QVERIFY(!m_desk->window().isWindowModified());
        QVERIFY(readAgain("frame-ras"));
        QVERIFY(view().bounds().min() == Vec3(-30, -40, -20) && view().bounds().max() == Vec3(20, 20, 50));
        QCOMPARE(coordinates().button().text(), QStringLiteral("RAS"));
        QCOMPARE(view().cube().left(), std::string("L"));
        QVERIFY2(told().contains("The meshes were read again with coordinates RAS"), qPrintable(told()));
        QVERIFY(m_desk->window().isWindowModified());
        answer("save", {});
        QVERIFY(!m_desk->window().isWindowModified());
        const QJsonObject saved = jsonOf(scene);
        QCOMPARE(saved["structures"][0]["frame"].toString(), QStringLiteral("RAS"));
        QCOMPARE(saved["structures"][0]["stiffness_N_per_mm"].toDouble(), 0.3);
        // at the same position on the liver
        QCOMPARE(saved["findings"][0]["position"], (QJsonArray{-30.0, -10.0, 5.0}));
        QCOMPARE(saved["findings"][0]["camera"]["position"], (QJsonArray{-300.0, 0.0, 50.0}));
        QVERIFY(readAgain("frame-y-up"));
        QVERIFY(view().bounds().min() == Vec3(-20, -50, -20) && view().bounds().max() == Vec3(30, 20, 40));
        QCOMPARE(coordinates().button().text(), QStringLiteral("Y up"));
        answer("save", {});
        QCOMPARE(jsonOf(scene)["findings"][0]["position"], (QJsonArray{30.0, -5.0, 10.0}));
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({scene}));
        QVERIFY(view().bounds().max() == Vec3(30, 20, 40));
        QCOMPARE(view().cube().left(), std::string("L"));
    }

    void whatIsChangedMeanwhileIsKept()
    {
        QVERIFY(m_desk->open({folder() / "liver.stl", folder() / "a.stl"}));
        QAbstractItemModel& list = *m_desk->window().findChild<QTreeView*>()->model();
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        m_desk->command("frame-ras").trigger();
        const QModelIndex shown = list.index(0, ui::StructureModel::Shown);
        QVERIFY(list.setData(shown, Qt::Unchecked, Qt::CheckStateRole));
        PALPATE_TRY_COMPARE(ready.count(), 1);
        QCOMPARE(shown.model()->index(0, ui::StructureModel::Shown).data(Qt::CheckStateRole).toInt(),
                 static_cast<int>(Qt::Unchecked));
        QCOMPARE(coordinates().button().text(), QStringLiteral("RAS"));
        QVERIFY(view().bounds().min() == Vec3(-80, -20, 0)); // bounds of the visible structures
    }

    void notesStandAmongTheMessages()
    {
        QVERIFY(m_desk->open({folder() / "liver.stl"}));
        QVERIFY2(told().contains("no SPACE tag: coordinates taken as LPS"), qPrintable(told()));
    }

    void twoWindowsDoNotWipeEachOthersScene()
    {
        const auto scene = writeScene("two.palpate.json");
        QVERIFY(m_desk->open({scene}));
        answer("save", {}); // no other process changed the file
        const auto other = [&] { writeScene("two.palpate.json", "", R"({"name": "theirs", "position": [1, 2, 3]})"); };
        other();
        answer("save", QStringLiteral("Cancel"));
        QCOMPARE(jsonOf(scene)["findings"][0]["name"].toString(), QStringLiteral("theirs"));
        answer("save", QStringLiteral("Save anyway"));
        QCOMPARE(jsonOf(scene)["findings"].toArray().size(), 0);
        answer("save", {}); // the window's own write is no foreign change
        other();
        answer("save", QStringLiteral("Cancel"));
        QVERIFY(QFile::remove(textOf(scene))); // deleted: nothing can be lost
        answer("save", {});
        QVERIFY(QFile::exists(textOf(scene)));
    }

    void theTitleNamesWhatIsOpen()
    {
        const auto other = write("other.json", R"({"a": 1})");
        QVERIFY(m_desk->open({other, folder() / "liver.stl"}));
        QCOMPARE(m_desk->window().windowTitle(), QStringLiteral("liver.stl[*] – Palpate"));
        QVERIFY(m_desk->window().findChild<ui::MessageBar*>()->text().contains("other.json: is not a Palpate scene"));
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({folder() / "liver.stl", folder() / "a.stl", folder() / "b.stl"}));
        QCOMPARE(m_desk->window().windowTitle(), QStringLiteral("liver.stl and 2 more[*] – Palpate"));
    }

    void findingsOfASecondSceneAreKept()
    {
        const auto one = writeScene("one.palpate.json", "", R"({"name": "A", "position": [30, 0, 0]})");
        const auto two = write("more.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.stl"}], "findings":
            [{"name": "B", "position": [60, 5, 5]}, {"name": "C", "position": [60, 9, 9]}]})");
        QVERIFY(m_desk->open({one, two}));
        PALPATE_TRY_COMPARE(view().findings().count(), std::size_t{3});
        QCOMPARE(m_desk->window().windowTitle(), QStringLiteral("one.palpate.json and 1 more[*] – Palpate"));
    }

    void unsavedChangesComeBackOnce()
    {
        const auto scene = writeScene("r.palpate.json", "", R"({"name": "A", "position": [30, 0, 0]})");
        const QString copy = leaveCopy(scene);
        QVERIFY(m_desk->show());
        PALPATE_TRY_VERIFY(offer() != nullptr);
        const QtMessageHandler before = qInstallMessageHandler(hear);
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        offer()->click();
        PALPATE_TRY_COMPARE(ready.count(), 1);
        qInstallMessageHandler(before);
        QVERIFY2(!said.join('\n').contains("setWindowModified"), qPrintable(said.join('\n')));
        QCOMPARE(m_desk->window().windowTitle(), QStringLiteral("r.palpate.json[*] – Palpate"));
        QVERIFY(m_desk->window().isWindowModified());
        QVERIFY(!QFile::exists(copy));
        const QStringList ours = QDir(copies()).entryList({"*.palpate.json"}, QDir::Files); // until they are saved
        QCOMPARE(ours.size(), 1);
        QCOMPARE(jsonOf((copies() + '/' + ours[0]).toStdString())["findings"].toArray().size(), 1);
        m_desk->close();
    }

    /// The sample opens without a file of its own: saving asks for one and proposes a folder of the user's.
    void theSampleIsNeverOverwritten()
    {
        const std::filesystem::path sample = folder() / "data" / "phantom";
        std::filesystem::create_directories(sample.parent_path());
        std::filesystem::copy(std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom", sample,
                              std::filesystem::copy_options::recursive);
        qputenv("PALPATE_DATA_DIR", QByteArray::fromStdString((folder() / "data").string()));
        const auto restored = qScopeGuard([] { qunsetenv("PALPATE_DATA_DIR"); });
        const std::string before = meshio::fileHash(sample / "phantom.palpate.json");
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({sample / "phantom.palpate.json"}));
        QVERIFY2(m_desk->window().windowTitle().startsWith(QStringLiteral("Unsaved copy of phantom.palpate.json")),
                 qPrintable(m_desk->window().windowTitle()));
        const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        QVERIFY(QDir().mkpath(documents));
        QString proposed;
        QTimer look;
        connect(&look, &QTimer::timeout, &look, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                proposed = dialog->directory().absolutePath();
                dialog->reject();
            }
        });
        look.start(50);
        m_desk->command("save").trigger();
        QCOMPARE(proposed, documents);
        QCOMPARE(meshio::fileHash(sample / "phantom.palpate.json"), before);
    }

    void anotherWindowWasFaster()
    {
        const auto scene = writeScene("r.palpate.json");
        const QString copy = leaveCopy(scene);
        QVERIFY(m_desk->show());
        PALPATE_TRY_VERIFY(offer() != nullptr);
        QLockFile others(copy + ".lock"); // the other process has the scene open
        others.setStaleLockTime(0);
        QVERIFY(others.tryLock(0));
        offer()->click();
        QVERIFY2(told().contains("already restored in another window"), qPrintable(told()));
        others.unlock();
        QVERIFY(m_desk->show());
        PALPATE_TRY_VERIFY(offer() != nullptr);
        QVERIFY(QFile::remove(copy)); // the other process has finished
        offer()->click();
        QVERIFY2(told().contains("already restored in another window"), qPrintable(told()));
    }
};

PALPATE_TEST(OpenedFiles)
#include "tst_OpenedFiles.moc"
