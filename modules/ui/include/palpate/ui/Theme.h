// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QColor>
#include <QIcon>

#include <string>

class QWidget;

namespace palpate::ui {

/// Colour theme of the application.
enum class Theme
{
    System, ///< light or dark, following the system palette
    Light,
    Dark,
    ContrastOnBlack, ///< all texts and symbols at a contrast of 7 : 1 or more
    ContrastOnWhite
};

/// Applies the Fusion style with a theme's palette to the application. The first call records whether the
/// system palette is dark.
///
/// @par Thread GUI thread only.
PALPATE_EXPORT void applyTheme(Theme theme);

/// Checks whether the application palette was changed externally after `applyTheme`. An external palette is taken as
/// the system palette, and its brightness is recorded.
/// @param mustAsk  fetches the system palette after a system change; the theme is lost until the next `applyTheme`
/// @return true when `applyTheme` must be called again
[[nodiscard]] PALPATE_EXPORT bool noteSystemPalette(bool mustAsk);

/// Sets the font of the texts in 3D views and in the pictures of a report, so that they match the window. Before the
/// first view. @param boldFile  TrueType or OpenType font; empty: VTK's own
PALPATE_EXPORT void setViewFont(const std::string& boldFile);
[[nodiscard]] PALPATE_EXPORT const std::string& viewFont();

/// Sets the text size of the application; 100: system size. [%]
PALPATE_EXPORT void applyTextSize(int percent);
/// Current text size. [%]
[[nodiscard]] PALPATE_EXPORT int textSize_percent();
/// Scales a dimension with the text size, e.g. the size of an icon next to text.
/// @param usual_px  size at 100 %
[[nodiscard]] PALPATE_EXPORT int withText_px(int usual_px);

/// Keeps a widget's font at a fixed ratio to the parent's font, also after changes.
/// @param weight  QFont::Weight
PALPATE_EXPORT void keepFont(QWidget& widget, double ratio, int weight);

/// Scales the icons of a button, list or tool bar with the text size. @param usual_px  size at 100 %
PALPATE_EXPORT void keepIconSize(QWidget& widget, int usual_px);

/// True for a dark palette.
[[nodiscard]] PALPATE_EXPORT bool isDarkTheme();
/// True for a high-contrast palette.
[[nodiscard]] PALPATE_EXPORT bool isHighContrast();

/// Semantic colours with a contrast of 4.5 : 1 or more on the window background, 7 : 1 in high contrast. The palette
/// provides the warning colour as QPalette::BrightText, so that labels follow theme changes by role.
[[nodiscard]] PALPATE_EXPORT QColor forceColour();   ///< force curves
[[nodiscard]] PALPATE_EXPORT QColor depthColour();   ///< depth curves
[[nodiscard]] PALPATE_EXPORT QColor goodColour();    ///< normal state
[[nodiscard]] PALPATE_EXPORT QColor warningColour(); ///< warning
[[nodiscard]] PALPATE_EXPORT QColor recordColour();  ///< recording is running
[[nodiscard]] PALPATE_EXPORT QColor mutedColour();   ///< units and secondary text

/// Icons for buttons, drawn in the palette's text colour at any size.
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
    Mark,
    Keys
};
[[nodiscard]] PALPATE_EXPORT QIcon icon(Symbol symbol);

} // namespace palpate::ui
