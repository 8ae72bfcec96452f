// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
};

/// What fills the device's workspace.
enum class MapFill
{
    Scene,
    Selection, ///< the structure that is selected
    Lump,      ///< 10 mm
    Scale,     ///< nothing: a scale by number
    Direct,    ///< nothing: the device's coordinates are the scene's, no clutch
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
    MapFill fill = MapFill::Direct;
    double scale = 1.0;        ///< with MapFill::Scale
    bool isLeftHanded = false; ///< the first two buttons change places: the thumb's is on the other side
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
    core::Box scene;                          ///< of all that is shown [mm]
    core::Box selection;                      ///< of the selected structure [mm]
};

/// Makes the servo's map. A device without a workspace of its own (mouse, simulated hand) stays direct.
[[nodiscard]] servo::MapSettings mapFor(const HandSettings& settings, const device::DeviceInfo& info,
                                        const HandPlace& place);

} // namespace palpate::ui
