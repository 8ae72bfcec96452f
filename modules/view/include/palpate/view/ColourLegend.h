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

/// Colour legend of a structure in a corner of the view: a colour bar with title, unit and numbers. A legend with marks
/// is wider, and has a brief form for views where it would hide tissue.
class PALPATE_EXPORT ColourLegend
{
  public:
    /// Labelled value beside the bar, for example a threshold.
    struct Mark
    {
        double value = 0.0;
        std::string text;
        std::string brief{}; ///< text of the brief form; empty: `text`
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
        std::string briefTitle{};   ///< title of the brief form; empty: `title`
        std::string briefUnknown{}; ///< label of the grey box in the brief form; empty: `unknown`
    };

    ColourLegend();
    void addTo(vtkRenderer& renderer);
    void show(const Content& content);
    void hide();
    /// Drawn: has a content and is not closed.
    [[nodiscard]] bool isShown() const { return m_bar->GetVisibility() != 0; }
    /// Keeps the legend out of sight until it is opened again, whatever its content.
    void setClosed(bool isClosed);
    [[nodiscard]] bool isClosed() const noexcept { return m_isClosed; }
    /// Shows title and marks in few letters.
    void setBrief(bool isBrief);
    [[nodiscard]] bool isBrief() const noexcept { return m_isBrief; }
    /// Draws the sign that closes the legend, while the pointer is over it.
    void setHovered(bool isHovered);
    [[nodiscard]] bool isHovered() const noexcept { return m_isHovered; }
    /// Moves the legend out of its corner while it is dragged. @param offset_px  logical pixels, y up
    void setOffset(const Eigen::Vector2d& offset_px) { m_offset_px = offset_px; }
    /// Texts from top to bottom: title, maximum, middle and minimum number, and the label of the grey box if shown.
    [[nodiscard]] std::array<std::string, 5> texts() const;
    /// Texts of the marks, lowest value first.
    [[nodiscard]] std::vector<std::string> markTexts() const;
    /// Position in the view. The lower corners are above the orientation cube (left) and the scale bar (right).
    enum class Corner
    {
        UpperLeft,
        LowerRight,
        UpperRight,
        LowerLeft
    };
    static constexpr Corner kCorners[] = {Corner::UpperLeft, Corner::LowerRight, Corner::UpperRight, Corner::LowerLeft};
    void setCorner(Corner corner) noexcept { m_corner = corner; }
    [[nodiscard]] Corner corner() const noexcept { return m_corner; }
    /// Number of times that the legend appeared or got another number of marks.
    [[nodiscard]] std::size_t revision() const noexcept { return m_revision; }
    [[nodiscard]] bool hasMarks() const noexcept { return !m_marks.empty(); }
    /// Upper edges of the objects below the legend in each corner, and the heights that something covers at the top of
    /// the view. [logical px]
    struct Below
    {
        double cube_px = 0.0, scale_px = 0.0, coveredLeft_px = 0.0, coveredRight_px = 0.0;
    };
    /// Lays out the legend. @param renderer  the renderer that contains the legend
    void place(vtkRenderer& renderer, const ViewFrame& frame, const Below& below);
    /// Bounding box after `place`, so that other labels can avoid the legend. Empty while hidden. Logical pixels from
    /// the centre of the view.
    [[nodiscard]] Eigen::AlignedBox2d box() const { return isShown() ? m_box : Eigen::AlignedBox2d(); }
    /// Place of the sign that closes the legend, drawn or not, as `box`.
    [[nodiscard]] Eigen::AlignedBox2d closeBox() const { return isShown() ? m_closeBox : Eigen::AlignedBox2d(); }

  private:
    /// Layout of the bar and the grey box. [device px]
    struct Place
    {
        double left, right, low, high, greyLow, greyHigh, pixelRatio, letter;
    };
    [[nodiscard]] double heightWithMarks(double letter) const;
    [[nodiscard]] double titleHeight(double letter) const;
    [[nodiscard]] double lead_px() const noexcept;
    [[nodiscard]] TextStyle fitting(vtkRenderer& renderer, const ViewFrame& frame, double below_px, double height);
    [[nodiscard]] double reach(vtkRenderer& renderer, const TextStyle& style, double pixelRatio);
    void placeMarks(const Place& at);
    void placeLines(const Place& at);
    void write();
    void setVisibilities();

    vtkSmartPointer<vtkActor2D> m_back; ///< dark background, for contrast on bright tissue
    vtkSmartPointer<vtkActor2D> m_bar;
    vtkSmartPointer<vtkActor2D> m_grey;
    std::array<vtkSmartPointer<vtkTextActor>, 5> m_texts;
    vtkSmartPointer<vtkTextActor> m_close; ///< sign in the upper right corner of the legend
    Eigen::AlignedBox2d m_box, m_closeBox;
    Eigen::Vector2d m_offset_px = Eigen::Vector2d::Zero();
    Corner m_corner = Corner::LowerLeft;
    std::size_t m_revision = 0;
    Content m_content;
    bool m_hasContent = false, m_isClosed = false, m_isBrief = false, m_isHovered = false;
    bool m_hasUnknown = false;
    int m_steps = 0; ///< 0: the colour map
    ColourRange m_range;
    std::vector<Mark> m_marks;
    std::array<vtkSmartPointer<vtkTextActor>, kMaxMarks> m_markTexts;
    vtkSmartPointer<vtkActor2D> m_lines; ///< leader lines of the marks, and the hatching
};

} // namespace palpate::view
