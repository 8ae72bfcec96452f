// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/meshio/MeshFile.h>
#include <palpate/ui/SceneLoader.h>

#include <QFile>
#include <QTemporaryDir>

using namespace palpate;

class SceneLoader : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    /// Files that are opened together have the names of a folder: without the prefix of a segmentation.
    void commonPrefixIsDropped()
    {
        std::vector<std::filesystem::path> files;
        for (const char* name : {"Segmentation_liver.stl", "Segmentation_spleen.stl"}) {
            files.push_back(m_ball.parent_path() / name);
            const meshio::MeshStructure one{name, test::ball(20.0, 3), std::nullopt};
            QVERIFY(meshio::writeMesh(files.back(), std::span(&one, 1)).isOk());
        }
        for (const bool isTwo : {true, false}) {
            files.resize(isTwo ? 2 : 1);
            ui::SceneLoader loader;
            std::shared_ptr<ui::OpenedScene> scene;
            connect(&loader, &ui::SceneLoader::opened, this, [&](const auto& found) { scene = found; });
            loader.open(files);
            PALPATE_TRY_VERIFY(scene != nullptr);
            const std::string name = scene->rows[0].loaded.description.name;
            QVERIFY2(name == (isTwo ? "liver" : "Segmentation_liver") || name == "spleen", name.c_str());
            QCOMPARE(scene->scene.structures.size(), files.size());
        }
    }

    void init()
    {
        QVERIFY(m_folder.isValid());
        m_ball = m_folder.path().toStdString() + "/ball.vtp";
        m_bad = m_folder.path().toStdString() + "/bad.stl";
        const meshio::MeshStructure one{"ball", test::ball(20.0, 3), std::nullopt};
        QVERIFY(meshio::writeMesh(m_ball, std::span(&one, 1)).isOk());
        QFile bad(QString::fromStdString(m_bad.string()));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("this is no mesh");
    }
    void opensReadyToTouch()
    {
        ui::SceneLoader loader;
        std::shared_ptr<ui::OpenedScene> scene;
        connect(&loader, &ui::SceneLoader::opened, this, [&](const auto& opened) { scene = opened; });
        loader.open({m_ball});
        QVERIFY(loader.isBusy()); // this thread is free
        PALPATE_TRY_VERIFY(scene != nullptr);
        QCOMPARE(scene->rows.size(), std::size_t{1});
        QVERIFY(scene->rows[0].touch != nullptr);
        QCOMPARE(scene->rows[0].touch->triangleCount(), 1280u);
        QCOMPARE(scene->rows[0].picture->GetNumberOfPolys(), vtkIdType{1280});
        QCOMPARE(scene->rows[0].sha256.size(), std::size_t{64});
        QVERIFY(!loader.isBusy());
    }
    void saysInOneLineWhyNothingOpened()
    {
        ui::SceneLoader loader;
        QSignalSpy failed(&loader, &ui::SceneLoader::failed);
        loader.open({m_bad});
        PALPATE_TRY_COMPARE(failed.count(), 1);
        const QString line = failed.first().first().toString();
        QVERIFY2(line.contains(QStringLiteral("bad.stl")) && !line.contains(QLatin1Char('\n')), qPrintable(line));
    }
    void oneBadFileDoesNotKeepTheOthersOut()
    {
        ui::SceneLoader loader;
        std::shared_ptr<ui::OpenedScene> scene;
        connect(&loader, &ui::SceneLoader::opened, this, [&](const auto& opened) { scene = opened; });
        loader.open({m_bad, m_ball});
        PALPATE_TRY_VERIFY(scene != nullptr);
        QCOMPARE(scene->rows.size(), std::size_t{1});
        QCOMPARE(scene->problems.size(), 1);
    }
    /// The preview has the surfaces and display meshes of the scene, before the scene is complete.
    void structuresAreShownBeforeTheScene()
    {
        ui::SceneLoader loader;
        std::vector<ui::StructureRow> shown;
        std::shared_ptr<ui::OpenedScene> scene;
        connect(&loader, &ui::SceneLoader::structuresReady, this, [&](const auto& rows) {
            QVERIFY(scene == nullptr);
            shown.insert(shown.end(), rows->begin(), rows->end());
        });
        connect(&loader, &ui::SceneLoader::opened, this, [&](const auto& opened) { scene = opened; });
        loader.open({m_ball, m_bad, m_ball});
        PALPATE_TRY_VERIFY(scene != nullptr);
        QCOMPARE(scene->rows.size(), std::size_t{2});
        QCOMPARE(shown.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(shown[i].loaded.surface == scene->rows[i].loaded.surface);
            QVERIFY(shown[i].picture == scene->rows[i].picture);
            QCOMPARE(shown[i].loaded.description.name, std::string("ball"));
        }
        shown.clear();
        scene = nullptr;
        loader.add({m_ball}, 1.0, {ui::OpenSurface{}}); // the open scene stays in the view
        PALPATE_TRY_VERIFY(scene != nullptr);
        QVERIFY(shown.empty());
    }
    void cancelDropsWhatWasShown()
    {
        ui::SceneLoader loader;
        QSignalSpy dropped(&loader, &ui::SceneLoader::structuresDropped);
        QSignalSpy cancelled(&loader, &ui::SceneLoader::cancelled);
        QSignalSpy opened(&loader, &ui::SceneLoader::opened);
        connect(&loader, &ui::SceneLoader::structuresReady, &loader, &ui::SceneLoader::cancel);
        loader.open(std::vector<std::filesystem::path>(500, m_ball));
        QCOMPARE(dropped.count(), 1); // of an earlier job
        PALPATE_TRY_COMPARE(cancelled.count(), 1);
        QCOMPARE(dropped.count(), 2);
        QCOMPARE(opened.count(), 0);
    }
    void cancelOpensNothing()
    {
        ui::SceneLoader loader;
        QSignalSpy cancelled(&loader, &ui::SceneLoader::cancelled);
        QSignalSpy opened(&loader, &ui::SceneLoader::opened);
        loader.open(std::vector<std::filesystem::path>(200, m_ball));
        loader.cancel();
        PALPATE_TRY_COMPARE(cancelled.count(), 1);
        QCOMPARE(opened.count(), 0);
    }
    void newerWishReplacesTheOlder()
    {
        ui::SceneLoader loader;
        QSignalSpy opened(&loader, &ui::SceneLoader::opened);
        QSignalSpy failed(&loader, &ui::SceneLoader::failed);
        loader.open({m_bad});
        loader.open({m_ball});
        PALPATE_TRY_COMPARE(opened.count(), 1);
        QCOMPARE(failed.count(), 0);
    }

  private:
    QTemporaryDir m_folder;
    std::filesystem::path m_ball;
    std::filesystem::path m_bad;
};

PALPATE_TEST(SceneLoader)
#include "tst_SceneLoader.moc"
