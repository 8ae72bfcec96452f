// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include "compare/ComparisonDialog.h"
#include "compare/ComparisonPart.h"

#include <palpate/core/Quantity.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/CompareRecordings.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/TouchMap.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QProcess>
#include <QTextBrowser>

#include <cmath>
#include <fstream>

using namespace palpate;

/// Tests the comparison of two recordings in the whole window: tables, map and playheads.
class Comparison : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::filesystem::path m_phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
    std::filesystem::path m_second;

    ui::TouchMap& map() { return *m_desk->window().findChild<ui::TouchMap*>(); }
    ui::Playback& playback() { return *m_desk->window().findChild<ui::Playback*>(); }
    ui::SessionPanel& panel() { return *m_desk->window().findChild<ui::SessionPanel*>(); }
    app::ComparisonPart& part() { return *m_desk->window().findChild<app::ComparisonPart*>(); }
    view::ColourLegend& legend() { return m_desk->window().viewport().view().legend(); }
    bool isRead(double first_s, double second_s)
    {
        return map().sums() != nullptr && std::abs(map().sums()->time_s - first_s) < 1e-6 &&
               map().secondSums() != nullptr && std::abs(map().secondSums()->time_s - second_s) < 1e-6;
    }
    void keepPicture(const char* name)
    {
        if (const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES"); !folder.isEmpty()) {
            QVERIFY(m_desk->picture().save(folder + '/' + name));
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        // The hand of the bundled recording from the fourth second on, 12 mm beside its path.
        const auto recorded = session::RecordingReader::open(m_phantom / "palpation.palpate");
        const std::filesystem::path motion = m_desk->folder() / "m.csv";
        std::ofstream csv(motion);
        csv << "x,y,z\n";
        QVERIFY(recorded.value()
                    ->forEach(4000, 16000,
                              [&](const servo::TickRecord& tick) {
                                  csv << tick.p_WH.x() + 12.0 << ',' << tick.p_WH.y() << ',' << tick.p_WH.z() << '\n';
                                  return true;
                              })
                    .isOk());
        csv.close();
        m_second = m_desk->folder() / "second.palpate";
        QCOMPARE(QProcess::execute(PALPATE_EXECUTABLE,
                                   {"replay", QString::fromStdString((m_phantom / "phantom.palpate.json").string()),
                                    "--motion", QString::fromStdString(motion.string()), "--record",
                                    QString::fromStdString(m_second.string())}),
                 0);
        part().compareWith(m_second);
        QVERIFY(playback().second() != nullptr);
    }

    /// The cells of the window are those that the command line prints.
    void tablesAreThoseOfTheCommandLine()
    {
        auto* dialog = m_desk->window().findChild<app::ComparisonDialog*>();
        QVERIFY(dialog != nullptr);
        auto* text = dialog->findChild<QTextBrowser*>();
        PALPATE_TRY_VERIFY(text->toPlainText().contains("Whole session"));
        const auto compared = study::compareRecordings(playback().recording()->path(), m_second);
        QVERIFY(compared.isOk());
        const QString shown = text->toPlainText().simplified();
        int cells = 0;
        for (const study::ReportTable& table : study::comparisonTables(compared.value().sessions)) {
            for (const auto& row : table.rows) {
                QStringList line;
                for (const core::MessageArgument& cell : row) {
                    line << QString::fromStdString(cell.english);
                }
                QVERIFY2(shown.contains(line.join(' ').simplified()), qPrintable(line.join(" | ")));
                cells += static_cast<int>(line.size());
            }
        }
        QVERIFY(cells > 100);
        QVERIFY(shown.contains("The device was"));
        dialog->close();
    }

    void mapShowsWhatEachHandTouched()
    {
        QCOMPARE(map().quantity(), ui::TouchQuantity::Covered);
        const double first_s = playback().recording()->duration_s(), second_s = playback().second()->duration_s();
        playback().seek(first_s);
        playback().seekSecond(second_s);
        PALPATE_TRY_VERIFY(isRead(first_s, second_s));
        const auto compared = study::compareRecordings(playback().recording()->path(), m_second);
        const session::ComparedSurface& liver = compared.value().sessions.surfaces.front();
        QVERIFY(liver.both_mm2 > 0.0 && liver.onlyFirst_mm2 > 0.0 && liver.onlySecond_mm2 > 0.0);
        const auto text = [&](const char* who, double area_mm2) {
            const double percent = 100.0 * area_mm2 / liver.area_mm2;
            return QStringLiteral("%1: %2, %3 %")
                .arg(who, QString::fromStdString(core::areaText(area_mm2).english()),
                     QString::number(percent, 'f', percent < 1.0 ? 1 : 0))
                .toStdString();
        };
        const std::vector<std::string> marks = legend().markTexts();
        QCOMPARE(marks, (std::vector<std::string>{text("only A", liver.onlyFirst_mm2), text("both", liver.both_mm2),
                                                  text("only B", liver.onlySecond_mm2)}));
    }

    void eachRecordingHasItsOwnPlayhead()
    {
        playback().seek(3.0);
        playback().seekSecond(5.0);
        PALPATE_TRY_VERIFY(isRead(3.0, 5.0));
        QVERIFY(QString::fromStdString(legend().texts()[0]).contains("A up to 3.0 s, B up to 5.0 s"));
        QVERIFY(panel().secondTimeline().isVisible());
        Q_EMIT panel().secondTimeline().seekWanted(6.0); // by the mouse
        PALPATE_TRY_VERIFY(isRead(3.0, 6.0));
        QVERIFY(m_desk->window().viewport().view().secondHand().isShown());
        keepPicture("window-comparison.png");
        playback().play();
        PALPATE_TRY_VERIFY(playback().position_s() > 3.3);
        playback().pause();
        QVERIFY(std::abs(panel().secondTransport().position_s() - playback().position_s() - 3.0) < 0.05);
        // The longer one goes on alone.
        playback().seek(playback().recording()->duration_s());
        playback().seekSecond(2.0);
        playback().play();
        PALPATE_TRY_VERIFY(panel().secondTransport().position_s() > 2.2);
        QVERIFY(playback().isPlaying());
        QCOMPARE(playback().position_s(), playback().recording()->duration_s());
        playback().pause();
    }

    /// A click in a timeline moves its own playhead; map and ring of the other recording stay.
    void aClickMovesOnePlayhead()
    {
        view::SceneView& view = m_desk->window().viewport().view();
        playback().seek(3.0);
        playback().seekSecond(5.0);
        PALPATE_TRY_VERIFY(isRead(3.0, 5.0));
        const core::Vec3 ofSecond = view.secondHand().place_W(), ofFirst = view.cursor().state().p_WH;
        const auto click = [](ui::ForceTimeline& timeline, double share) {
            QTest::mouseClick(&timeline, Qt::LeftButton, {},
                              QPoint(static_cast<int>(share * timeline.width()), timeline.height() / 2));
        };
        click(panel().timeline(), 0.6);
        const double first_s = playback().position_s();
        QVERIFY(std::abs(first_s - 3.0) > 1.0);
        QCOMPARE(panel().secondTransport().position_s(), 5.0);
        PALPATE_TRY_VERIFY(isRead(first_s, 5.0));
        QVERIFY(view.cursor().state().p_WH != ofFirst);
        QVERIFY(view.secondHand().place_W() == ofSecond);
        click(panel().secondTimeline(), 0.4);
        const double second_s = panel().secondTransport().position_s();
        QVERIFY(std::abs(second_s - 5.0) > 0.5);
        QCOMPARE(playback().position_s(), first_s);
        PALPATE_TRY_VERIFY(isRead(first_s, second_s));
        // The ring is where the second hand was in contact.
        const auto tick = playback().second()->at(second_s);
        QVERIFY(tick.has_value());
        QCOMPARE(view.secondHand().isShown(), tick->felt.structure >= 0);
        QVERIFY(tick->felt.structure < 0 || (view.secondHand().place_W() - tick->felt.p_WG).norm() < 20.0);
        m_desk->window().viewport().setFocus();
        m_desk->pressKeyOf("to-start"); // both
        QCOMPARE(playback().position_s(), 0.0);
        QCOMPARE(panel().secondTransport().position_s(), 0.0);
        PALPATE_TRY_VERIFY(isRead(0.0, 0.0));
        playback().seek(playback().recording()->duration_s());
    }

    void endsWithTheCommandOrAnotherRecording()
    {
        m_desk->command("compare").trigger();
        QVERIFY(playback().second() == nullptr);
        QVERIFY(!panel().secondTimeline().isVisible());
        QVERIFY(!m_desk->window().viewport().view().secondHand().isShown());
        QCOMPARE(m_desk->command("compare").text(), "Compare with…");
        PALPATE_TRY_VERIFY(QString::fromStdString(legend().texts()[0]).contains("touched: "));
        part().compareWith(m_second);
        QVERIFY(playback().second() != nullptr);
        playback().setRecording(ui::RecordedTouch::open(m_second).value());
        QVERIFY(playback().second() == nullptr);
    }

    void refusesWhatCannotBeCompared()
    {
        part().compareWith(m_second);
        QVERIFY(playback().second() == nullptr);
        QVERIFY2(m_desk->window().findChild<ui::MessageBar*>()->text().contains("same recording twice"),
                 qPrintable(m_desk->window().findChild<ui::MessageBar*>()->text()));
    }
};

PALPATE_TEST(Comparison)
#include "tst_Comparison.moc"
