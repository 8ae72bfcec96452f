// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SceneView.h"

#include <Eigen/LU>

#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace palpate::view {

namespace {

core::Box boxOf(vtkActor* actor)
{
    const double* b = actor->GetMapper()->GetBounds();
    return {Vec3(b[0], b[2], b[4]), Vec3(b[1], b[3], b[5])};
}

constexpr int kPeels = 4, kCoarsePeels = 1; // layers of translucent tissue that are sorted
constexpr double kLeastDivisor = 1.5;       // a coarse picture with more of the triangles saves too little

/// Opacity up to which a structure is meant to be looked through, so that its cut face must not hide others.
constexpr double kLeastFilled = 0.25;

} // namespace

SceneView::SceneView()
    : m_solid(vtkSmartPointer<vtkRenderer>::New())
    , m_overlay(vtkSmartPointer<vtkRenderer>::New())
{
    m_solid->GradientBackgroundOn();
    setBackground({0.20, 0.23, 0.27}, {0.36, 0.41, 0.47}, {0.95, 0.96, 0.97});
    // Depth peeling of the front layers of translucent tissue; layers behind the fourth are practically invisible.
    m_solid->UseDepthPeelingOn();
    m_solid->SetMaximumNumberOfPeels(kPeels);
    m_solid->SetOcclusionRatio(0.05);
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(0.82);
    lights->SetKeyLightWarmth(0.56);
    lights->SetFillLightWarmth(0.46);
    lights->SetKeyToFillRatio(2.6);
    lights->SetKeyToBackRatio(3.6);
    lights->SetKeyToHeadRatio(3.4);
    lights->AddLightsToRenderer(m_solid);
    m_solid->AutomaticLightCreationOff();

    m_overlay->SetLayer(1);
    m_overlay->InteractiveOff();
    m_overlay->SetActiveCamera(m_solid->GetActiveCamera());
    m_solid->GetActiveCamera()->SetViewAngle(30.0);
    m_image.addTo(*m_solid);
    m_sectionPicture.addTo(*m_solid);
    m_handPath.addTo(*m_solid);
    m_cursor.addTo(*m_solid, *m_overlay);
    m_findings.addTo(*m_overlay);
    m_measures.addTo(*m_overlay);
    m_scaleBar.addTo(*m_overlay);
    m_legend.addTo(*m_overlay);
    m_placeRing.addTo(*m_overlay);
    m_secondHand.addTo(*m_overlay);
    m_targets.addTo(*m_overlay);
}

SceneView::~SceneView()
{
    detach();
}

void SceneView::attach(vtkRenderWindow& window)
{
    detach();
    m_window = &window;
    window.SetNumberOfLayers(2);
    // Depth peeling needs a depth buffer without multisampling; FXAA smooths edges afterwards.
    window.SetMultiSamples(0);
    window.SetAlphaBitPlanes(1);
    for (vtkRenderer* renderer : {m_solid.Get(), m_overlay.Get(), m_cube.renderer()}) {
        window.AddRenderer(renderer);
    }
}

void SceneView::detach()
{
    if (m_window == nullptr) {
        return;
    }
    for (vtkRenderer* renderer : {m_solid.Get(), m_overlay.Get(), m_cube.renderer()}) {
        m_window->RemoveRenderer(renderer);
    }
    m_window = nullptr;
}

void SceneView::setStructures(std::vector<ViewStructure> structures)
{
    for (const ViewStructure& old : m_structures) {
        m_solid->RemoveActor(old.picture.actor());
        m_solid->RemoveActor(old.picture.coarseActor());
    }
    m_structures = std::move(structures);
    ++m_tissueRevision;
    m_isSectionOld = true;
    m_legend.hide();
    m_placeRing.hide();
    m_secondHand.hide();
    m_targets.set({});
    m_handPath.set({});
    for (const ViewStructure& one : m_structures) {
        m_solid->AddActor(one.picture.actor());
        m_solid->AddActor(one.picture.coarseActor());
    }
}

