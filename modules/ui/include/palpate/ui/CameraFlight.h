// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Export.h>
#include <palpate/core/ViewPose.h>

#include <QVariantAnimation>

namespace palpate::ui {

/// Current pose of the view's camera.
[[nodiscard]] PALPATE_EXPORT core::ViewPose viewPose(VtkViewport& viewport);

/// Interpolates between two camera poses. The camera orbits the focal point, so that it does not pass through the
/// anatomy. For opposite viewing directions it rotates about `from.up_W`.
/// @param share  fraction of the path, 0 to 1
[[nodiscard]] PALPATE_EXPORT core::ViewPose poseBetween(const core::ViewPose& from, const core::ViewPose& to,
                                                        double share);

/// Animates the view's camera to a pose within 0.3 s. The final pose is exact.
class PALPATE_EXPORT CameraFlight : public QObject
{
    Q_OBJECT
  public:
    static constexpr int kTime_ms = 300;

    /// @param viewport  must outlive this object
    explicit CameraFlight(VtkViewport& viewport, QObject* parent = nullptr);
    void flyTo(const core::ViewPose& to);

  private:
    void show(const core::ViewPose& pose);

    VtkViewport& m_viewport;
    QVariantAnimation m_clock;
    core::ViewPose m_from;
    core::ViewPose m_to;
};

} // namespace palpate::ui
