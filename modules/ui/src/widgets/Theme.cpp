// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Theme.h"

#include "widgets/DeskStyle.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QToolTip>

#include <optional>

namespace palpate::ui {

namespace {

struct Shades
{
    QColor window, base, alternate, button, text, muted, disabled, highlight, highlighted, line, grid;
    QColor force, depth, warning, record, good;
};

const Shades& shadesOf(bool isDark, bool isContrast)
{
    const auto faint = [](QColor colour) {
        colour.setAlpha(150);
        return colour;
    };
    static const Shades light{
        QColor(0xf2f4f6U), QColor(0xffffffU), QColor(0xf7f9faU), QColor(0xfafbfcU),
        QColor(0x1a242eU), QColor(0x556270U), faint(0x556270U),  QColor(0x1b66a3U),
        QColor(0xffffffU), QColor(0xc9d0d7U), QColor(0xc9d0d7U), QColor(0x9a5b00U),
        QColor(0x1b66a3U), QColor(0x9c4a00U), QColor(0xb42318U), QColor(0x1a753fU),
    };
    static const Shades dark{
        QColor(0x22272dU), QColor(0x191d22U), QColor(0x1e2328U), QColor(0x2d333bU),
        QColor(0xe8ecf0U), QColor(0xa3aebaU), faint(0xa3aebaU),  QColor(0x2a7abfU),
        QColor(0xffffffU), QColor(0x3d4650U), QColor(0x3d4650U), QColor(0xf2c14eU),
        QColor(0x6fb7eeU), QColor(0xf0a04bU), QColor(0xff7b72U), QColor(0x5fc98aU),
    };
    static const Shades black{
        QColor(0x000000U), QColor(0x000000U), QColor(0x0c0c0cU), QColor(0x141414U),
        QColor(0xffffffU), QColor(0xe0e0e0U), QColor(0xa8a8a8U), QColor(0x45e0ffU),
        QColor(0x000000U), QColor(0xffffffU), QColor(0x5a5a5aU), QColor(0xffd75eU),
        QColor(0x8fd0ffU), QColor(0xffb870U), QColor(0xffa59dU), QColor(0x7fe0a5U),
    };
    static const Shades white{
        QColor(0xffffffU), QColor(0xffffffU), QColor(0xf4f4f4U), QColor(0xf4f4f4U),
        QColor(0x000000U), QColor(0x303030U), QColor(0x555555U), QColor(0x00308fU),
        QColor(0xffffffU), QColor(0x000000U), QColor(0xb0b0b0U), QColor(0x6a3d00U),
        QColor(0x00418aU), QColor(0x7a2f00U), QColor(0x8a0f0aU), QColor(0x0b5226U),
    };
    return isContrast ? (isDark ? black : white) : (isDark ? dark : light);
}

QPalette paletteOf(const Shades& s)
{
    QPalette p;
    p.setColor(QPalette::Window, s.window);
    p.setColor(QPalette::WindowText, s.text);
    p.setColor(QPalette::Base, s.base);
    p.setColor(QPalette::AlternateBase, s.alternate);
    p.setColor(QPalette::Text, s.text);
    p.setColor(QPalette::PlaceholderText, s.muted);
    p.setColor(QPalette::Button, s.button);
    p.setColor(QPalette::ButtonText, s.text);
    p.setColor(QPalette::BrightText, s.warning);
    p.setColor(QPalette::Highlight, s.highlight);
    p.setColor(QPalette::HighlightedText, s.highlighted);
    p.setColor(QPalette::Link, s.depth);
    p.setColor(QPalette::LinkVisited, s.depth);
    p.setColor(QPalette::ToolTipBase, s.base);
    p.setColor(QPalette::ToolTipText, s.text);
    p.setColor(QPalette::Mid, s.line);
    p.setColor(QPalette::Midlight, s.grid); // grid lines of charts
    p.setColor(QPalette::Dark, s.line.darker(130));
    p.setColor(QPalette::Light, s.base);
    p.setColor(QPalette::Shadow, Qt::black);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, s.disabled);
    }
    return p;
}

