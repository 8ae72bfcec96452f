// SPDX-License-Identifier: BSD-3-Clause
#include "Masks.h"
#include "TestRunner.h"

#include <palpate/geometry/Holes.h>
#include <palpate/meshio/MeshFile.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/SceneLoader.h>

#include <QTemporaryDir>

#include <algorithm>
#include <span>

using namespace palpate;
using ui::StructureModel;

/// Tests smoothing and reorienting a surface in the window: in the background, with undo.
class SurfaceEdits : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::filesystem::path m_file;
    ui::SceneLoader m_loader;
    StructureModel m_model;

    const study::OpenStructure& row() const { return m_model.rows().front(); }

    void openFile(const std::filesystem::path& file)
    {
        std::shared_ptr<ui::OpenedScene> scene;
        const auto opened =
            connect(&m_loader, &ui::SceneLoader::opened, this, [&](const auto& found) { scene = found; });
        m_loader.open({file}, 1.0);
        PALPATE_TRY_VERIFY(scene != nullptr);
        disconnect(opened);
        m_model.setRows(std::move(scene->rows));
    }

  private Q_SLOTS:
    void initTestCase()
    {
        meshio::MeshStructure one{"ball", test::maskSurface(test::ballMask(10.0, core::Vec3(1, 1, 3))), std::nullopt};
        geometry::flip(one.mesh);
        m_file = m_folder.path().toStdString() + "/ball.vtp";
        QVERIFY(meshio::writeMesh(m_file, std::span(&one, 1)).isOk());
        connect(&m_model, &StructureModel::surfaceWanted, this,
                [this](int wanted) { m_loader.buildSurface(wanted, m_model.rows()[0].loaded); });
        connect(&m_loader, &ui::SceneLoader::surfaceBuilt, this,
                [this](int built, const auto& made) { m_model.setSurface(built, *made); });
    }
    void init() { openFile(m_file); }

    void smoothsAndUndoes()
    {
        QCOMPARE(m_model.steppedRows(), std::vector<int>{0});
        QVERIFY(m_model.isDefective(0));
        QVERIFY(m_model.defects(0).join(QLatin1Char(' ')).contains(QStringLiteral("steps of 1 × 1 × 3 mm")));
        const auto surface = row().loaded.surface;
        const auto touch = row().touch;
        const auto picture = m_model.picture(0);
        QSignalSpy replaced(&m_model, &StructureModel::surfaceReplaced);
        m_model.smooth(m_model.steppedRows());
        PALPATE_TRY_COMPARE(replaced.count(), 1);
        QVERIFY(row().loaded.smoothing.has_value());
        QVERIFY(row().loaded.surface != surface && row().touch != touch && m_model.picture(0) != picture);
        QVERIFY(m_model.steppedRows().empty());
        QVERIFY(m_model.structure(0).surface == meshio::SurfaceKind::Smoothed); // as saved later
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(replaced.count(), 2);
        QCOMPARE(row().loaded.surface.get(), surface.get());
        QVERIFY(!row().loaded.smoothing.has_value());
        QCOMPARE(m_model.steppedRows(), std::vector<int>{0});
    }

    void turnsAroundAndUndoes()
    {
        QCOMPARE(m_model.insideOutRows(), std::vector<int>{0});
        QSignalSpy replaced(&m_model, &StructureModel::surfaceReplaced);
        m_model.turnOutwards(m_model.insideOutRows());
        PALPATE_TRY_COMPARE(replaced.count(), 1);
        QVERIFY(m_model.insideOutRows().empty());
        QVERIFY(row().loaded.surface->report.volume_mm3 > 0.0);
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(replaced.count(), 2);
        QVERIFY(row().loaded.surface->report.volume_mm3 < 0.0);
    }

    /// The holes of an open surface are closed, reopened and undone; the file stays.
    void closesHolesAndReopensThem()
    {
        geometry::TriangleMesh open =
            geometry::repair(test::maskSurface(test::ballMask(10.0, core::Vec3(1, 1, 1)))).mesh;
        std::erase_if(open.triangles, [&](const geometry::Triangle& t) {
            return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return open.vertices[v].z() > 6.0; });
        });
        const std::filesystem::path file = m_folder.path().toStdString() + "/open.vtp";
        const meshio::MeshStructure one{"open", open, std::nullopt};
        QVERIFY(meshio::writeMesh(file, std::span(&one, 1)).isOk());
        const std::string before = meshio::fileHash(file);
        openFile(file);
        const std::vector<geometry::Hole> holes = m_model.holes(0);
        QCOMPARE(holes.size(), std::size_t{1});
        QSignalSpy replaced(&m_model, &StructureModel::surfaceReplaced);
        m_model.closeHoles({0});
        PALPATE_TRY_COMPARE(replaced.count(), 1);
        QVERIFY(row().loaded.surface->report.isClosed() && row().loaded.surface->report.volume_mm3 > 0.0);
        QVERIFY(m_model.holes(0).empty());
        QVERIFY(row().touch != nullptr);
        QVERIFY2(m_model.defects(0).join(QLatin1Char(' ')).startsWith(QStringLiteral("A hole of ")),
                 qPrintable(m_model.defects(0).join(QLatin1Char(' '))));
        QVERIFY(m_model.structure(0).closeHoles_mm >= holes[0].across_mm); // as saved later
        m_model.reopenHoles({0});
        PALPATE_TRY_COMPARE(replaced.count(), 2);
        QCOMPARE(m_model.holes(0).size(), std::size_t{1});
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(replaced.count(), 3);
        QVERIFY(row().loaded.surface->report.isClosed());
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(replaced.count(), 4);
        QCOMPARE(m_model.holes(0).size(), std::size_t{1});
        QCOMPARE(m_model.structure(0).closeHoles_mm, 0.0);
        QCOMPARE(meshio::fileHash(file), before);
    }

    /// Changed and undone before the first surface is ready: the last request counts.
    void lateSurfacesAreNotTaken()
    {
        QSignalSpy built(&m_loader, &ui::SceneLoader::surfaceBuilt);
        m_model.smooth({0});
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(built.count(), 2);
        QVERIFY(!row().loaded.smoothing.has_value());
        QVERIFY(m_model.structure(0).surface == meshio::SurfaceKind::Facets);
    }
};

PALPATE_TEST(SurfaceEdits)
#include "tst_SurfaceEdits.moc"
