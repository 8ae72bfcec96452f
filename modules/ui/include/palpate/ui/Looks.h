// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/ActionList.h"

#include <QObject>

namespace palpate::ui {

/// What a person chose the program to look like: its theme and the size of its texts, each a group of commands, kept in
/// the settings and taken at once. Follows the system's palette while that is what was chosen.
/// @par Thread The GUI's.
class Looks : public QObject
{
    Q_OBJECT
  public:
    /// Sizes of text to choose from. [%]
    static constexpr int kTextSizes[] = {90, 100, 110, 125, 150, 175, 200};

    /// Takes what the settings have.
    /// @param actions  gets the commands "appearance-…" and "text-size-…"; @param window  is told of the system's
    /// changes
    Looks(ActionList& actions, QWidget* window);

    /// Takes a theme, without a word to the settings.
    void use(Theme theme);

  Q_SIGNALS:
    /// Texts have another size. @param ratio  to the one before
    void textSizeChanged(double ratio);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void addThemes(ActionList& actions);
    void addTextSizes(ActionList& actions);

    Theme m_theme = Theme::System;
};

} // namespace palpate::ui
