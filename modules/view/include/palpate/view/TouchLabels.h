// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/LabelLayout.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>
#include <vector>

namespace palpate::view {

/// The numbers beside the cursor: always inside the view, off the cursor and off each other.
class TouchLabels
{
  public:
    /// A number and what it belongs to.
    struct Item
    {
        std::string text;                     ///< empty: none
        Vec3 p_W = Vec3::Zero();              ///< beside what [mm]
        Eigen::Vector2d towards = {1.0, 0.0}; ///< on which side of it, if there is room
        Colour colour{1.0, 1.0, 1.0};         ///< light: the ground is dark
        bool isLarge = false;
    };

    /// @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay) { m_overlay = &overlay; }
    /// @param taken  what is not to be covered, logical pixels from the middle of the view
    void place(const std::vector<Item>& items, std::vector<Eigen::AlignedBox2d> taken, const ViewFrame& frame);
    /// Boxes of the texts shown, logical pixels from the middle of the view.
    [[nodiscard]] const std::vector<Eigen::AlignedBox2d>& boxes() const noexcept { return m_boxes; }
    [[nodiscard]] std::vector<std::string> texts() const;

  private:
    struct Label
    {
        vtkSmartPointer<vtkTextActor> actor;
        PointLabel layout;
    };
    void add();

    std::vector<Label> m_labels; ///< at most as many as there were items
    std::vector<Eigen::AlignedBox2d> m_boxes;
    vtkRenderer* m_overlay = nullptr;
};

} // namespace palpate::view
