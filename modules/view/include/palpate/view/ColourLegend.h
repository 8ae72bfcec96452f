// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/SurfaceColours.h"

#include <Eigen/Geometry>

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

namespace palpate::view {

/// What the colours of a structure say: a bar of them at the left of the view with its name, unit and numbers. With
/// marks it is wide, and stands in the corner where it hides less of the tissue.
class ColourLegend
{
  public:
    /// A number that means something, and what.
    struct Mark
    {
        double value = 0.0;
        std::string text;
    };
    static constexpr std::size_t kMostMarks = 5;
    /// What it says, UTF-8.
    struct Content
    {
        std::string title;   ///< what is coloured, by what and in which unit; lines
        std::string unknown; ///< what grey means
        ColourRange range;
        std::string decimalPoint = "."; ///< of the numbers
        /// Ascending, at most kMostMarks: they stand beside the bar in place of its numbers, and what is unknown is
        /// hatched.
        std::vector<Mark> marks{};
    };

    ColourLegend();
    void addTo(vtkRenderer& renderer);
    void show(const Content& content);
    void hide();
    [[nodiscard]] bool isShown() const { return m_bar->GetVisibility() != 0; }
    /// Its words from the top: title, largest, middle, least number, and what grey means where it is there.
    [[nodiscard]] std::array<std::string, 5> texts() const;
    /// The marks' words, from the lowest.
    [[nodiscard]] std::vector<std::string> markTexts() const;
    /// Where it may stand: at the left above the cube, or, with marks, at the right above the scale.
    enum class Corner
    {
        UpperLeft,
        LowerRight
    };
    void setCorner(Corner corner) noexcept { m_corner = corner; }
    /// Counts what was shown.
    [[nodiscard]] std::size_t revision() const noexcept { return m_revision; }
    [[nodiscard]] bool hasMarks() const noexcept { return !m_marks.empty(); }
    /// What is below it in each corner ends there. [logical px]
    struct Below
    {
        double cube_px = 0.0, scale_px = 0.0;
    };
    /// @param renderer  that it was added to
    void place(vtkRenderer& renderer, const ViewFrame& frame, const Below& below);
    /// Where it stands after `place`, for what is to stay clear of it; empty when it is not shown. Logical pixels from
    /// the view's middle.
    [[nodiscard]] Eigen::AlignedBox2d box() const { return isShown() ? m_box : Eigen::AlignedBox2d(); }

  private:
    /// Where the bar and what is below it stand. [device px]
    struct Place
    {
        double left, right, low, high, greyLow, greyHigh, pixelRatio, letter;
    };
    [[nodiscard]] double markedHeight(double letter) const;
    [[nodiscard]] TextStyle fitting(vtkRenderer& renderer, const ViewFrame& frame, double below_px);
    [[nodiscard]] double reach(vtkRenderer& renderer, const TextStyle& style, double pixelRatio);
    void placeMarks(const Place& at);
    void placeLines(const Place& at);

    vtkSmartPointer<vtkActor2D> m_back; ///< behind it all, so that it reads on bright tissue
    vtkSmartPointer<vtkActor2D> m_bar;
    vtkSmartPointer<vtkActor2D> m_grey;
    std::array<vtkSmartPointer<vtkTextActor>, 5> m_texts;
    Eigen::AlignedBox2d m_box;
    Corner m_corner = Corner::UpperLeft;
    std::size_t m_revision = 0;
    bool m_hasUnknown = false;
    ColourRange m_range;
    std::vector<Mark> m_marks;
    std::array<vtkSmartPointer<vtkTextActor>, kMostMarks> m_markTexts;
    vtkSmartPointer<vtkActor2D> m_lines; ///< from the marks to their words, and the hatch
};

} // namespace palpate::view
