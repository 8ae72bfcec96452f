// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"
#include "palpate/view/Dimple.h"
#include "palpate/view/MovedSurface.h"

#include <palpate/core/Export.h>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <future>
#include <memory>

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
    /// Sets where the surface is from the next `follow` on. @param motion  null: at rest
    void moveTo(std::shared_ptr<const geometry::SurfaceMotion> motion, double time_s);
    /// Moves the picture to the place of `moveTo`. A picture with more than kMostAtOnce vertices is moved on another
    /// thread and shown by the first call after that, so that the caller never waits. Returns true if the picture has
    /// changed.
    bool follow();
    /// Time of `moveTo`. [s]
    [[nodiscard]] double time_s() const noexcept { return m_time_s; }
    /// The displayed place; its motion is null at rest.
    [[nodiscard]] const MovedSurface& moved() const noexcept { return m_moved; }
    /// Takes a place on the surface back to the rest shape, at the time of `moveTo`. [mm]
    [[nodiscard]] Vec3 restOf(const Vec3& p_W) const;
    /// Largest number of vertices that `follow` moves at once: 6 ms in a breath, 11 ms in frames.
    static constexpr vtkIdType kMostAtOnce = 40'000;
    /// Draws the surface with a dent from the next frame on, if the dent reaches the structure.
    void bend(const Dimple& dimple, const ViewFrame& frame);
    /// Hides what is on the negative side of the planes. @param planes  null: hides nothing
    void clip(vtkPlaneCollection* planes);
    /// Picture of the rest shape, from which a coarse one is made.
    [[nodiscard]] vtkPolyData* picture() const noexcept { return m_rest; }
    /// Sets the picture that `setCoarse` draws. @param coarse  from `coarseSurface` of `picture`
    void setCoarsePicture(vtkPolyData* coarse);
    [[nodiscard]] bool hasCoarsePicture() const noexcept { return m_hasCoarse; }
    /// Draws the coarse picture, if there is one and the surface has neither a dent, colours nor a motion.
    void setCoarse(bool isOn);
    /// Brightens the structure slightly, in its own colour.
    void setHighlighted(bool isOn);
    [[nodiscard]] const Appearance& appearance() const noexcept { return m_appearance; }
    /// Displayed positions of the vertices without a dent, world frame [mm].
    [[nodiscard]] vtkPoints& points() const;
    [[nodiscard]] vtkActor* actor() const noexcept { return m_actor; }
    /// Drawn instead while coarse.
    [[nodiscard]] vtkActor* coarseActor() const noexcept { return m_coarse; }

  private:
    [[nodiscard]] bool isInPlace() const;
    void showMoved();
    void showEither();

    vtkSmartPointer<vtkActor> m_actor;
    vtkSmartPointer<vtkActor> m_coarse;                      ///< with the property of the other
    vtkSmartPointer<vtkPolyData> m_rest;                     ///< picture of the rest shape
    vtkSmartPointer<vtkPolyData> m_drawn;                    ///< the same with moved points; null until moved
    std::shared_ptr<const geometry::SurfaceMotion> m_motion; ///< of `moveTo`
    double m_time_s = 0.0;
    MovedSurface m_moved;
    std::future<MovedSurface> m_next; ///< being computed
    Appearance m_appearance;
    bool m_isClosed = false;
    bool m_isBent = false;
    vtkSmartPointer<vtkCellArray> m_coarseOf; ///< triangles of the surface with the coarse picture
    bool m_hasColours = false;
    bool m_hasCoarse = false;
    bool m_isCoarse = false; ///< wanted
};

} // namespace palpate::view
