// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandControl.h"

#include <QSettings>

#include <vtkCamera.h>

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
    connect(&model, &QAbstractItemModel::modelReset, this, &HandControl::centre);
    connect(&live, &LiveTouch::statusChanged, this, &HandControl::showStatus);
    takeDevice();
}

void HandControl::takeDevice()
{
    QSettings store;
    const device::DeviceInfo& info = m_live.deviceInfo();
    m_panel.setDevice(info, HandSettings::load(store, QString::fromStdString(info.id)));
    if (servo::edgeOf(info) > 0.0) {
        m_follow.start();
    } else {
        m_follow.stop();
    }
    centre();
    showStatus();
}

void HandControl::setClutched(bool isClutched)
{
    m_isClutched = isClutched;
    lay();
}

void HandControl::centre()
{
    ++m_centreRequest;
    lay();
}

void HandControl::keep()
{
    QSettings store;
    m_panel.settings().save(store, QString::fromStdString(m_live.deviceInfo().id));
    lay();
}

void HandControl::lay()
{
    const std::uint32_t buttons = m_live.newest().buttons;
    if ((buttons & ~m_buttonsBefore & m_panel.settings().buttonsFor(ButtonUse::Centre)) != 0) {
        ++m_centreRequest;
    }
    m_buttonsBefore = buttons;
    vtkCamera& camera = m_viewport.view().camera();
    HandPlace place;
    const core::Vec3 forward = core::Vec3(camera.GetDirectionOfProjection());
    place.right_W = forward.cross(core::Vec3(camera.GetViewUp())).normalized();
    place.up_W = place.right_W.cross(forward);
    place.scene = m_viewport.view().bounds();
    const int row = m_structures.currentRow();
    if (row >= 0 && row < m_model.rowCount()) {
        if (const auto& touch = m_model.rows()[static_cast<std::size_t>(row)].touch) {
            place.selection = touch->bounds();
        }
    }
    servo::MapSettings map = mapFor(m_panel.settings(), m_live.deviceInfo(), place);
    map.centreRequest = m_centreRequest;
    map.isClutched = m_isClutched;
    m_live.setMap(map);
}

void HandControl::showStatus()
{
    const servo::TickRecord& tick = m_live.newest();
    HandStatus status;
    status.held_N_per_mm = m_live.heldStiffness_N_per_mm();
    status.rate_Hz = m_live.rate_Hz();
    status.delayTicks = m_live.delayTicks();
    status.scale = m_live.map().isDirect ? 1.0 : m_live.map().scale;
    status.energy_mJ = tick.energy_mJ;
    status.damping_N = tick.fDamping_W.norm();
    status.isClutched = (tick.flags & servo::kClutched) != 0;
    status.timing = m_live.timing();
    status.realtime = m_live.realtime();
    m_panel.show(status);
}

} // namespace palpate::ui
