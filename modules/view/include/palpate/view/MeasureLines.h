// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/TouchLabels.h"

#include <palpate/core/Export.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace palpate::view {

/// Straight line between two places with a text.
struct MeasureLine
{
    Vec3 from_W = Vec3::Zero(); ///< [mm]
    Vec3 to_W = Vec3::Zero();   ///< equal to `from_W`: a single place, drawn as a point
    std::string text{};         ///< UTF-8: "12.3 mm"
    Colour colour{1.0, 1.0, 1.0};
    bool isWide = false;      ///< selected
    bool isTextAtEnd = false; ///< text beyond `to_W` instead of beside the middle

    friend bool operator==(const MeasureLine&, const MeasureLine&) = default;
};

/// Lines of measured distances, of constant width on screen, with end points and texts. Tissue does not hide them.
/// @par Thread The view's.
class PALPATE_EXPORT MeasureLines
{
  public:
    /// Adds the actors. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    void set(std::vector<MeasureLine> lines);
    [[nodiscard]] const std::vector<MeasureLine>& lines() const noexcept { return m_lines; }
    /// Fits lines and texts to the view. Call before each frame.
    /// @param taken  boxes that texts avoid, logical pixels from the centre of the view
    /// @param isOff  tells of a place that it is far from the plane that is shown; a line with such an end is faint.
    /// Empty: none is
    void place(const ViewFrame& frame, std::vector<Eigen::AlignedBox2d> taken,
               const std::function<bool(const Vec3& p_W)>& isOff = {});
    /// Opacity of faint lines.
    static constexpr double kFaintOpacity = 0.3;
    /// Returns whether a line was drawn faint, after `place`.
    [[nodiscard]] bool isFaint(std::size_t i) const { return m_drawn[i].isFaint; }
    /// Bounding box, for the clipping range [mm]; empty without lines.
    [[nodiscard]] core::Box bounds() const;
    /// Texts as drawn, in the order of the lines.
    [[nodiscard]] std::vector<std::string> texts() const { return m_labels.texts(); }

  private:
    /// One drawn line: dark rim and colour of the line, each with two end points.
    struct Drawn
    {
        std::array<BillboardLine, 2> line;
        std::array<std::array<vtkSmartPointer<vtkActor>, 2>, 2> ends;
        bool isFaint = false;
    };
    void add(const MeasureLine& line);

    std::vector<MeasureLine> m_lines;
    std::vector<Drawn> m_drawn; ///< one for each line
    TouchLabels m_labels;
    vtkRenderer* m_overlay = nullptr;
};

} // namespace palpate::view
