// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

namespace palpate::ui {

/// Lets a person type in lists: there a letter looks for what begins with it, and is no command. Home and End go to the
/// ends of lists, sliders and texts, as fields to write in do by themselves. Wherever else the keys are, letters, Home
/// and End stay the window's commands.
class TypeAhead : public QObject
{
    Q_OBJECT
  public:
    /// @param window  whose lists and choices are meant; owns this
    explicit TypeAhead(QWidget* window);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace palpate::ui
