// SPDX-License-Identifier: BSD-3-Clause
// The dialog that says what the phantom's recording says.
#include "MeasuresDialog.h"
#include "TestRunner.h"

#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>

class Measures : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void saysTheRecordingWithoutScrollingSideways()
    {
        MeasuresDialog dialog(PALPATE_SOURCE_DIR "/data/phantom/palpation.palpate", {});
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        auto* text = dialog.findChild<QTextBrowser*>();
        QVERIFY(text->toPlainText().contains(QStringLiteral("Measuring")));
        QTRY_VERIFY_WITH_TIMEOUT(text->toPlainText().contains(QStringLiteral("Coverage")), 60'000);
        for (const char* part :
             {"Duration", "Touch", "liver", "Peak [N]", "Deepest [mm]", "Searching", "not a diagnosis"}) {
            QVERIFY2(text->toPlainText().contains(QLatin1String(part)), part);
        }
        if (const QByteArray to = qgetenv("PALPATE_MEASURES_PICTURE"); !to.isEmpty()) {
            dialog.grab().save(QString::fromLocal8Bit(to)); // to be looked at
        }
        QVERIFY(!text->horizontalScrollBar()->isVisible());
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
            QVERIFY2(button->isEnabled(), qPrintable(button->text()));
        }
    }

    void saysWhyThereIsNothingToSay()
    {
        MeasuresDialog dialog("/nowhere/nothing.palpate", {});
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        auto* text = dialog.findChild<QTextBrowser*>();
        QTRY_VERIFY(text->toPlainText().contains(QStringLiteral("/nowhere/nothing.palpate")));
    }
};

PALPATE_TEST(Measures)
#include "tst_Measures.moc"