// State of the system palette and of the applied theme.
struct State
{
    std::optional<QPalette> applied;
    bool isSystemDark = false;
    bool isContrast = false;
    bool isApplying = false;
    std::optional<QFont> font; ///< system font before the first change of the text size
    int textSize_percent = 100;
    std::string viewFont;
};

State& state()
{
    static State one;
    return one;
}

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

const Shades& shades()
{
    return shadesOf(isDarkTheme(), isHighContrast());
}

} // namespace

bool isDarkTheme()
{
    return isDark(QApplication::palette());
}

bool isHighContrast()
{
    return state().isContrast;
}

void applyTheme(Theme theme)
{
    State& now = state();
    if (!now.applied) {
        now.isSystemDark = isDark(QApplication::palette());
        QApplication::setStyle(new DeskStyle(QStyleFactory::create(QStringLiteral("Fusion"))));
    }
    now.isContrast = theme == Theme::ContrastOnBlack || theme == Theme::ContrastOnWhite;
    const bool wantsDark =
        theme == Theme::System ? now.isSystemDark : theme == Theme::Dark || theme == Theme::ContrastOnBlack;
    now.isApplying = true;
    now.applied = paletteOf(shadesOf(wantsDark, now.isContrast));
    QApplication::setPalette(*now.applied);
    now.applied = QApplication::palette(); // as resolved by Qt, for later comparison
    QToolTip::setPalette(*now.applied);
    qApp->setStyleSheet(
        QStringLiteral("QToolBar { spacing: 4px; padding: 4px 8px; border: 0; }"
                       "QToolBar QToolButton { padding: 5px 9px; border-radius: 4px; border: 1px solid transparent; }"
                       "QToolBar QToolButton:hover { background: palette(base); border-color: palette(mid); }"
                       "QToolBar QToolButton:pressed { background: palette(alternate-base); "
                       "border-color: palette(highlight); }"
                       "QToolBar QToolButton:checked { background: palette(base); padding: 4px 8px; "
                       "border: 2px solid palette(highlight); }"
                       "QToolBar QToolButton:focus { border: 1px solid palette(highlight); }"
                       "QDockWidget::title { padding: 6px 10px; text-align: left; }"
                       "QStatusBar::item { border: 0; }"));
    now.isApplying = false;
}

bool noteSystemPalette(bool mustAsk)
{
    State& now = state();
    if (now.isApplying || !now.applied) {
        return false;
    }
    if (mustAsk) {
        now.isApplying = true;
        QApplication::setPalette(QPalette()); // fetches the system palette
        now.isApplying = false;
    } else if (QApplication::palette() == *now.applied) {
        return false;
    }
    now.isSystemDark = isDark(QApplication::palette());
    return true;
}

void setViewFont(const std::string& boldFile)
{
    state().viewFont = boldFile;
}

const std::string& viewFont()
{
    return state().viewFont;
}

void applyTextSize(int percent)
{
    State& now = state();
    if (!now.font) {
        now.font = QApplication::font();
    }
    if (percent == now.textSize_percent) {
        return; // keeps the system's separate fonts for menus and other widgets
    }
    now.textSize_percent = percent;
    QFont font = *now.font;
    const double share = 0.01 * percent;
    if (font.pointSizeF() > 0.0) {
        font.setPointSizeF(share * font.pointSizeF());
    } else {
        font.setPixelSize(qRound(share * font.pixelSize()));
    }
    QApplication::setFont(font);
    // With a style sheet only top-level windows receive the font, and only later. Setting the sheet again propagates
    // it.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::ApplicationFontChange);
    qApp->setStyleSheet(qApp->styleSheet());
}

int textSize_percent()
{
    return state().textSize_percent;
}

int withText_px(int usual_px)
{
    return qRound(0.01 * state().textSize_percent * usual_px);
}

QColor forceColour()
{
    return shades().force;
}

QColor depthColour()
{
    return shades().depth;
}

QColor goodColour()
{
    return shades().good;
}

QColor warningColour()
{
    return shades().warning;
}

QColor recordColour()
{
    return shades().record;
}

QColor mutedColour()
{
    return QApplication::palette().color(QPalette::PlaceholderText);
}

} // namespace palpate::ui
