// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>

namespace palpate::view {

/// Ring on a surface that marks a place to press, with the size of the finger's contact area. Tissue does not hide
/// the ring.
/// @par Thread The view's.
class PALPATE_EXPORT PlaceRing
{
  public:
    PlaceRing();
    /// Adds the actors. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    /// Shows the ring. @param p_W  centre [mm]; @param n_W  outward unit normal; @param radius_mm  > 0
    void show(const core::Vec3& p_W, const core::Vec3& n_W, double radius_mm);
    void hide();
    [[nodiscard]] bool isShown() const;

  private:
    std::array<vtkSmartPointer<vtkActor>, 2> m_rings; ///< dark rim, and a bright ring on top
};

} // namespace palpate::view
