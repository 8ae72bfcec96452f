// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Effort.h"

#include <palpate/device/HapticDevice.h>
#include <palpate/servo/WorkspaceMap.h>

#include <QString>

#include <array>

class QSettings;

namespace palpate::ui {

/// What the device turns with.
enum class MapTurn
{
    Camera,  ///< to the right is to the right in the picture
    Patient, ///< to the right is to the patient's left, up is to the head: as one who stands before the patient
    None,    ///< nothing is mapped: the device's coordinates are the scene's, no clutch
};

/// What fills the device's workspace.
enum class MapFill
{
    Scene,
    Organ, ///< one structure
    Lump,  ///< 10 mm about a place
    Scale, ///< nothing: a scale by number
};

/// What a button of the device does.
enum class ButtonUse
{
    Nothing,
    Clutch,
    Centre,
};

/// How a person wants a device to lie in the scene; kept for each device by itself.
struct HandSettings
{
    static constexpr int kButtons = 4;

    MapTurn turn = MapTurn::Camera;
    MapFill fill = MapFill::Scene;      ///< organ and lump are this moment's choice: kept as the scene
    double scale = 1.0;                 ///< with MapFill::Scale
    int rate_kHz = 1;                   ///< of the servo loop: 1, 2 or 4
    int cpu = -1;                       ///< that the servo loop runs on alone; -1: on any
    bool isByEffort = false;            ///< of the pointer: a press has a force, and the depth follows
    double effort_N = Effort::kUsual_N; ///< that force at most
    bool isLeftHanded = false;          ///< the first two buttons change places: the thumb's is on the other side
    std::array<ButtonUse, kButtons> buttons{ButtonUse::Clutch, ButtonUse::Centre, ButtonUse::Nothing,
                                            ButtonUse::Nothing};

    /// @param id  of the device, see device::DeviceInfo
    static HandSettings load(QSettings& store, const QString& id);
    void save(QSettings& store, const QString& id) const;

    /// Bits of the device's buttons with this use, as the hand that holds it reaches them.
    [[nodiscard]] std::uint32_t buttonsFor(ButtonUse use) const;
};

/// What the map is made for.
struct HandPlace
{
    core::Vec3 right_W = core::Vec3::UnitX(); ///< of the picture, unit
    core::Vec3 up_W = core::Vec3::UnitY();    ///< of the picture, unit
    core::Box filled;                         ///< what fills the workspace [mm]
};

/// A lump's size, about a place. [mm]
[[nodiscard]] core::Box lumpAt(const core::Vec3& p_W);

/// Makes the servo's map. What fills the workspace has room around it, so that it can be come at from outside. A device
/// without a workspace of its own (mouse, simulated hand) stays direct; one that is a speed has no edge, and its centre
/// is before what fills it: it may begin anywhere, so it does not begin inside.
[[nodiscard]] servo::MapSettings mapFor(const HandSettings& settings, const device::DeviceInfo& info,
                                        const HandPlace& place);

} // namespace palpate::ui
