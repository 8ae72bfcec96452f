// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/ui/EngineeringPanel.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PanelScroll.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchChart.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTreeView>

#include <algorithm>

using namespace palpate;

namespace {

struct Heard
{
    const QObject* object = nullptr;
    QAccessible::Event kind = QAccessible::Alert;
};
std::vector<Heard> g_heard; // NOLINT: Qt's handler is a function without data

void hear(QAccessibleEvent* event)
{
    g_heard.push_back({event->object(), event->type()});
}

long countOf(const QObject* object, QAccessible::Event kind)
{
    return std::count_if(g_heard.begin(), g_heard.end(),
                         [&](const Heard& one) { return one.object == object && one.kind == kind; });
}

/// Returns whether a widget is interactive or reachable by Tab.
bool isForActing(const QWidget* widget)
{
    // Qt's own widgets: a tab bar without panels, kept for reuse, and the clear button in a text field.
    const auto* tabs = qobject_cast<const QTabBar*>(widget);
    const bool isQts = (tabs != nullptr && tabs->currentIndex() < 0) ||
                       qobject_cast<const QLineEdit*>(widget->parentWidget()) != nullptr;
    const bool isPart = isQts || widget->focusProxy() != nullptr || qobject_cast<const QScrollBar*>(widget) != nullptr;
    return !isPart &&
           (widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(widget) != nullptr ||
            qobject_cast<const QAbstractSlider*>(widget) != nullptr);
}

} // namespace

