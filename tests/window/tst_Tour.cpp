// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/Tour.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>

using namespace palpate;

/// Tests *Help › Show me around* by keyboard: four callouts, each beside the feature described.
class Tour : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    [[nodiscard]] MainWindow& window() const { return m_desk->window(); }
    [[nodiscard]] ui::Tour& tour() const { return *window().findChild<ui::Tour*>(); }

    /// Checks that the callout is inside the window, beside its target, with all text visible.
    void isWellPlaced()
    {
        QCoreApplication::processEvents();
        const QRect callout = tour().geometry();
        const QString what = QStringLiteral("stop %1: callout %2 %3 %4 x %5, part %6 %7 %8 x %9")
                                 .arg(tour().at())
                                 .arg(callout.x())
                                 .arg(callout.y())
                                 .arg(callout.width())
                                 .arg(callout.height())
                                 .arg(tour().target().x())
                                 .arg(tour().target().y())
                                 .arg(tour().target().width())
                                 .arg(tour().target().height());
        QVERIFY2(window().rect().contains(callout), qPrintable(what));
        QVERIFY2(window().rect().contains(tour().target()), qPrintable(what));
        QVERIFY2(tour().target().width() > 80 && tour().target().height() > 40, qPrintable(what));
        QVERIFY2(!callout.intersects(tour().target()), qPrintable(what));
        for (const QLabel* label : tour().findChildren<QLabel*>()) {
            QVERIFY2(!label->text().isEmpty() && label->height() >= label->heightForWidth(label->width()),
                     qPrintable(what + label->text()));
            QVERIFY2(tour().rect().contains(label->geometry()), qPrintable(what));
        }
    }

    /// Goes through all stops by Enter.
    void walk()
    {
        for (int stop = 0; stop < 4; ++stop) {
            QVERIFY(tour().isVisible());
            QCOMPARE(tour().at(), stop);
            isWellPlaced();
            m_desk->press(Qt::Key_Return);
        }
        QVERIFY(!tour().isVisible());
    }

    /// Saves a picture of each stop in the folder in PALPATE_PICTURES.
    void picture(const char* name)
    {
        if (const QByteArray folder = qgetenv("PALPATE_PICTURES"); !folder.isEmpty()) {
            window().grab().save(QString::fromLocal8Bit(folder) + QLatin1Char('/') + QLatin1String(name));
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
    }
    void init() { QVERIFY(m_desk->show({1024, 700})); }
    void cleanupTestCase() { m_desk.reset(); }

    void opensThePhantomAndShowsFourThings()
    {
        m_desk->command("show-around").trigger();
        PALPATE_TRY_VERIFY(tour().isVisible());
        QCOMPARE(window().windowTitle(), QStringLiteral("Unsaved copy of phantom.palpate.json[*] – Palpate"));
        for (int stop = 0; stop < 4; ++stop) {
            isWellPlaced();
            QTest::qWait(300);
            picture(qPrintable(QStringLiteral("tour%1.png").arg(stop + 1)));
            m_desk->press(Qt::Key_Return);
        }
        QVERIFY(!tour().isVisible());
        const auto* touch = window().findChild<QDockWidget*>(QStringLiteral("touch")); // not behind another tab
        QVERIFY(window().rect().intersects(QRect(touch->mapTo(&window(), QPoint()), touch->size())));
    }

    void escEndsItWhereverTheKeysAre()
    {
        QVERIFY(m_desk->openPhantom());
        window().viewport().setFocus();
        m_desk->command("show-around").trigger();
        QVERIFY(tour().isVisible() && tour().isAncestorOf(window().focusWidget()));
        m_desk->press(Qt::Key_Escape);
        QVERIFY(!tour().isVisible());
        QCOMPARE(window().focusWidget(), static_cast<QWidget*>(&window().viewport()));
        m_desk->command("show-around").trigger();
        window().viewport().setFocus();
        m_desk->press(Qt::Key_P); // the described feature works during the tour
        QVERIFY(m_desk->command("palpate").isChecked());
        m_desk->press(Qt::Key_F6, Qt::ShiftModifier); // keyboard focus returns to the tour
        for (int i = 0; i < 12 && !tour().isAncestorOf(window().focusWidget()); ++i) {
            m_desk->press(Qt::Key_F6);
        }
        QVERIFY(tour().isAncestorOf(window().focusWidget()));
        window().viewport().setFocus();
        m_desk->press(Qt::Key_Escape);
        QVERIFY(!tour().isVisible());
        QVERIFY(m_desk->command("palpate").isChecked()); // only the tour ended
        m_desk->press(Qt::Key_P);
    }

    void anOpenSceneStaysAsItIs()
    {
        QVERIFY(m_desk->openPhantom());
        window().findChild<ui::StructurePanel*>()->findChild<QAbstractItemView*>()->setFocus();
        m_desk->press(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(window().isWindowModified());
        QSignalSpy opened(&window(), &MainWindow::ready);
        m_desk->command("show-around").trigger();
        QVERIFY(tour().isVisible()); // at once, without a question
        QVERIFY(tour().accessibleDescription().startsWith(QStringLiteral("The tour uses the open scene")));
        walk();
        QCOMPARE(opened.count(), 0);
        QVERIFY(window().isWindowModified());
    }

    void isLaidOutAnewInAnySize()
    {
        QVERIFY(m_desk->openPhantom());
        m_desk->command("show-around").trigger();
        for (int stop = 0; stop < 4; ++stop) {
            for (const QSize size : {QSize(1500, 900), QSize(1280, 800), QSize(1024, 700)}) {
                window().resize(size);
                PALPATE_TRY_COMPARE(window().size(), size);
                isWellPlaced();
            }
            m_desk->press(Qt::Key_Return);
        }
        m_desk->command("panels").trigger(); // all closed: each opens for its stop
        m_desk->command("show-around").trigger();
        walk();
        m_desk->command("show-around").trigger();
        m_desk->press(Qt::Key_Return);
        QCOMPARE(tour().at(), 1);
        m_desk->pressKeyOf("panels");
        QCoreApplication::processEvents();
        isWellPlaced(); // the view now fills the window
        m_desk->press(Qt::Key_Escape);
    }
};

PALPATE_TEST(Tour)
#include "tst_Tour.moc"
