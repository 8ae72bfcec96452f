// SPDX-License-Identifier: BSD-3-Clause
#include "Masks.h"
#include "TestRunner.h"

#include <palpate/geometry/Holes.h>
#include <palpate/meshio/MeshFile.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructurePanel.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTemporaryDir>

#include <algorithm>
#include <fstream>
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

    void openFile(const std::filesystem::path& file, const meshio::ReadOptions& options = {})
    {
        std::shared_ptr<ui::OpenedScene> scene;
        const auto opened =
            connect(&m_loader, &ui::SceneLoader::opened, this, [&](const auto& found) { scene = found; });
        m_loader.open({file}, options);
        PALPATE_TRY_VERIFY(scene != nullptr);
        disconnect(opened);
        m_model.setRows(std::move(scene->rows));
    }

    /// A label map with a ball of radius 8 in voxels of 1 x 1 x 3 mm, as MetaImage.
    static std::string ballMap()
    {
        std::string bytes = "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 20 20 8\n"
                            "ElementSpacing = 1 1 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
        for (int z = 0; z < 8; ++z) {
            for (int y = 0; y < 20; ++y) {
                for (int x = 0; x < 20; ++x) {
                    const core::Vec3 p(x - 9.5, y - 9.5, 3.0 * (z - 3.5));
                    bytes += p.norm() < 8.0 ? '\1' : '\0';
                }
            }
        }
        return bytes;
    }

    template<class Widget>
    static Widget* named(QWidget& panel, const QString& name)
    {
        for (Widget* widget : panel.findChildren<Widget*>()) {
            if (widget->accessibleName() == name) {
                return widget;
            }
        }
        return nullptr;
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

    /// The factor of a label map's structure in the panel: shown, changed, undone, and saved.
    void changesTheSmoothingFactor()
    {
        const std::filesystem::path map = m_folder.filePath(QStringLiteral("ball.mha")).toStdString();
        std::ofstream(map, std::ios::binary) << ballMap();
        openFile(map);
        ui::StructurePanel panel(m_model);
        panel.select(0);
        auto* const factor = named<QDoubleSpinBox>(panel, QStringLiteral("Smoothing factor"));
        auto* const surface = named<QComboBox>(panel, QStringLiteral("Surface"));
        QVERIFY(factor != nullptr && surface != nullptr);
        QCOMPARE(factor->value(), meshio::kLabelSmoothing);
        QCOMPARE(surface->currentText(), QStringLiteral("Smoothed"));
        QVERIFY(m_model.defects(0).join(QLatin1Char(' ')).contains(QStringLiteral("smoothed by 0.5")));
        const double before_mm3 = row().loaded.smoothing->volumeAfter_mm3;
        QSignalSpy replaced(&m_model, &StructureModel::surfaceReplaced);
        factor->setValue(0.9);
        PALPATE_TRY_COMPARE(replaced.count(), 1);
        QCOMPARE(m_model.structure(0).smoothing, 0.9);
        QCOMPARE(row().loaded.smoothing->strength, 0.9);
        QVERIFY(row().loaded.smoothing->volumeAfter_mm3 != before_mm3);
        QVERIFY(m_model.defects(0).join(QLatin1Char(' ')).contains(QStringLiteral("smoothed by 0.9")));
        m_model.undoStack().undo();
        PALPATE_TRY_COMPARE(replaced.count(), 2);
        QCOMPARE(factor->value(), meshio::kLabelSmoothing);
        QCOMPARE(row().loaded.smoothing->volumeAfter_mm3, before_mm3);
        m_model.undoStack().redo();
        PALPATE_TRY_COMPARE(replaced.count(), 3);
        const auto scene = map.parent_path() / "ball.palpate.json";
        meshio::SceneFile edited;
        edited.structures = {m_model.structure(0)};
        QVERIFY(meshio::writeScene(scene, edited).isOk());
        const auto saved = meshio::readScene(scene);
        QVERIFY(saved.isOk());
        QCOMPARE(saved.value().structures.front().smoothing, 0.9);
        surface->setCurrentIndex(0);
        Q_EMIT surface->activated(0); // as in the file: no factor
        PALPATE_TRY_COMPARE(replaced.count(), 4);
        QVERIFY(!factor->isVisibleTo(&panel));
        QVERIFY(!row().loaded.smoothing.has_value());
        meshio::ReadOptions options; // chosen before opening
        options.smoothing = 0.25;
        openFile(map, options);
        panel.select(0);
        QCOMPARE(factor->value(), 0.25);
        QCOMPARE(row().loaded.smoothing->strength, 0.25);
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
