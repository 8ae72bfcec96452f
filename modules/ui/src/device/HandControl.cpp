// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandControl.h"

#include "palpate/ui/Translated.h"

#include <palpate/geometry/Inside.h>
#include <palpate/study/HapticCopy.h>

#include <QLocale>
#include <QSettings>

#include <vtkCamera.h>
#include <vtkPolyData.h>

namespace palpate::ui {

HandControl::HandControl(VtkViewport& viewport, LiveTouch& live, StructureModel& model, StructurePanel& structures,
                         HandPanel& panel, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_live(live)
    , m_model(model)
    , m_structures(structures)
    , m_panel(panel)
{
    constexpr int kFollow_ms = 40;
    m_follow.setInterval(kFollow_ms);
    connect(&m_follow, &QTimer::timeout, this, &HandControl::lay);
    connect(&panel, &HandPanel::settingsChanged, this, &HandControl::keep);
    connect(&panel, &HandPanel::centreWanted, this, &HandControl::centre);
    connect(&panel, &HandPanel::clutchWanted, this, &HandControl::setClutched);
    connect(&panel, &HandPanel::fitWanted, this, &HandControl::fit);
    // Queued, because the scene's camera is set after the model.
    connect(&model, &QAbstractItemModel::modelReset, this, &HandControl::takeScene, Qt::QueuedConnection);
    connect(&live, &LiveTouch::statusChanged, this, &HandControl::showStatus);
    takeDevice();
}

void HandControl::takeDevice()
{
    QSettings store;
    const device::DeviceInfo& info = m_live.deviceInfo();
    HandSettings settings = HandSettings::load(store, QString::fromStdString(info.id));
    settings.cpu = m_cpu.value_or(settings.cpu);
    m_panel.setDevice(info, settings);
    if (servo::edgeOf(info) > 0.0) {
        m_follow.start();
    } else {
        m_follow.stop();
    }
    takeLoop();
    takeScene();
    showStatus();
    Q_EMIT settingsTaken(m_panel.settings());
}

void HandControl::setByEffort(bool isByEffort)
{
    HandSettings settings = m_panel.settings();
    if (m_live.usesPointer() && settings.isByEffort != isByEffort) {
        settings.isByEffort = isByEffort;
        m_panel.setSettings(settings);
        keep();
    }
}

void HandControl::setEffort(double most_N)
{
    HandSettings settings = m_panel.settings();
    if (m_live.usesPointer() && settings.effort_N != most_N) {
        settings.effort_N = most_N;
        m_panel.setSettings(settings);
        keep();
    }
}

void HandControl::useCpu(int cpu)
{
    m_cpu = cpu;
    takeDevice();
}

void HandControl::chooseLoop(int rate_kHz, int cpu)
{
    HandSettings settings = m_panel.settings();
    settings.rate_kHz = rate_kHz;
    settings.cpu = cpu;
    m_panel.setSettings(settings);
    keep();
}

void HandControl::takeLoop()
{
    HandSettings settings = m_panel.settings();
    if (const core::Status allowed = servo::checkCpu(settings.cpu); !allowed.isOk()) {
        settings.cpu = -1; // saved on another machine or outside a container
        m_panel.setSettings(settings);
        // Queued, to follow other messages about a newly selected device.
        QMetaObject::invokeMethod(
            this, [this, line = tr("%1; using any CPU").arg(translated(allowed))] { Q_EMIT said(line); },
            Qt::QueuedConnection);
    }
    if (const core::Status status = m_live.setLoop(settings.rate_kHz * 1000.0, settings.cpu); !status.isOk()) {
        settings.rate_kHz = static_cast<int>(m_live.rate_Hz() * 1e-3);
        settings.cpu = m_live.cpu();
        m_panel.setSettings(settings);
        Q_EMIT said(translated(status));
    }
}

void HandControl::takeScene()
{
    HandSettings settings = m_panel.settings();
    if (settings.fill != MapFill::Scale) {
        settings.fill = MapFill::Scene;
        m_panel.setSettings(settings);
    }
    m_filled = scene().value_or(Filled());
    centre();
}

void HandControl::setClutched(bool isClutched)
{
    m_isClutched = isClutched;
    lay();
}

void HandControl::centre()
{
    ++m_centreRequest;
    if (m_live.deviceInfo().isRateControlled) {
        (void)m_live.calibrate(); // also resets the origin of a rate-controlled device to its current position
    }
    lay();
}

void HandControl::fit(MapFill fill)
{
    const auto found = fill == MapFill::Scene ? scene() : fill == MapFill::Organ ? organ() : lump();
    if (!found) {
        Q_EMIT said(fill == MapFill::Lump ? tr("First touch a place, point at one or mark a finding (M).")
                                          : tr("No visible structure to fit the workspace to."));
        return;
    }
    m_filled = *found;
    HandSettings settings = m_panel.settings();
    settings.fill = fill;
    settings.turn = settings.turn == MapTurn::None ? MapTurn::Camera : settings.turn;
    m_panel.setSettings(settings);
    const bool isStaying = isTouching();
    keep();
    // Recentring would tear a hand in contact off the tissue.
    if (!isStaying) {
        centre();
    }
    Q_EMIT said(isStaying
                    ? tr("%1 fills the workspace. The hand stays in contact; Centre moves the hand to the middle.")
                          .arg(m_filled.name)
                    : tr("%1 fills the workspace.").arg(m_filled.name));
}

bool HandControl::isTouching() const
{
    const servo::TickRecord& tick = m_live.newest();
    return (tick.flags & servo::kNoHand) == 0 && tick.felt.structure >= 0 && tick.felt.structure < m_model.rowCount();
}

std::optional<HandControl::Filled> HandControl::scene()
{
    const core::Box box = m_viewport.view().bounds();
    return box.isEmpty() ? std::nullopt : std::optional(Filled{box, tr("The whole scene")});
}

std::optional<HandControl::Filled> HandControl::organ()
{
    int row = m_structures.currentRow();
    if (isTouching()) {
        row = m_live.newest().felt.structure;
    } else if (const auto ray = m_viewport.pointerRay()) {
        if (const auto pick = m_viewport.view().pick(*ray)) {
            row = static_cast<int>(pick->structure);
        }
    }
    if (row < 0 || row >= m_model.rowCount() || !m_model.isListed(row)) {
        return std::nullopt;
    }
    const double* b = m_model.picture(row)->GetBounds();
    return Filled{{core::Vec3(b[0], b[2], b[4]), core::Vec3(b[1], b[3], b[5])},
                  readableName(m_model.structure(row).name)};
}

std::optional<HandControl::Filled> HandControl::lump()
{
    if (isTouching()) {
        return Filled{lumpAt(m_live.newest().felt.touched_W()), tr("10 mm around the contact")};
    }
    if (const auto ray = m_viewport.pointerRay()) {
        if (const auto pick = m_viewport.view().pick(*ray)) {
            constexpr double kNear_mm = 10.0; // snaps to a finding near the pointer
            core::Vec3 place = pick->hit.p_W;
            for (const core::Vec3& finding : m_findings) {
                place = (finding - pick->hit.p_W).norm() < kNear_mm ? finding : place;
            }
            return Filled{lumpAt(place), tr("10 mm around the pointer")};
        }
    }
    if (!m_findings.empty()) {
        return Filled{lumpAt(m_findings.back()), tr("10 mm around finding %1").arg(m_findings.size())};
    }
    return std::nullopt;
}

void HandControl::keep()
{
    if (m_cpu && *m_cpu != m_panel.settings().cpu) {
        m_cpu.reset(); // the user chose another CPU
    }
    takeLoop();
    QSettings store;
    m_panel.settings().save(store, QString::fromStdString(m_live.deviceInfo().id));
    lay();
    showStatus();
    Q_EMIT settingsTaken(m_panel.settings());
}

void HandControl::lay()
{
    const std::uint32_t buttons = m_live.newest().buttons;
    const bool isCentrePressed = (buttons & ~m_buttonsBefore & m_panel.settings().buttonsFor(ButtonUse::Centre)) != 0;
    m_buttonsBefore = buttons;
    if (isCentrePressed) {
        centre();
        return;
    }
    vtkCamera& camera = m_viewport.view().camera();
    HandPlace place;
    const core::Vec3 forward = core::Vec3(camera.GetDirectionOfProjection());
    place.right_W = forward.cross(core::Vec3(camera.GetViewUp())).normalized();
    place.up_W = place.right_W.cross(forward);
    place.filled = m_filled.box;
    servo::MapSettings map = mapFor(m_panel.settings(), m_live.deviceInfo(), place);
    map.centreRequest = m_centreRequest;
    map.isClutched = m_isClutched;
    m_live.setMap(map);
}

HandStatus::Clutch HandControl::clutch() const
{
    const servo::TickRecord& tick = m_live.newest();
    if ((tick.flags & servo::kClutched) == 0) {
        return HandStatus::Clutch::None;
    }
    return m_isClutched || (tick.buttons & m_live.map().clutchButtons) != 0 ? HandStatus::Clutch::Asked
                                                                            : HandStatus::Clutch::AtEdge;
}

QString HandControl::inside() const
{
    const servo::TickRecord& tick = m_live.newest();
    if (m_live.map().isDirect || (tick.flags & servo::kNoHand) != 0 || tick.felt.structure >= 0) {
        return {};
    }
    for (const study::OpenStructure& one : m_model.rows()) {
        if (one.touch != nullptr && one.isListed() && study::canBeFelt(one.loaded.description) &&
            one.loaded.surface->report.isClosed() && geometry::isInside(*one.touch, tick.p_WH)) {
            return readableName(one.loaded.description.name);
        }
    }
    return {};
}

void HandControl::showStatus()
{
    const servo::TickRecord& tick = m_live.newest();
    HandStatus status;
    status.held_N_per_mm = m_live.heldStiffness_N_per_mm();
    status.isMapped = !m_live.map().isDirect;
    status.scale = status.isMapped ? m_live.map().scale : 1.0;
    status.filled = m_filled.name;
    status.force_N = tick.fSent_W.norm();
    status.clutch = clutch();
    status.inside = inside();
    m_panel.show(status);
}

} // namespace palpate::ui

#include "palpate/ui/moc_HandControl.cpp"
