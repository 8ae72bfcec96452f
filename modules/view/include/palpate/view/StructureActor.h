// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"
#include "palpate/view/Dimple.h"

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

/// How a structure looks.
struct Appearance
{
    Colour colour{0.85, 0.6, 0.5};
    double opacity = 1.0; ///< 0 … 1; below 1 what lies behind shows
    bool isVisible = true;
};

/// One structure in the view: soft specular on smooth shading, its inner side a little darker. A translucent one shows
/// only the side towards the viewer when it is closed: its far wall would cost twice the time and hide what is inside.
/// @par Thread Make it anywhere; once it is in a view, the view's thread only.
class StructureActor
{
  public:
    /// @param surface  from `makeSurface`
    /// @param isClosed  it has no open edges and its normals are outwards
    explicit StructureActor(vtkPolyData* surface, const Appearance& appearance = {}, bool isClosed = false);

    void setAppearance(const Appearance& appearance);
    /// Shows the same surface with other colours: those that `coloured` or `feltColoured` gave it, where it has some,
    /// instead of the structure's own.
    void setPicture(vtkPolyData* surface);
    /// Draws it bent from the next frame on, where the dent reaches it.
    void bend(const Dimple& dimple, const ViewFrame& frame);
    /// Lights the structure up a little, in its own colour.
    void setHighlighted(bool isOn);
    [[nodiscard]] const Appearance& appearance() const noexcept { return m_appearance; }
    /// Where its surface's vertices are drawn without a dent, world frame [mm].
    [[nodiscard]] vtkPoints& points() const;
    [[nodiscard]] vtkActor* actor() const noexcept { return m_actor; }

  private:
    vtkSmartPointer<vtkActor> m_actor;
    Appearance m_appearance;
    bool m_isClosed = false;
    bool m_isBent = false;
};

} // namespace palpate::view
