// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/CameraPresets.h"
#include "palpate/view/CoarseSurface.h"
#include "palpate/view/ColourLegend.h"
#include "palpate/view/FindingMarkers.h"
#include "palpate/view/HandPath.h"
#include "palpate/view/ImageSlice.h"
#include "palpate/view/MeasureLines.h"
#include "palpate/view/OrientationCube.h"
#include "palpate/view/PlaceRing.h"
#include "palpate/view/ScaleBar.h"
#include "palpate/view/SectionPicture.h"
#include "palpate/view/StructureActor.h"
#include "palpate/view/SurfacePicker.h"
#include "palpate/view/TargetMarks.h"
#include "palpate/view/TouchCursor.h"

#include <palpate/core/Export.h>

#include <vtkRenderWindow.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace palpate::view {

/// A displayed structure, and the surface used for picking.
struct ViewStructure
{
    StructureActor picture;
    std::shared_ptr<const geometry::SurfaceIndex> touchable; ///< null: the pointer passes through
    std::shared_ptr<const geometry::RepairedMesh> surface{}; ///< cut by a section; null: not cut
};

/// First intersection of a ray with the scene.
struct ScenePick
{
    std::size_t structure = 0; ///< index of the structure in the view
    RayHit hit;
};

/// 3D view: tissue under a three-point light fixed to the camera, the touch cursor, the orientation cube, a scale bar
/// and a colour legend. Draws into a render window that the caller owns and renders.
/// `resources/examples/own_window` is a program with such a window.
/// @par Thread The thread of the render window only.
class PALPATE_EXPORT SceneView
{
  public:
    SceneView();
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    /// Adds the renderers to a window. @param window  must outlive the view, or be detached first
    void attach(vtkRenderWindow& window);
    void detach();

    void setStructures(std::vector<ViewStructure> structures);
    /// Appends structures; indices of existing structures stay valid.
    void addStructures(std::vector<ViewStructure> structures);
    /// Highlights the given structures and removes the highlight from all others.
    void highlight(const std::vector<int>& structures);
    [[nodiscard]] std::size_t structureCount() const noexcept { return m_structures.size(); }
    [[nodiscard]] const ViewStructure& structure(std::size_t i) const { return m_structures[i]; }
    void setAppearance(std::size_t i, const Appearance& appearance);
    /// Replaces the colours of a structure: see `coloured`. The caller updates the legend.
    void setPicture(std::size_t i, vtkPolyData* surface) { m_structures[i].picture.setPicture(surface); }
    /// Replaces a structure: surface, appearance and picking surface.
    void setStructure(std::size_t i, ViewStructure structure);
    void setTouchable(std::size_t i, std::shared_ptr<const geometry::SurfaceIndex> surface);
    /// Sets where the structures are from the next frame on. Findings and the ring of a structure move along.
    /// @param motions  one per structure, null: at rest; structures beyond the list rest
    /// @param time_s  time of the servo tick that the cursor shows
    void moveTo(const std::vector<std::shared_ptr<const geometry::SurfaceMotion>>& motions, double time_s);
    /// Moves the pictures to the places of `moveTo`, as `prepareFrame` does. Returns true if a new frame would differ.
    bool follow();
    void setBackground(const Colour& bottom, const Colour& top, const Colour& text);
    /// Sets the heights at the top of the view that something covers, which the legend avoids. @param left_px,right_px
    /// in the two upper corners [logical px]
    void setCoveredAbove(double left_px, double right_px) noexcept { m_coveredAbove_px = {left_px, right_px}; }
    /// Sets the height at the bottom of the view that something covers; orientation cube, scale bar and legend stay
    /// above. [logical px]
    void setCoveredBelow(double height_px) noexcept { m_coveredBelow_px = height_px; }
    /// Keeps the colour legend in a corner. @param corner  empty: where it hides the least tissue, and a legend without
    /// marks above the orientation cube
    void setLegendCorner(std::optional<ColourLegend::Corner> corner) { m_legendCorner = corner; }
    [[nodiscard]] std::optional<ColourLegend::Corner> legendCorner() const noexcept { return m_legendCorner; }
    /// Sets a part of the view that something covers, which labels avoid. @param box_px  logical pixels from the centre
    /// of the view, y up; empty: none
    void setCovered(const Eigen::AlignedBox2d& box_px) { m_covered = box_px; }
    /// Number of sampled vertices of visible tissue in a box, to choose the box that hides the least. @param box_px  as
    /// above
    /// @par Cost Some hundred projections per structure
    [[nodiscard]] std::size_t tissueIn(const Eigen::AlignedBox2d& box_px, double pixelRatio) const;
    /// Sets the style of all texts, from the next frame on.
    void setTextStyle(const TextStyle& style) { m_text = style; }
    [[nodiscard]] const TextStyle& textStyle() const noexcept { return m_text; }

