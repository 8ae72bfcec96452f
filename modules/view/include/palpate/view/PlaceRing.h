// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>

namespace palpate::view {

/// Ring on a surface that marks a place to press or a second hand, with the size of the finger's contact area. Tissue
/// does not hide the ring.
/// @par Thread The view's.
class PALPATE_EXPORT PlaceRing
{
  public:
    /// Pink does not occur in the colour map.
    explicit PlaceRing(const Colour& colour = {1.0, 0.35, 0.75});
    /// Adds the actors. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    /// Shows the ring. @param p_W  centre [mm]; @param n_W  outward unit normal; @param radius_mm  > 0
    /// @param structure  index in the view; if that structure moves, the place is on its rest shape
    void show(const core::Vec3& p_W, const core::Vec3& n_W, double radius_mm, std::size_t structure);
    /// Moves the shown ring, to where the place of `show` is now.
    void moveTo(const core::Vec3& p_W, const core::Vec3& n_W);
    [[nodiscard]] std::size_t structure() const noexcept { return m_structure; }
    /// Place and normal of `show`.
    [[nodiscard]] const core::Vec3& place_W() const noexcept { return m_place_W; }
    [[nodiscard]] const core::Vec3& normal_W() const noexcept { return m_normal_W; }
    void hide();
    [[nodiscard]] bool isShown() const;

  private:
    std::array<vtkSmartPointer<vtkActor>, 2> m_rings; ///< dark rim, and a bright ring on top
    core::Vec3 m_place_W = core::Vec3::Zero(), m_normal_W = core::Vec3::UnitZ();
    double m_radius_mm = 0.0;
    std::size_t m_structure = 0;
};

} // namespace palpate::view
