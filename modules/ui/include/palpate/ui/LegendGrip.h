// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/view/ColourLegend.h>

#include <QObject>
#include <QPointF>

namespace palpate::ui {

class VtkViewport;

/// Lets the mouse drag the colour legend of the view to another corner, and close it with the sign that appears under
/// the pointer. On the legend the mouse neither turns the view nor presses.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT LegendGrip : public QObject
{
    Q_OBJECT
  public:
    /// @param viewport  must outlive this object
    LegendGrip(VtkViewport& viewport, QObject* parent);

  Q_SIGNALS:
    /// The legend was dropped. @param corner  nearest corner
    void dropped(palpate::view::ColourLegend::Corner corner);
    void closed();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void hover(bool isOn);
    void drop(const QPointF& place);

    VtkViewport& m_viewport;
    QPointF m_pressedAt;
    bool m_isDragged = false; ///< the button was pressed on the legend
    bool m_isClosing = false; ///< the button was pressed on the closing sign
};

} // namespace palpate::ui
