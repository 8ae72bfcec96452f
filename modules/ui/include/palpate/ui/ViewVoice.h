// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/RateLimiter.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QWidget>

namespace palpate::ui {

class TouchPanel;

/// Announces the current touch in the 3D view to screen readers: the view's accessible name becomes "3D view: liver,
/// 2.31 N, 4.6 mm deep", updated at most twice a second.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT ViewVoice : public QObject
{
    Q_OBJECT
  public:
    /// @param touch  source of the reading; must outlive this object, as must the view
    ViewVoice(QWidget& view, const TouchPanel& touch, QObject* parent);

  private:
    void say();

    QWidget& m_view;
    const TouchPanel& m_touch;
    RateLimiter m_pace;
};

} // namespace palpate::ui
