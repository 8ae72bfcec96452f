// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"
#include "palpate/view/Dimple.h"

#include <palpate/core/Export.h>

#include <vtkActor.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

/// Appearance of a structure.
struct Appearance
{
    Colour colour{0.85, 0.6, 0.5};
    double opacity = 1.0; ///< 0 to 1; translucent below 1
    bool isVisible = true;
};

/// Actor of one structure: smooth shading with soft highlights; back faces are slightly darker. Back faces of closed
/// translucent structures are culled, because they would double the rendering time and hide inner structures.
/// @par Thread Construct in any thread; use in the view's thread only once added to a view.
class PALPATE_EXPORT StructureActor
{
  public:
    /// Makes the actor.
    /// @param surface  from `makeSurface`
    /// @param isClosed  true: the mesh has no open edges, and normals point outwards
    explicit StructureActor(vtkPolyData* surface, const Appearance& appearance = {}, bool isClosed = false);

    void setAppearance(const Appearance& appearance);
    /// Replaces the picture of the same surface. Colours from `coloured` or `palpabilityColoured`, if any, replace the
    /// structure's own.
    void setPicture(vtkPolyData* surface);
    /// Draws the surface with a dent from the next frame on, if the dent reaches the structure.
    void bend(const Dimple& dimple, const ViewFrame& frame);
    /// Hides what is on the negative side of the planes. @param planes  null: hides nothing
    void clip(vtkPlaneCollection* planes);
    /// Brightens the structure slightly, in its own colour.
    void setHighlighted(bool isOn);
    [[nodiscard]] const Appearance& appearance() const noexcept { return m_appearance; }
    /// Positions of the vertices without a dent, world frame [mm].
    [[nodiscard]] vtkPoints& points() const;
    [[nodiscard]] vtkActor* actor() const noexcept { return m_actor; }

  private:
    vtkSmartPointer<vtkActor> m_actor;
    Appearance m_appearance;
    bool m_isClosed = false;
    bool m_isBent = false;
};

} // namespace palpate::view
