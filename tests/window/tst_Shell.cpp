// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/ui/ChipRow.h>
#include <palpate/ui/EngineeringPanel.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/MessageList.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSettings>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>

#include <algorithm>
#include <set>

using namespace palpate;

namespace {

std::vector<QObject*> g_alerted; // NOLINT: Qt's handler is a function without data

void catchAlert(QAccessibleEvent* event)
{
    if (event->type() == QAccessible::Alert) {
        g_alerted.push_back(event->object());
    }
}

/// Returns whether a panel is in the window: Qt places a panel behind another panel's tab outside the window.
bool isInWindow(const QDockWidget& dock)
{
    const QWidget* window = dock.window();
    return dock.isVisible() && window->rect().intersects(QRect(dock.mapTo(window, QPoint()), dock.size()));
}

/// Returns whether a panel, or a widget inside, is behind another panel's tab.
bool isBehindATab(QMainWindow& window, const QWidget* widget)
{
    for (const QWidget* one = widget; one != nullptr; one = one->parentWidget()) {
        const auto* dock = qobject_cast<const QDockWidget*>(one);
        if (dock != nullptr && !isInWindow(*dock) &&
            !window.tabifiedDockWidgets(const_cast<QDockWidget*>(dock)).isEmpty()) {
            return true;
        }
    }
    return false;
}

} // namespace

