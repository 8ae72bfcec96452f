// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/ui/HintLine.h>
#include <palpate/ui/Looks.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <QTreeView>

using namespace palpate;

namespace {

/// Moves down an open menu to an entry.
bool goTo(QMenu& menu, const QAction* entry)
{
    for (int i = 0; i < 80 && menu.activeAction() != entry; ++i) {
        QTest::keyClick(&menu, Qt::Key_Down);
    }
    return menu.activeAction() == entry;
}

} // namespace

/// Tests appearance and text size, chosen by menu keys in the whole window, with the phantom.
class Looks : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    [[nodiscard]] MainWindow& window() const { return m_desk->window(); }
    [[nodiscard]] view::SceneView& view() const { return window().viewport().view(); }
    [[nodiscard]] double ground() const { return view().renderer().GetBackground()[0]; }
    /// Chooses the command's entry by Alt+V, arrows and Enter.
    [[nodiscard]] bool choose(const char* id)
    {
        QAction& command = m_desk->command(id);
        QMenu* submenu = nullptr;
        for (QMenu* one : window().findChildren<QMenu*>()) {
            submenu = one->actions().contains(&command) ? one : submenu;
        }
        if (submenu == nullptr) {
            return false;
        }
        QTest::keyClick(&window(), Qt::Key_V, Qt::AltModifier);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (menu == nullptr || !goTo(*menu, submenu->menuAction())) {
            return false;
        }
        QTest::keyClick(menu, Qt::Key_Right);
        if (QApplication::activePopupWidget() != submenu || !goTo(*submenu, &command)) {
            return false;
        }
        QTest::keyClick(submenu, Qt::Key_Return);
        QCoreApplication::processEvents();
        return QApplication::activePopupWidget() == nullptr;
    }
    /// Goes to the peak force of the recording, with force, depths and a finding in the view.
    void toThePeak()
    {
        PALPATE_TRY_VERIFY(window().playback().peakTime_s() > 0.0); // computed in the background
        window().playback().seek(window().playback().peakTime_s());
        window().viewport().update();
        QTest::qWait(300);
    }
    /// Returns the heights of the view's texts: numbers at the hand, then findings [px].
    [[nodiscard]] std::vector<double> heights() const
    {
        std::vector<double> all;
        for (const Eigen::AlignedBox2d& box : view().cursor().labels().boxes()) {
            all.push_back(box.sizes().y());
        }
        for (std::size_t i = 0; i < view().findings().count(); ++i) {
            all.push_back(view().findings().labelOf(i).size_px.y());
        }
        all.push_back(view().cube().top_px());
        return all;
    }
    void open()
    {
        QVERIFY(m_desk->show({1024, 700}));
        QVERIFY(m_desk->openPhantom());
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QSettings().clear();
        open();
    }
    void cleanupTestCase()
    {
        if (m_desk != nullptr) {
            ui::applyTextSize(100);
            ui::applyTheme(ui::Theme::System);
        }
        m_desk.reset();
    }

    void aThemeIsTakenAtOnce()
    {
        auto* panel = window().findChild<ui::TouchPanel*>();
        QVERIFY(choose("appearance-light"));
        const double light = ground();
        const QColor lightText = panel->findChild<QLabel*>()->palette().color(QPalette::WindowText);
        QVERIFY(choose("appearance-contrast-black"));
        QTest::qWait(100);
        for (const QTreeView* list : window().findChildren<QTreeView*>()) { // swatches and symbols on the selected row
            QVERIFY(list->palette().color(QPalette::Highlight).lightness() < 128);
        }
        QCOMPARE(QSettings().value("look/appearance").toString(), QStringLiteral("contrast-black"));
        QCOMPARE(ground(), 0.0);
        QCOMPARE(view().textStyle().groundOpacity, 1.0);
        QVERIFY(light > 0.2);
        for (const QLabel* label : panel->findChildren<QLabel*>()) {
            QCOMPARE(label->palette().color(QPalette::WindowText), QColor(Qt::white));
        }
        QVERIFY(lightText != QColor(Qt::white));
        for (const ui::Chip* chip : window().findChildren<ui::Chip*>()) {
            QVERIFY(chip->palette().color(QPalette::WindowText).lightness() > 128);
        }
        // Rendered pixels: the background of the panel, and the upper corner of the view.
        const QImage picture = m_desk->picture();
        QCOMPARE(picture.pixelColor(panel->mapTo(&window(), QPoint(2, 2))), QColor(Qt::black));
        QCOMPARE(picture.pixelColor(window().viewport().mapTo(&window(), QPoint(4, 4))), QColor(Qt::black));
        QVERIFY(choose("appearance-contrast-white"));
        QCOMPARE(ground(), 1.0);
        QCOMPARE(m_desk->picture().pixelColor(panel->mapTo(&window(), QPoint(2, 2))), QColor(Qt::white));
    }

    void theSystemsPaletteIsFollowed()
    {
        QVERIFY(choose("appearance-system"));
        QVERIFY(!ui::isDarkTheme());
        const double light = ground();
        QPalette dark;
        dark.setColor(QPalette::Window, Qt::black);
        dark.setColor(QPalette::WindowText, Qt::white);
        QApplication::setPalette(dark); // like the platform plugin
        PALPATE_TRY_COMPARE(ui::warningColour().lightness() > 128, true);
        PALPATE_TRY_VERIFY(ui::isDarkTheme() && ground() < light);
        QVERIFY(window().palette().color(QPalette::Window) != QColor(Qt::black)); // the theme's own dark
        QVERIFY(choose("appearance-light"));
        QVERIFY(!ui::isDarkTheme());
        QApplication::setPalette(dark); // the user's choice stays
        PALPATE_TRY_VERIFY(!ui::isDarkTheme() && ground() == light);
    }

    void textsGrowInPanelsAndView()
    {
        window().viewport().setFocus();
        m_desk->command("palpate").setChecked(false);
        toThePeak();
        auto* panel = window().findChild<ui::TouchPanel*>();
        const int before = panel->findChild<QLabel*>()->fontMetrics().height();
        const double usual_px = view().textStyle().size_px;
        const int menu = window().menuWidget()->fontMetrics().height();
        const std::vector<double> small = heights();
        QVERIFY(small.size() > 2); // a force, a depth and the cube
        QVERIFY(choose("text-size-175"));
        QCOMPARE(QSettings().value("look/text_percent").toInt(), 175);
        QTest::qWait(300);
        QVERIFY(panel->findChild<QLabel*>()->fontMetrics().height() > 1.6 * before);
        QVERIFY(window().menuWidget()->fontMetrics().height() > 1.6 * menu);
        const std::vector<double> large = heights();
        QCOMPARE(large.size(), small.size());
        for (std::size_t i = 0; i + 1 < large.size(); ++i) {
            QVERIFY2(large[i] > 1.5 * small[i], qPrintable(QStringLiteral("%1: %2").arg(i).arg(large[i] / small[i])));
        }
        QVERIFY(large.back() > small.back());
        QVERIFY(choose("text-size-90"));
        QTest::qWait(300);
        QVERIFY(view().textStyle().size_px < usual_px);
    }

    void largeTextsHaveRoomOnASmallScreen()
    {
        QVERIFY(choose("text-size-200"));
        window().resize(1024, 700);
        QTest::qWait(300);
        QCOMPARE(window().size(), QSize(1024, 700));
        const QSize least = window().minimumSizeHint();
        QVERIFY2(least.width() <= 1024 && least.height() <= 700,
                 qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
        QStringList wrong;
        const auto note = [&](const QWidget& widget, const QString& text, const QSize& size) {
            wrong << QStringLiteral("%1 \"%2\": %3 x %4")
                         .arg(QLatin1String(widget.metaObject()->className()), text)
                         .arg(size.width())
                         .arg(size.height());
        };
        for (const QWidget* widget : window().findChildren<QWidget*>()) {
            // Widgets behind another tab, or in the overflow menu "»", are not visible.
            if (!widget->isVisible() || widget->isWindow() || test::isScrolled(widget) ||
                widget->visibleRegion().isEmpty()) {
                continue;
            }
            const QRect place(widget->mapTo(&window(), QPoint()), widget->size());
            if (!window().rect().contains(place)) {
                note(*widget, widget->objectName(), QSize(place.right(), place.bottom()));
            }
            const auto* label = qobject_cast<const QLabel*>(widget);
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            // shortened text with a mark; F4 shows all
            const bool isHint = qobject_cast<const ui::HintLine*>(widget) != nullptr;
            if ((label != nullptr || button != nullptr) && !isHint && widget->parentWidget() != nullptr &&
                qobject_cast<const QDockWidget*>(widget->parentWidget()) == nullptr) {
                const QSize needed = widget->sizeHint();
                const QString text = label != nullptr ? label->text() : button->text();
                if (!text.isEmpty() && (widget->width() < needed.width() || widget->height() < needed.height())) {
                    note(*widget, text, needed);
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }

    void anotherWindowLooksTheSameInTheLocalesNumbers()
    {
        QVERIFY(choose("appearance-dark"));
        const int large = window().fontMetrics().height();
        QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
        open();
        QVERIFY(m_desk->command("appearance-dark").isChecked() && ui::isDarkTheme());
        QVERIFY(m_desk->command("text-size-200").isChecked());
        QCOMPARE(window().fontMetrics().height(), large);
        toThePeak();
        PALPATE_TRY_VERIFY(view().cursor().labels().texts().size() > 1);
        const auto texts = view().cursor().labels().texts();
        QLocale::setDefault(QLocale::c());
        for (const std::string& text : texts) {
            QVERIFY2(text.find(',') != std::string::npos && text.find('.') == std::string::npos, text.c_str());
        }
    }
};

PALPATE_TEST(Looks)
#include "tst_Looks.moc"
