// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QWidget>

namespace palpate::ui {

/// Event filter for typing in lists. In a list, letters search for entries instead of triggering single-letter
/// commands. Home and End move to the ends of lists, sliders and selectable texts, as in text fields. Elsewhere
/// letters, Home and End remain commands of the window.
class PALPATE_EXPORT TypeAhead : public QObject
{
    Q_OBJECT
  public:
    /// @param window  window with the lists and combo boxes; owns this object
    explicit TypeAhead(QWidget* window);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace palpate::ui
