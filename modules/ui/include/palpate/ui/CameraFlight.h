// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/VtkViewport.h"

#include <palpate/core/ViewPose.h>

#include <QVariantAnimation>

namespace palpate::ui {

/// @return where the view's camera stands.
[[nodiscard]] core::ViewPose viewPose(VtkViewport& viewport);

/// On the way from one place to another: turned about what is looked at, rather than straight through the anatomy, and
/// about `from.up_W` where the two look from opposite sides.
/// @param share  of the way, 0 to 1
[[nodiscard]] core::ViewPose poseBetween(const core::ViewPose& from, const core::ViewPose& to, double share);

/// Moves the view's camera to another place in 0.3 s, and there exactly.
class CameraFlight : public QObject
{
    Q_OBJECT
  public:
    static constexpr int kTime_ms = 300;

    /// @param viewport  must outlive this
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
