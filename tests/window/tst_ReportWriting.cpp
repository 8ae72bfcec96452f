// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "touch/ReportDialog.h"
#include "touch/ReportPart.h"

#include <palpate/meshio/VtpFile.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TapesModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTimer>
#include <QToolBar>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

using namespace palpate;
using core::Vec3;

/// Tests the report in the main window: dialog, pictures, messages, and the walk-through of resources/docs/window.md
/// from three files to the report with the mouse alone. With PALPATE_KEEP_PICTURES the walk-through uses the phantom
/// and writes the pictures of that page into this folder.
class ReportWriting : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    Vec3 m_above_W = Vec3::Zero(); ///< place of the liver nearest to the tumour
    QPoint m_place;                ///< of the last press, in the view

    app::ReportPart& part() const { return *m_desk->window().findChild<app::ReportPart*>(); }
    ui::VtkViewport& viewport() const { return m_desk->window().viewport(); }
    ui::MessageBar& messages() const { return *m_desk->window().findChild<ui::MessageBar*>(); }
    QByteArray read(const char* name) const
    {
        QFile file(QString::fromStdString((m_desk->folder() / name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    /// Writes a liver and a recording of a press.
    void record() const
    {
        const auto scene = study::openScene(m_desk->writeStl("liver.stl", test::sphere(10, 60.0)));
        QVERIFY(scene.isOk());
        const auto haptic = study::hapticScene(scene.value());
        session::Motion motion;
        for (int i = 0; i < 500; ++i) {
            motion.p_WH.emplace_back(0.0, 0.0, 60.5 - 8.0 * std::sin(M_PI * i / 500.0));
        }
        auto writer =
            session::RecordingWriter::create(m_desk->folder() / "r.palpate", {}, session::RecordingWriter::Sync::AtEnd);
        QVERIFY(writer.isOk());
        QVERIFY(writer.value()->addScene(session::describeScene(1, *haptic, study::sourcesOf(scene.value()))).isOk());
        session::replay(*haptic, motion,
                        [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); });
        QVERIFY(writer.value()->finish().isOk());
    }

    static QString picturesFolder() { return qEnvironmentVariable("PALPATE_KEEP_PICTURES"); }
    static void keepPicture(const char* name, const QImage& picture)
    {
        constexpr int kWidth_px = 800; // in the page
        if (!picturesFolder().isEmpty()) {
            QVERIFY(picture.scaledToWidth(kWidth_px, Qt::SmoothTransformation).save(picturesFolder() + '/' + name));
        }
    }
    static geometry::TriangleMesh meshOf(const std::filesystem::path& file)
    {
        const auto scene = study::openScene(file);
        return scene.isOk() ? scene.value().structures.at(0).surface->mesh : geometry::TriangleMesh();
    }
    /// Writes liver.stl, tumour.stl and vessels.vtp: of the phantom for pictures, otherwise coarse.
    /// @return the folder
    std::filesystem::path writePatient()
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        const bool isForPictures = !picturesFolder().isEmpty();
        const geometry::TriangleMesh tumour =
            isForPictures ? meshOf(phantom / "lump-20-mm.stl") : test::moved(test::sphere(5, 8.0), {10.0, -40.0, 10.0});
        geometry::TriangleMesh vessels =
            isForPictures ? meshOf(phantom / "portal-vein.stl") : test::moved(test::sphere(3, 6.0), {-10.0, 5.0, 0.0});
        if (isForPictures) {
            test::append(vessels, meshOf(phantom / "hepatic-veins.stl"));
        }
        const geometry::TriangleMesh liver = isForPictures ? meshOf(phantom / "liver.stl") : test::sphere(20, 60.0);
        Vec3 middle_W = Vec3::Zero();
        for (const Vec3& vertex : tumour.vertices) {
            middle_W += vertex / static_cast<double>(tumour.vertices.size());
        }
        m_above_W = *std::min_element(liver.vertices.begin(), liver.vertices.end(), [&](const Vec3& a, const Vec3& b) {
            return (a - middle_W).norm() < (b - middle_W).norm();
        });
        m_desk->writeStl("patient/liver.stl", liver);
        m_desk->writeStl("patient/tumour.stl", tumour);
        meshio::VtpFile vtp;
        vtp.points = vessels.vertices;
        vtp.triangles = vessels.triangles;
        const auto bytes = meshio::vtpBytes(vtp);
        std::ofstream(m_desk->folder() / "patient" / "vessels.vtp", std::ios::binary)
            << (bytes.isOk() ? bytes.value() : std::string());
        return m_desk->folder() / "patient";
    }

    static void click(QWidget* widget)
    {
        QVERIFY(widget != nullptr && widget->isVisible());
        QTest::mouseClick(widget, Qt::LeftButton);
    }
    /// Returns the button with this text in a message; null: none.
    QPushButton* answer(const char* text) const
    {
        const auto buttons = messages().findChildren<QPushButton*>();
        const auto found = std::find_if(buttons.begin(), buttons.end(), [&](const QPushButton* one) {
            return one->isVisible() && one->text() == QLatin1String(text);
        });
        return found == buttons.end() ? nullptr : *found;
    }
    QWidget* tool(const char* id) const
    {
        return m_desk->window().findChild<QToolBar*>("tools")->widgetForAction(&m_desk->command(id));
    }
    /// Chooses File › Report… with the mouse.
    void chooseReport() const
    {
        QMenuBar* bar = m_desk->window().menuBar();
        QAction* file = bar->actions().front();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(file).center());
        PALPATE_TRY_VERIFY(file->menu()->isVisible());
        QAction& report = m_desk->command("report");
        const QPoint place = file->menu()->actionGeometry(&report).center();
        QVERIFY(file->menu()->actionAt(place) == &report && report.isEnabled());
        // Qt 6.8 closes the menu when a test clicks into it without a real pointer.
        file->menu()->close();
        report.trigger();
    }
    /// Answers the next file dialog, which blocks the click that opens it.
    static void atDialog(const std::filesystem::path& folder, const QString& names)
    {
        constexpr int kWait_ms = 300; // until the dialog is drawn
        QTimer::singleShot(kWait_ms, [folder, names] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog != nullptr);
            dialog->setDirectory(QString::fromStdString(folder.string()));
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(names);
            click(dialog->findChild<QDialogButtonBox*>()->buttons().front());
        });
    }
    double depth_mm() const
    {
        const auto& last = m_desk->window().palpation().lastPress();
        return last ? last->reading.depth_mm : 0.0;
    }
    /// Waits for the press: on tissue that is oblique to the press, it is less deep than the hand has moved.
    void awaitDepth() const
    {
        PALPATE_TRY_VERIFY(depth_mm() > 0.5 * m_desk->window().palpation().depth_mm());
        QTest::qWait(300);
    }
    /// Presses over the tumour with the mouse button, then deeper with the wheel.
    void press(int notches)
    {
        m_place = viewport().placeOf(m_above_W).toPoint();
        QTest::mouseMove(&viewport(), m_place);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, m_place);
        awaitDepth();
        for (int notch = 0; notch < notches; ++notch) {
            Q_EMIT viewport().depthTurned(1.0);
        }
        awaitDepth();
    }
    /// Releases the mouse button. @return the force before [N]
    double letGo()
    {
        const double force_N = m_desk->window().palpation().lastPress()->reading.force_N;
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, m_place);
        const bool isOff = QTest::qWaitFor([this] { return !viewport().view().cursor().state().isInContact; },
                                           test::kPatience_ms); // a human is slower than the lift
        return isOff ? force_N : -1.0;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(!m_desk->command("report").isEnabled());
        record();
        QVERIFY(m_desk->open({m_desk->folder() / "liver.stl", m_desk->folder() / "r.palpate"}));
        QVERIFY(m_desk->command("report").isEnabled());
    }

    void asksForCaseAndExaminer()
    {
        m_desk->pressKeyOf("report");
        auto* dialog = m_desk->window().findChild<app::ReportDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
        QCOMPARE(fields.size(), 2);
        QCOMPARE(dialog->examiner(), QString());
        QTest::keyClicks(fields[0], "17");
        QTest::keyClicks(fields[1], "N. N.");
        QCOMPARE(dialog->caseText(), QString("17"));
        if (const QString folder = qEnvironmentVariable("PALPATE_TEST_PICTURES"); !folder.isEmpty()) {
            QVERIFY(dialog->grab().save(folder + "/report-dialog.png"));
        }
        dialog->disconnect(&part()); // the file dialog belongs to the system
        dialog->accept();
        PALPATE_TRY_VERIFY(m_desk->window().findChild<app::ReportDialog*>() == nullptr);
        m_desk->pressKeyOf("report");
        dialog = m_desk->window().findChild<app::ReportDialog*>();
        QVERIFY(dialog != nullptr);
        QCOMPARE(dialog->examiner(), QString("N. N."));
        QCOMPARE(dialog->caseText(), QString());
        dialog->reject();
    }

    void writesPicturesAndTables()
    {
        part().write(m_desk->folder() / "report", ".html", "17", "N. N.");
        PALPATE_TRY_VERIFY2(messages().text().contains("Report written to"), qPrintable(messages().text()));
        QVERIFY2(!messages().text().contains("missing"), qPrintable(messages().text()));
        QVERIFY2(!messages().text().contains("outside"), qPrintable(messages().text()));
        const QByteArray html = read("report.html");
        QVERIFY(html.contains("<td dir=\"auto\">17</td>"));
        qsizetype at = 0;
        QList<QImage> pictures;
        while ((at = html.indexOf("data:image/jpeg;base64,", at)) >= 0) {
            at += 23;
            const QByteArray base64 = html.mid(at, html.indexOf('"', at) - at);
            pictures << QImage::fromData(QByteArray::fromBase64(base64));
        }
        QCOMPARE(pictures.size(), qsizetype{2 + 4}); // views, and maps of time and force
        for (const QImage& picture : pictures) {
            QCOMPARE(3 * picture.width(), 4 * picture.height());
            QVERIFY(picture.pixelColor(3, 3).lightness() > 245); // white around
            int tissue = 0;
            for (int x = 0; x < picture.width(); x += 4) {
                for (int y = 0; y < picture.height(); y += 4) {
                    tissue += picture.pixelColor(x, y).saturation() > 30 ? 1 : 0;
                }
            }
            QVERIFY2(tissue > picture.width() * picture.height() / 16 / 10, qPrintable(QString::number(tissue)));
        }
        QVERIFY(pictures[0] != pictures[1]);
        // The brightest touched place is yellow, a colour that nothing in the scene has.
        const auto yellows = [](const QImage& picture) {
            int count = 0;
            for (int x = 0; x < picture.width(); x += 4) {
                for (int y = 0; y < picture.height(); y += 4) {
                    const QColor c = picture.pixelColor(x, y);
                    count += c.hue() > 40 && c.hue() < 65 && c.saturation() > 60 ? 1 : 0;
                }
            }
            return count;
        };
        for (const int map : {2, 4}) { // from the front
            QVERIFY2(yellows(pictures[map]) > yellows(pictures[0]) + 20,
                     qPrintable(QString::number(yellows(pictures[map]))));
        }
        QVERIFY(pictures[2] != pictures[4]);
    }

    /// The report has the tapes of the open scene, saved in a scene file or not.
    void reportHasTheTapes()
    {
        auto& tapes = dynamic_cast<ui::TapesModel&>(*m_desk->window().findChild<QTableView*>("tapes")->model());
        core::Tape tape;
        tape.name = "Rim to rim";
        tape.from_W = Vec3(-60, 0, 0);
        tape.to_W = Vec3(59.7311, 0, 0);
        tape.fromOn = tape.toOn = "liver";
        tapes.add({tape});
        part().write(m_desk->folder() / "tapes", ".html", {}, {});
        PALPATE_TRY_VERIFY2(messages().text().contains("tapes.html"), qPrintable(messages().text()));
        const QByteArray html = read("tapes.html");
        QVERIFY(html.contains("<h2") && html.contains(">Measured distances</h2>"));
        QVERIFY(html.contains("Rim to rim"));
        QVERIFY(html.contains(">119.7</td>"));
        tapes.remove({0});
        QVERIFY(tapes.tapes().empty());
    }

    void refusesOtherNames()
    {
        part().write(m_desk->folder() / "report", ".html", {}, {}); // not the name that a dialog confirmed
        QVERIFY2(messages().text().contains("report.html already exists"), qPrintable(messages().text()));
        part().write(m_desk->folder() / "report.txt", ".pdf", {}, {});
        QVERIFY2(messages().text().contains("report.txt must end in .pdf or .html"), qPrintable(messages().text()));
        const auto size = std::filesystem::file_size(m_desk->folder() / "r.palpate");
        part().write(m_desk->folder() / "r.palpate", ".pdf", {}, {}); // the recording itself
        QVERIFY2(messages().text().contains("r.palpate must end in .pdf or .html"), qPrintable(messages().text()));
        QCOMPARE(std::filesystem::file_size(m_desk->folder() / "r.palpate"), size);
    }

    void leadsFromThreeFilesToAReportWithTheMouseAlone()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QSettings().remove(QStringLiteral("fingertip_mm")); // the usual fingertip
        const std::filesystem::path patient = writePatient();
        QVERIFY(m_desk->show());
        const QString files = QStringLiteral("\"liver.stl\" \"tumour.stl\" \"vessels.vtp\"");
        atDialog(patient, files);
        click(m_desk->window().findChild<QPushButton*>("openAnatomy"));
        const ui::StructureModel& model = m_desk->window().model();
        PALPATE_TRY_VERIFY(model.rowCount() == 3 && model.rows()[1].loaded.isTransmitted);
        keepPicture("window-walk-1.png", m_desk->picture());

        chooseReport();                                  // without a recording
        PALPATE_TRY_VERIFY(answer("Record") != nullptr); // a message on the files may come after that on the report
        click(answer("Record"));
        QVERIFY(m_desk->window().palpation().isPalpating());
        PALPATE_TRY_VERIFY(m_desk->window().findChild<ui::LumpMaps*>()->isHandUpToDate());
        press(16);
        keepPicture("window-walk-2.png", m_desk->picture());
        const double force_N = letGo();
        click(tool("mark"));
        const auto* table = m_desk->window().findChild<QAbstractItemView*>("findingsTable");
        QCOMPARE(table->model()->rowCount(), 1);
        const auto shown_N = table->model()->index(0, ui::FindingsModel::Force).data().toString().toDouble();
        QVERIFY2(std::abs(shown_N - force_N) < 0.1, qPrintable(QString::number(shown_N)));
        if (!picturesFolder().isEmpty()) {
            QEvent leaving(QEvent::Leave);
            QApplication::sendEvent(&viewport(), &leaving);
            m_desk->window().findChild<QDockWidget*>("findings")->raise();
            QTest::qWait(500);
            keepPicture("window-walk-3.png", m_desk->picture());
        }

        chooseReport(); // while recording
        QVERIFY2(messages().text().contains("finished recording"), qPrintable(messages().text()));
        click(test::answerOf(messages()));
        QVERIFY(m_desk->window().playback().recording() != nullptr);
        auto* dialog = m_desk->window().findChild<app::ReportDialog*>();
        QVERIFY(dialog != nullptr);
        atDialog(m_desk->folder(), "walk.html");
        for (QPushButton* one : dialog->findChildren<QPushButton*>()) {
            if (one->isDefault()) {
                click(one);
                break;
            }
        }
        PALPATE_TRY_VERIFY2(messages().text().contains("Report written to"), qPrintable(messages().text()));
        QCOMPARE(test::answerOf(messages())->text(), QString("Open the report"));
        const QByteArray html = read("walk.html");
        for (const char* part :
             {"Finding 1", "Touched lightly", "Distances and margins", "vessels", "published for such"}) {
            QVERIFY2(html.contains(part), part);
        }
        QVERIFY(!messages().text().contains("outside"));

        QVERIFY(m_desk->window().palpation().isPalpating()); // as before the end of the recording
        press(0);
        letGo();
        click(tool("mark"));
        part().write(m_desk->folder() / "again.html", ".html", {}, {});
        PALPATE_TRY_VERIFY2(messages().text().contains("again.html; 1 finding"), qPrintable(messages().text()));
        const QString again = QString::fromUtf8(read("again.html"));
        QVERIFY(again.contains("Findings marked outside of this recording: 1, in a table of their own."));
        QVERIFY(again.contains("Findings marked outside of this recording: before it"));
        QVERIFY(again.contains("Finding 2"));
    }

    void cleanupTestCase() { m_desk.reset(); }
};

PALPATE_TEST(ReportWriting)
#include "tst_ReportWriting.moc"
