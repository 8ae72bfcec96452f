// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/HapticDevice.h>

#include <QObject>
#include <QTimer>

#include <memory>

class vtkCamera;

namespace palpate::ui {

/// Reads a rate-controlled device that is not the hand, such as a 6-axis mouse, at display rate; where its reach ends
/// it goes on from its origin.
class PuckReader : public QObject
{
    Q_OBJECT
  public:
    explicit PuckReader(QObject* parent = nullptr);
    ~PuckReader() override;

    /// Starts it; null stops the one in use.
    core::Status use(std::unique_ptr<device::HapticDevice> device);
    [[nodiscard]] bool isOn() const noexcept { return m_device != nullptr; }

  Q_SIGNALS:
    /// At each step: the hand's poses before and after; `isPresent` is false while the device is gone.
    void moved(const palpate::device::DeviceState& from, const palpate::device::DeviceState& to, double passed_s);

  private:
    void step();

    std::unique_ptr<device::HapticDevice> m_device;
    device::DeviceState m_last;
    std::int64_t m_last_ns = 0;
    int m_recentring = 0; ///< steps in which it may still be on its way back to the origin
    QTimer m_timer;
};

/// Moves a camera as if the anatomy followed a hand that moved and turned: x right, y away from the viewer, z up in the
/// picture. Shifts grow with the camera's distance.
/// @param from,to  the hand's poses before and after
void moveWithHand(vtkCamera& camera, const device::DeviceState& from, const device::DeviceState& to);

/// How hard a puck is pushed down: its speed against z, as a share of the 60 mm/s that the 6-axis mouse's plugin gives
/// it at full way as it comes. A share below 0.02 is a hand that rests.
/// @return 0 … 1; 0 where nothing is measured
[[nodiscard]] double pushOf(const device::DeviceState& from, const device::DeviceState& to, double passed_s) noexcept;

} // namespace palpate::ui
