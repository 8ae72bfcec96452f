// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/SurfaceColours.h"

#include <palpate/core/Export.h>

#include <Eigen/Geometry>

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

namespace palpate::view {

/// Colour legend of a structure: a colour bar at the left of the view with title, unit and numbers. A legend with
/// marks is wider and is placed in the corner where it hides less tissue.
class PALPATE_EXPORT ColourLegend
{
  public:
    /// Labelled value beside the bar, for example a threshold.
    struct Mark
    {
        double value = 0.0;
        std::string text;
    };
    static constexpr std::size_t kMaxMarks = 5;
    /// Contents of the legend; all texts are UTF-8.
    struct Content
    {
        std::string title;   ///< structure, quantity and unit; may have several lines
        std::string unknown; ///< label of the grey box (values not known)
        ColourRange range;
        std::string decimalPoint = "."; ///< decimal separator of the numbers
        /// At most kMaxMarks, ascending. Marks replace the numbers beside the bar, and the box for unknown values is
        /// hatched.
        std::vector<Mark> marks{};
        /// Equal steps of these colours, from the bottom, instead of the colour map; empty: the colour map.
        std::vector<Colour> steps{};
    };

    ColourLegend();
    void addTo(vtkRenderer& renderer);
    void show(const Content& content);
    void hide();
    [[nodiscard]] bool isShown() const { return m_bar->GetVisibility() != 0; }
    /// Texts from top to bottom: title, maximum, middle and minimum number, and the label of the grey box if shown.
    [[nodiscard]] std::array<std::string, 5> texts() const;
    /// Texts of the marks, lowest value first.
    [[nodiscard]] std::vector<std::string> markTexts() const;
    /// Position in the view: at the left above the orientation cube or, only with marks, at the right above the scale
    /// bar.
    enum class Corner
    {
        UpperLeft,
        LowerRight
    };
    void setCorner(Corner corner) noexcept { m_corner = corner; }
    /// Number of content changes so far.
    [[nodiscard]] std::size_t revision() const noexcept { return m_revision; }
    [[nodiscard]] bool hasMarks() const noexcept { return !m_marks.empty(); }
    /// Upper edges of the objects below the legend in each corner, and the height that something covers at the top of
    /// the view. [logical px]
    struct Below
    {
        double cube_px = 0.0, scale_px = 0.0, covered_px = 0.0;
    };
    /// Lays out the legend. @param renderer  the renderer that contains the legend
    void place(vtkRenderer& renderer, const ViewFrame& frame, const Below& below);
    /// Bounding box after `place`, so that other labels can avoid the legend. Empty while hidden. Logical pixels from
    /// the centre of the view.
    [[nodiscard]] Eigen::AlignedBox2d box() const { return isShown() ? m_box : Eigen::AlignedBox2d(); }

  private:
    /// Layout of the bar and the grey box. [device px]
    struct Place
    {
        double left, right, low, high, greyLow, greyHigh, pixelRatio, letter;
    };
    [[nodiscard]] double heightWithMarks(double letter) const;
    [[nodiscard]] TextStyle fitting(vtkRenderer& renderer, const ViewFrame& frame, double below_px, double height);
    [[nodiscard]] double reach(vtkRenderer& renderer, const TextStyle& style, double pixelRatio);
    void placeMarks(const Place& at);
    void placeLines(const Place& at);

    vtkSmartPointer<vtkActor2D> m_back; ///< dark background, for contrast on bright tissue
    vtkSmartPointer<vtkActor2D> m_bar;
    vtkSmartPointer<vtkActor2D> m_grey;
    std::array<vtkSmartPointer<vtkTextActor>, 5> m_texts;
    Eigen::AlignedBox2d m_box;
    Corner m_corner = Corner::UpperLeft;
    std::size_t m_revision = 0;
    bool m_hasUnknown = false;
    int m_steps = 0; ///< 0: the colour map
    ColourRange m_range;
    std::vector<Mark> m_marks;
    std::array<vtkSmartPointer<vtkTextActor>, kMaxMarks> m_markTexts;
    vtkSmartPointer<vtkActor2D> m_lines; ///< leader lines of the marks, and the hatching
};

} // namespace palpate::view
