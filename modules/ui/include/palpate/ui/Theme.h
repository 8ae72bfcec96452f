// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QIcon>

class QApplication;

namespace palpate::ui {

/// Takes the Fusion style with a quiet palette, light or dark.
void applyTheme(QApplication& application, bool isDark);

/// @return whether the system's palette, before `applyTheme`, is a dark one.
[[nodiscard]] bool systemIsDark(const QApplication& application);

/// @return whether the palette in use is dark.
[[nodiscard]] bool isDarkTheme();

/// Colours with a meaning, each at 4.5 : 1 or more on the window's background.
[[nodiscard]] QColor forceColour();   ///< lines of force
[[nodiscard]] QColor depthColour();   ///< lines of depth
[[nodiscard]] QColor goodColour();    ///< all is well
[[nodiscard]] QColor warningColour(); ///< something to look at
[[nodiscard]] QColor recordColour();  ///< recording is on
[[nodiscard]] QColor mutedColour();   ///< units and secondary text

/// The pictures on buttons, drawn in the palette's text colour at any size.
enum class Symbol
{
    Open,
    Camera,
    Hand,
    HandOff,
    Record,
    Stop,
    Play,
    Pause,
    Restart,
    Snapshot,
    Fit,
    Eye,
    EyeOff,
    Told,
    Warning,
    Error,
    Offer,
    Undo,
    Redo,
    Keys
};
[[nodiscard]] QIcon icon(Symbol symbol);

} // namespace palpate::ui
