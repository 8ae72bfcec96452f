// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/VtkViewport.h"

#include <palpate/device/HapticDevice.h>

#include <QObject>
#include <QTimer>

#include <memory>

class vtkCamera;

namespace palpate::ui {

/// Moves a camera as if the anatomy followed a hand that moved and turned: x right, y away from the viewer, z up in the
/// picture. Shifts grow with the camera's distance.
/// @param from,to  the hand's poses before and after
void moveWithHand(vtkCamera& camera, const device::DeviceState& from, const device::DeviceState& to);

/// Lets a device that is rate-controlled and senses a pose move the view instead of the hand.
class PuckCamera : public QObject
{
    Q_OBJECT
  public:
    explicit PuckCamera(VtkViewport& viewport, QObject* parent = nullptr);
    ~PuckCamera() override;

    /// Starts it; null stops the one in use.
    core::Status use(std::unique_ptr<device::HapticDevice> device);
    [[nodiscard]] bool isOn() const noexcept { return m_device != nullptr; }

  private:
    void step();

    VtkViewport& m_viewport;
    std::unique_ptr<device::HapticDevice> m_device;
    device::DeviceState m_last;
    QTimer m_timer;
};

} // namespace palpate::ui
