// SPDX-License-Identifier: BSD-3-Clause
#include "touch/DevicePart.h"

#include "scene/StructuresPart.h"
#include "shell/Docks.h"
#include "shell/Notices.h"
#include "touch/DeviceTests.h"
#include "touch/RecordingPart.h"
#include "touch/ThresholdDialog.h"
#include "touch/TouchPart.h"

#include <palpate/device/PluginHost.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/DeviceChoice.h>
#include <palpate/ui/HandControl.h>
#include <palpate/ui/HandPanel.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRandomGenerator>

#include <utility>

namespace palpate::app {

using ui::ActionGroup;

DevicePart::DevicePart(const WindowCore& core, StructuresPart& structures, TouchPart& touch, RecordingPart& recording)
    : WindowPart(&core.window)
    , m_core(core)
    , m_palpation(touch.palpation())
    , m_panel(new ui::HandPanel(&core.window))
    , m_hand(new ui::HandControl(core.viewport, core.live, core.model, structures.panel(), *m_panel, this))
    , m_devices(new ui::DeviceChoice(core.live, core.viewport, recording.playback(), this))
    , m_chip(*core.chips.add("device", tr("Device"), 2))
{
    connectDevices(structures);
    // Recording (R) starts to palpate, too: "P palpate" would then end what it names.
    connect(&touch, &TouchPart::palpationChanged, this, [this] { m_core.notices.hint().say(howToTouch()); });
    connect(m_hand, &ui::HandControl::said, this, [this](const QString& line) { m_core.notices.say(line); });
    connect(m_hand, &ui::HandControl::settingsTaken, this, &DevicePart::takePress);
    connect(&m_palpation, &ui::PalpationController::effortTurned, m_hand, &ui::HandControl::setEffort);
    connect(m_panel, &ui::HandPanel::presetChanged, this, [this] { use("simulated"); }); // starts with its limits
    connect(&core.live, &ui::LiveTouch::deviceChanged, m_hand, &ui::HandControl::takeDevice);
    connect(&core.live, &ui::LiveTouch::statusChanged, this, &DevicePart::showDevice);
    connect(&core.live, &ui::LiveTouch::faulted, this, &DevicePart::tellFault);
}

DevicePart::~DevicePart()
{
    delete m_test;    // uses the device
    delete m_devices; // notifies the others
    delete m_hand;
    delete m_panel;
}

void DevicePart::connectDevices(StructuresPart& structures)
{
    connect(m_devices, &ui::DeviceChoice::refused, &m_core.notices, &Notices::showError);
    connect(m_devices, &ui::DeviceChoice::pushed, &m_palpation, &ui::PalpationController::push);
    connect(m_devices, &ui::DeviceChoice::pressingWanted, this, [this] {
        m_core.actions.at("effort").setChecked(true);
        m_core.notices.say(tr("The pointer sets the place, the SpaceMouse the force: push its cap down. P palpate, "
                              "wheel for the force limit"),
                           60000);
    });
    connect(m_devices, &ui::DeviceChoice::changed, this, [this, &structures] {
        structures.takeLimit();
        Q_EMIT stateChanged();
        m_core.notices.say(howToTouch(), 60000);
    });
}

void DevicePart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    QAction* effort = actions.add("effort", ActionGroup::Session, tr("Press by effort"),
                                  tr("Press with a set force: it rises while the button is held, or follows the "
                                     "pressure of a pen, and stiff tissue yields less. Off: the wheel sets the depth"),
                                  {QKeySequence(Qt::Key_E)});
    effort->setCheckable(true);
    takePress(m_panel->settings());
    connect(effort, &QAction::toggled, this, [this](bool isByEffort) {
        m_hand->setByEffort(isByEffort);
        if (m_core.model.rowCount() > 0) {
            m_core.notices.say(howToTouch(), 60000); // the hint about the wheel is no longer valid
        }
    });
    connect(actions.add("threshold", ActionGroup::Session, tr("My threshold…"),
                        tr("Measure the smallest increase of stiffness that your hand detects")),
            &QAction::triggered, this, &DevicePart::measureThreshold);
    QAction* clutch = actions.add(
        "clutch", ActionGroup::Session, tr("Lift the hand"),
        tr("Move the device without moving the hand in the scene, like lifting a mouse; press again to continue"),
        {QKeySequence(Qt::Key_C)}, ui::Symbol::Hand);
    clutch->setCheckable(true);
    connect(clutch, &QAction::toggled, m_hand, &ui::HandControl::setClutched);
    const auto addFit = [&](const char* id, const QString& text, const QString& tip, Qt::Key key, ui::MapFill fill) {
        connect(actions.add(id, ActionGroup::Device, text, tip, {QKeySequence(key)}, ui::Symbol::Fit),
                &QAction::triggered, m_hand, [this, fill] { m_hand->fit(fill); });
    };
    addFit("fit-device-all", tr("Fit the workspace to the scene"),
           tr("The workspace of the device covers everything shown"), Qt::Key_W, ui::MapFill::Scene);
    addFit("fit-device-organ", tr("Fit the workspace to the organ"),
           tr("The workspace of the device covers the organ that is touched or under the pointer"), Qt::Key_O,
           ui::MapFill::Organ);
    addFit("fit-device-lump", tr("Fit the workspace to the lump"),
           tr("The workspace of the device covers 10 mm around the place that is touched, under the pointer or marked"),
           Qt::Key_L, ui::MapFill::Lump);
    addTests();
}

