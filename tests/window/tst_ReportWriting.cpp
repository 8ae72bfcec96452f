// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "touch/ReportDialog.h"
#include "touch/ReportPart.h"

#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>
#include <palpate/ui/HintLine.h>
#include <palpate/ui/MessageBar.h>

#include <QAction>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QSettings>

#include <cmath>
#include <filesystem>
#include <memory>

using namespace palpate;

/// Tests the report in the main window: dialog, pictures, messages.
class ReportWriting : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    app::ReportPart& part() const { return *m_desk->window().findChild<app::ReportPart*>(); }
    QString hint() const { return m_desk->window().findChild<ui::HintLine*>()->said(); }
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
        PALPATE_TRY_VERIFY2(hint().contains("Report written to"), qPrintable(hint()));
        QVERIFY2(!hint().contains("missing"), qPrintable(hint()));
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

    void refusesOtherNames()
    {
        auto& messages = *m_desk->window().findChild<ui::MessageBar*>();
        part().write(m_desk->folder() / "report", ".html", {}, {}); // not the name that a dialog confirmed
        QVERIFY2(messages.text().contains("report.html already exists"), qPrintable(messages.text()));
        part().write(m_desk->folder() / "report.txt", ".pdf", {}, {});
        QVERIFY2(messages.text().contains("report.txt must end in .pdf or .html"), qPrintable(messages.text()));
        const auto size = std::filesystem::file_size(m_desk->folder() / "r.palpate");
        part().write(m_desk->folder() / "r.palpate", ".pdf", {}, {}); // the recording itself
        QVERIFY2(messages.text().contains("r.palpate must end in .pdf or .html"), qPrintable(messages.text()));
        QCOMPARE(std::filesystem::file_size(m_desk->folder() / "r.palpate"), size);
    }

    void cleanupTestCase() { m_desk.reset(); }
};

PALPATE_TEST(ReportWriting)
#include "tst_ReportWriting.moc"
