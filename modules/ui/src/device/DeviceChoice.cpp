// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/DeviceChoice.h"

#include "palpate/ui/ConnectedDevices.h"
#include "palpate/ui/Effort.h"
#include "palpate/ui/HandSettings.h"
#include "palpate/ui/Translated.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/device/PlaybackDevice.h>
#include <palpate/device/SimulatedHand.h>
#include <palpate/session/RecordingReader.h>

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QStringList>

#include <string>
#include <vector>

namespace palpate::ui {

using core::Status;
using core::StatusCode;

namespace {

constexpr const char* kPuckPlugin = "spacemouse";

/// Palpation pattern at a place of the surface: press, slide, lift, repeated every 4 s for 400 s.
std::vector<device::HandTarget> palpationAt(const core::Vec3& p_W, const core::Vec3& inwards_W)
{
    constexpr double kAbove_mm = 15.0;
    constexpr double kDepth_mm = 6.0;
    constexpr double kSlide_mm = 8.0;
    constexpr int kRounds = 100;
    const core::Vec3 across_W = inwards_W.unitOrthogonal();
    const core::Vec3 along_W = inwards_W.cross(across_W);
    std::vector<device::HandTarget> targets{{0.0, p_W - kAbove_mm * inwards_W}};
    for (int i = 0; i < kRounds; ++i) {
        const double at_s = 4.0 * i;
        const core::Vec3 side_W = kSlide_mm * (i % 2 == 0 ? across_W : along_W);
        targets.push_back({at_s + 1.0, p_W + kDepth_mm * inwards_W});
        targets.push_back({at_s + 2.0, p_W + kDepth_mm * inwards_W + side_W});
        targets.push_back({at_s + 3.0, p_W + kDepth_mm * inwards_W - side_W});
        targets.push_back({at_s + 4.0, p_W - kAbove_mm * inwards_W});
    }
    return targets;
}

} // namespace

DeviceChoice::DeviceChoice(LiveTouch& live, VtkViewport& viewport, Playback& playback, QObject* parent)
    : QObject(parent)
    , m_live(live)
    , m_viewport(viewport)
    , m_playback(playback)
{
    connect(&m_puck, &PuckReader::moved, this, &DeviceChoice::takePuck);
}

DeviceChoice::~DeviceChoice()
{
    // Objects created by a plugin must be destroyed before the plugin is unloaded.
    (void)m_puck.use(nullptr);
    (void)m_live.useDevice(nullptr);
}

void DeviceChoice::setPlugins(std::unique_ptr<device::PluginHost> plugins)
{
    m_plugins = std::move(plugins);
}

void DeviceChoice::fill(QMenu& menu)
{
    menu.setToolTipsVisible(true);
    m_group = new QActionGroup(&menu);
    const auto add = [&](const std::string& id, const QString& text, const QString& tip) {
        QAction* action = menu.addAction(text);
        action->setCheckable(true);
        action->setChecked(id == m_chosen);
        action->setData(QString::fromStdString(id));
        action->setToolTip(tip);
        m_group->addAction(action);
        connect(action, &QAction::triggered, this, [this, id] {
            if (const Status status = choose(id); !status.isOk()) {
                Q_EMIT refused(translated(status));
            }
        });
    };
    add("mouse", tr("Mouse"), tr("Mouse pointer over the view; the force is displayed, not felt"));
    add("simulated", tr("Simulated hand (no device)"),
        tr("Computed hand that palpates the centre of the view and responds to the force"));
    add("playback", tr("Replay with current tissue"),
        tr("Repeats the motion of the open recording on the current tissue"));
    if (m_plugins != nullptr) {
        menu.addSeparator();
        bool hasPuck = false;
        for (const device::PluginEntry& entry : m_plugins->plugins()) {
            if (entry.status.isOk()) {
                QStringList tip(QString::fromStdString(entry.info.drives));
                if (const QString steps = stepsToConnect(entry.info.id); !steps.isEmpty()) {
                    tip << steps;
                }
                add(entry.info.id, QString::fromStdString(entry.info.name), tip.join(QLatin1Char('\n')));
                hasPuck = hasPuck || entry.info.id == kPuckPlugin;
            } else {
                QAction* action = menu.addAction(tr("%1 (skipped)").arg(QString::fromStdString(entry.file.filename())));
                action->setEnabled(false);
                action->setToolTip(translated(entry.status));
            }
        }
        if (hasPuck) {
            menu.addSeparator();
            addPuck(menu);
        }
    }
    menu.addSeparator();
    QAction* calibrate = menu.addAction(tr("Calibrate"), this, [this] {
        if (const Status status = m_live.calibrate(); !status.isOk()) {
            Q_EMIT refused(translated(status));
        }
    });
    calibrate->setToolTip(tr("Use the current pose of the device as calibration pose"));
    connect(&menu, &QMenu::aboutToShow, calibrate, [this, calibrate] {
        calibrate->setEnabled(m_chosen != "mouse" && m_chosen != "simulated" && m_chosen != "playback");
    });
    menu.addAction(tr("Connected devices…"), this, &DeviceChoice::reportBusDevices);
}

void DeviceChoice::addPuck(QMenu& menu)
{
    const auto add = [&](std::size_t place, const QString& text, const QString& tip, SixAxisMouseUse use) {
        QAction* action = menu.addAction(text);
        action->setCheckable(true);
        action->setToolTip(tip);
        connect(action, &QAction::triggered, this,
                [this, use](bool isOn) { usePuck(isOn ? use : SixAxisMouseUse::Nothing); });
        m_puckActions[place] = action;
    };
    add(0, tr("SpaceMouse moves the view"), tr("The puck rotates and moves the anatomy while another device palpates"),
        SixAxisMouseUse::MovesView);
    add(1, tr("SpaceMouse presses"),
        tr("The pointer sets the place, the puck sets the force: the further down, the more newtons"),
        SixAxisMouseUse::Presses);
}

void DeviceChoice::usePuck(SixAxisMouseUse use)
{
    Status status;
    if (use == SixAxisMouseUse::Nothing) {
        (void)m_puck.use(nullptr);
    } else if (m_chosen == kPuckPlugin) {
        status = Status(StatusCode::Unsupported,
                        PALPATE_TEXT("the SpaceMouse is the hand now; choose another device for it first"));
    } else if (!m_puck.isOn()) {
        auto made = m_plugins->make(kPuckPlugin);
        status = made.isOk() ? m_puck.use(std::move(made).value()) : made.status();
    }
    if (m_puckUse == SixAxisMouseUse::Presses) {
        Q_EMIT pushed(0.0); // releases a running press before the role changes
    }
    m_puckUse = m_puck.isOn() ? use : SixAxisMouseUse::Nothing;
    m_puckActions[0]->setChecked(m_puckUse == SixAxisMouseUse::MovesView);
    m_puckActions[1]->setChecked(m_puckUse == SixAxisMouseUse::Presses);
    if (!status.isOk()) {
        Q_EMIT refused(translated(status));
    } else if (m_puckUse == SixAxisMouseUse::Presses) {
        Q_EMIT pressingWanted();
    }
}

void DeviceChoice::takePuck(const device::DeviceState& from, const device::DeviceState& to, double passed_s)
{
    if (m_puckUse == SixAxisMouseUse::Presses) {
        Q_EMIT pushed(pushOf(from, to, passed_s));
    } else if (from.isPresent && to.isPresent && (from.p_D != to.p_D || from.q_D.coeffs() != to.q_D.coeffs())) {
        moveWithHand(m_viewport.view().camera(), from, to);
        m_viewport.update();
    }
}

Status DeviceChoice::choose(const std::string& id)
{
    Status status;
    if (id == kPuckPlugin && m_puck.isOn()) {
        status = Status(StatusCode::Unsupported,
                        PALPATE_TEXT("the SpaceMouse moves the view or presses; switch that off first"));
    } else {
        auto made = make(id);
        status = made.isOk() ? m_live.useDevice(std::move(made).value()) : made.status();
        if (made.isOk()) {
            m_chosen = m_live.usesPointer() ? "mouse" : id;
        }
    }
    if (m_group != nullptr) {
        for (QAction* action : m_group->actions()) {
            action->setChecked(action->data().toString().toStdString() == m_chosen);
        }
    }
    Q_EMIT changed();
    return status;
}

core::Result<std::unique_ptr<device::HapticDevice>> DeviceChoice::make(const std::string& id)
{
    if (id == "mouse") {
        return std::unique_ptr<device::HapticDevice>();
    }
    if (id == "simulated") {
        return makeSimulated();
    }
    if (id == "playback") {
        return makePlayback();
    }
    if (m_plugins == nullptr) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("no device is called \"%1\""), id);
    }
    return m_plugins->make(id);
}

