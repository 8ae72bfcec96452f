// SPDX-License-Identifier: BSD-3-Clause
#include "touch/TouchPart.h"

#include "shell/Docks.h"
#include "shell/Notices.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/DeviceChoice.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/LumpLabel.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/ViewKeys.h>
#include <palpate/ui/ViewVoice.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>

namespace palpate::app {

using ui::ActionGroup;

TouchPart::TouchPart(const WindowCore& core, ui::StructurePanel& structures)
    : WindowPart(&core.window)
    , m_core(core)
    , m_panel(new ui::TouchPanel(&core.window))
    , m_palpation(new ui::PalpationController(core.viewport, core.live, core.model, this))
    , m_chip(*core.chips.add("mode", tr("Use of the pointer or the device"), 3))
{
    m_chip.setToolTip(tr("The pointer turns the view, or presses this far along the line of sight [mm] or with this "
                         "force [N]. The wheel sets the value; P switches between the two"));
    m_panel->setForceLimit(core.live.deviceInfo().maxForce_N);
    connect(m_palpation, &ui::PalpationController::touched, m_panel, &ui::TouchPanel::show);
    connect(m_palpation, &ui::PalpationController::touched, &structures, &ui::StructurePanel::showTouch);
    connect(m_palpation, &ui::PalpationController::handGone, m_panel, &ui::TouchPanel::showNoHand);
    connect(m_palpation, &ui::PalpationController::textChanged, this, &TouchPart::showHand);
    connect(m_palpation, &ui::PalpationController::palpationWanted, this, [this] { setPalpating(true); });
    connect(m_palpation, &ui::PalpationController::said, this,
            [this](const QString& line) { m_core.notices.say(line); });
    connect(&core.live, &ui::LiveTouch::statusChanged, this, &TouchPart::showHand);
    new ui::ViewKeys(core.viewport, *m_palpation, this);
    new ui::ViewVoice(core.viewport, *m_panel, this);
    new ui::LumpLabel(core.viewport, *m_panel, this);
    connectView();
}

TouchPart::~TouchPart()
{
    delete m_panel;
}

void TouchPart::connectView()
{
    ui::VtkViewport& viewport = m_core.viewport;
    connect(&viewport, &ui::VtkViewport::spaceHeld, this,
            [this](bool isDown) { m_core.actions.at("palpate").setChecked(isDown); });
    connect(&viewport, &ui::VtkViewport::centreWanted, this, [&viewport](const QPointF& place) {
        if (const auto pick = viewport.view().pick(viewport.rayAt(place))) {
            viewport.view().centreOn(pick->hit.p_W);
            viewport.update();
        }
    });
}

void TouchPart::addActions()
{
    QAction* palpate = m_core.actions.add(
        "palpate", ActionGroup::Session, tr("Palpate"),
        tr("Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera"),
        {QKeySequence(Qt::Key_P)}, ui::Symbol::Hand);
    palpate->setCheckable(true);
    connect(palpate, &QAction::toggled, this, &TouchPart::setPalpating);
    addGestures();
}

void TouchPart::addGestures()
{
    ui::ActionList& actions = m_core.actions;
    actions.addGesture(ActionGroup::InView, tr("hold Space"), tr("palpate while the key is held"));
    actions.addGesture(ActionGroup::InView, tr("drag"), tr("camera: rotate · palpate: press and slide"));
    actions.addGesture(ActionGroup::InView, tr("click"),
                       tr("camera: select the structure (with Ctrl: add to the selection)"));
    actions.addGesture(ActionGroup::InView, tr("right drag"), tr("camera: zoom · palpate: rotate"));
    actions.addGesture(ActionGroup::InView, tr("middle drag"), tr("pan"));
    actions.addGesture(ActionGroup::InView, tr("wheel"),
                       tr("camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)"));
    actions.addGesture(ActionGroup::InView, tr("double-click"), tr("centre the view on the point"));
    ui::ViewKeys::describe(actions);
    connect(actions.add("let-go", ActionGroup::InView, tr("Let go"), tr("lift the hand, then return to the camera"),
                        {QKeySequence(Qt::Key_Escape)}),
            &QAction::triggered, this, &TouchPart::letGoWanted);
}

void TouchPart::addPanel(Docks& docks)
{
    docks.add({tr("Touch"), "touch", m_panel, Qt::RightDockWidgetArea});
}

void TouchPart::showState(const WindowState& state)
{
    m_core.actions.at("palpate").setEnabled(state.hasScene);
    showHand();
}

void TouchPart::setPalpating(bool isPalpating)
{
    m_core.actions.at("palpate").setChecked(isPalpating);
    if (isPalpating) {
        Q_EMIT palpationBegins();
        m_core.viewport.setFocus();
    }
    const bool wasPalpating = m_palpation->isPalpating();
    m_palpation->setPalpating(isPalpating);
    if (m_palpation->isPalpating() != wasPalpating) {
        Q_EMIT palpationChanged();
    }
    Q_EMIT stateChanged(); // the displayed force limit may change
}

void TouchPart::letGo()
{
    if (!m_palpation->letGo()) {
        m_core.actions.at("palpate").setChecked(false);
    }
}

void TouchPart::showHand()
{
    m_chip.say(handText(), m_palpation->isSlidOff() ? ui::Chip::Tone::Warning : ui::Chip::Tone::Quiet);
}

/// State of pointer or device.
QString TouchPart::handText() const
{
    if (!m_core.live.usesPointer()) {
        return tr("Touching with the %1").arg(ui::deviceName(m_core.live.deviceInfo()));
    }
    return m_palpation->isPalpating() ? m_palpation->text() : tr("Turning the view");
}

} // namespace palpate::app

#include "moc_TouchPart.cpp"
