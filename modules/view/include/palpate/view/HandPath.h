// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace palpate::view {

/// Position of a recorded hand.
struct PathPoint
{
    core::Vec3 p_W = core::Vec3::Zero(); ///< finite [mm]
    bool isTouching = false;             ///< the contact force is not zero
    bool isContinued = true;             ///< false: the hand appears here, without a line from the point before
};

/// Path of a recorded hand as a line, thick where the hand touched. For recordings without the touched surfaces.
/// @par Thread The view's.
class PALPATE_EXPORT HandPath
{
  public:
    HandPath();
    /// Adds the actors. @param renderer  must outlive this
    void addTo(vtkRenderer& renderer);
    /// Replaces the path. @param points  in the order of time; empty: nothing is drawn
    /// @par Cost O(points); thousands are drawn without delay
    void set(const std::vector<PathPoint>& points);
    [[nodiscard]] bool isShown() const noexcept { return !m_box.isEmpty(); }
    /// Bounding box [mm]; empty without a path.
    [[nodiscard]] const core::Box& bounds() const noexcept { return m_box; }

  private:
    vtkSmartPointer<vtkActor> m_free, m_touching;
    core::Box m_box;
};

} // namespace palpate::view
