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
                        tr("Short tour of the window, with the practice liver if no scene is open")),
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
                                      : tr("The tour uses the open scene and changes nothing.");
    m_tour->start({
        {panel("structures"), tr("Structures"),
         where + QLatin1Char(' ') +
             tr("The list shows all structures. The eye shows or hides a structure; the hand makes a structure "
                "palpable or not. Below the list you set how the structure feels.")},
        {m_view, tr("Press to feel"),
         tr("Click Palpate (P), then drag on the anatomy to press and slide; the wheel sets the depth. With the "
            "keyboard: "
            "Ctrl and the arrow keys move the press point, Enter presses, Page Down goes deeper. Esc releases.")},
        {panel("touch"), tr("Touch"),
         tr("Force in newtons, touched structure, depth in millimetres and a chart of the last ten seconds. At the "
            "same depth, stiffer tissue pushes back harder.")},
        {panel("findings"), tr("Recording and findings"),
         tr("Record (R) starts and stops a recording. Mark (M) marks the touched place, or the place pressed last, as "
            "a "
            "finding with force and depth, listed here; F2 renames the finding. File › Report… writes a recording with "
            "findings, distances and margins as PDF.")},
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
