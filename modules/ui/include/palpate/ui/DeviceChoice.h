// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/Playback.h"
#include "palpate/ui/PuckReader.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/device/PluginHost.h>

#include <QObject>

#include <array>
#include <memory>
#include <string>

class QAction;
class QActionGroup;
class QMenu;

namespace palpate::ui {

/// A device's name within a sentence: of those that are part of the program in the window's language, of others as
/// they say it themselves.
[[nodiscard]] QString deviceName(const device::DeviceInfo& info);

/// Which device the hand holds: mouse, simulated hand, the open recording played again, or a plugin's; and what a
/// 6-axis mouse moves. Says how the device is doing.
class DeviceChoice : public QObject
{
    Q_OBJECT
  public:
    /// All must outlive this.
    DeviceChoice(LiveTouch& live, VtkViewport& viewport, Playback& playback, QObject* parent = nullptr);
    ~DeviceChoice() override;

    /// Plugins to choose from; those that were skipped are named in the menu.
    void setPlugins(std::unique_ptr<device::PluginHost> plugins);
    /// Fills a menu with the choices, calibration and what else is on the bus.
    void fill(QMenu& menu);
    /// Takes another device. On failure the mouse is used. @param id  "mouse", "simulated", "playback" or a plugin's
    core::Status choose(const std::string& id);
    [[nodiscard]] const std::string& chosen() const noexcept { return m_chosen; }

    /// The device and its latency, short: "woodenhaptics 1.5 ms".
    [[nodiscard]] QString summary() const;
    /// All of it, in lines.
    [[nodiscard]] QString details() const;
    /// It cannot be felt with now.
    [[nodiscard]] bool isTroubled() const;

  Q_SIGNALS:
    void changed();
    /// A choice that could not be followed. @param line  why
    void refused(const QString& line);
    /// A 6-axis mouse is to press where the pointer is.
    void pressingWanted();
    /// It is pushed down. @param share  0 … 1 of its way; 0: it rests
    void pushed(double share);

  private:
    core::Result<std::unique_ptr<device::HapticDevice>> make(const std::string& id);
    core::Result<std::unique_ptr<device::HapticDevice>> makeSimulated();
    core::Result<std::unique_ptr<device::HapticDevice>> makePlayback();
    /// What a 6-axis mouse does that is not the hand.
    enum class PuckUse
    {
        Nothing,
        MovesView,
        Presses
    };
    void addPuck(QMenu& menu);
    void usePuck(PuckUse use);
    void takePuck(const device::DeviceState& from, const device::DeviceState& to, double passed_s);
    void tellWhatIsOnTheBus();

    LiveTouch& m_live;
    VtkViewport& m_viewport;
    Playback& m_playback;
    PuckReader m_puck;
    PuckUse m_puckUse = PuckUse::Nothing;
    std::array<QAction*, 2> m_puckActions{}; ///< for view and press; null without its plugin
    std::unique_ptr<device::PluginHost> m_plugins;
    std::string m_chosen = "mouse";
    QActionGroup* m_group = nullptr;
};

} // namespace palpate::ui