void DevicePart::addTests()
{
    connect(m_core.actions.add("test-device", ActionGroup::Device, tr("Test…"),
                               tr("Measure round trip, noise, friction and the stiffness that the device holds")),
            &QAction::triggered, this, [this] {
                m_test = new SelfTestDialog(m_core.live, &m_core.window);
                m_test->open();
            });
    connect(m_core.actions.add("check-axes", ActionGroup::Device, tr("Check the axes…"),
                               tr("Check whether the device moves as the hand does")),
            &QAction::triggered, this, &DevicePart::checkAxes);
    connect(&m_core.live, &ui::LiveTouch::deviceChanged, this, [this] {
        m_core.notices.bar().withdraw(m_axesOffer);
        const device::DeviceInfo& info = m_core.live.deviceInfo();
        if (info.workspaceRadius_mm > 0.0 && !AxisCheckDialog::wasDone(info)) {
            m_axesOffer = tr("Check once whether %1 moves as your hand does.").arg(QString::fromStdString(info.name));
            m_core.notices.bar().offer(m_axesOffer, tr("Check the axes…"), [this] { checkAxes(); });
        }
    });
}

void DevicePart::checkAxes()
{
    m_core.notices.bar().withdraw(m_axesOffer);
    m_test = new AxisCheckDialog(m_core.live, &m_core.window);
    m_test->open();
}

/// Only for a device with a workspace of its own, in which the user holds the handle.
void DevicePart::showTests(bool isRecording)
{
    const device::DeviceInfo& info = m_core.live.deviceInfo();
    const bool isHeld = !m_core.live.usesPointer() && info.workspaceRadius_mm > 0.0;
    m_core.actions.at("test-device").setEnabled(isHeld && !isRecording && info.actuatedAxes > 0);
    m_core.actions.at("check-axes").setEnabled(isHeld);
}

void DevicePart::measureThreshold()
{
    if (m_core.live.recording().isRecording) {
        m_core.notices.say(tr("Stop the recording before you measure your threshold."));
        return;
    }
    auto* dialog =
        new ThresholdDialog(m_core.live, m_core.viewport, QRandomGenerator::global()->generate(), &m_core.window);
    dialog->open();
}

void DevicePart::addPanel(Docks& docks)
{
    docks.add({tr("Device"), "device", m_panel, Qt::RightDockWidgetArea});
}

void DevicePart::showState(const WindowState& state)
{
    showTests(state.isRecording);
    showDevice();
}

void DevicePart::showDevice()
{
    m_chip.say(m_devices->summary(), m_devices->isTroubled() ? ui::Chip::Tone::Warning : ui::Chip::Tone::Quiet);
    m_chip.setToolTip(m_devices->details());
}

void DevicePart::setPlugins(std::unique_ptr<device::PluginHost> plugins)
{
    m_devices->setPlugins(std::move(plugins));
    QMenuBar& bar = *m_core.window.menuBar();
    auto* menu = new QMenu(tr("&Device"), &m_core.window);
    bar.insertMenu(bar.actions().constLast(), menu); // before the Help menu
    m_devices->fill(*menu);
    menu->addSeparator();
    m_core.actions.fill(*menu, ActionGroup::Device);
}

void DevicePart::choose(const std::string& id)
{
    if (m_core.model.rowCount() == 0) {
        m_waiting = id;
    } else {
        use(id);
    }
}

void DevicePart::chooseWaiting()
{
    if (const auto id = std::exchange(m_waiting, std::nullopt)) {
        use(*id);
    }
}

void DevicePart::use(const std::string& id)
{
    if (const core::Status status = m_devices->choose(id); !status.isOk()) {
        m_core.notices.showError(ui::translated(status));
        Q_EMIT refused(ui::translated(status));
    }
}

QString DevicePart::howToTouch() const
{
    if (!m_core.live.usesPointer()) {
        return tr("Touch with the device; O or L fits the workspace to the organ or lump, C lifts the hand");
    }
    if (m_palpation.isPalpating()) {
        return m_panel->settings().isByEffort
                   ? tr("Hold to press harder, wheel for the force limit; then Mark; right drag turns the view")
                   : tr("Drag to press, wheel for depth; then Mark; right drag turns the view");
    }
    return m_panel->settings().isByEffort ? tr("Palpate (P): hold to press harder, wheel for the force limit")
                                          : tr("Palpate (P): drag to press, wheel for depth");
}

/// Shows how the pointer presses; with another device, the setting of the pointer stays.
void DevicePart::takePress(const ui::HandSettings& settings)
{
    QAction& effort = m_core.actions.at("effort");
    effort.setEnabled(m_core.live.usesPointer());
    if (m_core.live.usesPointer()) {
        m_palpation.setPress(settings);
        effort.setChecked(settings.isByEffort);
    }
}

void DevicePart::tellFault(const QString& line)
{
    if (m_core.live.usesPointer()) {
        m_core.notices.say(line);
        return;
    }
    m_core.notices.bar().offer(line, tr("Restore the force"), [this] { m_core.live.rearm(); });
}

} // namespace palpate::app

#include "moc_DevicePart.cpp"