void SceneView::addStructures(std::vector<ViewStructure> structures)
{
    for (ViewStructure& one : structures) {
        m_solid->AddActor(one.picture.actor());
        m_solid->AddActor(one.picture.coarseActor());
        m_structures.push_back(std::move(one));
    }
    m_isSectionOld = true;
}

void SceneView::setStructure(std::size_t i, ViewStructure structure)
{
    m_solid->RemoveActor(m_structures[i].picture.actor());
    m_solid->RemoveActor(m_structures[i].picture.coarseActor());
    m_structures[i] = std::move(structure);
    m_solid->AddActor(m_structures[i].picture.actor());
    m_solid->AddActor(m_structures[i].picture.coarseActor());
    ++m_tissueRevision;
    m_isSectionOld = true;
}

void SceneView::highlight(const std::vector<int>& structures)
{
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        const bool isIn = std::find(structures.begin(), structures.end(), static_cast<int>(i)) != structures.end();
        m_structures[i].picture.setHighlighted(isIn);
    }
}

void SceneView::setAppearance(std::size_t i, const Appearance& appearance)
{
    m_structures[i].picture.setAppearance(appearance);
    ++m_tissueRevision;
    m_isSectionOld = true;
}

void SceneView::setTouchable(std::size_t i, std::shared_ptr<const geometry::SurfaceIndex> surface)
{
    m_structures[i].touchable = std::move(surface);
    ++m_tissueRevision;
    m_isSectionOld = true;
}

void SceneView::moveTo(const std::vector<std::shared_ptr<const geometry::SurfaceMotion>>& motions, double time_s)
{
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        m_structures[i].picture.moveTo(i < motions.size() ? motions[i] : nullptr, time_s);
    }
}

/// Findings, rings and targets move with their structures.
bool SceneView::follow()
{
    bool hasMoved = false;
    for (ViewStructure& one : m_structures) {
        hasMoved = one.picture.follow() || hasMoved;
    }
    m_tissueRevision += hasMoved ? 1 : 0;
    m_isSectionOld = m_isSectionOld || (hasMoved && m_section);
    const auto movedOf = [this](std::size_t i) {
        return i < m_structures.size() && m_structures[i].picture.moved().motion != nullptr
                   ? &m_structures[i].picture.moved()
                   : nullptr;
    };
    for (std::size_t i = 0; i < m_findings.marks().size(); ++i) {
        const auto structure = m_findings.marks()[i].structure;
        const MovedSurface* moved = structure ? movedOf(*structure) : nullptr;
        const Vec3& rest_W = m_findings.rest_W(i);
        m_findings.move(i, moved == nullptr ? rest_W : moved->motion->toWorld(moved->moment, rest_W));
    }
    const auto movedBy = [](const MovedSurface* moved, Vec3 p_W, Vec3 n_W) {
        if (moved != nullptr) {
            geometry::Mat3 F;
            p_W = moved->motion->toWorld(moved->moment, p_W, F);
            n_W = (F.inverse().transpose() * n_W).normalized();
        }
        return std::pair(p_W, n_W);
    };
    if (m_placeRing.isShown()) {
        const auto [p_W, n_W] =
            movedBy(movedOf(m_placeRing.structure()), m_placeRing.place_W(), m_placeRing.normal_W());
        m_placeRing.moveTo(p_W, n_W);
    }
    for (std::size_t i = 0; i < m_targets.marks().size(); ++i) {
        const TargetMark& mark = m_targets.marks()[i];
        const auto [p_W, n_W] = movedBy(mark.structure ? movedOf(*mark.structure) : nullptr, mark.p_W, mark.n_W);
        m_targets.moveTo(i, p_W, n_W);
    }
    return hasMoved;
}

void SceneView::setBackground(const Colour& bottom, const Colour& top, const Colour& text)
{
    m_solid->SetBackground(bottom[0], bottom[1], bottom[2]);
    m_solid->SetBackground2(top[0], top[1], top[2]);
    m_scaleBar.setColour(text);
}

double SceneView::aspect() const
{
    const int* size = m_solid->GetSize();
    return size[0] > 0 && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.5;
}

