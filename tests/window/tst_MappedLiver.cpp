// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "window/MainWindow.h"

#include "../support/Shapes.h"

#include <palpate/meshio/MeshFile.h>
#include <palpate/ui/MessageList.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cmath>
#include <fstream>

using namespace palpate;
using core::Vec3;

/// Opens a real liver whose right half is soft and left half stiff by a file array, colours the surface and presses.
/// Requires a display.
class MappedLiver : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    double m_force_N = 0.0, m_depth_mm = 0.0, m_said_N_per_mm = 0.0;

    /// Writes the mesh with an array that steps from 0.5 to 2 at the middle in x; every 50th vertex of the stiff half
    /// has no value.
    void writeMapped(const geometry::TriangleMesh& mesh, const char* name) const
    {
        const double middle = mesh.bounds().center().x();
        std::ofstream out(m_folder.filePath(name).toStdString());
        out.precision(12);
        out << R"(<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">)"
            << "<PolyData><Piece NumberOfPoints=\"" << mesh.vertices.size() << "\" NumberOfPolys=\""
            << mesh.triangles.size() << "\"><PointData>"
            << R"(<DataArray type="Float64" Name="StiffnessScale" format="ascii">)";
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const bool isSoft = mesh.vertices[i].x() < middle;
            out << (isSoft ? "0.5 " : i % 50 == 0 ? "nan " : "2 ");
        }
        out << R"(</DataArray></PointData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">)";
        for (const Vec3& p : mesh.vertices) {
            out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        }
        out << R"(</DataArray></Points><Polys><DataArray type="Int64" Name="connectivity" format="ascii">)";
        for (const geometry::Triangle& t : mesh.triangles) {
            out << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
        }
        out << R"(</DataArray><DataArray type="Int64" Name="offsets" format="ascii">)";
        for (std::size_t i = 1; i <= mesh.triangles.size(); ++i) {
            out << 3 * i << ' ';
        }
        out << "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
    }

    QComboBox* box(const QString& name) const
    {
        for (QComboBox* one : m_window->findChildren<QComboBox*>()) {
            if (one->accessibleName() == name) {
                return one;
            }
        }
        qFatal("no such box");
    }

    void choose(const QString& name, const QString& text) const
    {
        QComboBox* one = box(name);
        const int at = one->findText(text);
        QVERIFY2(at >= 0, qPrintable(name + ": " + text));
        one->setCurrentIndex(at);
        Q_EMIT one->activated(at);
    }

    void keep(const char* name) const
    {
        if (const QByteArray to = qgetenv("PALPATE_MAP_PICTURES"); !to.isEmpty()) {
            QTest::qWait(300);
            // for visual inspection
            m_window->grab().save(QString::fromLocal8Bit(to + "/" + QByteArray(name) + ".png"));
        }
    }

    /// Presses at a fraction of the view's width.
    /// @return the resulting stiffness [N/mm]
    double stiffnessAt(double share, const char* picture)
    {
        ui::VtkViewport& viewport = m_window->viewport();
        ui::PalpationController& hand = m_window->palpation();
        m_window->setPalpating(true);
        QTest::qWait(200);
        for (int i = 0; i < 8 && std::abs(hand.depth_mm() - 6.0) > 1e-9; ++i) { // wheel steps grow with depth
            const double before_mm = hand.depth_mm();
            Q_EMIT viewport.depthTurned(1.0);
            const double notch_mm = hand.depth_mm() - before_mm;
            Q_EMIT viewport.depthTurned((6.0 - hand.depth_mm()) / notch_mm);
        }
        m_depth_mm = m_force_N = 0.0;
        hand.pressAt({share * viewport.width(), 0.5 * viewport.height()});
        (void)QTest::qWaitFor([this] { return m_depth_mm > 2.0; }, test::kPatience_ms);
        QTest::qWait(600); // after the force ramp
        keep(picture);
        const double felt = m_depth_mm > 2.0 ? m_force_N / m_depth_mm : -1.0;
        if (!(std::abs(m_said_N_per_mm / felt - 1.0) < 0.02)) {
            qWarning("said %g, felt %g N/mm", m_said_N_per_mm, felt);
            return -1.0;
        }
        hand.letGo();
        (void)QTest::qWaitFor([this] { return m_depth_mm == 0.0; }, test::kPatience_ms);
        return felt;
    }

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
    }
    void cleanup() { m_window.reset(); }

    /// The colouring of a structure is saved with the scene: opened, changed, saved, opened again.
    void theShownMapIsKept()
    {
        writeMapped(test::sphere(24, 20.0), "ball.vtp");
        const QString file = m_folder.filePath("ball.palpate.json");
        std::ofstream(file.toStdString())
            << R"({"version": 1, "structures": [{"mesh": "ball.vtp", "name": "ball"}],)"
            << R"( "shown_map": {"structure": "ball", "numbers": "array:StiffnessScale"}})";
        const auto title = [&] {
            m_window = std::make_unique<MainWindow>();
            m_window->show();
            QSignalSpy ready(m_window.get(), &MainWindow::ready);
            m_window->open({file.toStdString()});
            if (!QTest::qWaitFor([&] { return ready.count() == 1; }, test::kPatience_ms)) {
                return QStringLiteral("not opened");
            }
            const auto& legend = m_window->viewport().view().legend();
            return legend.isShown() ? QString::fromStdString(legend.texts()[0]) : QString();
        };
        const auto save = [&] {
            QAction* action = m_window->findChild<QAction*>(QStringLiteral("save"));
            action->trigger();
            return !m_window->isWindowModified();
        };
        QCOMPARE(title(), QStringLiteral("ball\nStiffnessScale"));
        choose(QStringLiteral("Show"), QStringLiteral("felt stiffness, N/mm"));
        QVERIFY(save());
        QCOMPARE(title(), QStringLiteral("ball\nfelt stiffness, N/mm"));
        box(QStringLiteral("Show"))->setCurrentIndex(0); // plain colour
        Q_EMIT box(QStringLiteral("Show"))->activated(0);
        QVERIFY(save());
        QCOMPARE(title(), QString());
    }

    /// A map with a step that can make a device oscillate causes a warning beside the map and in the messages: on
    /// opening, on choosing a map, on a change of tissue and on a change of device; not with a pointer, which has no
    /// motors.
    void aSharpStepIsWarnedOf()
    {
        writeMapped(test::sphere(24, 20.0), "ball.vtp");
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kPatience_ms));
        const auto inMessages = [this] {
            int lines = 0;
            const QAbstractItemModel& all = *m_window->findChild<ui::MessageList*>()->model();
            for (int row = 0; row < all.rowCount(); ++row) {
                lines += all.index(row, 0).data().toString().contains(
                             QStringLiteral("ball: the stiffness map changes too abruptly for the simulated hand at ("))
                             ? 1
                             : 0;
            }
            return lines;
        };
        const auto inPanel = [this] {
            for (const QLabel* one : m_window->findChildren<QLabel*>()) {
                if (one->accessibleDescription() == QStringLiteral("Stability warning for the map") &&
                    one->isVisibleTo(m_window.get())) {
                    return one->text();
                }
            }
            return QString();
        };
        const auto isWarned = [&] {
            const QString line = inPanel();
            return line.contains(QStringLiteral("simulated hand at (")) &&
                   line.contains(QStringLiteral("The sideways force jumps by")) &&
                   line.contains(QStringLiteral("Spread the step over a longer distance"));
        };
        QSignalSpy ready(m_window.get(), &MainWindow::ready);
        m_window->open({m_folder.filePath("ball.vtp").toStdString()});
        PALPATE_TRY_COMPARE(ready.count(), 1);
        QTest::qWait(600);
        QVERIFY(!isWarned()); // a pointer has no motors
        QCOMPARE(inMessages(), 0);

        m_window->chooseDevice("simulated");
        PALPATE_TRY_VERIFY(isWarned());
        QCOMPARE(inMessages(), 1);
        keep("warned");

        choose(QStringLiteral("Map"), QStringLiteral("None"));
        PALPATE_TRY_VERIFY(!isWarned());
        choose(QStringLiteral("Map"), QStringLiteral("By name"));
        PALPATE_TRY_VERIFY(isWarned());
        QCOMPARE(inMessages(), 2);

        choose(QStringLiteral("Friction"), QStringLiteral("Moist (0.15, assumed)"));
        PALPATE_TRY_VERIFY(!isWarned()); // the sideways force is suppressed
        choose(QStringLiteral("Friction"), QStringLiteral("None"));
        PALPATE_TRY_VERIFY(isWarned());

        m_window->chooseDevice("mouse");
        PALPATE_TRY_VERIFY(!isWarned());
        m_window->chooseDevice("simulated");
        PALPATE_TRY_VERIFY(isWarned());
    }

    void softAndStiffHalvesAreSeenAndFelt()
    {
        PALPATE_SHARED_OR_SKIP(anatomy, "anatomy");
        meshio::ReadOptions options;
        options.unit_mm = 25.0; // size of a liver
        const auto liver = meshio::readMesh(anatomy / "liver-smooth.obj", options);
        QVERIFY2(liver.isOk(), liver.status().message().c_str());
        writeMapped(liver.value().structures[0].mesh, "liver.vtp");

        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kPatience_ms));
        connect(&m_window->palpation(), &ui::PalpationController::touched, this, [this](const ui::TouchReading& touch) {
            m_force_N = touch.force_N;
            m_depth_mm = touch.depth_mm;
            m_said_N_per_mm = touch.stiffness_N_per_mm;
        });
        QSignalSpy ready(m_window.get(), &MainWindow::ready);
        m_window->open({m_folder.filePath("liver.vtp").toStdString()});
        PALPATE_TRY_COMPARE(ready.count(), 1);
        view::SceneView& view = m_window->viewport().view();
        view.look(view::ViewFrom::Front);
        QVERIFY(!view.legend().isShown());

        choose(QStringLiteral("Show"), QStringLiteral("felt stiffness, N/mm"));
        QVERIFY(view.legend().isShown());
        const auto texts = view.legend().texts();
        QCOMPARE(QString::fromStdString(texts[0]), QStringLiteral("liver\nfelt stiffness, N/mm"));
        QCOMPARE(QString::fromStdString(texts[1]), QStringLiteral("1"));
        QCOMPARE(QString::fromStdString(texts[3]), QStringLiteral("0.25"));
        QVERIFY(!texts[4].empty()); // unknown values are grey and named

        // Seen from the front, x grows to the right.
        const double soft = stiffnessAt(0.40, "soft"), stiff = stiffnessAt(0.60, "stiff");
        QVERIFY2(std::abs(soft / 0.25 - 1.0) < 0.02, qPrintable(QString::number(soft)));
        QVERIFY2(std::abs(stiff / 1.0 - 1.0) < 0.02, qPrintable(QString::number(stiff)));

        choose(QStringLiteral("Map"), QStringLiteral("None"));
        QVERIFY(!view.legend().isShown()); // the map no longer affects the force
        const double plain = stiffnessAt(0.40, "none");
        QVERIFY2(std::abs(plain / 0.5 - 1.0) < 0.02, qPrintable(QString::number(plain)));
        for (QAction* one : m_window->actions()) {
            if (one->text().startsWith(QLatin1String("Undo"))) {
                one->trigger();
            }
        }
        QVERIFY(view.legend().isShown());
        QVERIFY(std::abs(stiffnessAt(0.40, "undone") / 0.25 - 1.0) < 0.02);
    }
};

PALPATE_TEST(MappedLiver)
#include "tst_MappedLiver.moc"