/// Tests the layout around the panels: sizes, chips, messages, keyboard navigation between panels.
class Shell : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    [[nodiscard]] MainWindow& window() const { return m_desk->window(); }
    template<class T>
    [[nodiscard]] T& the(const char* name = "") const
    {
        T* found = window().findChild<T*>(QLatin1String(name));
        if (found == nullptr) {
            qFatal("no such part of the window");
        }
        return *found;
    }
    [[nodiscard]] static bool mentions(const QWidget& panel, const QString& text)
    {
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().contains(text); });
    }
    [[nodiscard]] QTreeView& list() const { return *the<ui::StructurePanel>().findChild<QTreeView*>(); }
    [[nodiscard]] static ui::Chip* chipThatSays(const QWidget& window, const QString& start)
    {
        for (ui::Chip* chip : window.findChildren<ui::Chip*>()) {
            if (chip->said().startsWith(start)) {
                return chip;
            }
        }
        return nullptr;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show({1024, 700}));
        QVERIFY(m_desk->openPhantom());
    }
    void cleanupTestCase() { m_desk.reset(); }

    /// Also run with fonts for a display of 160 dots per inch.
    void fitsASmallScreen()
    {
        QCoreApplication::processEvents();
        const QSize least = window().minimumSizeHint();
        QVERIFY2(least.width() <= 1024 && least.height() <= 700,
                 qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
        QCOMPARE(window().size(), QSize(1024, 700));
        m_desk->pressKeyOf("keys");
        QVERIFY(the<ui::KeysCard>().isVisible());
        for (const QWidget* widget : window().findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->isWindow() || test::isScrolled(widget) ||
                isBehindATab(window(), widget)) {
                continue;
            }
            const QRect place(widget->mapTo(&window(), QPoint()), widget->size());
            QVERIFY2(window().rect().contains(place),
                     qPrintable(QStringLiteral("%1 \"%2\" reaches to %3, %4")
                                    .arg(QLatin1String(widget->metaObject()->className()), widget->objectName())
                                    .arg(place.right())
                                    .arg(place.bottom())));
        }
        m_desk->press(Qt::Key_Escape);
        QVERIFY(!the<ui::KeysCard>().isVisible());
    }

    void theRecordingChipNeverGoes()
    {
        window().resize(1024, 700);
        m_desk->command("record").trigger();
        PALPATE_TRY_VERIFY(chipThatSays(window(), QStringLiteral("●")) != nullptr);
        ui::Chip& recording = *chipThatSays(window(), QStringLiteral("●"));
        PALPATE_TRY_VERIFY(recording.isVisible() && recording.visibleRegion().boundingRect() == recording.rect());
        QVERIFY(recording.text().startsWith(QStringLiteral("● recording 00:")));
        QVERIFY(recording.width() >= recording.fontMetrics().horizontalAdvance(recording.text()));
        // Chips without room fold into a button and stay reachable.
        ui::ChipRow& row = the<ui::ChipRow>();
        QWidget small;
        ui::ChipRow folding(&small);
        ui::Chip* first = folding.add("first", QStringLiteral("first"), 1);
        ui::Chip* last = folding.add("second", QStringLiteral("last"), 2, true);
        first->say(QStringLiteral("liver of a patient"));
        last->say(QStringLiteral("recording 00:10, 4 dropped"));
        small.show();
        folding.resize(600, 30);
        QVERIFY(first->isVisible() && last->isVisible());
        QCOMPARE(last->text(), last->said());
        folding.resize(last->widthFor(true) + 40, 30);
        QVERIFY(!first->isVisible() && last->isVisible());
        QCOMPARE(last->text(), QStringLiteral("recording 00:10"));
        QVERIFY(folding.findChild<QToolButton*>()->isVisible());
        // Warnings fold last, and the button shows that a warning is folded.
        ui::Chip* calm = folding.add("calm", QStringLiteral("calm"), 5);
        calm->say(QStringLiteral("pressing"));
        first->say(QStringLiteral("no device"), ui::Chip::Tone::Warning);
        folding.resize(last->widthFor(true) + first->widthFor(true) + 50, 30);
        QVERIFY(first->isVisible() && last->isVisible() && !calm->isVisible());
        QCOMPARE(folding.findChild<QToolButton*>()->text(), QStringLiteral("»"));
        folding.resize(last->widthFor(true) + 40, 30);
        QVERIFY(!first->isVisible() && last->isVisible());
        QCOMPARE(folding.findChild<QToolButton*>()->text(), QStringLiteral("⚠ »"));
        QVERIFY(row.minimumSizeHint().width() >= recording.widthFor(true));
        m_desk->command("record").trigger();
        PALPATE_TRY_VERIFY(!recording.isVisible());
    }

    void theChipSaysWhatThePointerDoes()
    {
        m_desk->command("palpate").setChecked(false);
        QVERIFY(chipThatSays(window(), QStringLiteral("Turning the view")) != nullptr);
    }

    void theSimulatedHandHasItsRate()
    {
        window().chooseDevice("simulated");
        QVERIFY(!window().usesPointer());
        PALPATE_TRY_VERIFY(chipThatSays(window(), QStringLiteral("Touching with the simulated hand")) != nullptr);
        m_desk->command("engineering").trigger();
        QComboBox* rate = nullptr;
        for (QComboBox* box : the<ui::EngineeringPanel>().findChildren<QComboBox*>()) {
            rate = box->findData(4) >= 0 && box->count() == 3 ? box : rate;
        }
        QVERIFY(rate != nullptr && rate->isVisible());
        QCOMPARE(rate->currentData().toInt(), 1);
        rate->setFocus();
        m_desk->press(Qt::Key_Down);
        QCOMPARE(rate->currentData().toInt(), 2);
        PALPATE_TRY_VERIFY(mentions(the<ui::EngineeringPanel>(), QStringLiteral("0.5 ms"))); // one tick of delay
        QCOMPARE(rate->currentData().toInt(), 2);
        m_desk->press(Qt::Key_Up);
        m_desk->command("engineering").trigger();
        window().chooseDevice("mouse");
    }

    /// Engineering figures are in the engineering panel only; the other panels show one status, whether the loop runs
    /// well.
    void engineeringWaitsUntilItIsAskedFor()
    {
        auto& dock = the<QDockWidget>("engineering");
        QVERIFY(!dock.isVisible());
        PALPATE_TRY_VERIFY(!the<ui::Chip>("running").said().isEmpty());
        const QRegularExpression numbers(
            QStringLiteral("constraint|solver|jitter|\\bkHz\\b|µs|\\bmJ\\b|damping added|latency"),
            QRegularExpression::CaseInsensitiveOption);
        for (const QLabel* label : window().findChildren<QLabel*>()) {
            QVERIFY2(dock.isAncestorOf(label) || !label->text().contains(numbers), qPrintable(label->text()));
        }
        QTest::mouseClick(&the<ui::Chip>("running"), Qt::LeftButton);
        QVERIFY(the<ui::EngineeringPanel>().isVisible());
        QVERIFY(m_desk->command("engineering").isChecked());
        PALPATE_TRY_VERIFY(mentions(the<ui::EngineeringPanel>(), QStringLiteral("kHz")));
        m_desk->command("engineering").trigger();
        QVERIFY(!dock.isVisible());
    }

    void aWindowComesBackWithItsEngineering()
    {
        QVERIFY(m_desk->show({1024, 700})); // no changes that closing would ask about
        for (const bool isShown : {true, false}) {
            m_desk->command("engineering").trigger();
            QVERIFY(window().close());
            QVERIFY(m_desk->show({1024, 700}));
            QCOMPARE(the<QDockWidget>("engineering").toggleViewAction()->isChecked(), isShown);
            QCOMPARE(m_desk->command("engineering").isChecked(), isShown);
        }
        QVERIFY(m_desk->openPhantom());
    }

    void f6GoesRoundAndTabLeavesTheView()
    {
        window().viewport().setFocus();
        const auto isSeen = [&](const char* dock) { return isInWindow(the<QDockWidget>(dock)); };
        QVERIFY(isSeen("touch") && !isSeen("findings") && !isSeen("device"));
        std::set<const QWidget*> been;
        std::set<QString> panels; // visible and with keyboard focus inside
        for (int i = 0; i < 14; ++i) {
            m_desk->press(Qt::Key_F6);
            QCoreApplication::processEvents();
            for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
                if (dock->isAncestorOf(window().focusWidget()) && isSeen(qPrintable(dock->objectName()))) {
                    panels.insert(dock->objectName());
                }
            }
            been.insert(window().focusWidget());
            const QWidget* at = window().focusWidget();
            QVERIFY(at != nullptr && at->isVisible());
        }
        QCOMPARE(panels, std::set<QString>({"structures", "touch", "findings", "device", "session"}));
        for (int i = 0; i < 14 && window().focusWidget() != &window().viewport(); ++i) {
            m_desk->press(Qt::Key_F6);
        }
        QVERIFY(isSeen("touch") && !isSeen("findings") && !isSeen("device")); // as before
        QVERIFY(been.count(&window().viewport()) == 1);
        QCOMPARE(been.count(&list()), std::size_t{1});
        QVERIFY(std::any_of(been.begin(), been.end(),
                            [&](const QWidget* one) { return the<ui::SessionPanel>().isAncestorOf(one); }));
        window().viewport().setFocus();
        m_desk->press(Qt::Key_F6);
        const QWidget* next = window().focusWidget();
        m_desk->press(Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(window().focusWidget(), &window().viewport());
        QVERIFY(next != &window().viewport());
        m_desk->press(Qt::Key_Tab);
        QVERIFY(window().focusWidget() != &window().viewport());
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            QVERIFY(dock->objectName() != QStringLiteral("structures") || dock->isVisible());
        }
    }

    void f9HidesAndShowsThePanels()
    {
        window().viewport().setFocus();
        auto& structures = the<QDockWidget>("structures");
        m_desk->pressKeyOf("panels");
        QVERIFY(!structures.isVisible());
        m_desk->pressKeyOf("panels");
        QVERIFY(structures.isVisible());
    }

    void lettersInAListLookForNames()
    {
        list().setFocus();
        const auto putBack = qScopeGuard(
            [before = QApplication::keyboardInputInterval()] { QApplication::setKeyboardInputInterval(before); });
        QApplication::setKeyboardInputInterval(20000); // so that a slow machine does not split the typed name
        the<ui::StructurePanel>().select(0);
        const bool wasModified = window().isWindowModified();
        QString name =
            list().model()->index(list().model()->rowCount() - 1, ui::StructureModel::Name).data().toString();
        list().setCurrentIndex(list().model()->index(0, ui::StructureModel::Name));
        for (const QChar letter : name) {
            QTest::keyClick(&list(), letter.toLatin1());
        }
        QCOMPARE(list().currentIndex().row(), list().model()->rowCount() - 1);
        QCOMPARE(window().isWindowModified(), wasModified);
        m_desk->press(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(window().isWindowModified());
        m_desk->command("undo").trigger();
    }

    void lettersCanBeSwitchedOff()
    {
        QAction& letters = m_desk->command("letter-keys");
        QVERIFY(letters.isChecked());
        letters.trigger();
        QVERIFY(m_desk->command("palpate").shortcuts().isEmpty());
        QVERIFY(!m_desk->command("open").shortcuts().isEmpty());
        QVERIFY(!m_desk->command("let-go").shortcuts().isEmpty());
        QCOMPARE(QSettings().value(QStringLiteral("keys/letters")).toBool(), false);
        window().viewport().setFocus();
        m_desk->press(Qt::Key_P);
        QVERIFY(!m_desk->command("palpate").isChecked());
        letters.trigger();
        m_desk->press(Qt::Key_P);
        QVERIFY(m_desk->command("palpate").isChecked());
        m_desk->press(Qt::Key_P);
    }

    void messagesWaitForEachOther()
    {
        ui::MessageBar& bar = the<ui::MessageBar>();
        bar.forgetScene();
        QCOMPARE(bar.text(), QString());
        g_alerted.clear();
        const auto before = QAccessible::installUpdateHandler(catchAlert);
        const bool isHeard = QAccessible::isActive();
        int restored = 0;
        bar.offer(
            QStringLiteral("An offer"), QStringLiteral("Restore"), [&] { ++restored; },
            ui::MessageBar::Keep::UntilAnswered);
        for (int i = 0; i < 3; ++i) {
            bar.showError(QStringLiteral("error %1").arg(i));
        }
        QAccessible::installUpdateHandler(before);
        if (isHeard) { // requires the bus of a screen reader
            QCOMPARE(g_alerted.size(), std::size_t{4});
        }
        const auto rows = bar.findChildren<ui::MessageRow*>();
        QCOMPARE(rows.size(), 4);
        QCOMPARE(rows.first()->text(), QStringLiteral("An offer"));
        QVERIFY(!rows.first()->isVisible()); // three newer messages hide the offer
        bar.forgetScene();
        QCOMPARE(bar.text(), QStringLiteral("An offer"));
        QVERIFY(rows.first()->isVisible());
        rows.first()->findChild<QPushButton*>()->click();
        QCOMPARE(restored, 1);
        QVERIFY(!bar.isVisible());
    }

    /// Scrolling a panel changes no value under the pointer: fields and lists take the wheel only with the focus.
    void theWheelNeedsTheFocus()
    {
        const auto turn = [](QWidget& field) {
            const QPointF middle = QRectF(field.rect()).center();
            QWheelEvent wheel(middle, field.mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&field, &wheel);
            return wheel.isAccepted();
        };
        int fields = 0, lists = 0;
        for (auto* field : the<ui::StructurePanel>().findChildren<QDoubleSpinBox*>()) {
            if (!field->isVisible() || !field->isEnabled() || field->value() == field->minimum()) {
                continue;
            }
            ++fields;
            window().viewport().setFocus();
            const double before = field->value();
            QVERIFY(!turn(*field));
            QCOMPARE(field->value(), before);
            field->setFocus();
            QVERIFY(turn(*field));
            QVERIFY(field->value() < before);
            window().viewport().setFocus();
        }
        for (auto* list : the<ui::StructurePanel>().findChildren<QComboBox*>()) {
            if (list->isVisible() && list->isEnabled()) {
                ++lists;
                const int before = list->currentIndex();
                QVERIFY(!turn(*list));
                QCOMPARE(list->currentIndex(), before);
                QVERIFY(list->focusPolicy() == Qt::StrongFocus);
            }
        }
        QVERIFY2(fields > 0 && lists > 0, qPrintable(QStringLiteral("%1, %2").arg(fields).arg(lists)));
    }

    void theListKeepsMessagesAndCopiesThem()
    {
        window().viewport().setFocus();
        m_desk->pressKeyOf("messages");
        auto& messages = the<ui::MessageList>();
        QVERIFY(messages.isVisible() && messages.hasFocus());
        const auto* session = window().findChild<QDockWidget*>(QStringLiteral("session"));
        QVERIFY(window()
                    .tabifiedDockWidgets(qobject_cast<QDockWidget*>(messages.parentWidget()))
                    .contains(session)); // as wide as the window
        QStringList all;
        for (int row = 0; row < messages.model()->rowCount(); ++row) {
            all << messages.model()->index(row, 0).data().toString();
        }
        QCOMPARE(all.filter(QStringLiteral("error 1")).size(), 1);
        QCOMPARE(all.filter(QStringLiteral("An offer")).size(), 1);
        messages.selectAll();
        m_desk->press(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), all.join(QLatin1Char('\n')));
        m_desk->pressKeyOf("messages");
        QVERIFY(!messages.isVisible());
    }
};

PALPATE_TEST(Shell)
#include "tst_Shell.moc"