void SceneView::look(ViewFrom from)
{
    lookFrom(camera(), from, bounds(), aspect());
    ++m_fitCount;
}

void SceneView::fitAll()
{
    fit(camera(), bounds(), aspect());
    ++m_fitCount;
}

void SceneView::centreOn(const Vec3& p_W)
{
    const Vec3 shift = p_W - Vec3(camera().GetFocalPoint());
    const Vec3 position = Vec3(camera().GetPosition()) + shift;
    camera().SetFocalPoint(p_W.x(), p_W.y(), p_W.z());
    camera().SetPosition(position.x(), position.y(), position.z());
}

Ray SceneView::rayThrough(double x, double y)
{
    const ViewFrame frame = ViewFrame::of(*m_solid, 1.0);
    const int* size = m_solid->GetSize();
    const double right = (x - 0.5 * size[0]) / frame.height_px * frame.scale;
    const double up = (y - 0.5 * size[1]) / frame.height_px * frame.scale;
    if (frame.isParallel) {
        return {frame.eye_W + right * frame.right_W + up * frame.up_W, -frame.back_W};
    }
    return {frame.eye_W, (right * frame.right_W + up * frame.up_W - frame.back_W).normalized()};
}

std::optional<ScenePick> SceneView::pick(const Ray& ray) const
{
    std::optional<ScenePick> best;
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        const ViewStructure& one = m_structures[i];
        if (one.touchable == nullptr || !one.picture.appearance().isVisible) {
            continue;
        }
        const MovedSurface& moved = one.picture.moved();
        const auto hit = moved.motion == nullptr ? firstHit(*one.touchable, ray)
                                                 : firstHit(*one.touchable, *moved.motion, moved.moment, ray);
        if (hit && (!best || hit->distance_mm < best->hit.distance_mm)) {
            best = ScenePick{i, *hit};
        }
    }
    return best;
}

core::Box SceneView::bounds() const
{
    core::Box shown;
    core::Box all;
    for (const ViewStructure& one : m_structures) {
        const core::Box box = boxOf(one.picture.actor());
        all.extend(box);
        if (one.picture.appearance().isVisible) {
            shown.extend(box);
        }
    }
    return !shown.isEmpty() ? shown : !all.isEmpty() ? all : m_handPath.bounds();
}

/// Returns whether a place is so far from the section that drawing it over the section would mislead: in front, where
/// everything is cut away, and with an image, which hides everything behind it, also there.
bool SceneView::isOffSection(const Vec3& p_W) const
{
    constexpr double kNear_mm = 5.0; // about the radius of a small lump, and more than a slice of a CT is thick
    if (!m_section) {
        return false;
    }
    const double inFront_mm = m_section->n_W.dot(p_W - m_section->p_W);
    return inFront_mm > kNear_mm || (m_image.isShown() && inFront_mm < -kNear_mm);
}

/// Casts a ray from the eye to each finding; tissue hit before the finding hides it.
void SceneView::findHiddenFindings(const ViewFrame& frame)
{
    const Seen now{frame, m_findings.revision(), m_tissueRevision, m_sectionRevision};
    if (m_findings.count() == 0 || m_findingInputs == now) {
        return;
    }
    m_findingInputs = now;
    m_findings.updateHidden([&](const Vec3& p_W) {
        // A finding lies on a surface: hits closer than this belong to the finding's own surface.
        constexpr double kOwn_mm = 0.5, kOwnShare = 1e-3;
        if (isOffSection(p_W)) {
            return true;
        }
        const double along_mm = (frame.eye_W - p_W).dot(frame.back_W);
        const Vec3 start = frame.isParallel ? Vec3(p_W + along_mm * frame.back_W) : frame.eye_W;
        const double distance_mm = (p_W - start).norm();
        if (distance_mm <= 0.0) {
            return false;
        }
        const auto first = pick({start, (p_W - start) / distance_mm});
        return first && first->hit.distance_mm < distance_mm - std::max(kOwn_mm, kOwnShare * distance_mm);
    });
}

