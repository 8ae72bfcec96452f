// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QDialog>
#include <QPointer>

#include <memory>
#include <optional>
#include <string>

namespace palpate::device {
class PluginHost;
}

namespace palpate::ui {
class Chip;
class DeviceChoice;
class HandControl;
class HandPanel;
class PalpationController;
struct HandSettings;
} // namespace palpate::ui

namespace palpate::app {

class RecordingPart;
class StructuresPart;
class TouchPart;

/// The haptic device: choice, state, and the map from the device's workspace into the scene.
class DevicePart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    DevicePart(const WindowCore& core, StructuresPart& structures, TouchPart& touch, RecordingPart& recording);
    ~DevicePart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    /// Takes the device plugins and adds the Device menu. Call once, before `choose`.
    void setPlugins(std::unique_ptr<device::PluginHost> plugins);
    /// Chooses a device, once a scene is open: the simulated hand needs a scene, the playback device an open recording.
    /// @param id  "mouse", "simulated", "playback" or a plugin's id
    void choose(const std::string& id);
    /// Chooses a device that waits for a scene.
    void chooseWaiting();
    [[nodiscard]] ui::HandControl& hand() noexcept { return *m_hand; }
    /// Instruction how to touch with the chosen device.
    [[nodiscard]] QString howToTouch() const;

  Q_SIGNALS:
    /// A device could not be used.
    void refused(const QString& line);

  private:
    void connectDevices(StructuresPart& structures);
    void use(const std::string& id);
    void takePress(const ui::HandSettings& settings);
    void showDevice();
    void addTests();
    void showTests(bool isRecording);
    void checkAxes();
    void measureThreshold();
    void tellFault(const QString& line);

    WindowCore m_core;
    ui::PalpationController& m_palpation;
    ui::HandPanel* m_panel = nullptr;
    ui::HandControl* m_hand = nullptr;
    ui::DeviceChoice* m_devices = nullptr;
    ui::Chip& m_chip;
    std::optional<std::string> m_waiting; ///< device that waits for a scene
    QPointer<QDialog> m_test;             ///< open test of the device
    QString m_axesOffer;                  ///< text of the open offer to check the axes
};

} // namespace palpate::app
