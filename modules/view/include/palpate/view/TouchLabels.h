// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/LabelLayout.h"

#include <palpate/core/Export.h>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>
#include <vector>

namespace palpate::view {

/// Numbers beside the cursor, kept inside the view and clear of the cursor and of each other.
class PALPATE_EXPORT TouchLabels
{
  public:
    /// Text and the point to label.
    struct Item
    {
        std::string text;                     ///< empty: no label
        Vec3 p_W = Vec3::Zero();              ///< labelled point [mm]
        Eigen::Vector2d towards = {1.0, 0.0}; ///< preferred side of the point
        Colour colour{1.0, 1.0, 1.0};         ///< a light colour: the background is dark
        bool isLarge = false;
    };

    /// Sets the renderer. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay) { m_overlay = &overlay; }
    /// Lays out the labels. @param taken  boxes to avoid, logical pixels from the centre of the view
    void place(const std::vector<Item>& items, std::vector<Eigen::AlignedBox2d> taken, const ViewFrame& frame);
    /// Boxes of the visible texts, logical pixels from the centre of the view.
    [[nodiscard]] const std::vector<Eigen::AlignedBox2d>& boxes() const noexcept { return m_boxes; }
    [[nodiscard]] std::vector<std::string> texts() const;

  private:
    struct Label
    {
        vtkSmartPointer<vtkTextActor> actor;
        PointLabel layout;
    };
    void add();

    std::vector<Label> m_labels; ///< never more than the largest number of items so far
    std::vector<Eigen::AlignedBox2d> m_boxes;
    vtkRenderer* m_overlay = nullptr;
};

} // namespace palpate::view