/// Number of vertices of visible tissue inside a box, from a sample of a few hundred vertices per structure.
/// @param box_px  logical pixels from the centre of the view
std::size_t SceneView::countTissueVertices(const Eigen::AlignedBox2d& box_px, const ViewFrame& frame) const
{
    constexpr vtkIdType kAsked = 512;
    std::size_t count = 0;
    for (const ViewStructure& one : m_structures) {
        if (!one.picture.appearance().isVisible) {
            continue;
        }
        vtkPoints& points = one.picture.points();
        const vtkIdType all = points.GetNumberOfPoints();
        const vtkIdType step = std::max<vtkIdType>(1, all / kAsked);
        for (vtkIdType i = 0; i < all; i += step) {
            count += box_px.contains(frame.pixelOf(Vec3(points.GetPoint(i)))) ? 1 : 0;
        }
    }
    return count;
}

std::size_t SceneView::tissueIn(const Eigen::AlignedBox2d& box_px, double pixelRatio) const
{
    return countTissueVertices(box_px, ViewFrame::of(*m_solid, pixelRatio));
}

/// Boxes that labels avoid: the legend and what covers the view.
std::vector<Eigen::AlignedBox2d> SceneView::coveredBoxes() const
{
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const Eigen::AlignedBox2d& box : {m_legend.box(), m_covered}) {
        if (!box.isEmpty()) {
            boxes.push_back(box);
        }
    }
    return boxes;
}

/// Chooses corner and form of the legend: the chosen corner, or for a legend with marks the one where it hides the
/// least tissue, and the brief form if much would still be hidden. The pointer over the legend shows the full form.
void SceneView::chooseLegendPlace(const ViewFrame& frame, const ColourLegend::Below& below)
{
    using Corner = ColourLegend::Corner;
    constexpr double kMostHidden = 0.04; // share of the visible vertices
    const auto hiddenIn = [&](Corner corner) {
        m_legend.setCorner(corner);
        m_legend.place(*m_overlay, frame, below);
        return countTissueVertices(m_legend.box(), frame);
    };
    const auto chooseCorner = [&] {
        Corner best = m_legendCorner.value_or(m_legend.hasMarks() ? Corner::UpperLeft : Corner::LowerLeft);
        std::size_t least = hiddenIn(best);
        for (const Corner corner : ColourLegend::kCorners) {
            if (m_legendCorner || !m_legend.hasMarks() || least == 0) {
                break;
            }
            if (const std::size_t hidden = hiddenIn(corner); hidden < least) {
                best = corner;
                least = hidden;
            }
        }
        m_legend.setCorner(best);
        return least;
    };
    m_legend.setBrief(false);
    if (m_legend.isHovered()) {
        m_legend.setCorner(m_legendCorner.value_or(m_legend.corner())); // it must not jump away from the pointer
        return;
    }
    const Eigen::Vector2d half(0.5 * frame.width_px, 0.5 * frame.height_px);
    const auto all = static_cast<double>(countTissueVertices({-half, half}, frame));
    if (static_cast<double>(chooseCorner()) > kMostHidden * all) {
        m_legend.setBrief(true);
        (void)chooseCorner();
    }
}

/// Places the legend. Corner and form are chosen when the legend appears, the view is resized or the whole scene is
/// fitted into the view, but not while the view is turned.
void SceneView::placeLegend(const ViewFrame& frame)
{
    const ColourLegend::Below below{m_cube.top_px(), m_scaleBar.top() / frame.pixelRatio, m_coveredAbove_px[0],
                                    m_coveredAbove_px[1]};
    const LegendInputs now{m_legend.revision(), m_fitCount,           frame.width_px, frame.height_px,
                           frame.text.size_px,  m_legend.isHovered(), m_legendCorner};
    if (m_legend.isShown() && !(now == m_legendInputs)) {
        m_legendInputs = now;
        chooseLegendPlace(frame, below);
    }
    m_legend.place(*m_overlay, frame, below);
}

