// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QIcon>

class QWidget;

namespace palpate::ui {

/// What the application looks like.
enum class Theme
{
    System, ///< light or dark as the system's palette is
    Light,
    Dark,
    ContrastOnBlack, ///< all texts and signs at 7 : 1 or more
    ContrastOnWhite
};

/// Takes the Fusion style with a palette for the whole application. The first call notes what the system had.
/// @par Thread The GUI's.
void applyTheme(Theme theme);

/// Checks whether the application's palette was set elsewhere since `applyTheme`: then it is the system's.
/// @param mustAsk  the system said that it changed: its palette is fetched anew, and ours is gone until `applyTheme`
/// @return whether `applyTheme` is to be called again.
[[nodiscard]] bool noteSystemPalette(bool mustAsk);

/// Makes the application's texts this large, 100: as the system has them. [%]
void applyTextSize(int percent);
/// The size that was applied last. [%]
[[nodiscard]] int textSize_percent();
/// A size of what goes with a text, such as a picture beside it, at the size of texts now.
/// @param usual_px  at 100 %
[[nodiscard]] int withText_px(int usual_px);

/// Keeps a widget's font at a ratio to its parent's, also when that changes.
/// @param weight  QFont::Weight
void keepFont(QWidget& widget, double ratio, int weight);

/// Keeps the size of the icons of a button, list or tool bar with that of texts. @param usual_px  at 100 %
void keepIconSize(QWidget& widget, int usual_px);

/// @return whether the palette in use is dark.
[[nodiscard]] bool isDarkTheme();
/// @return whether the palette in use is one of high contrast.
[[nodiscard]] bool isHighContrast();

/// Colours with a meaning, each at 4.5 : 1 or more on the window's background, in high contrast at 7 : 1. The palette
/// has the colour of warnings as QPalette::BrightText, so that a label follows it by that role.
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
