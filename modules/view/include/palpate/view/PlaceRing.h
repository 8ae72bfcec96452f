// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>

namespace palpate::view {

/// A ring on a surface that marks one place to press on, as large as the finger's contact. Tissue does not hide it.
/// @par Thread The view's.
class PlaceRing
{
  public:
    PlaceRing();
    /// @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    /// @param p_W  middle [mm]; @param n_W  outward normal, length 1; @param radius_mm  of the ring, > 0
    void show(const core::Vec3& p_W, const core::Vec3& n_W, double radius_mm);
    void hide();
    [[nodiscard]] bool isShown() const;

  private:
    std::array<vtkSmartPointer<vtkActor>, 2> m_rings; ///< a dark one, and a bright one on it
};

} // namespace palpate::view