core::Result<std::unique_ptr<device::HapticDevice>> DeviceChoice::makeSimulated()
{
    const QPointF middle(0.5 * m_viewport.width(), 0.5 * m_viewport.height());
    const view::Ray ray = m_viewport.rayAt(middle);
    const auto pick = m_viewport.view().pick(ray);
    if (!pick) {
        return Status(StatusCode::Empty,
                      PALPATE_TEXT("the simulated hand palpates what is in the middle of the view: found nothing "
                                   "palpable there"));
    }
    const double touch_mm = m_live.scene() != nullptr
                                ? touchAlongRay_mm(*m_live.scene(), ray, pick->hit.distance_mm, m_live.time_s())
                                : pick->hit.distance_mm;
    auto script = device::HandScript::make(palpationAt(ray.p_W + touch_mm * ray.d_W, ray.d_W));
    if (!script.isOk()) {
        return script.status();
    }
    device::SimulatedHandOptions options;
    const QSettings store;
    const HandSettings settings = HandSettings::load(store, QStringLiteral("simulated-hand"));
    if (const device::DevicePreset* preset = device::findDevicePreset(settings.preset); preset != nullptr) {
        options.preset = *preset;
    }
    return std::make_unique<device::SimulatedHand>(std::move(script).value(), options);
}

