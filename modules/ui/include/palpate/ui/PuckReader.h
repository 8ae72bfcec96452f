// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>

#include <QObject>
#include <QTimer>

#include <memory>

class vtkCamera;

namespace palpate::ui {

/// Polls a rate-controlled input device, such as a 6-axis mouse, at display rate. Used for devices that are not the
/// haptic device. At the end of the range the device is recentred, so that motion continues.
class PALPATE_EXPORT PuckReader : public QObject
{
    Q_OBJECT
  public:
    explicit PuckReader(QObject* parent = nullptr);
    ~PuckReader() override;

    /// Starts a device; null stops the current one.
    core::Status use(std::unique_ptr<device::HapticDevice> device);
    [[nodiscard]] bool isOn() const noexcept { return m_device != nullptr; }

  Q_SIGNALS:
    /// Emitted at each step with the poses before and after. `isPresent` is false while the device is disconnected.
    void moved(const palpate::device::DeviceState& from, const palpate::device::DeviceState& to, double passed_s);

  private:
    void step();

    std::unique_ptr<device::HapticDevice> m_device;
    device::DeviceState m_last;
    std::int64_t m_last_ns = 0;
    int m_recentring = 0; ///< steps left for the return to the origin
    QTimer m_timer;
};

/// Moves a camera as if the anatomy followed the motion of a hand: x right, y away from the viewer, z up on the screen.
/// Translations scale with the camera's distance.
/// @param from,to  hand poses before and after
PALPATE_EXPORT void moveWithHand(vtkCamera& camera, const device::DeviceState& from, const device::DeviceState& to);

/// Push strength of a 6-axis mouse: downward speed divided by 60 mm/s, the plugin's default at full deflection. Values
/// below 0.02 count as rest.
/// @return 0 to 1; 0 without a measurement
[[nodiscard]] PALPATE_EXPORT double pushOf(const device::DeviceState& from, const device::DeviceState& to,
                                           double passed_s) noexcept;

} // namespace palpate::ui
