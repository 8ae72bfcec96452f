// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PanelRound.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace palpate::ui {

namespace {

/// The first that takes the keys by Tab, in or at the part.
QWidget* firstIn(QWidget* part)
{
    for (QWidget* one = part; one != nullptr;) {
        if ((one == part || part->isAncestorOf(one)) && one->isVisibleTo(part->window()) && one->isEnabled() &&
            (one->focusPolicy() & Qt::TabFocus) != 0 && one->focusProxy() == nullptr) {
            return one;
        }
        one = one->nextInFocusChain();
        if (one == part) {
            break;
        }
    }
    return nullptr;
}

/// Whether a part lies in the window: behind another one's tab it doesn't.
bool isInWindow(const QWidget& part)
{
    const QWidget* window = part.window();
    return window->rect().intersects(QRect(part.mapTo(window, QPoint()), part.size()));
}

} // namespace

void PanelRound::add(QWidget* part)
{
    m_parts.push_back({part, {}});
}

void PanelRound::go(int step)
{
    const auto count = static_cast<int>(m_parts.size());
    QWidget* focus =
        count > 0 && m_parts.front().widget != nullptr ? m_parts.front().widget->window()->focusWidget() : nullptr;
    int now = -1;
    for (int i = 0; i < count; ++i) {
        QWidget* part = m_parts[static_cast<std::size_t>(i)].widget;
        if (part != nullptr && focus != nullptr && (part == focus || part->isAncestorOf(focus))) {
            now = i;
            m_parts[static_cast<std::size_t>(i)].last = focus;
        }
    }
    for (int tried = 1; tried <= count; ++tried) {
        const int i = ((now < 0 && step < 0 ? 0 : now) + step * tried + 2 * count) % count;
        Part& part = m_parts[static_cast<std::size_t>(i)];
        if (part.widget == nullptr || !part.widget->isVisible() || !isInWindow(*part.widget)) {
            continue; // hidden, or behind another tab
        }
        QWidget* to = part.last != nullptr && part.last->isVisible() && part.last->isEnabled() ? part.last.data()
                                                                                               : firstIn(part.widget);
        if (to != nullptr) {
            to->setFocus(Qt::TabFocusReason);
            return;
        }
    }
}

FocusFrame::FocusFrame(QWidget* held, QWidget* watched, QWidget* parent)
    : QWidget(parent)
    , m_watched(watched)
{
    constexpr int kWide_px = 2;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kWide_px, kWide_px, kWide_px, kWide_px);
    layout->addWidget(held);
    watched->installEventFilter(this);
}

void FocusFrame::paintEvent(QPaintEvent*)
{
    if (m_watched->hasFocus()) {
        QPainter(this).fillRect(rect(), palette().color(QPalette::Highlight));
    }
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        update();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace palpate::ui