/// Places the texts of distances clear of the hand, its numbers, the findings and the legend.
void SceneView::placeMeasures(const ViewFrame& frame)
{
    std::vector<Eigen::AlignedBox2d> taken = m_cursor.marks_px(frame);
    taken.insert(taken.end(), m_cursor.labels().boxes().begin(), m_cursor.labels().boxes().end());
    for (std::size_t i = 0; i < m_findings.count() && m_findings.count() <= FindingMarkers::kMaxNumbered; ++i) {
        const DiscLabel& label = m_findings.labelOf(i);
        const Eigen::Vector2d centre = label.disc_px + label.offset_px;
        taken.emplace_back(centre - 0.5 * label.size_px, centre + 0.5 * label.size_px);
    }
    const std::vector<Eigen::AlignedBox2d> covered = coveredBoxes();
    taken.insert(taken.end(), covered.begin(), covered.end());
    m_measures.place(frame, taken, [this](const Vec3& p_W) { return isOffSection(p_W); });
    m_targets.place(taken, frame);
}

void SceneView::bendTissue(const ViewFrame& frame)
{
    const Dimple dimple = m_bends ? Dimple::of(m_cursor.state()) : Dimple();
    m_cursor.setInDent(m_bends);
    for (ViewStructure& one : m_structures) {
        one.picture.bend(dimple, frame);
    }
}

void SceneView::setSmoothEdges(bool isOn)
{
    m_hasSmoothEdges = isOn;
    m_solid->SetUseFXAA(isOn && !m_isCoarse);
}

void SceneView::setCoarse(bool isOn)
{
    m_isCoarse = isOn;
    m_solid->SetUseFXAA(m_hasSmoothEdges && !isOn);
    if (!isOn || m_coarse.isBusy()) {
        return;
    }
    double triangles = 0.0;
    std::vector<vtkSmartPointer<vtkPolyData>> without;
    for (const ViewStructure& one : m_structures) {
        triangles += static_cast<double>(one.picture.picture()->GetNumberOfPolys());
        if (!one.picture.hasCoarsePicture() &&
            one.picture.picture()->GetNumberOfPolys() >= CoarseSurfaces::kLeastTriangles) {
            without.emplace_back(one.picture.picture());
        }
    }
    const double divisor = triangles / CoarseSurfaces::kTriangles;
    if (!without.empty() && divisor > kLeastDivisor) {
        m_coarse.start(without, divisor);
    }
}

void SceneView::takeCoarsePictures()
{
    for (const auto& [surface, coarse] : m_coarse.take()) {
        for (ViewStructure& one : m_structures) {
            if (one.picture.picture() == surface) {
                one.picture.setCoarsePicture(coarse);
            }
        }
    }
    for (ViewStructure& one : m_structures) {
        one.picture.setCoarse(m_isCoarse);
    }
}

void SceneView::setSection(const std::optional<geometry::SectionPlane>& plane)
{
    m_section = plane;
    m_isSectionOld = true;
}

void SceneView::setImage(std::shared_ptr<const geometry::VoxelVolume> volume, const geometry::GreyWindow& window)
{
    m_image.setVolume(std::move(volume));
    m_image.setWindow(window);
    m_isSectionOld = true;
}

std::optional<double> SceneView::imageNumberAt(const Vec3& p_W) const
{
    return m_section && m_image.volume() != nullptr ? m_image.volume()->numberAt(p_W) : std::nullopt;
}

struct SceneView::CutInput
{
    std::vector<CutSurface> surfaces;
    std::deque<std::vector<Vec3>> movedVertices; ///< to which surfaces refer
};

/// The visible structures as drawn.
SceneView::CutInput SceneView::cutInput() const
{
    CutInput input;
    for (const ViewStructure& one : m_structures) {
        CutSurface surface;
        const Appearance& look = one.picture.appearance();
        if (one.surface != nullptr && look.isVisible && look.opacity > 0.0) {
            surface.vertices = one.surface->mesh.vertices;
            surface.triangles = one.surface->mesh.triangles;
            surface.twoSided = one.surface->twoSided;
            surface.bounds = one.surface->report.bounds;
            if (const MovedSurface& moved = one.picture.moved(); moved.motion != nullptr) {
                std::vector<Vec3>& vertices = input.movedVertices.emplace_back(one.surface->mesh.vertices);
                surface.bounds.setEmpty();
                for (Vec3& p_W : vertices) {
                    p_W = moved.motion->toWorld(moved.moment, p_W);
                    surface.bounds.extend(p_W);
                }
                surface.vertices = vertices;
            }
            surface.colour = look.colour;
            surface.isFilled = look.opacity > kLeastFilled;
        }
        input.surfaces.push_back(surface);
    }
    return input;
}

