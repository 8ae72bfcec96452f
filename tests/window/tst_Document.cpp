// SPDX-License-Identifier: BSD-3-Clause
#include "FileLimits.h"
#include "TestRunner.h"
#include "scene/SceneDocument.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace palpate;

class Document : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static QString copies()
    {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/unsaved";
    }

    static QStringList copyNames() { return QDir(copies()).entryList({"*.palpate.json"}, QDir::Files); }

    static QByteArray bytes(const QString& name)
    {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("nothing");
    }

    /// Returns a scene of one structure, as opened by the window.
    static ui::OpenedScene opened(ui::StructureModel& model, const std::filesystem::path& file)
    {
        ui::OpenedScene scene;
        scene.files = {file};
        if (auto read = meshio::readScene(file); read.isOk()) {
            scene.scene = read.value();
        }
        std::vector<ui::StructureRow> rows(1);
        rows[0].loaded.description = scene.scene.structures.at(0);
        model.setRows(std::move(rows));
        return scene;
    }

    QJsonObject json(const std::filesystem::path& file) const
    {
        QFile in(QString::fromStdString(file.string()));
        return in.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(in.readAll()).object() : QJsonObject();
    }

  private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QDir(copies()).removeRecursively();
        QFile file(m_folder.filePath("a.palpate.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"version": 1, "author": "A", "structures": [{"mesh": "a.stl", "breathing": 1}],
                       "findings": [{"name": "old", "position": [1, 2, 3], "size": 4}]})");
        QFile mesh(m_folder.filePath("a.stl"));
        QVERIFY(mesh.open(QIODevice::WriteOnly));
        mesh.write("mesh");
    }

    void cleanupTestCase() { QDir(copies()).removeRecursively(); }

    void savesEverythingAndKeepsWhatItDoesNotKnow()
    {
        ui::StructureModel model;
        SceneDocument document(model);
        ui::OpenedScene scene = opened(model, path("a.palpate.json"));
        meshio::SceneStructure gone;
        gone.mesh = path("gone.stl");
        scene.unopened = {gone};
        document.take(scene);
        QVERIFY(!document.isModified());
        std::vector<std::string> told; // messages to an active recording
        connect(&document, &SceneDocument::marked, this, [&](const core::Finding& f) { told.push_back("+" + f.name); });
        connect(&document, &SceneDocument::unmarked, this,
                [&](const core::Finding& f) { told.push_back("-" + f.name); });
        document.addFinding({"new", {4, 5, 6}, "hard"});
        meshio::SceneStructure edited = model.structure(0);
        edited.tissue.stiffness_N_per_mm = 0.9;
        model.edit(0, edited);
        QVERIFY(document.isModified());
        QCOMPARE(document.findings().size(), std::size_t{2});
        model.undoStack().undo();
        model.undoStack().undo();
        QCOMPARE(document.findings().size(), std::size_t{1});
        QVERIFY(!document.isModified());
        model.undoStack().redo();
        model.undoStack().redo();
        QCOMPARE(document.findings().size(), std::size_t{2});
        QCOMPARE(told, (std::vector<std::string>{"+new", "-new", "+new"}));
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.9);

        QVERIFY(QDir(m_folder.path()).mkpath("elsewhere"));
        QVERIFY(document.save(path("elsewhere/b.palpate.json"), {}).isOk());
        QVERIFY(!document.isModified());
        QCOMPARE(document.file(), path("elsewhere/b.palpate.json"));
        const QJsonObject saved = json(path("elsewhere/b.palpate.json"));
        QCOMPARE(saved["author"].toString(), QString("A"));
        const QJsonArray structures = saved["structures"].toArray();
        QCOMPARE(structures.size(), 2); // including the missing structure
        QCOMPARE(structures.at(0).toObject().value("mesh").toString(), QString("../a.stl"));
        QCOMPARE(structures.at(0).toObject().value("breathing").toInt(), 1);
        QCOMPARE(structures.at(0).toObject().value("sha256").toString().toStdString(), meshio::fileHash(path("a.stl")));
        QCOMPARE(structures.at(1).toObject().value("mesh").toString(), QString("../gone.stl"));
        QCOMPARE(saved["findings"].toArray().size(), 2);
        QCOMPARE(saved["findings"].toArray().at(0).toObject().value("size").toInt(), 4);
        QVERIFY(!document.save(path("no/such/folder.palpate.json"), {}).isOk());
    }

    void unsavedChangesSurviveACrash()
    {
        QByteArray copy;
        {
            ui::StructureModel model;
            SceneDocument document(model);
            document.take(opened(model, path("a.palpate.json")));
            document.addFinding({"unsaved", {7, 8, 9}, {}});
            PALPATE_TRY_COMPARE(QDir(copies()).entryList({"*.palpate.json"}, QDir::Files).size(), 1);
            QVERIFY(!SceneDocument::findLeftover()); // its process is alive
            QFile file(QDir(copies()).filePath(QDir(copies()).entryList({"*.palpate.json"}, QDir::Files)[0]));
            QVERIFY(file.open(QIODevice::ReadOnly));
            copy = file.readAll();
        }
        QVERIFY(QDir(copies()).entryList({"*.palpate.json"}, QDir::Files).isEmpty()); // a regular exit
        QFile left(QDir(copies()).filePath("1.palpate.json")); // from a process that no longer exists
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.write(copy);
        left.close();
        const auto found = SceneDocument::findLeftover();
        QVERIFY(found.has_value());

        ui::StructureModel model;
        SceneDocument document(model);
        document.take(opened(model, *found));
        QCOMPARE(document.file(), path("a.palpate.json"));
        QVERIFY(document.isModified());
        QCOMPARE(document.findings().size(), std::size_t{2});
        QCOMPARE(document.findings()[1].name, std::string("unsaved"));
        QVERIFY(!SceneDocument::findLeftover()); // now owned by this process
        QVERIFY(document.save(path("c.palpate.json"), {}).isOk());
        QVERIFY(!json(path("c.palpate.json")).contains("copy_of"));
        QCOMPARE(json(path("c.palpate.json"))["author"].toString(), QString("A"));
        QCOMPARE(json(path("c.palpate.json"))["structures"].toArray().at(0).toObject().value("mesh").toString(),
                 QString("a.stl"));
        QVERIFY(QDir(copies()).entryList({"*.palpate.json"}, QDir::Files).isEmpty());
    }

    /// The disk is full: file and backup are unchanged, and the scene stays unsaved.
    void aFailedSaveLosesNothing()
    {
        QVERIFY(QFile::copy(m_folder.filePath("a.palpate.json"), m_folder.filePath("f.palpate.json")));
        const QByteArray old = bytes(m_folder.filePath("f.palpate.json"));
        ui::StructureModel model;
        SceneDocument document(model);
        document.take(opened(model, path("f.palpate.json")));
        QSignalSpy failed(&document, &SceneDocument::copyFailed);
        document.addFinding({"unsaved", {7, 8, 9}, {}});
        PALPATE_TRY_COMPARE(copyNames().size(), 1);
        const QString copy = QDir(copies()).filePath(copyNames()[0]);
        const QByteArray copied = bytes(copy);
        {
            const test::FileLimit full(100);
            document.addFinding({"second", {7, 8, 9}, {}});
            PALPATE_TRY_COMPARE(failed.count(), 1);
            document.addFinding({"third", {7, 8, 9}, {}});
            QTest::qWait(2000);          // longer than the delay after an edit
            QCOMPARE(failed.count(), 1); // one message
        }
        QCOMPARE(bytes(copy), copied);
        core::Status saved(core::StatusCode::Internal, core::Message());
        int failures = 0;
        for (rlim_t limit = 0; !saved.isOk(); limit += 97) {
            const test::FileLimit full(limit);
            saved = document.save(path("f.palpate.json"), {});
            if (!saved.isOk()) {
                ++failures;
                QCOMPARE(saved.code(), core::StatusCode::NoSpace);
                QCOMPARE(bytes(m_folder.filePath("f.palpate.json")), old);
                QCOMPARE(bytes(copy), copied);
                QVERIFY(document.isModified());
            }
        }
        QVERIFY2(failures > 5, qPrintable(QString::number(failures)));
        QCOMPARE(json(path("f.palpate.json"))["findings"].toArray().size(), 4);
        QVERIFY(!document.isModified());
        QCOMPARE(copyNames(), QStringList());
    }

    /// Restored changes stay in the old backup while a full disk prevents a new one.
    void aCopyIsKeptUntilThereIsAnother()
    {
        QVERIFY(QDir().mkpath(copies()));
        QFile left(QDir(copies()).filePath("1.palpate.json"));
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.write(R"({"version": 1, "copy_of": "a.palpate.json", "structures": [{"mesh": "a.stl"}],
                       "findings": [{"name": "unsaved", "position": [1, 2, 3]}]})");
        left.close();
        const QByteArray before = bytes(left.fileName());
        {
            ui::StructureModel model;
            SceneDocument document(model);
            QVERIFY(document.claimLeftover(left.fileName().toStdString()));
            const ui::OpenedScene scene = opened(model, left.fileName().toStdString());
            {
                const test::FileLimit full(0);
                document.take(scene);
            }
            QCOMPARE(document.findings().size(), std::size_t{1});
            QCOMPARE(bytes(left.fileName()), before);
            QVERIFY(!SceneDocument::findLeftover()); // owned by this process
            document.addFinding({"second", {7, 8, 9}, {}});
            PALPATE_TRY_VERIFY(bytes(left.fileName()).contains("second"));
        }
        QCOMPARE(copyNames(), QStringList()); // a regular exit
    }

    /// Two processes may have the same process ID, in containers or on machines with a shared folder.
    void twoProgramsHaveTwoCopies()
    {
        ui::StructureModel models[2];
        SceneDocument one(models[0]), two(models[1]);
        for (SceneDocument* document : {&one, &two}) {
            document->take(opened(models[document == &two ? 1 : 0], path("a.palpate.json")));
            document->addFinding({"unsaved", {7, 8, 9}, {}});
        }
        PALPATE_TRY_COMPARE(copyNames().size(), 2);
    }
};

PALPATE_TEST(Document)
#include "tst_Document.moc"
