// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PanelRound.h"

#include <QEvent>
#include <QMainWindow>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace palpate::ui {

namespace {

/// First widget of a part that accepts focus by Tab.
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

QDockWidget* dockOf(QWidget* part)
{
    for (QWidget* one = part; one != nullptr; one = one->parentWidget()) {
        if (auto* dock = qobject_cast<QDockWidget*>(one)) {
            return dock;
        }
    }
    return nullptr;
}

QList<QDockWidget*> besideByTab(const QDockWidget& dock)
{
    const auto* window = qobject_cast<const QMainWindow*>(dock.parentWidget());
    return window != nullptr ? window->tabifiedDockWidgets(const_cast<QDockWidget*>(&dock)) : QList<QDockWidget*>();
}

/// True when a dock panel is visible. Qt moves panels behind another tab outside the window.
bool isInFront(const QDockWidget& dock)
{
    const QWidget* window = dock.window();
    return window->rect().intersects(QRect(dock.mapTo(window, QPoint()), dock.size()));
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
    const QDockWidget* left = focus != nullptr ? dockOf(focus) : nullptr;
    if (m_covered != nullptr && (left == nullptr || !besideByTab(*m_covered).contains(left))) {
        m_covered.clear(); // the pointer has moved the focus in the meantime
    }
    for (int tried = 1; tried <= count; ++tried) {
        const int i = ((now < 0 && step < 0 ? 0 : now) + step * tried + 2 * count) % count;
        if (isGivenKeys(m_parts[static_cast<std::size_t>(i)])) {
            return;
        }
    }
}

/// Focuses a part. Returns false when the part is hidden or contains no focusable widget.
bool PanelRound::isGivenKeys(Part& part)
{
    if (part.widget == nullptr || !part.widget->isVisible()) {
        return false;
    }
    QWidget* to = part.last != nullptr && part.last->isVisible() && part.last->isEnabled() ? part.last.data()
                                                                                           : firstIn(part.widget);
    if (to == nullptr) {
        return false;
    }
    QDockWidget* dock = dockOf(part.widget);
    const QList<QDockWidget*> tabs = dock != nullptr ? besideByTab(*dock) : QList<QDockWidget*>();
    if (m_covered != nullptr && m_covered != dock && !tabs.contains(m_covered)) {
        m_covered->raise(); // the focus leaves the tabbed panels
        m_covered.clear();
    }
    if (dock != nullptr && !isInFront(*dock)) {
        const auto front =
            std::find_if(tabs.begin(), tabs.end(), [](const QDockWidget* one) { return isInFront(*one); });
        if (m_covered == nullptr && front != tabs.end()) {
            m_covered = *front;
        }
        dock->raise();
    }
    to->setFocus(Qt::TabFocusReason);
    return true;
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

#include "palpate/ui/moc_PanelRound.cpp"
