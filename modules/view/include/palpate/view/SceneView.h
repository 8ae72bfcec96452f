// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/CameraPresets.h"
#include "palpate/view/ColourLegend.h"
#include "palpate/view/FindingMarkers.h"
#include "palpate/view/OrientationCube.h"
#include "palpate/view/PlaceRing.h"
#include "palpate/view/ScaleBar.h"
#include "palpate/view/StructureActor.h"
#include "palpate/view/SurfacePicker.h"
#include "palpate/view/TouchCursor.h"

#include <vtkRenderWindow.h>

#include <memory>
#include <optional>
#include <vector>

namespace palpate::view {

/// A structure of the view: what is drawn, and what the pointer can find.
struct ViewStructure
{
    StructureActor picture;
    std::shared_ptr<const geometry::SurfaceIndex> touchable; ///< null: the pointer passes through it
};

/// What a ray meets first.
struct ScenePick
{
    std::size_t structure = 0; ///< number in the view
    RayHit hit;
};

/// The picture: tissue under a three-point light that moves with the camera, the cursor over it, the patient's axes,
/// a scale and a legend of colours. It draws into a render window that its caller owns and renders.
/// @par Thread One, that of the render window.
class SceneView
{
  public:
    SceneView();
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    /// Adds the view's renderers. @param window  must outlive the view or `detach`
    void attach(vtkRenderWindow& window);
    void detach();

    void setStructures(std::vector<ViewStructure> structures);
    /// Shows more structures, numbered after those that are there.
    void addStructures(std::vector<ViewStructure> structures);
    /// Makes structures stand out by a light of their own, and no others.
    void highlight(const std::vector<int>& structures);
    [[nodiscard]] std::size_t structureCount() const noexcept { return m_structures.size(); }
    [[nodiscard]] const ViewStructure& structure(std::size_t i) const { return m_structures[i]; }
    void setAppearance(std::size_t i, const Appearance& appearance);
    /// Shows the same surface with other colours: see `coloured`. What they say is the legend's to tell.
    void setPicture(std::size_t i, vtkPolyData* surface) { m_structures[i].picture.setPicture(surface); }
    /// Replaces a structure's surface: what is drawn, how it looks, and what the pointer can find.
    void setStructure(std::size_t i, ViewStructure structure);
    void setTouchable(std::size_t i, std::shared_ptr<const geometry::SurfaceIndex> surface);
    void setBackground(const Colour& bottom, const Colour& top, const Colour& text);
    /// Of all texts, from the next frame on.
    void setTextStyle(const TextStyle& style) { m_text = style; }
    [[nodiscard]] const TextStyle& textStyle() const noexcept { return m_text; }

    [[nodiscard]] TouchCursor& cursor() noexcept { return m_cursor; }
    [[nodiscard]] FindingMarkers& findings() noexcept { return m_findings; }
    [[nodiscard]] ColourLegend& legend() noexcept { return m_legend; }
    /// Hidden with new structures.
    [[nodiscard]] PlaceRing& placeRing() noexcept { return m_placeRing; }
    [[nodiscard]] OrientationCube& cube() noexcept { return m_cube; }
    [[nodiscard]] vtkRenderer& renderer() noexcept { return *m_solid; }
    [[nodiscard]] const ScaleBar& scaleBar() const noexcept { return m_scaleBar; }
    [[nodiscard]] vtkCamera& camera() noexcept { return *m_solid->GetActiveCamera(); }

    void look(ViewFrom from);
    void fitAll();
    /// Moves focus and camera alike, so that `p_W` is in the middle.
    void centreOn(const Vec3& p_W);

    /// @param x,y  device pixels from the lower left of the view
    [[nodiscard]] Ray rayThrough(double x, double y);
    /// The nearest structure that is shown and touchable.
    [[nodiscard]] std::optional<ScenePick> pick(const Ray& ray) const;

    /// Box of the structures shown [mm]; of all when none is.
    [[nodiscard]] core::Box bounds() const;

    /// Fits clipping, cursor, scale and cube to the camera. Before each frame.
    /// @param pixelRatio  device pixels of one logical pixel
    void prepareFrame(double pixelRatio);
    /// Draws the tissue with a dent under the hand, where the touch says that it bends: see `Dimple`.
    void setBending(bool isOn) { m_bends = isOn; }
    /// Smooth edges; cheap on a graphics card, felt on none.
    void setSmoothEdges(bool isOn) { m_solid->SetUseFXAA(isOn); }
    /// Sorts translucent surfaces by depth peeling; else a single translucent structure is drawn once, which takes half
    /// the time and has the same colours but where it folds over itself. Several are always sorted.
    void setSortedTransparency(bool isOn) { m_isSorted = isOn; }
    /// Darkens what lies in folds. For graphics cards: it costs many times the frame without it.
    void setAmbientOcclusion(bool isOn) { m_hasOcclusion = isOn; }

  private:
    [[nodiscard]] double aspect() const;
    void bendTissue(const ViewFrame& frame);
    void findHiddenFindings(const ViewFrame& frame);
    void placeLegend(const ViewFrame& frame);
    [[nodiscard]] std::size_t tissueIn(const Eigen::AlignedBox2d& box_px, const ViewFrame& frame) const;

    vtkSmartPointer<vtkRenderer> m_solid;
    vtkSmartPointer<vtkRenderer> m_overlay;
    OrientationCube m_cube;
    ScaleBar m_scaleBar;
    ColourLegend m_legend;
    PlaceRing m_placeRing;
    TouchCursor m_cursor;
    FindingMarkers m_findings;
    /// What the hidden findings were found for.
    struct Seen
    {
        ViewFrame frame;
        std::size_t findings = 0;
        std::size_t tissue = 0;
        friend bool operator==(const Seen&, const Seen&) = default;
    };
    std::optional<Seen> m_seen;
    /// What the legend's corner was chosen for: while the view is turned it stays.
    struct LegendSeen
    {
        std::size_t legend = 0, looks = 0;
        double width_px = 0.0, height_px = 0.0;
        friend bool operator==(const LegendSeen&, const LegendSeen&) = default;
    };
    LegendSeen m_legendSeen;
    std::size_t m_looks = 0;          ///< counts what put all of the scene into the view
    std::size_t m_tissueRevision = 0; ///< counts changes of what can hide a finding
    std::vector<ViewStructure> m_structures;
    vtkSmartPointer<vtkRenderWindow> m_window;
    TextStyle m_text;
    bool m_hasOcclusion = false;
    bool m_isSorted = true;
    bool m_bends = true;
};

} // namespace palpate::view