std::vector<SectionCut> SceneView::cutsAt(const geometry::SectionPlane& plane) const
{
    CutInput input = cutInput();
    for (CutSurface& surface : input.surfaces) {
        surface.isFilled = true;
    }
    return cutsOf(plane, input.surfaces);
}

void SceneView::cutTissue()
{
    if (!m_isSectionOld) {
        return;
    }
    m_isSectionOld = false;
    ++m_sectionRevision;
    for (ViewStructure& one : m_structures) {
        one.picture.clip(m_section ? m_sectionPicture.clipping() : nullptr);
    }
    if (!m_section) {
        m_sectionPicture.hide();
        m_image.hide();
        return;
    }
    const CutInput input = cutInput();
    m_sectionPicture.setFilled(!m_image.show(*m_section));
    m_sectionPicture.show(*m_section, input.surfaces);
}

void SceneView::prepareFrame(double pixelRatio)
{
    (void)follow();
    ViewFrame frame = ViewFrame::of(*m_solid, pixelRatio);
    frame.text = m_text;
    if (m_window != nullptr) {
        m_cube.place(camera(), m_window->GetSize(), frame, m_coveredBelow_px);
    }
    m_scaleBar.place(Vec3(camera().GetFocalPoint()), frame, m_solid->GetSize()[0], m_coveredBelow_px);
    placeLegend(frame);
    bendTissue(frame);
    cutTissue();
    takeCoarsePictures();
    m_cursor.place(frame, coveredBoxes());
    findHiddenFindings(frame);
    std::vector<Eigen::AlignedBox2d> marks = m_cursor.marks_px(frame);
    if (!m_covered.isEmpty()) {
        marks.push_back(m_covered);
    }
    m_findings.place(frame, marks);
    placeMeasures(frame);
    core::Box box = bounds();
    box.extend(m_cursor.bounds());
    box.extend(m_findings.bounds());
    box.extend(m_measures.bounds());
    if (!box.isEmpty()) {
        // Room for the ball and its rings, which have a size on screen but no extent in space.
        const double room = 20.0 * frame.mmPerPixel(box.center());
        const Vec3 low = box.min() - Vec3::Constant(room);
        const Vec3 high = box.max() + Vec3::Constant(room);
        const double bounds[6] = {low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
        m_solid->ResetCameraClippingRange(bounds);
    }
    // Without sorting, several translucent structures would blend differently and change their colours.
    const auto translucent = std::count_if(m_structures.begin(), m_structures.end(), [](const ViewStructure& one) {
        return one.picture.appearance().isVisible && one.picture.appearance().opacity < 1.0;
    });
    m_solid->SetUseDepthPeeling(m_isSorted || translucent > 1);
    m_solid->SetMaximumNumberOfPeels(m_isCoarse ? kCoarsePeels : kPeels);
    // SSAO uses the depth of opaque geometry: behind translucent tissue it would darken the wrong places.
    const bool isOpaque = std::all_of(m_structures.begin(), m_structures.end(), [](const ViewStructure& one) {
        return !one.picture.appearance().isVisible || one.picture.appearance().opacity >= 1.0;
    });
    m_solid->SetUseSSAO(m_hasOcclusion && isOpaque && !box.isEmpty());
    if (m_solid->GetUseSSAO()) {
        m_solid->SetSSAORadius(0.05 * box.diagonal().norm());
        m_solid->SetSSAOBias(0.001 * box.diagonal().norm());
        m_solid->SetSSAOKernelSize(64);
        m_solid->SSAOBlurOn();
    }
}

} // namespace palpate::view