    [[nodiscard]] TouchCursor& cursor() noexcept { return m_cursor; }
    [[nodiscard]] FindingMarkers& findings() noexcept { return m_findings; }
    [[nodiscard]] MeasureLines& measures() noexcept { return m_measures; }
    [[nodiscard]] ColourLegend& legend() noexcept { return m_legend; }
    [[nodiscard]] const ColourLegend& legend() const noexcept { return m_legend; }
    /// Cuts the picture: tissue on the side of the plane's normal is not drawn, and the cut is filled from the next
    /// frame on. Hand, pointer and picking are not affected. @param plane  empty: no cut
    void setSection(const std::optional<geometry::SectionPlane>& plane);
    [[nodiscard]] const std::optional<geometry::SectionPlane>& section() const noexcept { return m_section; }
    /// Cuts the visible structures as drawn with any plane; closed ones are filled. @par Cost as `cutsOf`
    [[nodiscard]] std::vector<SectionCut> cutsAt(const geometry::SectionPlane& plane) const;
    /// Image shown in the section instead of filled structures, whose outlines are drawn on it.
    /// @param volume  null: no image
    void setImage(std::shared_ptr<const geometry::VoxelVolume> volume, const geometry::GreyWindow& window);
    /// Number of the image at a position of the section [mm]; empty without section or image, and outside the image.
    [[nodiscard]] std::optional<double> imageNumberAt(const Vec3& p_W) const;
    /// Cut faces of the section, cut now if the plane or the tissue changed.
    [[nodiscard]] const SectionPicture& sectionPicture()
    {
        cutTissue();
        return m_sectionPicture;
    }
    /// The ring is hidden when structures are replaced.
    [[nodiscard]] PlaceRing& placeRing() noexcept { return m_placeRing; }
    /// Contact of the second of two hands; hidden when structures are replaced.
    [[nodiscard]] PlaceRing& secondHand() noexcept { return m_secondHand; }
    /// Targets of an exercise after the search; removed when structures are replaced.
    [[nodiscard]] TargetMarks& targets() noexcept { return m_targets; }
    /// Path of a recorded hand without the touched surfaces; removed when structures are replaced.
    [[nodiscard]] HandPath& handPath() noexcept { return m_handPath; }
    [[nodiscard]] OrientationCube& cube() noexcept { return m_cube; }
    [[nodiscard]] vtkRenderer& renderer() noexcept { return *m_solid; }
    [[nodiscard]] const ScaleBar& scaleBar() const noexcept { return m_scaleBar; }
    [[nodiscard]] vtkCamera& camera() noexcept { return *m_solid->GetActiveCamera(); }

    void look(ViewFrom from);
    void fitAll();
    /// Moves focal point and camera together so that `p_W` is in the centre of the view.
    void centreOn(const Vec3& p_W);

    /// Returns the viewing ray through a pixel. @param x,y  device pixels from the lower left of the view
    [[nodiscard]] Ray rayThrough(double x, double y);
    /// Returns the nearest hit on a visible structure with a picking surface.
    [[nodiscard]] std::optional<ScenePick> pick(const Ray& ray) const;

    /// Bounding box of the visible structures [mm]; of all structures when none is visible, and of the path of the
    /// hand without structures.
    [[nodiscard]] core::Box bounds() const;

