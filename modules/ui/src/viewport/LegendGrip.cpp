// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LegendGrip.h"

#include "palpate/ui/VtkViewport.h"

#include <QEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <utility>

namespace palpate::ui {

LegendGrip::LegendGrip(VtkViewport& viewport, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    viewport.installEventFilter(this);
}

/// Shows the closing sign and a hand while the pointer is on the legend.
void LegendGrip::hover(bool isOn)
{
    view::ColourLegend& legend = m_viewport.view().legend();
    if (isOn == legend.isHovered()) {
        return;
    }
    legend.setHovered(isOn);
    if (isOn) {
        Q_EMIT m_viewport.hoverEnded(); // the label at the pointer
    } else {
        QToolTip::hideText();
    }
    m_viewport.update();
}

/// Ends a drag at the corner next to the pointer.
void LegendGrip::drop(const QPointF& place)
{
    using Corner = view::ColourLegend::Corner;
    m_viewport.view().legend().setOffset(Eigen::Vector2d::Zero());
    const bool isUpper = 2.0 * place.y() < m_viewport.height(), isLeft = 2.0 * place.x() < m_viewport.width();
    Q_EMIT dropped(isLeft ? (isUpper ? Corner::UpperLeft : Corner::LowerLeft)
                          : (isUpper ? Corner::UpperRight : Corner::LowerRight));
    m_viewport.update();
}

bool LegendGrip::eventFilter(QObject* watched, QEvent* event)
{
    constexpr double kStill_px = 3.0;
    constexpr int kTip_px = 12; // Qt shows tool tips below and beside the pointer
    const QEvent::Type type = event->type();
    const bool isMouse = type == QEvent::MouseMove || type == QEvent::MouseButtonPress ||
                         type == QEvent::MouseButtonRelease || type == QEvent::MouseButtonDblClick;
    if (type == QEvent::Leave && !m_isDragged) {
        hover(false);
    }
    if (!isMouse) {
        return QObject::eventFilter(watched, event);
    }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const QPointF place = mouse->position();
    if (type == QEvent::MouseMove) {
        if (m_isDragged) {
            const QPointF by = place - m_pressedAt;
            if (!m_isClosing && by.manhattanLength() > kStill_px) {
                m_viewport.view().legend().setOffset({by.x(), -by.y()});
                m_viewport.update();
            }
            return true;
        }
        const bool isOn = mouse->buttons() == Qt::NoButton && m_viewport.isOnLegend(place);
        hover(isOn);
        if (isOn) {
            const Eigen::Vector2d corner =
                m_viewport.view().legend().box().min(); // below, where it hides nothing of it
            QToolTip::showText(m_viewport.mapToGlobal(QPoint(qRound(0.5 * m_viewport.width() + corner.x()),
                                                             qRound(0.5 * m_viewport.height() - corner.y()) - kTip_px)),
                               m_viewport.isOnLegendClose(place) ? tr("Close the legend; the View menu shows it again")
                                                                 : tr("Drag the legend to another corner"),
                               &m_viewport);
        }
        return isOn;
    }
    if (type == QEvent::MouseButtonRelease) {
        if (!m_isDragged || mouse->button() != Qt::LeftButton) {
            return m_isDragged;
        }
        m_isDragged = false;
        if (!std::exchange(m_isClosing, false)) {
            if ((place - m_pressedAt).manhattanLength() > kStill_px) {
                drop(place);
            }
        } else if (m_viewport.isOnLegendClose(place)) {
            hover(false);
            Q_EMIT closed();
        }
        return true;
    }
    if (m_isDragged) {
        return true; // other buttons
    }
    if (mouse->button() == Qt::LeftButton && m_viewport.isOnLegend(place)) {
        m_isDragged = true;
        m_pressedAt = place;
        m_isClosing = m_viewport.isOnLegendClose(place);
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace palpate::ui

#include "palpate/ui/moc_LegendGrip.cpp"
