// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/PlaceRing.h"
#include "palpate/view/TouchLabels.h"

#include <palpate/core/Export.h>

#include <vtkRenderer.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::view {

/// Target of an exercise after the search.
struct TargetMark
{
    core::Vec3 p_W = core::Vec3::Zero();  ///< place on the surface above the target, at rest [mm]
    core::Vec3 n_W = core::Vec3::UnitZ(); ///< outward unit normal there
    double radius_mm = 1.0;               ///< of the ball around the target, > 0
    std::string text;                     ///< result in words, such as "lump 12 mm: missed"
    bool isFound = false;
    std::optional<std::size_t> structure{}; ///< index in the view of the surface; the mark moves along
};

/// Shows the targets of an exercise: a ring on the surface above each and a text beside it. Tissue hides neither.
/// @par Thread The view's.
class PALPATE_EXPORT TargetMarks
{
  public:
    /// Sets the renderer. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    /// Replaces all marks.
    void set(std::vector<TargetMark> marks);
    /// Moves a mark to where its place at rest is now. @param i  index in `marks`
    void moveTo(std::size_t i, const core::Vec3& p_W, const core::Vec3& n_W);
    /// Place of a mark now. [mm]
    [[nodiscard]] const core::Vec3& place_W(std::size_t i) const { return m_shown[i].p_W; }
    /// Fits the texts to the view. Call before each frame.
    /// @param taken  boxes that the texts avoid, logical pixels from the centre of the view
    void place(const std::vector<Eigen::AlignedBox2d>& taken, const ViewFrame& frame);
    [[nodiscard]] const std::vector<TargetMark>& marks() const noexcept { return m_marks; }
    [[nodiscard]] std::vector<std::string> texts() const { return m_labels.texts(); }

  private:
    /// Where a mark is drawn.
    struct Shown
    {
        core::Vec3 p_W, n_W;
        PlaceRing* ring = nullptr;
    };
    std::vector<TargetMark> m_marks;
    std::vector<Shown> m_shown;                                ///< one for each mark
    std::vector<std::unique_ptr<PlaceRing>> m_found, m_missed; ///< never fewer than before; unused rings are hidden
    TouchLabels m_labels;
    vtkRenderer* m_overlay = nullptr;
};

} // namespace palpate::view