core::Result<std::unique_ptr<device::HapticDevice>> DeviceChoice::makePlayback()
{
    if (m_playback.recording() == nullptr) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("found no open recording, expected one whose motion the device repeats"));
    }
    const auto reader = session::RecordingReader::open(m_playback.recording()->path());
    if (!reader.isOk()) {
        return reader.status();
    }
    auto motion = reader.value()->motion();
    if (!motion.isOk()) {
        return motion.status();
    }
    auto device = std::make_unique<device::PlaybackDevice>(motion.value().p_WH);
    device->setLooping(true);
    return std::unique_ptr<device::HapticDevice>(std::move(device));
}

QString deviceName(const device::DeviceInfo& info)
{
    if (info.id == "mouse") {
        return DeviceChoice::tr("mouse");
    }
    if (info.id == "simulated-hand") {
        return DeviceChoice::tr("simulated hand");
    }
    return info.id == "playback" ? DeviceChoice::tr("replayed recording") : QString::fromStdString(info.name);
}

QString DeviceChoice::summary() const
{
    const QString name = deviceName(m_live.deviceInfo());
    const device::DeviceReport report = m_live.deviceReport();
    switch (report.condition) {
    case device::DeviceCondition::Lost:
        return tr("%1 lost").arg(name);
    case device::DeviceCondition::NeedsCalibration:
        return tr("%1: calibrate").arg(name);
    case device::DeviceCondition::Working:
        break;
    }
    return name;
}

QString DeviceChoice::details() const
{
    const device::DeviceInfo& info = m_live.deviceInfo();
    QStringList lines{tr("Input device: %1").arg(QString::fromStdString(info.name))};
    const device::DeviceReport report = m_live.deviceReport();
    if (!report.text.empty()) {
        lines << QString::fromStdString(report.text);
    }
    lines << (info.actuatedAxes == 0
                  ? tr("No force feedback: forces up to %1 N are displayed only.").arg(numberText(info.maxForce_N))
                  : tr("Up to %1 N and %2 N/mm")
                        .arg(numberText(info.maxForce_N), numberText(info.maxStiffness_N_per_mm)));
    return lines.join(QLatin1Char('\n'));
}

bool DeviceChoice::isTroubled() const
{
    return m_live.deviceReport().condition != device::DeviceCondition::Working;
}

void DeviceChoice::reportBusDevices()
{
    ConnectedDevices(m_plugins.get(), &m_viewport).exec();
}

} // namespace palpate::ui

#include "palpate/ui/moc_DeviceChoice.cpp"
