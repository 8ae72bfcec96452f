// SPDX-License-Identifier: BSD-3-Clause
#include "touch/MotionPart.h"

#include "shell/Docks.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/DrawnMotion.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/MotionControl.h>
#include <palpate/ui/MotionPanel.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace palpate::app {

namespace {

constexpr int kMotionFrame_ms = 25; // 40 frames per second, if the view is as fast

} // namespace

MotionPart::MotionPart(const WindowCore& core, const ui::Playback& playback, const ui::PalpationController& palpation)
    : WindowPart(&core.window)
    , m_core(core)
    , m_playback(playback)
    , m_palpation(palpation)
    , m_control(new ui::MotionControl(core.model, core.live, this))
    , m_panel(new ui::MotionPanel(&core.window))
{
    m_frames.setTimerType(Qt::PreciseTimer);
    m_frames.setInterval(kMotionFrame_ms);
    connect(&m_frames, &QTimer::timeout, this, &MotionPart::step);
    connect(m_panel, &ui::MotionPanel::chosen, m_control, &ui::MotionControl::set);
    connect(m_control, &ui::MotionControl::changed, this, &MotionPart::refresh);
}

MotionPart::~MotionPart()
{
    delete m_panel;
}

void MotionPart::addActions()
{
    QAction* panel = m_core.actions.add("motion", ui::ActionGroup::Panels, tr("Motion"),
                                        tr("Show or hide the controls of moving tissue"));
    panel->setCheckable(true);
    QAction* hold = m_core.actions.add("hold-breath", ui::ActionGroup::Session, tr("Hold breath"),
                                       tr("Hold breathing tissue where it is"), {QKeySequence(Qt::Key_H)});
    hold->setCheckable(true);
    connect(hold, &QAction::triggered, this, [this](bool isHeld) {
        ui::MotionSettings settings = m_control->settings();
        settings.isHeld = isHeld;
        m_control->set(settings);
    });
}

void MotionPart::addPanel(Docks& docks)
{
    m_dock = &docks.addHidden({tr("Motion"), "motion", m_panel, Qt::LeftDockWidgetArea, false});
    QAction& action = m_core.actions.at("motion");
    connect(m_dock->toggleViewAction(), &QAction::toggled, &action, &QAction::setChecked);
    connect(&action, &QAction::triggered, m_dock, &QDockWidget::setVisible);
    refresh();
}

void MotionPart::showState(const WindowState& /*state*/)
{
    refresh();
}

/// Draws the tissue at the newest tick. A displayed hand has set the time of its tick, and a recording its own.
void MotionPart::step()
{
    const bool isRecorded =
        m_playback.recording() != nullptr && !m_palpation.isPalpating() && m_core.live.usesPointer();
    view::SceneView& view = m_core.viewport.view();
    if (!isRecorded && !view.cursor().state().isPresent) {
        servo::TickRecord tick;
        (void)m_core.live.fetch(tick);
        ui::drawMotion(view, m_core.model, m_core.live.time_s());
    }
    if (view.follow()) {
        m_core.viewport.update();
    }
}

void MotionPart::refresh()
{
    const bool hadMotion = m_hasMotion;
    m_hasMotion = m_control->hasMotion();
    m_panel->show(m_control->settings(), m_control->hasBreath());
    QAction& hold = m_core.actions.at("hold-breath");
    hold.setEnabled(m_control->hasBreath());
    hold.setChecked(m_control->settings().isHeld);
    m_core.actions.at("motion").setEnabled(m_hasMotion);
    if (m_hasMotion != hadMotion) {
        m_hasMotion ? m_frames.start() : m_frames.stop();
        m_dock->setVisible(m_hasMotion);
    } else if (!m_hasMotion) {
        m_dock->hide(); // a restored layout may have shown it
    }
}

} // namespace palpate::app

#include "moc_MotionPart.cpp"
