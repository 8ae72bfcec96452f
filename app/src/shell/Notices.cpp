// SPDX-License-Identifier: BSD-3-Clause
#include "shell/Notices.h"

#include "shell/Docks.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/MessageList.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>

namespace palpate::app {

Notices::Notices(QMainWindow& window, ui::ActionList& actions, ui::VtkViewport& viewport)
    : WindowPart(&window)
    , m_actions(actions)
    , m_viewport(viewport)
    , m_bar(new ui::MessageBar(m_messages, &window))
    , m_hint(new ui::HintLine(&window))
{
    connect(m_bar, &ui::MessageBar::listWanted, this, &Notices::toggleList);
    connect(m_hint, &ui::HintLine::pressed, this, &Notices::toggleList);
}

void Notices::addActions()
{
    connect(m_actions.add("messages", ui::ActionGroup::Panels, tr("Messages"),
                          tr("Show or hide the list of all messages and file notes since the start"),
                          {QKeySequence(Qt::Key_F4)}),
            &QAction::triggered, this, &Notices::toggleList);
}

void Notices::addPanel(Docks& docks)
{
    m_docks = &docks;
    m_dock = &docks.addHidden(
        {tr("Messages"), "messages", new ui::MessageList(m_messages), Qt::BottomDockWidgetArea, false});
}

void Notices::say(const QString& text, int duration_ms)
{
    m_messages.add(ui::Messages::Kind::Told, text);
    m_hint->say(text);
    QTimer::singleShot(duration_ms, this, [this, text] {
        if (m_hint->said() == text) {
            m_hint->say({});
        }
    });
}

void Notices::warn(const QStringList& lines)
{
    m_messages.add(ui::Messages::Kind::Warning, lines);
}

void Notices::forgetIf(const std::function<bool(const QString& text)>& matches)
{
    m_messages.removeIf(matches);
    m_bar->withdrawIf(matches);
    if (matches(m_hint->said())) {
        m_hint->say({});
    }
}

void Notices::toggleList()
{
    const bool isShown = !m_dock->isVisible();
    m_docks->setShown(*m_dock, isShown);
    if (isShown) {
        m_dock->widget()->setFocus(Qt::ShortcutFocusReason);
    } else {
        m_viewport.setFocus();
    }
}

} // namespace palpate::app

#include "moc_Notices.cpp"
