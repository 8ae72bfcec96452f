// SPDX-License-Identifier: BSD-3-Clause
#include "shell/Docks.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/PanelScroll.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

namespace palpate::app {

using ui::ActionGroup;

Docks::Docks(QMainWindow& window, ui::ActionList& actions)
    : WindowPart(&window)
    , m_window(window)
    , m_actions(actions)
{
    window.setDockNestingEnabled(false);
    window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    m_fitTitles.setSingleShot(true);
    m_fitTitles.setInterval(0);
    connect(&m_fitTitles, &QTimer::timeout, this, &Docks::fitTitles);
}

void Docks::addActions()
{
    m_actions.addSubmenu(ActionGroup::View, tr("Panels"), ActionGroup::Panels);
    m_actions.addSeparator(ActionGroup::Panels);
    connect(m_actions.add("next-panel", ActionGroup::Panels, tr("Next panel"),
                          tr("Move the keyboard focus to the next panel, after the last to the view"),
                          {QKeySequence(Qt::Key_F6)}),
            &QAction::triggered, this, [this] { m_round.go(1); });
    connect(m_actions.add("previous-panel", ActionGroup::Panels, tr("Previous panel"),
                          tr("Move the keyboard focus to the previous panel"), {QKeySequence(Qt::SHIFT | Qt::Key_F6)}),
            &QAction::triggered, this, [this] { m_round.go(-1); });
    connect(m_actions.add("panels", ActionGroup::Panels, tr("Hide or show all panels"), tr("Hide or show all panels"),
                          {QKeySequence(Qt::Key_F9)}),
            &QAction::triggered, this, &Docks::toggleAll);
}

QDockWidget& Docks::make(const Panel& panel)
{
    auto* dock = new QDockWidget(panel.title, &m_window);
    dock->setObjectName(QLatin1String(panel.name));
    // A low window has no room for a whole panel.
    dock->setWidget(panel.isScrollable ? new ui::PanelScroll(panel.content, &m_window) : panel.content);
    m_window.addDockWidget(panel.area, dock);
    for (const auto& changed : {&QDockWidget::visibilityChanged, &QDockWidget::topLevelChanged}) {
        connect(dock, changed, this, [this] { m_fitTitles.start(); });
    }
    return *dock;
}

/// Hides the title bars of panels with a tab, which has the same title. A double click on the tab detaches the panel.
void Docks::fitTitles()
{
    for (const auto* docks : {&m_docks, &m_hidden}) {
        for (const Docked& one : *docks) {
            const QList<QDockWidget*> beside = m_window.tabifiedDockWidgets(one.dock);
            const bool hasTab =
                !one.dock->isFloating() &&
                std::any_of(beside.begin(), beside.end(), [](const QDockWidget* other) { return !other->isHidden(); });
            if (hasTab != (one.dock->titleBarWidget() != nullptr)) {
                QWidget* before = one.dock->titleBarWidget();
                one.dock->setTitleBarWidget(hasTab ? new QWidget(one.dock) : nullptr);
                delete before;
            }
        }
    }
    for (QTabBar* tabs : m_window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        connect(tabs, &QTabBar::tabBarDoubleClicked, this, &Docks::detach, Qt::UniqueConnection);
    }
}

/// Detaches the panel of a tab of the window.
void Docks::detach(int tab)
{
    const auto* tabs = qobject_cast<QTabBar*>(sender());
    for (QDockWidget* dock : m_window.findChildren<QDockWidget*>()) {
        if (tab >= 0 && dock->windowTitle() == tabs->tabText(tab) && !m_window.tabifiedDockWidgets(dock).isEmpty()) {
            dock->setFloating(true);
            return;
        }
    }
}

QDockWidget& Docks::add(const Panel& panel)
{
    QDockWidget& dock = make(panel);
    const auto beside =
        std::find_if(m_docks.rbegin(), m_docks.rend(), [&](const Docked& other) { return other.area == panel.area; });
    if (beside != m_docks.rend()) {
        m_window.tabifyDockWidget(beside->dock, &dock);
        firstAt(panel.area).raise();
    }
    m_docks.push_back({&dock, panel.area});
    return dock;
}

QDockWidget& Docks::addHidden(const Panel& panel)
{
    QDockWidget& dock = make(panel);
    dock.hide();
    m_hidden.push_back({&dock, panel.area});
    return dock;
}

/// First panel of an area, which has at least one.
QDockWidget& Docks::firstAt(Qt::DockWidgetArea area) const
{
    return *std::find_if(m_docks.begin(), m_docks.end(), [&](const Docked& one) { return one.area == area; })->dock;
}

void Docks::setShown(QDockWidget& dock, bool isShown)
{
    dock.setVisible(isShown);
    if (isShown) {
        const auto one =
            std::find_if(m_hidden.begin(), m_hidden.end(), [&](const Docked& docked) { return docked.dock == &dock; });
        if (m_window.dockWidgetArea(&dock) == one->area && !dock.isFloating()) {
            // Only once visible: tabified while hidden, the dock would leave a tab bar with a single tab.
            m_window.tabifyDockWidget(&firstAt(one->area), &dock);
        }
        dock.raise();
    }
}

void Docks::fill(QMenu& menu) const
{
    QAction* first = menu.actions().value(0);
    for (const Docked& one : m_docks) {
        menu.insertAction(first, one.dock->toggleViewAction());
    }
    menu.insertSeparator(first);
}

void Docks::fit(double left_px, double right_px, double below_px)
{
    constexpr double kMostLeft = 0.22, kMostRight = 0.27, kMostBelow = 0.22; // fractions of the window
    m_window.resizeDocks({&firstAt(Qt::LeftDockWidgetArea), &firstAt(Qt::RightDockWidgetArea)},
                         {qRound(std::min(left_px, kMostLeft * m_window.width())),
                          qRound(std::min(right_px, kMostRight * m_window.width()))},
                         Qt::Horizontal);
    m_window.resizeDocks({&firstAt(Qt::BottomDockWidgetArea)},
                         {qRound(std::min(below_px, kMostBelow * m_window.height()))}, Qt::Vertical);
}

void Docks::scale(double ratio)
{
    fit(ratio * firstAt(Qt::LeftDockWidgetArea).width(), ratio * firstAt(Qt::RightDockWidgetArea).width(),
        ratio * firstAt(Qt::BottomDockWidgetArea).height());
}

void Docks::addPanelsToRound()
{
    for (const auto* docks : {&m_docks, &m_hidden}) {
        for (const Docked& one : *docks) {
            m_round.add(one.dock->widget());
        }
    }
}

void Docks::toggleAll()
{
    const bool isAnyShown =
        std::any_of(m_docks.begin(), m_docks.end(), [](const Docked& one) { return one.dock->isVisible(); });
    for (const Docked& one : m_docks) {
        one.dock->setVisible(!isAnyShown);
    }
}

} // namespace palpate::app

#include "moc_Docks.cpp"