    /// Fits clipping range, cursor, markers, scale bar and cube to the camera. Call before each frame.
    /// @param pixelRatio  device pixels per logical pixel
    void prepareFrame(double pixelRatio);
    /// Draws the dent under the hand where the touch state allows: see `Dimple`.
    void setBending(bool isOn) { m_bends = isOn; }
    /// Turns antialiasing (FXAA) on, except for coarse frames. Cheap on a graphics card, expensive with software
    /// rendering.
    void setSmoothEdges(bool isOn);
    /// Sorts translucent surfaces by depth peeling. When off, a single translucent structure is drawn without
    /// sorting: half the time and the same colours except where the surface folds over itself. Several structures are
    /// always sorted.
    void setSortedTransparency(bool isOn) { m_isSorted = isOn; }
    /// For frames while the view turns: without antialiasing, and large structures of a large scene with fewer
    /// triangles
    /// (`CoarseSurfaces`). Their coarse pictures are made on another thread at the first call; until then, structures
    /// are drawn as they are, and always those with a dent, colours or a motion.
    void setCoarse(bool isOn);
    /// Turns ambient occlusion on. For graphics cards only: a frame takes many times longer.
    void setAmbientOcclusion(bool isOn) { m_hasOcclusion = isOn; }

  private:
    [[nodiscard]] double aspect() const;
    void bendTissue(const ViewFrame& frame);
    struct CutInput;
    [[nodiscard]] CutInput cutInput() const;
    void cutTissue();
    [[nodiscard]] bool isOffSection(const Vec3& p_W) const;
    void findHiddenFindings(const ViewFrame& frame);
    void placeLegend(const ViewFrame& frame);
    void chooseLegendPlace(const ViewFrame& frame, const ColourLegend::Below& below);
    void placeMeasures(const ViewFrame& frame);
    void takeCoarsePictures();
    [[nodiscard]] std::vector<Eigen::AlignedBox2d> coveredBoxes() const;
    [[nodiscard]] std::size_t countTissueVertices(const Eigen::AlignedBox2d& box_px, const ViewFrame& frame) const;

    vtkSmartPointer<vtkRenderer> m_solid;
    vtkSmartPointer<vtkRenderer> m_overlay;
    OrientationCube m_cube;
    ScaleBar m_scaleBar;
    ColourLegend m_legend;
    PlaceRing m_placeRing;
    PlaceRing m_secondHand{kSecondColour};
    TargetMarks m_targets;
    HandPath m_handPath;
    SectionPicture m_sectionPicture;
    ImageSlice m_image;
    std::optional<geometry::SectionPlane> m_section;
    bool m_isSectionOld = false; ///< plane or tissue changed since the last cut
    TouchCursor m_cursor;
    FindingMarkers m_findings;
    MeasureLines m_measures;
    /// Inputs of the last visibility test of the findings.
    struct Seen
    {
        ViewFrame frame;
        std::size_t findings = 0;
        std::size_t tissue = 0;
        std::size_t section = 0;
        friend bool operator==(const Seen&, const Seen&) = default;
    };
    std::optional<Seen> m_findingInputs;
    /// Inputs of the last choice of the legend's corner, which does not change while the view is turned.
    struct LegendInputs
    {
        std::size_t legend = 0, looks = 0;
        double width_px = 0.0, height_px = 0.0, text_px = 0.0;
        bool isHovered = false;
        std::optional<ColourLegend::Corner> corner;
        friend bool operator==(const LegendInputs&, const LegendInputs&) = default;
    };
    LegendInputs m_legendInputs;
    std::size_t m_fitCount = 0; ///< number of times that the whole scene was fitted into the view
    std::size_t m_sectionRevision = 0;
    std::size_t m_tissueRevision = 0; ///< number of changes that may hide or reveal a finding
    std::vector<ViewStructure> m_structures;
    vtkSmartPointer<vtkRenderWindow> m_window;
    TextStyle m_text;
    std::array<double, 2> m_coveredAbove_px{}; ///< left, right
    double m_coveredBelow_px = 0.0;
    std::optional<ColourLegend::Corner> m_legendCorner;
    Eigen::AlignedBox2d m_covered;
    bool m_hasOcclusion = false;
    bool m_isSorted = true;
    bool m_isCoarse = false;
    bool m_hasSmoothEdges = false;
    CoarseSurfaces m_coarse;
    bool m_bends = true;
};

} // namespace palpate::view
