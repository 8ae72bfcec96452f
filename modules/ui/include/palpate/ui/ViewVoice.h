// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Pace.h"

#include <QObject>
#include <QWidget>

namespace palpate::ui {

class TouchPanel;

/// Says to a screen reader what is felt in the 3D view: the view's name becomes "3D view: liver, 2.31 N, 4.6 mm deep",
/// another one at most twice a second.
/// @par Thread The GUI's.
class ViewVoice : public QObject
{
    Q_OBJECT
  public:
    /// @param touch  has what is felt now; must outlive this, as the view
    ViewVoice(QWidget& view, const TouchPanel& touch, QObject* parent);

  private:
    void say();

    QWidget& m_view;
    const TouchPanel& m_touch;
    Pace m_pace;
};

} // namespace palpate::ui
