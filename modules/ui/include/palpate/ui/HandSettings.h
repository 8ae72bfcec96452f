// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Effort.h"

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/servo/WorkspaceMap.h>

#include <QString>

#include <array>
#include <string>

class QSettings;

namespace palpate::ui {

/// Reference frame that the device axes follow.
enum class MapTurn
{
    Camera,  ///< device right is screen right
    Patient, ///< device right is patient left and device up is towards the head, as seen by an examiner in front of the
             ///< patient
    None,    ///< no mapping: device coordinates are scene coordinates, without a clutch
};

/// Region that fills the device's workspace.
enum class MapFill
{
    Scene,
    Organ, ///< one structure
    Lump,  ///< 10 mm around a place
    Scale, ///< fixed scale instead of a region
};

/// Function of a device button.
enum class ButtonUse
{
    Nothing,
    Clutch,
    Centre,
};

/// Mapping settings of a device, saved per device id.
struct PALPATE_EXPORT HandSettings
{
    static constexpr int kButtons = 4;

    MapTurn turn = MapTurn::Camera;
    MapFill fill = MapFill::Scene;      ///< Organ and Lump are temporary choices and saved as Scene
    double scale = 1.0;                 ///< used with MapFill::Scale
    int rate_kHz = 1;                   ///< servo rate: 1, 2 or 4
    int cpu = -1;                       ///< CPU reserved for the servo loop; -1: any
    bool isByEffort = false;            ///< pointer only: a press sets a force, the depth follows
    double effort_N = Effort::kUsual_N; ///< force limit of a press by effort
    std::string preset = "touch";       ///< simulated hand only: device with the limits of this preset
    bool isLeftHanded = false;          ///< swaps the first two buttons, since the thumb is on the other side
    std::array<ButtonUse, kButtons> buttons{ButtonUse::Clutch, ButtonUse::Centre, ButtonUse::Nothing,
                                            ButtonUse::Nothing};

    /// Loads the settings of a device. @param id  device id, see device::DeviceInfo
    static HandSettings load(const QSettings& store, const QString& id);
    void save(QSettings& store, const QString& id) const;

    /// Bit mask of the buttons with this function, with left-handed swapping applied.
    [[nodiscard]] std::uint32_t buttonsFor(ButtonUse use) const;
};

/// View axes and region for which a map is computed.
struct HandPlace
{
    core::Vec3 right_W = core::Vec3::UnitX(); ///< screen right, unit vector
    core::Vec3 up_W = core::Vec3::UnitY();    ///< screen up, unit vector
    core::Box filled;                         ///< region that fills the workspace [mm]
};

/// Box with the size of a lump around a place. [mm]
[[nodiscard]] PALPATE_EXPORT core::Box lumpAt(const core::Vec3& p_W);

/// Computes the servo's workspace map. A margin around the filled region lets the hand approach from outside. Devices
/// without a workspace (mouse, simulated hand) stay unmapped. Rate-controlled devices have no edge; their centre is
/// placed in front of the region, so that a hand starting anywhere does not start inside the anatomy.
[[nodiscard]] PALPATE_EXPORT servo::MapSettings mapFor(const HandSettings& settings, const device::DeviceInfo& info,
                                                       const HandPlace& place);

} // namespace palpate::ui
