// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace palpate::ui {

namespace {

struct Shades
{
    QColor window, base, alternate, button, text, muted, highlight, line;
};

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
    p.setColor(QPalette::BrightText, QColor(255, 255, 255));
    p.setColor(QPalette::Highlight, s.highlight);
    p.setColor(QPalette::HighlightedText, QColor(255, 255, 255));
    p.setColor(QPalette::Link, s.highlight);
    p.setColor(QPalette::ToolTipBase, s.base);
    p.setColor(QPalette::ToolTipText, s.text);
    p.setColor(QPalette::Mid, s.line);
    p.setColor(QPalette::Dark, s.line.darker(130));
    p.setColor(QPalette::Light, s.base);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor faint = s.muted;
        faint.setAlpha(150);
        p.setColor(QPalette::Disabled, role, faint);
    }
    return p;
}

} // namespace

bool systemIsDark(const QApplication& application)
{
    const QPalette palette = application.palette();
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

bool isDarkTheme()
{
    return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

void applyTheme(QApplication& application, bool isDark)
{
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const Shades light{QColor(0xf2, 0xf4, 0xf6), QColor(0xff, 0xff, 0xff), QColor(0xf7, 0xf9, 0xfa),
                       QColor(0xfa, 0xfb, 0xfc), QColor(0x1a, 0x24, 0x2e), QColor(0x55, 0x62, 0x70),
                       QColor(0x1b, 0x66, 0xa3), QColor(0xc9, 0xd0, 0xd7)};
    const Shades dark{QColor(0x22, 0x27, 0x2d), QColor(0x19, 0x1d, 0x22), QColor(0x1e, 0x23, 0x28),
                      QColor(0x2d, 0x33, 0x3b), QColor(0xe8, 0xec, 0xf0), QColor(0xa3, 0xae, 0xba),
                      QColor(0x2a, 0x7a, 0xbf), QColor(0x3d, 0x46, 0x50)};
    application.setPalette(paletteOf(isDark ? dark : light));
    application.setStyleSheet(
        QStringLiteral("QToolBar { spacing: 4px; padding: 4px 8px; border: 0; }"
                       "QToolBar QToolButton { padding: 5px 9px; border-radius: 4px; border: 1px solid transparent; }"
                       "QToolBar QToolButton:hover { background: palette(base); border-color: palette(mid); }"
                       "QToolBar QToolButton:pressed { background: palette(mid); }"
                       "QToolBar QToolButton:checked { background: palette(base); "
                       "border: 2px solid palette(highlight); }"
                       "QToolBar QToolButton:focus { border: 1px solid palette(highlight); }"
                       "QDockWidget::title { padding: 6px 10px; text-align: left; }"
                       "QStatusBar::item { border: 0; }"));
}

QColor forceColour()
{
    return isDarkTheme() ? QColor(0xf2, 0xc1, 0x4e) : QColor(0x9a, 0x5b, 0x00);
}

QColor depthColour()
{
    return isDarkTheme() ? QColor(0x6f, 0xb7, 0xee) : QColor(0x1b, 0x66, 0xa3);
}

QColor goodColour()
{
    return isDarkTheme() ? QColor(0x5f, 0xc9, 0x8a) : QColor(0x1a, 0x75, 0x3f);
}

QColor warningColour()
{
    return isDarkTheme() ? QColor(0xf0, 0xa0, 0x4b) : QColor(0x9c, 0x4a, 0x00);
}

QColor recordColour()
{
    return isDarkTheme() ? QColor(0xff, 0x7b, 0x72) : QColor(0xb4, 0x23, 0x18);
}

QColor mutedColour()
{
    return QApplication::palette().color(QPalette::PlaceholderText);
}

} // namespace palpate::ui
