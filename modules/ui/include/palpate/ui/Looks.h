// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/ActionList.h"

#include <palpate/core/Export.h>

#include <QObject>

namespace palpate::ui {

/// Theme and text size of the application: two command groups, stored in the settings and applied immediately. Follows
/// the system palette while the system theme is selected.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT Looks : public QObject
{
    Q_OBJECT
  public:
    /// Selectable text sizes. [%]
    static constexpr int kTextSizes[] = {90, 100, 110, 125, 150, 175, 200};

    /// Applies the saved settings.
    /// @param actions  receives the commands "appearance-…" and "text-size-…"
    /// @param window  source of palette change events
    Looks(ActionList& actions, QWidget* window);

    /// Applies a theme without saving the choice.
    void use(Theme theme);

  Q_SIGNALS:
    /// Emitted when the text size changed. @param ratio  new size divided by the previous size
    void textSizeChanged(double ratio);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void addThemes(ActionList& actions);
    void addTextSizes(ActionList& actions);

    Theme m_theme = Theme::System;
};

} // namespace palpate::ui
