// SPDX-License-Identifier: BSD-3-Clause
#include "touch/DistancesPart.h"

#include "scene/DocumentPart.h"
#include "shell/Docks.h"
#include "shell/Notices.h"
#include "shell/StatusProgress.h"
#include "touch/TouchPart.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/DistancesPanel.h>
#include <palpate/ui/MarginOverlay.h>
#include <palpate/ui/SceneDistances.h>
#include <palpate/ui/TapeTool.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

namespace palpate::app {

using ui::ActionGroup;

DistancesPart::DistancesPart(const WindowCore& core, const Parts& parts)
    : WindowPart(&core.window)
    , m_core(core)
    , m_parts(parts)
    , m_distances(new ui::SceneDistances(core.model, this))
{
    ui::TapesModel& tapes = parts.document.document().tapesModel();
    const auto touched = [&touch = parts.touch] { return ui::palpatedStructure(touch.panel().reading()).name; };
    m_tape = new ui::TapeTool(core.viewport, parts.pointed, tapes, touched, this);
    m_overlay = new ui::MarginOverlay(core.viewport, core.model, *m_distances, parts.maps, tapes, *m_tape, this);
    m_panel = new ui::DistancesPanel(*m_distances, *m_overlay, tapes, core.model, &core.window);
    connectDistances();
}

DistancesPart::~DistancesPart()
{
    delete m_panel;
    delete m_overlay;
    delete m_tape;
    delete m_distances;
}

void DistancesPart::connectDistances()
{
    connect(&m_parts.progress, &StatusProgress::cancelled, m_distances, &ui::SceneDistances::cancel);
    connect(m_distances, &ui::SceneDistances::progressed, &m_parts.progress, &StatusProgress::show);
    connect(m_distances, &ui::SceneDistances::ended, this, [this] {
        if (m_parts.progress.isVisible()) {
            m_parts.progress.end();
        }
    });
    connect(m_distances, &ui::SceneDistances::cancelled, this, [this](const QString& line) {
        m_core.actions.at("distances").setChecked(false);
        m_core.notices.say(line);
    });
    connect(m_tape, &ui::TapeTool::said, this, [this](const QString& line) { m_core.notices.say(line); });
    connect(m_tape, &ui::TapeTool::changed, this,
            [this] { m_core.actions.at("tape").setChecked(m_tape->isMeasuring()); });
}

void DistancesPart::addActions()
{
    QAction* shown = m_core.actions.add("distances", ActionGroup::View, tr("Distances and sizes"),
                                        tr("Measure the distances and margins of lumps to other structures, and list "
                                           "the tapes"),
                                        {QKeySequence(Qt::SHIFT | Qt::Key_T)});
    shown->setCheckable(true);
    QAction* tape = m_core.actions.add("tape", ActionGroup::View, tr("Tape"),
                                       tr("Measure between two places: click on both, or touch both and press T each "
                                          "time; snaps to findings"),
                                       {QKeySequence(Qt::Key_T)});
    tape->setCheckable(true);
    connect(tape, &QAction::triggered, this, [this, tape] {
        m_tape->press();
        tape->setChecked(m_tape->isMeasuring());
    });
    m_core.actions.setEnabled({"distances", "tape"}, false);
}

void DistancesPart::addPanel(Docks& docks)
{
    m_dock = &docks.addHidden({tr("Distances"), "distances", m_panel, Qt::BottomDockWidgetArea});
    QAction& action = m_core.actions.at("distances");
    connect(m_dock->toggleViewAction(), &QAction::toggled, m_distances, &ui::SceneDistances::setWanted);
    connect(&action, &QAction::toggled, this, [this, &docks](bool isShown) {
        if (isShown) {
            m_core.actions.at("felt").setChecked(false); // both colour structures and use the legend
        }
        m_overlay->setShown(isShown);
        docks.setShown(*m_dock, isShown);
        if (isShown) {
            constexpr int kHeight_px = 210; // five rows and the sentences of one
            m_core.window.resizeDocks({m_dock}, {std::max(kHeight_px, m_dock->height())}, Qt::Vertical);
        }
    });
    connect(&m_core.actions.at("felt"), &QAction::toggled, &action, [&action](bool isShown) {
        if (isShown) {
            action.setChecked(false);
        }
    });
}

void DistancesPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"distances", "tape"}, state.hasScene);
}

bool DistancesPart::cancelTape()
{
    return m_tape->cancel();
}

} // namespace palpate::app

#include "moc_DistancesPart.cpp"
