// SPDX-License-Identifier: BSD-3-Clause
#include "shell/MessagePlace.h"

#include <palpate/ui/MessageBar.h>
#include <palpate/ui/VtkViewport.h>

#include <QEvent>
#include <QGridLayout>

#include <algorithm>

namespace palpate::app {

MessagePlace::MessagePlace(ui::MessageBar& messages, ui::VtkViewport& viewport, QGridLayout& layout)
    : QObject(&viewport)
    , m_messages(messages)
    , m_viewport(viewport)
    , m_layout(layout)
{
    messages.installEventFilter(this);
    connect(&viewport, &QOpenGLWidget::frameSwapped, this, &MessagePlace::follow);
}

/// Part of the view that the messages cover at an edge. [px of the view]
QRect MessagePlace::stripAt(bool isBelow) const
{
    const int height = std::max(m_messages.height(), m_messages.sizeHint().height());
    return {0, isBelow ? m_viewport.height() - height : 0, m_viewport.width(), height};
}

/// Returns true if the messages at an edge would cover the touched place.
bool MessagePlace::hidesHand(bool isBelow) const
{
    constexpr int kAbout_px = 24; // cursor and numbers at the hand
    const view::TouchState& touch = m_viewport.view().cursor().state();
    const QRect strip = stripAt(isBelow).adjusted(0, -kAbout_px, 0, kAbout_px);
    return touch.isPresent && touch.isInContact &&
           (strip.contains(m_viewport.placeOf(touch.p_WG).toPoint()) ||
            strip.contains(m_viewport.placeOf(touch.p_WH).toPoint()));
}

/// Returns true if the lower edge is the better place. The upper edge is usual: the lower one has cube and scale.
bool MessagePlace::isBetterBelow() const
{
    if (hidesHand(false) != hidesHand(true)) {
        return hidesHand(false);
    }
    const auto hiddenAt = [this](bool isBelow) {
        const QRect strip = stripAt(isBelow);
        const Eigen::Vector2d half(0.5 * m_viewport.width(), 0.5 * m_viewport.height());
        const Eigen::Vector2d low(strip.left(), m_viewport.height() - strip.bottom() - 1),
            high(strip.right() + 1, m_viewport.height() - strip.top());
        return m_viewport.view().tissueIn({low - half, high - half}, m_viewport.devicePixelRatioF());
    };
    return 4 * hiddenAt(true) < 3 * hiddenAt(false);
}

void MessagePlace::put(bool isBelow)
{
    m_isBelow = isBelow;
    m_layout.setAlignment(&m_messages, isBelow ? Qt::AlignBottom : Qt::AlignTop);
    passCover();
}

/// Keeps legend, bars, orientation cube and scale bar clear of the messages.
void MessagePlace::passCover()
{
    const int height = m_messages.isHidden() ? 0 : m_messages.height();
    m_viewport.setCoveredAbove(m_isBelow ? 0 : height);
    m_viewport.setCoveredBelow(m_isBelow ? height : 0);
}

/// Moves the messages off the touched place.
void MessagePlace::follow()
{
    if (m_messages.isVisible() && hidesHand(m_isBelow) && !hidesHand(!m_isBelow)) {
        put(!m_isBelow);
    }
}

bool MessagePlace::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Show:
        put(m_viewport.isVisible() && isBetterBelow());
        break;
    case QEvent::Resize:
    case QEvent::Hide:
        passCover();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace palpate::app

#include "moc_MessagePlace.cpp"
