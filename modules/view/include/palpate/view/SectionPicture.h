// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/core/Export.h>
#include <palpate/geometry/SurfaceSection.h>

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace palpate::view {

/// Surface to be cut, as `geometry::sectionOf` takes it. The data must stay valid during the call only.
struct CutSurface
{
    std::span<const core::Vec3> vertices; ///< world frame [mm]
    std::span<const geometry::Triangle> triangles;
    std::span<const std::uint8_t> twoSided;
    core::Box bounds; ///< of the vertices
    Colour colour{};
    bool isFilled = true; ///< if it is closed; false: an outline only
};

/// Cut of one structure.
struct SectionCut
{
    std::size_t structure = 0; ///< its number
    std::vector<geometry::SectionContour> contours;
    std::vector<geometry::SectionStrip> strips; ///< the filled area; empty for an open structure
    Eigen::AlignedBox2d box{};                  ///< of the contours, in the plane [mm]
    double area_mm2 = 0.0;
    Colour colour{};
};

/// Cuts surfaces with a plane. @return the structures that are cut, by decreasing area, so that inner ones come last
/// @par Cost 2 to 9 ms of processor time for 1.2 million triangles, on several cores if several structures are cut
[[nodiscard]] PALPATE_EXPORT std::vector<SectionCut> cutsOf(const geometry::SectionPlane& plane,
                                                            const std::vector<CutSurface>& surfaces);

/// Cut faces and outlines of structures in a plane. Closed structures are filled in their own colour, inner ones on top
/// of outer ones; open structures are outlines only. Everything else that `clipping` is set for is hidden on the side
/// of the plane's normal.
/// @par Thread The view's.
class PALPATE_EXPORT SectionPicture
{
  public:
    SectionPicture();
    /// Adds the actors. @param solid  contains the tissue; must outlive this
    void addTo(vtkRenderer& solid);
    /// Cuts and draws. @param surfaces  by structure; without triangles: not cut
    /// @par Cost as `cutsOf`
    void show(const geometry::SectionPlane& plane, const std::vector<CutSurface>& surfaces);
    void hide();
    [[nodiscard]] bool isShown() const noexcept { return m_isShown; }
    /// Draws closed structures as outlines, too, for example on an image; from the next `show` on.
    void setFilled(bool isFilled);

    /// @return true if the plane cuts no structure
    [[nodiscard]] bool isEmpty() const noexcept { return m_cuts.empty(); }
    /// Finds the innermost filled structure at a place of the plane. @return its number; empty between structures
    [[nodiscard]] std::optional<std::size_t> structureAt(const core::Vec3& p_W) const;
    /// Area of a structure's cut face [mm²]; 0 if it is not cut or open.
    [[nodiscard]] double area_mm2(std::size_t structure) const;
    /// Plane for the mappers of tissue.
    [[nodiscard]] vtkPlaneCollection* clipping() const noexcept { return m_clipping; }

  private:
    void liftInner(double step_mm);
    void drawFaces();
    void drawOutlines(double step_mm);

    geometry::SectionPlane m_plane;
    std::vector<SectionCut> m_cuts; ///< by decreasing area
    std::vector<double> m_lifts_mm; ///< of the cuts above the plane, so that inner faces hide outer ones
    vtkSmartPointer<vtkPlane> m_clip;
    vtkSmartPointer<vtkPlaneCollection> m_clipping;
    vtkSmartPointer<vtkActor> m_faces, m_outlines;
    bool m_isShown = false;
    bool m_isFilled = true;
};

} // namespace palpate::view
