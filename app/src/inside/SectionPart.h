// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/core/Types.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/FingerInset.h>
#include <palpate/ui/SectionBar.h>

class SceneDocument;

namespace palpate::app {

/// Section of the anatomy: commands, the bar in the view and the plane; and the small section along the finger.
class SectionPart : public WindowPart
{
    Q_OBJECT
  public:
    /// @param document  holds the plane; must outlive this part
    SectionPart(const WindowCore& core, SceneDocument& document);
    ~SectionPart() override;
    void addActions() override;
    void showState(const WindowState& state) override;
    [[nodiscard]] ui::SectionBar& bar() noexcept { return *m_bar; }

  private:
    void setShown(bool isShown);
    void take();
    void setDirection(meshio::SectionDirection direction);
    void setDirection(meshio::SectionDirection direction, const core::Vec3& p_W);
    void goThrough(const core::Vec3& p_W);
    void move(double deeper_mm);
    void moveTo(double position_mm);
    void turnOver();
    void show();
    [[nodiscard]] core::Vec3 wantedPlace() const;
    [[nodiscard]] core::Vec3 towardsCamera(const core::Vec3& axis_W) const;
    [[nodiscard]] double step_mm() const;
    [[nodiscard]] double position_mm() const;
    [[nodiscard]] QString lineOf(double position_mm) const;

    WindowCore m_core;
    SceneDocument& m_document;
    ui::SectionBar* m_bar = nullptr;
    ui::FingerInset* m_inset = nullptr;
    meshio::SceneSection m_plane;              ///< shown, or the latest one
    core::Vec3 m_start_W = core::Vec3::Zero(); ///< where a free section was placed: the origin of its position [mm]
    core::Vec3 m_axis_W = core::Vec3::UnitZ(); ///< direction of increasing position
};

} // namespace palpate::app