/// Tests the window with a screen reader: names of all interactive widgets, numbers as displayed, and a limited rate of
/// announcements.
class Reader : public QObject
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
    [[nodiscard]] QTreeView& list() const { return *the<ui::StructurePanel>().findChild<QTreeView*>(); }
    [[nodiscard]] static QString heard(QWidget& widget, QAccessible::Text what)
    {
        QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(&widget);
        return reader != nullptr ? reader->text(what) : QStringLiteral("nothing");
    }
    [[nodiscard]] static QAccessibleValueInterface* valueOf(QWidget& widget)
    {
        QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(&widget);
        return reader != nullptr ? reader->valueInterface() : nullptr;
    }
    [[nodiscard]] QString labelThatSays(const QWidget& in, const QString& description) const
    {
        for (const QLabel* label : in.findChildren<QLabel*>()) {
            if (label->accessibleDescription() == description) {
                return label->text();
            }
        }
        return {};
    }
    [[nodiscard]] double position_s() const { return window().playback().position_s(); }

    /// Moves to the first contact of the recording with the keys of the timeline.
    void goToTouch()
    {
        the<ui::ForceTimeline>().setFocus();
        m_desk->press(Qt::Key_Home);
        for (int i = 0; i < 20 && !window().viewport().view().cursor().state().isInContact; ++i) {
            m_desk->press(Qt::Key_Right, Qt::ShiftModifier);
        }
        QVERIFY(window().viewport().view().cursor().state().isInContact);
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
    }
    void cleanupTestCase() { m_desk.reset(); }

    void theTimelineSaysWhereItStands()
    {
        goToTouch();
        PALPATE_TRY_VERIFY(
            heard(the<ui::ForceTimeline>(), QAccessible::Value).endsWith(QStringLiteral(" N"))); // loaded
        const QString value = heard(the<ui::ForceTimeline>(), QAccessible::Value);
        const QLocale locale;
        const QString position = locale.toString(position_s(), 'f', 1);
        const QString length = locale.toString(the<ui::ForceTimeline>().duration_s(), 'f', 1);
        QVERIFY2(value.startsWith(QStringLiteral("%1 of %2 s, ").arg(position, length)), qPrintable(value));
        QCOMPARE(heard(the<ui::ForceTimeline>(), QAccessible::Description), value);
        const QString clock = labelThatSays(the<ui::SessionPanel>(), QStringLiteral("Position and length"));
        QVERIFY2(clock.startsWith(ui::clockText(position_s())) && clock.contains(length), qPrintable(clock));
        // The force of this moment and of its bin are almost equal.
        const double said_N = locale.toDouble(value.section(QLatin1Char(' '), -2, -2));
        QVERIFY2(std::abs(said_N - the<ui::TouchPanel>().reading().force_N) < 0.2, qPrintable(value));

        QAccessibleValueInterface* slider = valueOf(the<ui::ForceTimeline>());
        QVERIFY(slider != nullptr);
        QCOMPARE(slider->currentValue().toDouble(), position_s());
        QCOMPARE(slider->maximumValue().toDouble(), the<ui::ForceTimeline>().duration_s());
        slider->setCurrentValue(2.0);
        QCOMPARE(position_s(), 2.0);
        slider->setCurrentValue(1e9);
        QCOMPARE(position_s(), the<ui::ForceTimeline>().duration_s());
    }

    void theTouchIsHeardAsItIsShown()
    {
        goToTouch();
        auto& panel = the<ui::TouchPanel>();
        const QString force = labelThatSays(panel, QStringLiteral("Force in newtons"));
        QVERIFY(!force.isEmpty() && force != ui::forceText(0.0));
        auto& bar = *panel.findChild<ui::ForceBar*>();
        QVERIFY2(heard(bar, QAccessible::Value).startsWith(force + QStringLiteral(" N of ")),
                 qPrintable(heard(bar, QAccessible::Value)));
        QVERIFY(valueOf(bar) != nullptr);
        QCOMPARE(ui::forceText(valueOf(bar)->currentValue().toDouble()), force);
        QCOMPARE(valueOf(bar)->maximumValue().toDouble(), bar.limit_N());
        const QString chart = heard(*panel.findChild<ui::TouchChart*>(), QAccessible::Description);
        const QString depth = ui::depthText(panel.reading().depth_mm);
        QVERIFY2(chart.startsWith(QStringLiteral("now %1 N, %2 mm deep").arg(force, depth)), qPrintable(chart));
        const QString view = QStringLiteral("3D view: liver, %1 N, %2 mm deep").arg(force, depth);
        PALPATE_TRY_COMPARE(heard(window().viewport(), QAccessible::Name), view);
        the<ui::ForceTimeline>().setFocus();
        m_desk->press(Qt::Key_Home); // before the contact
        PALPATE_TRY_COMPARE(heard(window().viewport(), QAccessible::Name), QStringLiteral("3D view"));
    }

    /// Counts changes of the view's accessible name, and announcements if a screen reader listens.
    void aReaderIsToldNoMoreThanTwiceASecond()
    {
        goToTouch();
        const auto before = QAccessible::installUpdateHandler(hear);
        g_heard.clear();
        QElapsedTimer timer;
        timer.start();
        m_desk->pressKeyOf("play");
        QString name = heard(window().viewport(), QAccessible::Name);
        int changes = 0;
        while (timer.elapsed() < 3000) {
            QTest::qWait(5);
            const QString now = heard(window().viewport(), QAccessible::Name);
            changes += now != name ? 1 : 0;
            name = now;
        }
        m_desk->pressKeyOf("play");
        const auto most = static_cast<long>(timer.elapsed() / 500 + 1);
        the<ui::MessageBar>().showError(QStringLiteral("An error that is read out"));
        QAccessible::installUpdateHandler(before);
        QVERIFY2(changes >= 2 && changes <= most, qPrintable(QString::number(changes)));
        the<ui::MessageBar>().forgetScene();
        if (!QAccessible::isActive()) { // the rest requires the bus of a screen reader
            return;
        }
        const long named = countOf(&window().viewport(), QAccessible::NameChanged);
        QVERIFY2(named >= 2 && named <= most, qPrintable(QString::number(named)));
        const long told = countOf(&the<ui::ForceTimeline>(), QAccessible::ValueChanged);
        QVERIFY2(told >= 2 && told <= most, qPrintable(QString::number(told)));
        QCOMPARE(std::count_if(g_heard.begin(), g_heard.end(),
                               [](const Heard& one) { return one.kind == QAccessible::Alert; }),
                 1L);
    }

    /// Home is a window command, except where the key goes to the start of a list, a slider or a text.
    void homeStaysInListsSlidersAndTexts()
    {
        goToTouch();
        const double there_s = position_s();
        QVERIFY(there_s > 0.0);
        list().setFocus();
        list().setCurrentIndex(list().model()->index(2, ui::StructureModel::Name));
        m_desk->press(Qt::Key_Home);
        QCOMPARE(list().currentIndex().row(), 0);
        auto& slider = *the<ui::StructurePanel>().findChild<QSlider*>();
        slider.setFocus();
        m_desk->press(Qt::Key_End);
        QCOMPARE(slider.value(), slider.maximum());
        m_desk->press(Qt::Key_Home);
        QCOMPARE(slider.value(), slider.minimum());
        auto& filter = the<QLineEdit>("filter");
        filter.setFocus();
        filter.setText(QStringLiteral("liver"));
        m_desk->press(Qt::Key_Home);
        QCOMPARE(filter.cursorPosition(), 0);
        filter.clear();
        auto& number = *the<ui::StructurePanel>().findChild<QAbstractSpinBox*>();
        number.setFocus();
        m_desk->press(Qt::Key_Home);
        auto& preset = *the<ui::StructurePanel>().findChild<QComboBox*>();
        preset.setFocus();
        m_desk->press(Qt::Key_Home);
        QCOMPARE(position_s(), there_s);
        while (m_desk->command("undo").isEnabled()) {
            m_desk->pressKeyOf("undo");
        }
        window().viewport().setFocus();
        m_desk->press(Qt::Key_Home);
        QCOMPARE(position_s(), 0.0);
    }

    void theEnergyIsHeardAsItIsShown()
    {
        window().chooseDevice("simulated");
        m_desk->command("engineering").trigger();
        QTest::qWait(300);
        auto* bar = the<ui::EngineeringPanel>().findChild<QWidget*>(QStringLiteral("energy"));
        QVERIFY(bar != nullptr && valueOf(*bar) != nullptr);
        const QString shown = labelThatSays(the<ui::EngineeringPanel>(), QStringLiteral("Energy"));
        const QString value = heard(*bar, QAccessible::Value);
        QVERIFY2(value.endsWith(QStringLiteral(" mJ")) && shown.contains(value), qPrintable(value + " / " + shown));
        m_desk->command("engineering").trigger();
        window().chooseDevice("mouse");
    }

    void allThatIsActedOnHasAName()
    {
        window().chooseDevice("simulated"); // the panel of this device has the most widgets
        m_desk->pressKeyOf("messages");
        the<ui::MessageBar>().offer(QStringLiteral("An offer"), QStringLiteral("Take it"), [] {});
        int count = 0;
        for (QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            for (QWidget* widget : window().findChildren<QWidget*>()) {
                if (!widget->isVisible() || !isForActing(widget)) {
                    continue;
                }
                QVERIFY2(!heard(*widget, QAccessible::Name).isEmpty(),
                         qPrintable(QStringLiteral("%1 \"%2\" in %3 has no name")
                                        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                                             widget->parentWidget()->metaObject()->className())));
                ++count;
            }
        }
        QVERIFY2(count > 100, qPrintable(QString::number(count)));
        the<ui::MessageBar>().forgetScene();
        m_desk->pressKeyOf("messages");
        window().chooseDevice("mouse");
        the<QDockWidget>("touch").raise();
    }
};

PALPATE_TEST(Reader)
#include "tst_Reader.moc"
