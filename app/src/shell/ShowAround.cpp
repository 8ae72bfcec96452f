// SPDX-License-Identifier: BSD-3-Clause
#include "shell/ShowAround.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/Tour.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace palpate::app {

ShowAround::ShowAround(QMainWindow* window, ui::ActionList& actions, QWidget* view)
    : QObject(window)
    , m_window(window)
    , m_view(view)
    , m_tour(new ui::Tour(window))
{
    connect(actions.add("show-around", ui::ActionGroup::Help, tr("Show me around"),
                        tr("Four notes on the window, on the practice liver when nothing is open")),
            &QAction::triggered, this, &ShowAround::wanted);
    connect(m_tour, &ui::Tour::coming, this, &ShowAround::bringForward);
    connect(m_tour, &ui::Tour::ended, this, [this] { bringForward(panel("touch")); });
}

void ShowAround::begin(bool hasScene, bool isOpening)
{
    m_isPhantom = !hasScene && !isOpening;
    m_isWaiting = m_isPhantom || isOpening;
    if (m_isPhantom) {
        Q_EMIT phantomWanted();
    } else if (!m_isWaiting) {
        start();
    }
}

void ShowAround::goOn()
{
    if (m_isWaiting) {
        m_isWaiting = false;
        start();
    }
}

void ShowAround::start()
{
    const QString where = m_isPhantom ? tr("This is a practice liver with lumps inside.")
                                      : tr("Shown on what is open; nothing of it is changed.");
    m_tour->start({
        {panel("structures"), tr("Structures"),
         where + QLatin1Char(' ') +
             tr("The list has every structure. The eye shows or hides it, the hand lets you feel it or not; below "
                "stands the tissue that it is felt as.")},
        {m_view, tr("Press to feel"),
         tr("Press P, then drag on the anatomy: you press and slide, the wheel goes deeper. By keys: Ctrl and the "
            "arrows "
            "move the place, Enter presses, Page down goes deeper. Esc lets go.")},
        {panel("touch"), tr("Touch"),
         tr("The force in newtons, which structure is touched, how deep in millimetres, and the last ten seconds. What "
            "is "
            "stiffer than its surroundings pushes back more at the same depth.")},
        {panel("findings"), tr("Record and findings"),
         tr("R records what you feel, and again ends it. M marks the place you touch as a finding: it stands here with "
            "force and depth; F2 names it. File › Export findings… writes them out.")},
    });
}

QWidget* ShowAround::panel(const char* name) const
{
    return m_window->findChild<QDockWidget*>(QLatin1String(name));
}

/// Shows a closed panel and raises a panel behind another tab.
void ShowAround::bringForward(QWidget* part)
{
    if (auto* dock = qobject_cast<QDockWidget*>(part)) {
        dock->show();
        dock->raise();
    }
}

} // namespace palpate::app

#include "moc_ShowAround.cpp"
