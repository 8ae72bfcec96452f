// SPDX-License-Identifier: BSD-3-Clause
#include "touch/EngineeringPart.h"

#include "shell/Docks.h"
#include "shell/Notices.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/EngineeringPanel.h>
#include <palpate/ui/HandControl.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace palpate::app {

EngineeringPart::EngineeringPart(const WindowCore& core, const ui::TouchPanel& touch, ui::HandControl& hand)
    : WindowPart(&core.window)
    , m_core(core)
    , m_touch(touch)
    , m_panel(new ui::EngineeringPanel(&core.window))
    , m_chip(*core.chips.add("running", tr("State of the servo loop"), 1))
{
    m_chip.setCursor(Qt::PointingHandCursor);
    connect(&core.live, &ui::LiveTouch::statusChanged, this, &EngineeringPart::refresh);
    connect(m_panel, &ui::EngineeringPanel::loopChosen, &hand, &ui::HandControl::chooseLoop);
    connect(m_panel, &ui::EngineeringPanel::loopChosen, this, &EngineeringPart::refresh);
}

EngineeringPart::~EngineeringPart()
{
    delete m_panel;
}

void EngineeringPart::addActions()
{
    m_core.actions
        .add("engineering", ui::ActionGroup::Panels, tr("Engineering"),
             tr("Show or hide measurements of solver, servo loop and device"))
        ->setCheckable(true);
}

void EngineeringPart::addPanel(Docks& docks)
{
    m_dock = &docks.addHidden({tr("Engineering"), "engineering", m_panel, Qt::LeftDockWidgetArea});
    QAction& action = m_core.actions.at("engineering");
    const auto show = [this, &docks](bool isShown) {
        docks.setShown(*m_dock, isShown);
        refresh();
    };
    connect(m_dock->toggleViewAction(), &QAction::toggled, &action, &QAction::setChecked);
    connect(&action, &QAction::triggered, this, show);
    connect(&m_chip, &ui::Chip::clicked, this, [show] { show(true); });
}

void EngineeringPart::showState(const WindowState&)
{
    refresh();
}

void EngineeringPart::refresh()
{
    const ui::EngineeringReading reading = ui::engineeringReading(m_core.live, m_touch.reading());
    const ui::RunningState state = ui::runningState(reading);
    m_chip.say(state.text, state.isWell ? ui::Chip::Tone::Good : ui::Chip::Tone::Warning);
    m_chip.setToolTip(state.tip);
    if (reading.isRunning) {
        listWarnings(reading.realtime);
    }
    if (m_panel->isVisible()) {
        m_panel->show(reading);
    }
}

/// Lists warnings, once per change, about settings that keep the servo thread from real-time operation, with remedies.
void EngineeringPart::listWarnings(const servo::RealtimeReport& report)
{
    if (report.isRealtime) {
        m_warnings.clear();
        return;
    }
    QStringList lines;
    for (const servo::RealtimeItem& item : report.items) {
        if (!item.isGranted && !item.remedy.empty()) {
            lines << tr("Forces may stutter: %1: %2. %3")
                         .arg(ui::translated(item.name), ui::translated(item.message),
                              QString::fromStdString(item.remedy));
        }
    }
    if (lines != m_warnings) {
        m_warnings = lines;
        m_core.notices.warn(lines);
    }
}

} // namespace palpate::app

#include "moc_EngineeringPart.cpp"
