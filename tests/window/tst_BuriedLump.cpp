// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"
#include "window/MainWindow.h"

#include "../support/Shapes.h"

#include <palpate/geometry/TriangleMesh.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace palpate;
using core::Vec3;

/// Opens two spheres as STL, 40 mm across and 10 mm across at a depth of 8 mm in the first, and presses: the lump is
/// palpable through the organ. Requires a display.
class BuriedLump : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    double m_force_N = 0.0;
    double m_depth_mm = 0.0;

    void writeStl(const char* name, const geometry::TriangleMesh& mesh) const
    {
        std::ofstream out(m_folder.filePath(name).toStdString(), std::ios::binary);
        const auto put = [&out](auto value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
        out << std::string(80, ' ');
        put(static_cast<std::uint32_t>(mesh.triangles.size()));
        for (const geometry::Triangle& t : mesh.triangles) {
            for (int i = 0; i < 3; ++i) {
                put(0.0F); // normals are computed, not read
            }
            for (const std::uint32_t corner : t) {
                for (const double v : mesh.vertices[corner]) {
                    put(static_cast<float>(v));
                }
            }
            put(std::uint16_t{0});
        }
    }

    void open(const std::vector<std::filesystem::path>& files)
    {
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kPatience_ms));
        connect(&m_window->palpation(), &ui::PalpationController::touched, this, [this](const ui::TouchReading& touch) {
            m_force_N = touch.force_N;
            m_depth_mm = touch.depth_mm;
        });
        QSignalSpy ready(m_window.get(), &MainWindow::ready);
        m_window->open(files);
        PALPATE_TRY_COMPARE(ready.count(), 1);
    }

    std::filesystem::path folder() const { return m_folder.path().toStdString(); }

    /// Presses 12 mm in the middle of the view.
    /// @return the force [N]
    double pressed(view::ViewFrom from)
    {
        ui::VtkViewport& viewport = m_window->viewport();
        ui::PalpationController& hand = m_window->palpation();
        m_window->setPalpating(true);
        QTest::qWait(200); // a layer that appeared around the hand would exert no force until the hand left
        viewport.view().look(from);
        for (int i = 0; i < 8 && std::abs(hand.depth_mm() - 12.0) > 1e-9; ++i) { // wheel steps grow with depth
            const double before_mm = hand.depth_mm();
            Q_EMIT viewport.depthTurned(1.0);
            const double notch_mm = hand.depth_mm() - before_mm;
            Q_EMIT viewport.depthTurned((12.0 - hand.depth_mm()) / notch_mm);
        }
        m_depth_mm = m_force_N = 0.0;
        hand.pressAt({0.5 * viewport.width(), 0.5 * viewport.height()});
        const bool isIn = QTest::qWaitFor([this] { return std::abs(m_depth_mm - 12.0) < 0.02; }, test::kPatience_ms);
        QTest::qWait(100);
        const double force_N = isIn ? m_force_N : -1.0;
        hand.letGo();
        (void)QTest::qWaitFor([this] { return m_depth_mm == 0.0; }, test::kPatience_ms);
        return force_N;
    }

    QAction* action(const QString& text) const
    {
        for (QAction* one : m_window->actions()) {
            if (one->text().startsWith(text)) {
                return one;
            }
        }
        qFatal("no such action");
    }

    ui::MessageBar& message() const { return *m_window->findChild<ui::MessageBar*>(); }
    QPushButton& wayBack() const { return *test::answerOf(message()); }

    /// Clicks a button of a message.
    void answer(const QString& text) const
    {
        for (QPushButton* one : message().findChildren<QPushButton*>()) {
            if (one->text() == text) {
                one->click();
                return;
            }
        }
        qFatal("no such button");
    }

    /// Waits for the lump maps; until then, lumps are simulated as layers.
    void awaitMaps() const { PALPATE_TRY_VERIFY(m_window->findChild<ui::LumpMaps*>()->isHandUpToDate()); }

  private Q_SLOTS:
    void initTestCase()
    {
        if (QGuiApplication::platformName() != QStringLiteral("xcb")) {
            QSKIP("no OpenGL without a display: run under xvfb-run with QT_QPA_PLATFORM=xcb");
        }
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings().setValue(QStringLiteral("fingertip_mm"), 0.0); // a point, whose forces are known in closed form
        QSurfaceFormat::setDefaultFormat(ui::VtkViewport::surfaceFormat());
        geometry::TriangleMesh liver = test::sphere(24, 20.0);
        std::erase_if(liver.triangles, [&](const geometry::Triangle& t) {
            return std::all_of(t.begin(), t.end(),
                               [&](std::uint32_t v) { return liver.vertices[v].y() > 15.0; }); // at the back
        });
        QVERIFY(QDir(m_folder.path()).mkpath("open"));
        writeStl("open/liver.stl", liver);
        writeStl("open/tumour.stl", test::moved(test::sphere(12, 5.0), Vec3(0, -7, 0)));
        QVERIFY(QDir(m_folder.path()).mkpath("two"));
        writeStl("two/liver.stl", test::sphere(24, 20.0));
        writeStl("two/tumour.stl", test::moved(test::sphere(12, 5.0), Vec3(0, -7, 0))); // towards the front
    }
    void cleanup() { m_window.reset(); }

    void whatLiesInTheLiverIsFeltThroughIt()
    {
        open({folder() / "two"});
        QVERIFY2(message().isVisible(), "nothing was said");
        QCOMPARE(test::newest(message().text()), QStringLiteral("tumour lies in liver and is felt through it, 4.4 (1 … "
                                                                "5.2) times as stiff (published for such lumps)."));
        QCOMPARE(wayBack().text(), QStringLiteral("Feel it as a layer"));
        QVERIFY(!m_window->isWindowModified());
        awaitMaps();
        const double beside_N = pressed(view::ViewFrom::Left);
        const double over_N = pressed(view::ViewFrom::Front);
        // By its name the liver is healthy: 12 mm × 0.092 N/mm, plus some 3 % from the lump, 15 mm to the side.
        QVERIFY2(beside_N > 1.105 && beside_N < 1.16, qPrintable(QString::number(beside_N)));
        QVERIFY2(over_N > 1.1 * beside_N, qPrintable(QString::number(over_N)));

        action("Undo")->trigger();
        const double flat_N = pressed(view::ViewFrom::Front);
        QVERIFY2(flat_N > 1.085 && flat_N < 1.122, qPrintable(QString::number(flat_N)));
        action("Redo")->trigger();
        awaitMaps();
        const double again_N = pressed(view::ViewFrom::Front);
        QVERIFY2(std::abs(again_N - over_N) < 0.02, qPrintable(QString::number(again_N)));
    }

    void aLayerIsOneClickAway()
    {
        open({folder() / "two"});
        wayBack().click();
        QVERIFY(!message().text().contains(QStringLiteral("felt through")));
        const double beside_N = pressed(view::ViewFrom::Left);
        const double below_N = pressed(view::ViewFrom::Front);
        QVERIFY2(beside_N > 1.085 && beside_N < 1.122, qPrintable(QString::number(beside_N)));
        QVERIFY2(below_N > 1.3 * beside_N, qPrintable(QString::number(below_N)));
        action("Undo")->trigger();
        awaitMaps();
        const double through_N = pressed(view::ViewFrom::Front);
        QVERIFY2(std::abs(through_N - below_N) > 0.05, qPrintable(QString::number(through_N)));
    }

    /// While pressed, the lump is named with change and verdict in the view, and the chart shows the share of the force
    /// that it adds.
    void theLumpIsNamedUnderTheFinger()
    {
        open({folder() / "two"});
        awaitMaps();
        const QLabel& label = *m_window->findChild<QLabel*>(QStringLiteral("lumpLabel"));
        const auto& panel = *m_window->findChild<ui::TouchPanel*>();
        m_window->setPalpating(true);
        m_window->viewport().view().look(view::ViewFrom::Front);
        Q_EMIT m_window->viewport().depthTurned(16.0);
        QVERIFY(!label.isVisible());
        m_window->palpation().pressAt({0.5 * m_window->viewport().width(), 0.5 * m_window->viewport().height()});
        PALPATE_TRY_VERIFY(label.isVisible());
        QVERIFY2(label.text().startsWith(QStringLiteral("over tumour: +")), qPrintable(label.text()));
        QVERIFY2(label.text().contains(QStringLiteral(" %, ")), qPrintable(label.text()));
        const ui::TouchReading felt = panel.reading();
        const std::vector<ui::LayerForce> forces = ui::chartForces(felt);
        QCOMPARE(forces.size(), std::size_t{2});
        QVERIFY(std::abs(forces[0].force_N + forces[1].force_N - felt.force_N) < 1e-9);
        QVERIFY(std::abs(forces[0].force_N * felt.lumpRatio - felt.force_N) < 1e-9);
        QVERIFY(forces[0].colour != forces[1].colour);
        const QString chart = ui::overLumpText(felt);
        QVERIFY2(label.text().startsWith(chart.section(QLatin1Char('+'), 0, 0)), qPrintable(chart));
        m_window->palpation().letGo();
        PALPATE_TRY_VERIFY(!label.isVisible());
    }

    /// A lump in an open organ is one click away from being a layer, and the map counts the lump.
    void inAnOpenOrganALayerIsOneClickAway()
    {
        open({folder() / "open"});
        QVERIFY2(test::newest(message().text())
                     .startsWith(QStringLiteral(
                         "tumour cannot be felt through liver yet: the surface of liver has a hole of ")),
                 qPrintable(message().text()));
        const double without_N = pressed(view::ViewFrom::Front);
        QVERIFY(without_N > 0.5);
        answer(QStringLiteral("Feel it as a layer below"));
        const double below_N = pressed(view::ViewFrom::Front);
        QVERIFY2(below_N > 1.3 * without_N, qPrintable(QString::number(below_N / without_N)));
        m_window->commands().at("felt").trigger();
        const auto& maps = *m_window->findChild<ui::LumpMaps*>();
        PALPATE_TRY_VERIFY(maps.isUpToDate());
        QCOMPARE(maps.notes().size(), 1);
        QVERIFY2(
            maps.notes().back().startsWith(QStringLiteral("tumour was left out: the surface of liver has a hole of ")),
            qPrintable(maps.notes().back()));
        action("Undo")->trigger();
        const double again_N = pressed(view::ViewFrom::Front);
        QVERIFY2(std::abs(again_N - without_N) < 0.05, qPrintable(QString::number(again_N)));
    }

    /// The other offer closes the hole: then the lump is felt through the organ.
    void theHoleOfAnOpenOrganIsClosed()
    {
        open({folder() / "open"});
        const double open_N = pressed(view::ViewFrom::Front);
        QVERIFY(open_N > 0.5);
        answer(QStringLiteral("Close the holes"));
        PALPATE_TRY_VERIFY(message().text().contains(QStringLiteral("felt through it")));
        awaitMaps();
        const double through_N = pressed(view::ViewFrom::Front);
        QVERIFY2(through_N > 1.1 * open_N, qPrintable(QString::number(through_N / open_N)));
        m_window->commands().at("felt").trigger();
        const auto& maps = *m_window->findChild<ui::LumpMaps*>();
        PALPATE_TRY_VERIFY(maps.isUpToDate());
        QVERIFY2(maps.notes().filter(QStringLiteral("left out")).isEmpty(), qPrintable(maps.notes().join(' ')));
        action("Undo")->trigger(); // felt through
        action("Undo")->trigger(); // closed
        PALPATE_TRY_VERIFY(!m_window->model().rows()[0].loaded.closing);
        QVERIFY(!m_window->model().rows()[0].loaded.surface->report.isClosed());
        QVERIFY(!m_window->model().isTransmitted(1));
    }

    /// The lump simulation changes twice under the pressing hand during a recording: each scene is recorded as
    /// simulated, and the whole recording is reproduced bit for bit.
    void changedDuringARecordingItIsRecorded()
    {
        open({folder() / "two"});
        awaitMaps();
        m_window->setPalpating(true);
        m_window->viewport().view().look(view::ViewFrom::Front);
        action("Record")->trigger();
        ui::PalpationController& hand = m_window->palpation();
        Q_EMIT m_window->viewport().depthTurned(6.0);
        hand.pressAt({0.5 * m_window->viewport().width(), 0.5 * m_window->viewport().height()});
        const auto isHeld = [this, &hand] { return m_force_N > 0.05 && std::abs(m_depth_mm - hand.depth_mm()) < 0.05; };
        PALPATE_TRY_VERIFY(isHeld());
        wayBack().click(); // as a layer
        QTest::qWait(300);
        action("Undo")->trigger(); // transmitted through the organ again
        awaitMaps();
        QTest::qWait(300);
        hand.letGo();
        PALPATE_TRY_COMPARE(m_depth_mm, 0.0);
        action("Stop")->trigger();

        const ui::RecordedTouch* recorded = m_window->playback().recording();
        QVERIFY(recorded != nullptr);
        const auto reader = session::RecordingReader::open(recorded->path());
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->extent().dropped, 0);
        QByteArray ways; // per scene: transmitted through the organ, or a layer
        for (const session::SceneRecord& scene : reader.value()->scenes()) {
            const session::StructureRecord &organ = scene.structures[0], &lump = scene.structures[1];
            QCOMPARE(lump.palpable, !organ.tissueMaps.hasFelt());
            QVERIFY(organ.tissueMaps.hasFelt() || lump.layer == 1);
            const char way = organ.tissueMaps.hasFelt() ? 'F' : 'L';
            if (ways.isEmpty() || ways.back() != way) {
                ways += way;
            }
        }
        QCOMPARE(ways, QByteArray("FLF"));
        const auto meshes = study::recordedSurfaces(*reader.value(), folder() / "two");
        QVERIFY2(meshes.isOk(), meshes.status().message().c_str());
        const auto again = session::resimulate(*reader.value(), study::indexedByHash(meshes.value()));
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QVERIFY2(again.value().isSame() && again.value().unverified == 0, again.value().difference.english().c_str());
        QVERIFY(again.value().compared > 500);
    }

    /// Outside the range of the lump model, a message gives the reason.
    void whatCannotBeFeltThroughIsALayer()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("out"));
        QVERIFY(QDir(m_folder.path()).mkpath("unknown"));
        writeStl("out/liver.stl", test::sphere(24, 20.0));
        writeStl("out/tumour.stl", test::moved(test::sphere(12, 5.0), Vec3(0, -15.5, 0)));
        open({folder() / "out"});
        QCOMPARE(test::newest(message().text()),
                 QStringLiteral("tumour: inside liver, felt as a layer below liver (extends beyond liver)."));
        QCOMPARE(wayBack().text(), QStringLiteral("All in one layer"));
        wayBack().click();
        QVERIFY(!message().text().contains(QStringLiteral("felt as a layer")));
        action("Undo")->trigger();

        writeStl("unknown/part.stl", test::sphere(24, 20.0));
        writeStl("unknown/tumour.stl", test::sphere(12, 5.0));
        open({folder() / "unknown"});
        QCOMPARE(
            test::newest(message().text()),
            QStringLiteral("tumour: inside part, felt as a layer below part (stiffness ratio to part unknown: enter a "
                           "ratio under What can be felt (B))."));
    }

    /// A scene file defines its layers: the new layers are offered but not applied.
    void aSceneIsOfferedLayersAndNotChanged()
    {
        std::ofstream(m_folder.filePath("flat.palpate.json").toStdString())
            << R"({"version": 1, "structures": [{"mesh": "two/liver.stl", "name": "liver"},
                   {"mesh": "two/tumour.stl", "name": "tumour"}]})";
        open({folder() / "flat.palpate.json"});
        QVERIFY(message().isVisible());
        QVERIFY2(message().text().contains(
                     QStringLiteral("tumour lies in liver, but all structures of this scene are in one layer")),
                 qPrintable(message().text()));
        const double flat_N = pressed(view::ViewFrom::Front);
        QVERIFY2(flat_N > 5.9 && flat_N < 6.1, qPrintable(QString::number(flat_N)));
        QVERIFY(!action("Undo")->isEnabled());
        wayBack().click();
        const double below_N = pressed(view::ViewFrom::Front);
        QVERIFY2(below_N > 1.3 * flat_N, qPrintable(QString::number(below_N)));
        action("Undo")->trigger();
        QVERIFY(std::abs(pressed(view::ViewFrom::Front) - flat_N) < 0.05);
    }

    void aSceneWithLayersIsLeftAlone()
    {
        std::ofstream(m_folder.filePath("own.palpate.json").toStdString())
            << R"({"version": 1, "structures": [{"mesh": "two/liver.stl", "name": "liver", "layer": 1},
                   {"mesh": "two/tumour.stl", "name": "tumour"}]})";
        open({folder() / "own.palpate.json"});
        QVERIFY(!message().isVisible());
        QVERIFY(!action("Undo")->isEnabled());
    }

    void theSameFileTwiceIsSaid()
    {
        open({folder() / "two/liver.stl", folder() / "two/liver.stl"});
        QVERIFY(message().isVisible());
        QCOMPARE(test::newest(message().text()), QStringLiteral("liver and liver are the same surface twice."));
        QCOMPARE(action("Undo")->text(), QStringLiteral("Undo: Tissue by name")); // layers are unchanged
    }
};

PALPATE_TEST(BuriedLump)
#include "tst_BuriedLump.moc"
