// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/SurfaceColours.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>

namespace palpate::view {

/// What the colours of a structure say: a bar of them at the left of the view with its name, unit and numbers.
class ColourLegend
{
  public:
    /// What it says, UTF-8.
    struct Content
    {
        std::string title;   ///< what is coloured, by what and in which unit; lines
        std::string unknown; ///< what grey means
        ColourRange range;
        std::string decimalPoint = "."; ///< of the numbers
    };

    ColourLegend();
    void addTo(vtkRenderer& renderer);
    void show(const Content& content);
    void hide();
    [[nodiscard]] bool isShown() const { return m_bar->GetVisibility() != 0; }
    /// Its words from the top: title, largest, middle, least number, and what grey means where it is there.
    [[nodiscard]] std::array<std::string, 5> texts() const;
    /// @param renderer  that it was added to; @param cubeTop_px  what is below it ends there, logical pixels
    void place(vtkRenderer& renderer, const ViewFrame& frame, double cubeTop_px);

  private:
    vtkSmartPointer<vtkActor2D> m_back; ///< behind it all, so that it reads on bright tissue
    vtkSmartPointer<vtkActor2D> m_bar;
    vtkSmartPointer<vtkActor2D> m_grey;
    std::array<vtkSmartPointer<vtkTextActor>, 5> m_texts;
    bool m_hasUnknown = false;
};

} // namespace palpate::view
