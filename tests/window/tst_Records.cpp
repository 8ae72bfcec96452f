// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/session/Findings.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QColorDialog>
#include <QDateTime>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include <csignal>
#include <filesystem>
#include <optional>

#include <sys/resource.h>

using namespace palpate;

namespace {

/// Returns a folder on a small disk that the test may fill, if there is one; otherwise a limit on file sizes takes its
/// place.
QByteArray smallDisk()
{
    return qgetenv("PALPATE_SMALL_DISK");
}

/// Limits the size of all files that this process writes, while the object lives.
class SmallFiles
{
  public:
    explicit SmallFiles(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN); // a write then fails instead of raising the signal
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit small = m_before;
        small.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallFiles() { setrlimit(RLIMIT_FSIZE, &m_before); }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;

  private:
    rlimit m_before{};
};

} // namespace

/// Tests recordings in the main window: full disk, closing during a recording, opening a recording alone.
class Records : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    static std::filesystem::path phantom() { return std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom"; }

    ui::Chip* chip() const
    {
        for (ui::Chip* one : m_desk->window().findChildren<ui::Chip*>()) {
            if (one->objectName() == QStringLiteral("recording")) {
                return one;
            }
        }
        qFatal("no chip of the recording");
    }
    ui::MessageBar& message() const { return *m_desk->window().findChild<ui::MessageBar*>(); }

    QToolButton* colourButton() const
    {
        for (QToolButton* one : m_desk->window().findChildren<QToolButton*>()) {
            if (one->accessibleName() == QStringLiteral("Colour")) {
                return one;
            }
        }
        qFatal("no button \"Colour\"");
    }
    /// Returns the colour of the selected structure.
    QColor colourOnButton() const
    {
        const QImage image = colourButton()->icon().pixmap(32, 32).toImage();
        return image.pixelColor(image.rect().center());
    }

    /// Returns the newest recording in the documents folder.
    std::filesystem::path newest() const
    {
        const QDir folder(QDir::homePath() + QStringLiteral("/Documents/Palpate"));
        const QStringList files = folder.entryList({QStringLiteral("*.palpate")}, QDir::Files, QDir::Time);
        return std::filesystem::path(files.isEmpty() ? std::string() : folder.filePath(files.front()).toStdString());
    }

