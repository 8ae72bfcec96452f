// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/device/OtherDevices.h>
#include <palpate/device/PluginHost.h>

#include <QDialog>
#include <QString>

#include <string>
#include <vector>

class QTableWidget;

namespace palpate::ui {

/// Devices that one plugin drives, and what the user can do to touch with them.
struct DeviceFamily
{
    enum class State
    {
        Ready,        ///< a connected device can be chosen
        NotReady,     ///< a connected device cannot be used yet
        NotConnected, ///< the program drives the device, and none is connected
        Unavailable   ///< driver or library of the maker is missing
    };
    QString name; ///< "3D Systems Touch"
    State state = State::NotConnected;
    QString stateText; ///< one line for the user
    QString nextStep;  ///< for the user
};

/// What a user does to connect a device of a known plugin; empty for other plugins.
[[nodiscard]] PALPATE_EXPORT QString stepsToConnect(const std::string& plugin);

/// Looks for the devices of all known makers, first, and of all other plugins of the host.
/// @param host  null: without plugins
/// @param onBus  recognised USB devices
/// @par Thread That of the host. May take seconds: plugins are loaded in another process first.
[[nodiscard]] PALPATE_EXPORT std::vector<DeviceFamily> deviceFamilies(device::PluginHost* host,
                                                                      const std::vector<device::OtherDevice>& onBus);

/// Table of the devices with state and next step. Opens with the result of a search; a button searches again.
class PALPATE_EXPORT ConnectedDevices : public QDialog
{
    Q_OBJECT
  public:
    /// @param host  null or must outlive the dialog
    explicit ConnectedDevices(device::PluginHost* host, QWidget* parent = nullptr);

  private:
    void search();

    device::PluginHost* m_host = nullptr;
    QTableWidget* m_table = nullptr;
};

} // namespace palpate::ui
