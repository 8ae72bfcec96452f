// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/Playback.h"
#include "palpate/ui/PuckReader.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Export.h>
#include <palpate/device/PluginHost.h>

#include <QObject>

#include <array>
#include <memory>
#include <string>

class QAction;
class QActionGroup;
class QMenu;

namespace palpate::ui {

/// Device name for use within a sentence. Names of built-in devices are translated; plugins provide their own.
[[nodiscard]] PALPATE_EXPORT QString deviceName(const device::DeviceInfo& info);

/// Selects the haptic device (mouse, simulated hand, playback of the open recording, or a plugin's device) and the role
/// of a 6-axis mouse. Reports the device's state.
class PALPATE_EXPORT DeviceChoice : public QObject
{
    Q_OBJECT
  public:
    /// All references must outlive this object.
    DeviceChoice(LiveTouch& live, VtkViewport& viewport, Playback& playback, QObject* parent = nullptr);
    ~DeviceChoice() override;

    /// Takes the plugins to choose from. The menu also names plugins that were skipped.
    void setPlugins(std::unique_ptr<device::PluginHost> plugins);
    /// Fills a menu with the devices, calibration and the other devices on the bus.
    void fill(QMenu& menu);
    /// Switches to another device. Falls back to the mouse when the device does not start; keeps the current device
    /// when the new one cannot be created.
    /// @param id  "mouse", "simulated", "playback" or a plugin's id
    core::Status choose(const std::string& id);
    [[nodiscard]] const std::string& chosen() const noexcept { return m_chosen; }

    /// Device name, with the condition of a device that does not work: "woodenhaptics lost", "woodenhaptics:
    /// calibrate".
    [[nodiscard]] QString summary() const;
    /// Full device report, one fact per line.
    [[nodiscard]] QString details() const;
    /// True while the device cannot be used for touch.
    [[nodiscard]] bool isTroubled() const;

  Q_SIGNALS:
    void changed();
    /// Emitted when a choice failed. @param line  reason, for the user
    void refused(const QString& line);
    /// Emitted when the 6-axis mouse was chosen to press at the pointer.
    void pressingWanted();
    /// Emitted while the 6-axis mouse is pushed down. @param share  fraction of full deflection, 0 to 1; 0: at rest
    void pushed(double share);

  private:
    core::Result<std::unique_ptr<device::HapticDevice>> make(const std::string& id);
    core::Result<std::unique_ptr<device::HapticDevice>> makeSimulated();
    core::Result<std::unique_ptr<device::HapticDevice>> makePlayback();
    /// Role of a 6-axis mouse that is not the haptic device.
    enum class SixAxisMouseUse
    {
        Nothing,
        MovesView,
        Presses
    };
    void addPuck(QMenu& menu);
    void usePuck(SixAxisMouseUse use);
    void takePuck(const device::DeviceState& from, const device::DeviceState& to, double passed_s);
    void reportBusDevices();

    LiveTouch& m_live;
    VtkViewport& m_viewport;
    Playback& m_playback;
    PuckReader m_puck;
    SixAxisMouseUse m_puckUse = SixAxisMouseUse::Nothing;
    std::array<QAction*, 2> m_puckActions{}; ///< view and press; null without the plugin
    std::unique_ptr<device::PluginHost> m_plugins;
    std::string m_chosen = "mouse";
    QActionGroup* m_group = nullptr;
};

} // namespace palpate::ui