    /// Answers the next question with a button.
    /// @param asked  receives the text of the question
    static void answer(const char* button, QString& asked)
    {
        QTimer::singleShot(300, qApp, [button, &asked] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) {
                return; // the test detects that no question appeared
            }
            asked = box->text();
            for (QAbstractButton* one : box->buttons()) {
                if (one->text().remove(QLatin1Char('&')) == QLatin1String(button)) {
                    one->click();
                    return;
                }
            }
            box->reject();
        });
    }

    void picture(const char* name) const
    {
        if (const QByteArray to = qgetenv("PALPATE_RECORDS_PICTURES"); !to.isEmpty()) {
            m_desk->window().grab().save(QString::fromLocal8Bit(to) + QLatin1Char('/') +
                                         QLatin1String(name)); // saved for visual inspection
        }
    }

    /// Returns the fingertip that the menu shows.
    QString fingertip()
    {
        for (QMenu* menu : m_desk->window().findChildren<QMenu*>()) {
            if (menu->title() == QStringLiteral("Fingertip")) {
                menu->popup({});
                QStringList chosen;
                for (const QAction* one : menu->actions()) {
                    chosen << (one->isChecked() ? QStringList(one->text()) : QStringList());
                }
                menu->close();
                return chosen.join(QLatin1Char('+'));
            }
        }
        return {};
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        QLocale::setDefault(QLocale::c());
        m_desk = std::make_unique<test::Desk>();
        const QByteArray own = QByteArray::fromStdString(m_desk->folder().string());
        qputenv("HOME", smallDisk().isEmpty() ? own : smallDisk()); // location of the documents folder
    }
    void init() { QVERIFY(m_desk->show()); }
    void cleanupTestCase() { m_desk.reset(); }

    /// The failure is reported once and correctly: the recording ends, chip and button show the state, and the file
    /// opens and contains the reason.
    void aFullDiskEndsTheRecordingAndIsToldOnce()
    {
        QVERIFY(m_desk->open({phantom() / "phantom-layers.palpate.json"}));
        m_desk->pressKeyOf("record");
        PALPATE_TRY_VERIFY(chip()->text().contains(QStringLiteral("● recording")));
        PALPATE_TRY_VERIFY2(chip()->text().endsWith(QStringLiteral(" late, 0 lost")), qPrintable(chip()->text()));
        QCOMPARE(m_desk->command("record").text(), QStringLiteral("Stop"));

        bool hasEnded = false;
        {
            std::optional<SmallFiles> limit;
            if (smallDisk().isEmpty()) {
                // Above the present size, which depends on the machine: pages that exist can be written on a full disk.
                limit.emplace(static_cast<rlim_t>(std::filesystem::file_size(newest())) + 128 * 1024);
            }
            hasEnded = QTest::qWaitFor(
                [&] { return chip()->text().startsWith(QStringLiteral("recording failed at ")); }, 60000);
        }
        QVERIFY2(hasEnded, qPrintable(chip()->text() + QStringLiteral(": ") + message().text()));
        QCOMPARE(m_desk->command("record").text(), QStringLiteral("Record"));
        QVERIFY(!m_desk->command("record").isChecked());
        QVERIFY(message().isVisible());
        QVERIFY2(
            message().text().contains(QStringLiteral("because the disk is full; what was felt after is not in it")),
            qPrintable(message().text()));
        picture("full.png");
        const auto reader = session::RecordingReader::open(newest());
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(reader.value()->verify().isOk());
        QVERIFY(!reader.value()->extent().isComplete && reader.value()->extent().ticks > 500);

        QTest::qWait(1200); // the message stays until the user acts
        QVERIFY(chip()->text().startsWith(QStringLiteral("recording failed")));
        m_desk->pressKeyOf("fit");
        PALPATE_TRY_VERIFY(chip()->text().isEmpty());
        QCOMPARE(test::answerOf(message())->text(), QStringLiteral("Open the recording"));
        test::answerOf(message())->click();
        PALPATE_TRY_VERIFY(m_desk->window().playback().recording() != nullptr);
        QVERIFY2(message().text().contains(QStringLiteral("Later palpation was not recorded")),
                 qPrintable(message().text()));
    }

    /// Names have a resolution of one second: an older recording with the same name is kept, and so is a file that
    /// SQLite would treat as a companion file.
    void aSecondRecordingGetsANumber()
    {
        QVERIFY(m_desk->openPhantom());
        const QString folder = QDir::homePath() + QStringLiteral("/Documents/Palpate");
        QVERIFY(QDir().mkpath(folder));
        const QDateTime now = QDateTime::currentDateTime();
        QStringList taken;
        for (int second = 0; second < 90; ++second) {
            const QString name =
                folder + QLatin1Char('/') + now.addSecs(second).toString(QStringLiteral("yyyy-MM-dd hh.mm.ss"));
            for (const QString& file :
                 {name + QStringLiteral(".palpate"), name + QStringLiteral(" (2).palpate-journal")}) {
                QFile out(file);
                QVERIFY(!out.exists() && out.open(QIODevice::WriteOnly) && out.write("older") == 5);
                taken << file;
            }
        }
        m_desk->command("record").trigger();
        PALPATE_TRY_VERIFY(chip()->text().contains(QStringLiteral("● recording")));
        m_desk->command("record").trigger();
        int numbered = 0;
        for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("* (3).palpate")}, QDir::Files)) {
            numbered += session::RecordingReader::open(file.filePath().toStdString()).isOk() ? 1 : 0;
            taken << file.filePath();
        }
        QCOMPARE(numbered, 1);
        for (const QString& name : taken) {
            QVERIFY(name.contains(QStringLiteral("(3)")) || QFileInfo(name).size() == 5);
            QVERIFY(QFile::remove(name));
        }
    }

    void closingAsksWhileARecordingRuns()
    {
        QVERIFY(m_desk->open({phantom() / "phantom.palpate.json"}));
        m_desk->pressKeyOf("record");
        PALPATE_TRY_VERIFY(chip()->text().contains(QStringLiteral("● recording")));
        QTest::qWait(600);
        QString asked;
        answer("Continue recording", asked);
        QVERIFY(!m_desk->window().close());
        QVERIFY(asked.startsWith(QStringLiteral("Recording in progress")));
        QVERIFY(m_desk->window().isVisible());
        QCOMPARE(m_desk->command("record").text(), QStringLiteral("Stop"));
        answer("Stop recording", asked);
        QVERIFY(m_desk->window().close());
        const auto reader = session::RecordingReader::open(newest());
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(reader.value()->extent().isComplete && reader.value()->extent().ticks > 300);
    }

    /// Connecting and removing a device keeps the shown moment of the recording.
    void theMomentStaysWhenTheDeviceChanges()
    {
        QVERIFY(m_desk->open({phantom() / "palpation.palpate"}));
        MainWindow& window = m_desk->window();
        PALPATE_TRY_VERIFY(window.playback().peakTime_s() > 0.0);
        const double peak_s = window.playback().peakTime_s();
        window.playback().seek(peak_s);
        const auto shown = [&] { return window.viewport().view().cursor().state(); };
        const view::TouchState before = shown();
        QVERIFY(before.isPresent && before.isInContact);
        window.chooseDevice("simulated");
        PALPATE_TRY_VERIFY(shown().isPresent && shown().p_WH != before.p_WH); // hand of the device
        window.chooseDevice("mouse");
        PALPATE_TRY_VERIFY(shown().isPresent && shown().p_WH == before.p_WH && shown().f_W == before.f_W);
        QCOMPARE(window.playback().position_s(), peak_s);
    }

    /// A recording restores the tissue and appearance of the phantom instead of the defaults for bare meshes.
    void aRecordingAloneBringsItsStructures()
    {
        QVERIFY(m_desk->open({phantom() / "palpation.palpate"}));
        QVERIFY(m_desk->window().playback().recording() != nullptr);
        const auto* list = m_desk->window().findChild<QAbstractItemView*>(QString(), Qt::FindChildrenRecursively);
        QVERIFY(list != nullptr && list->model()->rowCount() == 5);
        QCOMPARE(list->model()->index(0, ui::StructureModel::Name).data().toString(), QStringLiteral("liver"));
        QStringList fields;
        for (const QDoubleSpinBox* field : m_desk->window().findChildren<QDoubleSpinBox*>()) {
            if (field->accessibleName().startsWith(QStringLiteral("Stiffness"))) {
                fields << QString::number(field->value());
            }
        }
        QVERIFY2(fields.contains(QStringLiteral("0.2")), qPrintable(fields.join(QLatin1Char(' '))));
        picture("alone.png");
    }

    /// Without the touched surfaces the view shows the path of the hand, thick where it touched, and is fitted to it.
    void aRecordingWithoutMeshesShowsThePathOfTheHand()
    {
        const std::filesystem::path alone = m_desk->folder() / "alone";
        std::filesystem::create_directories(alone);
        std::filesystem::copy_file(phantom() / "palpation.palpate", alone / "palpation.palpate");
        const auto reader = session::RecordingReader::open(alone / "palpation.palpate");
        core::Box hand;
        std::int64_t touching = 0;
        QVERIFY(reader.value()
                    ->forEach(reader.value()->extent().firstTick, reader.value()->extent().lastTick,
                              [&](const servo::TickRecord& tick) {
                                  hand.extend(tick.p_WH);
                                  touching += tick.felt.f_W.norm() > 0.0 ? 1 : 0;
                                  return true;
                              })
                    .isOk());
        QVERIFY(touching > 0);
        view::SceneView& view = m_desk->window().viewport().view();
        QSignalSpy drawn(&m_desk->window().playback(), &ui::Playback::overviewReady);
        m_desk->window().open({alone / "palpation.palpate"});
        PALPATE_TRY_COMPARE(drawn.count(), 1);
        QVERIFY(m_desk->window().viewport().isVisible());
        QCOMPARE(view.structureCount(), std::size_t{0});
        QVERIFY(view.handPath().isShown());
        // Some thousand points stand for all ticks: between two points the hand may have gone a little farther.
        const core::Box& shown = view.handPath().bounds();
        QVERIFY(hand.contains(shown));
        QVERIFY((shown.sizes() - hand.sizes()).norm() < 0.02 * hand.diagonal().norm());
        QVERIFY(view.bounds().min() == shown.min() && view.bounds().max() == shown.max());
        for (int corner = 0; corner < 8; ++corner) { // the whole path is in the picture
            const QPointF place =
                m_desk->window().viewport().placeOf(shown.corner(static_cast<core::Box::CornerType>(corner)));
            QVERIFY(m_desk->window().viewport().rect().contains(place.toPoint()));
        }
        picture("hand-path.png");
        // With its surfaces, the path makes way.
        QVERIFY(m_desk->open({phantom() / "palpation.palpate"}));
        QVERIFY(view.structureCount() > 0);
        PALPATE_TRY_COMPARE(drawn.count(), 2);
        QVERIFY(!view.handPath().isShown());
    }

    /// A colour chosen by hand and never saved is restored from the recording.
    void aRecordingKeepsTheColours()
    {
        QVERIFY(m_desk->open({phantom() / "lump-20-mm.stl"}));
        const QColor chosen(20, 200, 90);
        QTimer::singleShot(300, qApp, [&chosen] {
            if (auto* dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget())) {
                dialog->setCurrentColor(chosen);
                dialog->accept();
            }
        });
        colourButton()->click();
        QCOMPARE(colourOnButton(), chosen);
        m_desk->window().activateWindow(); // no window manager does this after the dialog
        QVERIFY(QTest::qWaitForWindowActive(&m_desk->window()));
        m_desk->window().viewport().setFocus();
        m_desk->pressKeyOf("record");
        PALPATE_TRY_VERIFY(chip()->text().contains(QStringLiteral("● recording")));
        QTest::qWait(600);
        m_desk->pressKeyOf("record");
        PALPATE_TRY_VERIFY(m_desk->window().playback().recording() != nullptr);
        const std::filesystem::path file = newest();
        const auto reader = session::RecordingReader::open(file);
        QVERIFY2(reader.isOk() && reader.value()->verify().isOk(), file.c_str());
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({file}));
        QCOMPARE(colourOnButton(), chosen);
    }

    /// The recorded fingertip applies until another scene is open; then the user's choice returns.
    void aRecordingAloneBringsItsFingertip()
    {
        const std::filesystem::path folder = m_desk->folder() / "tip";
        std::filesystem::copy(phantom(), folder, std::filesystem::copy_options::recursive);
        const auto from = session::RecordingReader::open(folder / "palpation.palpate");
        const std::filesystem::path file = folder / "tip.palpate";
        auto writer = session::RecordingWriter::create(file, from.value()->info());
        session::SceneRecord scene = from.value()->scenes().front();
        scene.fingertip_mm = 3.0;
        QVERIFY(writer.value()->addScene(scene).isOk());
        QVERIFY(
            from.value()
                ->forEach(0, 999, [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); })
                .isOk());
        QVERIFY(writer.value()->finish().isOk());
        QVERIFY(m_desk->open({file}));
        QCOMPARE(fingertip(), QStringLiteral("Ball, radius 3 mm"));
        QCOMPARE(QSettings().value(QStringLiteral("fingertip_mm")).toDouble(), 0.0);
        QVERIFY(m_desk->open({folder / "phantom.palpate.json"}));
        QCOMPARE(fingertip(), QStringLiteral("Point"));
        m_desk->window().open({file}); // replayed in the open scene, which keeps its fingertip
        PALPATE_TRY_VERIFY(m_desk->window().playback().recording() != nullptr);
        QCOMPARE(fingertip(), QStringLiteral("Point"));
    }

    /// A recording that a crash cut off is offered at the next start; one that ended is not.
    void aRecordingCutOffIsOffered()
    {
        const QDir notes(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                         QStringLiteral("/recordings"));
        const auto count = [&notes] { return notes.entryList({QStringLiteral("*.txt")}, QDir::Files).size(); };
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({phantom() / "lump-20-mm.stl"}));
        m_desk->window().viewport().setFocus();
        m_desk->pressKeyOf("record");
        PALPATE_TRY_VERIFY(chip()->text().contains(QStringLiteral("● recording")));
        QCOMPARE(count(), 1);
        QTest::qWait(300);
        m_desk->pressKeyOf("record");
        PALPATE_TRY_COMPARE(count(), 0);

        QVERIFY(notes.mkpath(QStringLiteral(".")));
        QFile note(notes.filePath(QStringLiteral("left.txt")));
        QVERIFY(note.open(QIODevice::WriteOnly));
        note.write(QByteArray::fromStdString((phantom() / "palpation.palpate").string()));
        note.close();
        QVERIFY(m_desk->show());
        PALPATE_TRY_VERIFY(message().isVisible());
        QVERIFY2(message().text().contains(
                     QStringLiteral("Palpate ended unexpectedly while recording palpation.palpate. The first ")),
                 qPrintable(message().text()));
        test::answerOf(message())->click();
        PALPATE_TRY_VERIFY(m_desk->window().playback().recording() != nullptr);
        QCOMPARE(count(), 0);
        const QLabel& source = *m_desk->window().findChild<QLabel*>(QStringLiteral("touchSource"));
        QVERIFY2(source.text().startsWith(QStringLiteral("Recording, ")), qPrintable(source.text()));
        m_desk->window().setPalpating(true);
        m_desk->window().viewport().view().look(view::ViewFrom::Front);
        m_desk->window().palpation().pressAt(*m_desk->window().viewport().palpablePlace());
        PALPATE_TRY_COMPARE(source.text(), QStringLiteral("Live hand"));
    }

    /// The hand of a new user is a finger, and a chip shows its size.
    void theFingertipIsAFingerAtFirst()
    {
        QSettings().remove(QStringLiteral("fingertip_mm"));
        const auto restored = qScopeGuard([] { QSettings().setValue(QStringLiteral("fingertip_mm"), 0.0); });
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({phantom() / "lump-20-mm.stl"}));
        QCOMPARE(fingertip(), QStringLiteral("Ball, radius 8 mm"));
        const auto* shown = m_desk->window().findChild<ui::Chip*>(QStringLiteral("fingertip"));
        PALPATE_TRY_COMPARE(shown->said(), QStringLiteral("fingertip 8 mm ▾"));
        // A scene in metres is smaller than a finger.
        QVERIFY(m_desk->open({m_desk->writeStl("tiny.stl", test::sphere(8, 0.5))}));
        PALPATE_TRY_COMPARE(shown->said(), QStringLiteral("fingertip: point ▾"));
        QVERIFY(m_desk->open({phantom() / "lump-20-mm.stl"}));
        PALPATE_TRY_COMPARE(shown->said(), QStringLiteral("fingertip 8 mm ▾"));
    }

    /// Findings of a recording are drawn over the open scene, which stays unchanged.
    void aRecordingsFindingsAreDrawnOverTheScene()
    {
        const auto from = session::RecordingReader::open(phantom() / "palpation.palpate");
        const std::filesystem::path file = m_desk->folder() / "marked.palpate";
        auto writer = session::RecordingWriter::create(file, from.value()->info());
        QVERIFY(writer.value()->addScene(from.value()->scenes().front()).isOk());
        QVERIFY(
            from.value()
                ->forEach(0, 999, [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); })
                .isOk());
        for (const char* name : {"Finding 1", "Finding 2"}) {
            core::Finding finding;
            finding.name = name;
            finding.p_W = core::Vec3(name[8] - '0', -40.0, 5.0);
            QVERIFY(writer.value()->addEvent({500, "finding", session::findingJson(finding)}).isOk());
            if (name[8] == '2') {
                QVERIFY(writer.value()->addEvent({600, "finding-undone", session::findingJson(finding)}).isOk());
            }
        }
        QVERIFY(writer.value()->finish().isOk());
        QVERIFY(m_desk->open({phantom() / "phantom.palpate.json"}));
        QVERIFY(!m_desk->command("show-findings").isEnabled());
        m_desk->window().open({file});
        PALPATE_TRY_VERIFY(m_desk->command("show-findings").isEnabled());
        QCOMPARE(m_desk->window().playback().recording()->findings().size(), std::size_t{1});
        QVERIFY(!m_desk->window().isWindowModified());
        picture("findings.png");
    }
};

PALPATE_TEST(Records)
#include "tst_Records.moc"
