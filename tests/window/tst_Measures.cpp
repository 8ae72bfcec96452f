// SPDX-License-Identifier: BSD-3-Clause
// Tests the dialog of measures on the phantom's recording.
#include "TestRunner.h"
#include "reports/ResultTables.h"
#include "touch/MeasuresDialog.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include <filesystem>
#include <memory>

using namespace palpate;

class Measures : public QObject
{
    Q_OBJECT

    /// Returns the dialog for the phantom's recording with its results.
    static std::unique_ptr<MeasuresDialog> measured()
    {
        auto dialog = std::make_unique<MeasuresDialog>(PALPATE_SOURCE_DIR "/data/phantom/palpation.palpate",
                                                       session::MeshesByHash());
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        dialog->show();
        auto* text = dialog->findChild<QTextBrowser*>();
        (void)QTest::qWaitFor([text] { return text->toPlainText().contains(QStringLiteral("Session")); }, 60'000);
        return dialog;
    }

    static QLabel* line(const MeasuresDialog& dialog)
    {
        for (QLabel* label : dialog.findChildren<QLabel*>()) {
            if (label->wordWrap()) {
                return label;
            }
        }
        qFatal("the dialog has no line");
    }

  private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void saysTheRecordingWithoutScrollingSideways()
    {
        MeasuresDialog dialog(PALPATE_SOURCE_DIR "/data/phantom/palpation.palpate", {});
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        auto* text = dialog.findChild<QTextBrowser*>();
        QVERIFY(text->toPlainText().contains(QStringLiteral("Measuring")));
        PALPATE_TRY_VERIFY(text->toPlainText().contains(QStringLiteral("Examined")));
        for (const char* part : {"Duration", "Late samples", "Lost samples", "Touch", "liver", "Time spent [s]",
                                 "95th percentile [N]", "Peak [N]", "Maximum depth [mm]", "Searching", "within 5 mm",
                                 "698.2", "Longest time at one point [s]", "not a diagnosis"}) {
            QVERIFY2(text->toPlainText().contains(QLatin1String(part)), part);
        }
        if (const QByteArray to = qgetenv("PALPATE_MEASURES_PICTURE"); !to.isEmpty()) {
            dialog.grab().save(QString::fromLocal8Bit(to)); // for visual inspection
        }
        QVERIFY(!text->horizontalScrollBar()->isVisible());
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
            QVERIFY2(button->isEnabled(), qPrintable(button->text()));
        }
    }

    void summaryHasDurationsWithTheirUnit()
    {
        session::SessionMeasures measures;
        measures.sums.contact.time_s = 3.44;
        QVERIFY2(summaryOf(measures).contains("in contact for 3.4 s,"), qPrintable(summaryOf(measures)));
        measures.sums.contact.time_s = 125.0;
        QVERIFY2(summaryOf(measures).contains("in contact for 02:05.0 min,"), qPrintable(summaryOf(measures)));
    }

    /// Ctrl+C copies for a spreadsheet: rows with as many cells as the header.
    void copiesItsTables()
    {
        const auto dialog = measured();
        QGuiApplication::clipboard()->clear();
        QTest::keyClick(dialog->findChild<QTextBrowser*>(), Qt::Key_C, Qt::ControlModifier);
        const QStringList tables = QGuiApplication::clipboard()->text().split(QStringLiteral("\n\n"));
        QVERIFY(tables.size() >= 4);
        for (const QString& table : tables) {
            const QStringList rows = table.split(QLatin1Char('\n'), Qt::SkipEmptyParts); // cells may be empty
            QVERIFY2(rows.size() >= 3, qPrintable(table));                               // title, head, row
            for (qsizetype i = 2; i < rows.size(); ++i) {
                QCOMPARE(rows[i].count(QLatin1Char('\t')), rows[1].count(QLatin1Char('\t')));
            }
        }
    }

    void exportsAndSaysSoInItsLine()
    {
        const auto dialog = measured();
        const QString title = dialog->windowTitle();
        const QTemporaryDir folder;
        const auto path = [&folder](const char* name) {
            return std::filesystem::path(folder.filePath(QLatin1String(name)).toStdString());
        };
        QLabel* said = line(*dialog);
        dialog->exportTo(MeasuresDialog::Export::Csv, path("ticks"));
        PALPATE_TRY_VERIFY2(said->text() == QStringLiteral("Written to %1.").arg(folder.filePath("ticks.csv")),
                            qPrintable(said->text()));
        QFile csv(folder.filePath("ticks.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QVERIFY(csv.readLine().endsWith(
            ",layers,time_s,sent_x_N,sent_y_N,sent_z_N,force_N,depth_mm,felt_N_per_mm,events\n"));
        dialog->exportTo(MeasuresDialog::Export::Json, path("results.json"));
        PALPATE_TRY_VERIFY(said->text().contains("results.json"));
        PALPATE_TRY_VERIFY(QFile::exists(folder.filePath("results.json")));
        QCOMPARE(dialog->windowTitle(), title);
    }

    void refusesANameOfAnotherKind()
    {
        const auto dialog = measured();
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("session.vtp").toStdString();
        dialog->exportTo(MeasuresDialog::Export::Csv, path);
        QCOMPARE(line(*dialog)->text(), QStringLiteral("Nothing was written: session.vtp ends in .vtp. For Data table "
                                                       "(CSV), enter a name that ends in .csv."));
        // The user did not confirm replacing the file whose name includes the added extension.
        QFile old(folder.filePath("ticks.csv"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        dialog->exportTo(MeasuresDialog::Export::Csv, folder.filePath("ticks").toStdString());
        QVERIFY(line(*dialog)->text().contains("ticks.csv already exists"));
        QCOMPARE(QFileInfo(old).size(), qint64{3});
        QVERIFY(!std::filesystem::exists(path));
        dialog->exportTo(MeasuresDialog::Export::Json, "/nowhere/results.json");
        PALPATE_TRY_VERIFY(line(*dialog)->text().contains("/nowhere/results.json: cannot be written"));
    }

    void saysWhyThereIsNothingToSay()
    {
        MeasuresDialog dialog("/nowhere/nothing.palpate", {});
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        auto* text = dialog.findChild<QTextBrowser*>();
        PALPATE_TRY_VERIFY(text->toPlainText().contains(QStringLiteral("/nowhere/nothing.palpate")));
    }
};

PALPATE_TEST(Measures)
#include "tst_Measures.moc"
