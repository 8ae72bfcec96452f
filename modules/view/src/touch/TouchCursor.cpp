// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/TouchCursor.h"

#include "palpate/view/Dimple.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <utility>

namespace palpate::view {

namespace {

constexpr Colour kLight{0.98, 0.98, 0.96};
constexpr double kRimBall_px = 0.5 * TouchCursor::kBall_px + 2.6, kRimRing_px = 5.4; // radii including dark rims
constexpr double kInnerLift_px = 14.0;                  // draws inner marks above the line that passes them
constexpr double kPointer_px = 14.0;                    // half the size of the mouse pointer
constexpr double kCrossGap_px = 10.0, kCross_px = 24.0; // start and length of the crosshair's arms, from the centre

vtkSmartPointer<vtkActor> makeBall()
{
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(36);
    sphere->SetPhiResolution(24);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->PickableOff();
    return actor;
}

void placeBall(vtkActor& ball, const Vec3& p_W, double radius_mm)
{
    vtkNew<vtkMatrix4x4> X;
    for (int i = 0; i < 3; ++i) {
        X->SetElement(i, i, radius_mm);
        X->SetElement(i, 3, p_W[i]);
    }
    ball.SetUserMatrix(X);
}

/// Places a flat shape of unit radius on a surface.
void layOn(vtkActor& flat, const Vec3& p_W, const Vec3& n_W, double radius_mm)
{
    const Vec3 u = n_W.unitOrthogonal(), v = n_W.cross(u);
    vtkNew<vtkMatrix4x4> X;
    for (int i = 0; i < 3; ++i) {
        X->SetElement(i, 0, radius_mm * u[i]);
        X->SetElement(i, 1, radius_mm * v[i]);
        X->SetElement(i, 2, n_W[i]);
        X->SetElement(i, 3, p_W[i]);
    }
    flat.SetUserMatrix(X);
}

Eigen::AlignedBox2d boxAbout(const Eigen::Vector2d& centre, double half)
{
    return {centre - Eigen::Vector2d::Constant(half), centre + Eigen::Vector2d::Constant(half)};
}

std::string millimetres(double depth_mm, const TextStyle& style)
{
    return fixedText(depth_mm, depth_mm < 0.95 ? 2 : 1, style.decimalPoint) + " mm";
}

std::array<BillboardLine, 4> fourLines(double width_px, const Colour& colour)
{
    return {BillboardLine(width_px, colour), BillboardLine(width_px, colour), BillboardLine(width_px, colour),
            BillboardLine(width_px, colour)};
}

} // namespace

TouchCursor::TouchCursor()
    : m_ball(makeBall())
    , m_rim(makeBall())
    , m_outlineDark(makeRing(0.5 * kBall_px - 0.4, kRimBall_px, kDarkRim, 0.0))
    , m_outline(makeRing(0.5 * kBall_px + 0.4, 0.5 * kBall_px + 1.8, kLight, 0.5))
    , m_hipDark(makeRing(1.6, kRimRing_px, kDarkRim, 0.0))
    , m_hip(makeRing(2.5, 4.5, kLight, 0.5))
    , m_disc(makeRing(0.0, 1.0, kLight, 0.0))
    , m_discRim(makeRing(0.96, 1.0, kLight, 0.0))
    , m_patch(makeRing(0.0, 1.0, kDarkRim, 0.0))
    , m_patchDark(makeRing(0.96, 1.06, kDarkRim, 0.0))
    , m_patchRim(makeRing(0.88, 0.97, kLight, 0.0))
    , m_springDark(3.6, kDarkRim)
    , m_spring(1.6, kLight)
    , m_crossDark(fourLines(4.0, kDarkRim))
    , m_cross(fourLines(1.8, kLight))
{
    for (InnerMark& inner : m_inner) {
        inner.dark = makeRing(4.9, 6.1, kDarkRim, kInnerLift_px);
        inner.light = makeRing(3.7, 5.0, kLight, kInnerLift_px + 0.2);
        inner.mark = makeRing(0.0, 3.8, kLight, kInnerLift_px + 0.4);
    }
    m_patch->GetProperty()->SetOpacity(0.28); // looks like the shadow in a dent
    m_patchDark->GetProperty()->SetOpacity(0.7);
    m_patchRim->GetProperty()->SetOpacity(0.9);
    m_disc->GetProperty()->SetOpacity(0.16);
    m_discRim->GetProperty()->SetOpacity(0.6);
    m_ball->GetProperty()->SetAmbient(0.35);
    m_ball->GetProperty()->SetDiffuse(0.7);
    m_ball->GetProperty()->SetSpecular(0.35);
    m_ball->GetProperty()->SetSpecularPower(30.0);
    // The rim shows the back faces of a slightly larger sphere: a dark outline from every direction.
    m_rim->GetProperty()->LightingOff();
    m_rim->GetProperty()->FrontfaceCullingOn();
    m_rim->GetProperty()->SetColor(kDarkRim[0], kDarkRim[1], kDarkRim[2]);
}

void TouchCursor::addTo(vtkRenderer& solid, vtkRenderer& overlay)
{
    solid.AddActor(m_ball);
    solid.AddActor(m_rim);
    for (vtkActor* flat :
         {m_springDark.actor(), m_spring.actor(), m_outlineDark.Get(), m_outline.Get(), m_hipDark.Get(), m_hip.Get()}) {
        overlay.AddActor(flat);
    }
    for (vtkActor* flat : {m_patch.Get(), m_patchDark.Get(), m_patchRim.Get(), m_disc.Get(), m_discRim.Get()}) {
        overlay.AddActor(flat);
    }
    for (const InnerMark& inner : m_inner) {
        for (vtkActor* flat : {inner.dark.Get(), inner.light.Get(), inner.mark.Get(), inner.line.actor()}) {
            overlay.AddActor(flat);
        }
    }
    for (std::size_t i = 0; i < m_cross.size(); ++i) {
        overlay.AddActor(m_crossDark[i].actor());
        overlay.AddActor(m_cross[i].actor());
    }
    m_arrow.addTo(solid, overlay);
    m_labels.addTo(overlay);
}

void TouchCursor::setForceLimit(double force_N)
{
    m_limit_N = force_N > 0.0 ? force_N : m_limit_N;
}

Colour TouchCursor::ballColour() const
{
    return m_state.isInContact ? cividis(m_state.f_W.norm() / m_limit_N) : kLight;
}

void TouchCursor::place(const ViewFrame& frame, const std::vector<Eigen::AlignedBox2d>& taken)
{
    const bool isThere = m_state.isPresent && m_state.p_WH.allFinite() && m_state.p_WG.allFinite();
    const bool isTouching = isThere && m_state.isInContact;
    m_ball->SetVisibility(isThere);
    m_rim->SetVisibility(isTouching);
    for (vtkActor* flat : {m_outlineDark.Get(), m_outline.Get(), m_springDark.actor(), m_spring.actor()}) {
        flat->SetVisibility(isTouching);
    }
    m_hip->SetVisibility(isThere);
    m_hipDark->SetVisibility(isThere);
    m_arrow.setVisible(false);
    placeInner(frame, isTouching);
    placeFriction(isTouching);
    placeContact(frame, isTouching);
    placeCrosshair(frame, isThere);
    if (!isThere) {
        placeLabels(frame, false, taken);
        return;
    }
    const double pixel_mm = frame.mmPerPixel(m_state.p_WG);
    const double ball_mm = std::max(0.5 * kBall_px * pixel_mm, m_state.fingertip_mm);
    const Vec3 ball_W = m_state.p_WG + dentOffset_W();
    placeBall(*m_ball, ball_W, ball_mm);
    const Colour colour = ballColour();
    m_ball->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    // A fingertip larger than the cursor must not hide the tissue below.
    const bool isLarge = m_state.fingertip_mm > 0.5 * kBall_px * pixel_mm;
    m_ball->GetProperty()->SetOpacity(!isTouching ? 0.35 : isLarge ? 0.5 : 1.0);
    placeBillboard(*m_hip, m_state.p_WH, frame);
    placeBillboard(*m_hipDark, m_state.p_WH, frame);
    if (!isTouching) {
        placeLabels(frame, false, taken);
        return;
    }
    placeBall(*m_rim, ball_W, ball_mm + 1.4 * pixel_mm);
    placeBillboard(*m_outline, m_state.p_WG, frame);
    placeBillboard(*m_outlineDark, m_state.p_WG, frame);
    m_springDark.place(m_state.p_WH, m_state.p_WG, frame);
    const Vec3 over = 1.5 * pixel_mm * frame.back_W;
    m_spring.place(m_state.p_WH + over, m_state.p_WG + over, frame);
    // Dark blue, the colour of a light touch, has too little contrast on shaded tissue: use the brighter half of the
    // map.
    const double share = m_state.f_W.norm() / m_limit_N;
    m_arrow.place(m_state.p_WG, m_state.f_W, cividis(0.55 + 0.45 * share), 0.5 * kBall_px + 2.0, frame);
    placeLabels(frame, true, taken);
}

/// Offset from the surface at rest to the bottom of the dent.
Vec3 TouchCursor::dentOffset_W() const
{
    const Dimple dimple = Dimple::of(m_state);
    return m_drawsInDent ? Vec3(-dimple.depth_mm * dimple.n_W) : Vec3::Zero();
}

double TouchCursor::patchRadius_mm(const ViewFrame& frame) const
{
    const double pixel_mm = frame.mmPerPixel(m_state.p_WG);
    return m_state.fingertip_mm > 0.0
               ? std::max(m_state.fingertip_mm, kSmallestPatch_px * pixel_mm)
               : std::clamp(kPatch_mm, kSmallestPatch_px * pixel_mm, kLargestPatch_px * pixel_mm);
}

void TouchCursor::placeContact(const ViewFrame& frame, bool isTouching)
{
    Vec3 n_W = m_state.n_W;
    if (!n_W.allFinite() || !(n_W.norm() > 0.5)) {
        n_W = m_state.p_WG - m_state.p_WH; // normal unknown
    }
    const bool isShown = isTouching && n_W.norm() > 0.0;
    m_patch_mm = isShown ? patchRadius_mm(frame) : 0.0;
    for (vtkActor* flat : {m_patch.Get(), m_patchDark.Get(), m_patchRim.Get()}) {
        flat->SetVisibility(isShown);
        if (isShown) {
            n_W.normalize();
            // The god-object of a fingertip is the centre of its sphere.
            layOn(*flat, m_state.p_WG + dentOffset_W() - m_state.fingertip_mm * n_W, n_W, m_patch_mm);
        }
    }
}

void TouchCursor::placeCrosshair(const ViewFrame& frame, bool isThere)
{
    const Vec3& p_W = m_state.p_WH;
    const bool isShown = isThere && m_state.hasCrosshair;
    const Vec3 ways[4] = {frame.right_W, -frame.right_W, frame.up_W, -frame.up_W};
    for (std::size_t i = 0; i < m_cross.size(); ++i) {
        m_cross[i].actor()->SetVisibility(isShown);
        m_crossDark[i].actor()->SetVisibility(isShown);
        if (isShown) {
            const double pixel_mm = frame.mmPerPixel(p_W);
            const Vec3 lift = 1.5 * pixel_mm * frame.back_W;
            m_crossDark[i].place(p_W + (kCrossGap_px - 1.0) * pixel_mm * ways[i],
                                 p_W + (kCross_px + 1.0) * pixel_mm * ways[i], frame);
            m_cross[i].place(p_W + kCrossGap_px * pixel_mm * ways[i] + lift,
                             p_W + kCross_px * pixel_mm * ways[i] + lift, frame);
        }
    }
}

std::vector<Eigen::AlignedBox2d> TouchCursor::marks_px(const ViewFrame& frame) const
{
    if (!m_state.isPresent) {
        return {};
    }
    return {boxAbout(frame.pixelOf(m_state.p_WG), kRimBall_px), boxAbout(frame.pixelOf(m_state.p_WH), kRimRing_px)};
}

void TouchCursor::placeLabels(const ViewFrame& frame, bool isTouching, const std::vector<Eigen::AlignedBox2d>& others)
{
    const Eigen::Vector2d g = frame.pixelOf(m_state.p_WG), h = frame.pixelOf(m_state.p_WH);
    const Eigen::Vector2d half(0.5 * frame.width_px, 0.5 * frame.height_px);
    const Eigen::AlignedBox2d view(-half, half);
    if (!isTouching ||
        // A number would seem to belong to something else while the contact is outside the view.
        (!view.contains(g) && !view.contains(h))) {
        m_labels.place({}, {}, frame);
        return;
    }
    const Eigen::Vector2d tip = frame.pixelOf(m_arrow.tip_W());
    const double patch_px = std::min(m_patch_mm / frame.mmPerPixel(m_state.p_WG), 2.0 * kLargestPatch_px);
    std::vector<Eigen::AlignedBox2d> taken{boxAbout(g, std::max(m_arrow.radius_px() + 4.0, patch_px)),
                                           boxAbout(h, m_state.hasCrosshair ? kCross_px : kPointer_px)};
    taken.insert(taken.end(), others.begin(), others.end());
    constexpr int kPieces = 6; // boxes that cover a line
    for (int i = 0; i <= kPieces; ++i) {
        const double share = static_cast<double>(i) / kPieces;
        taken.push_back(boxAbout(g + share * (tip - g), 8.0));
        taken.push_back(boxAbout(g + share * (h - g), 5.0));
    }
    // The force is labelled beside the tip of the arrow, the depths below one another on the other side.
    const Eigen::Vector2d along = tip - g;
    const bool isLeft = along.x() < -8.0;
    std::vector<TouchLabels::Item> items;
    items.push_back(
        {m_arrow.label(), m_arrow.tip_W(), {isLeft ? -1.0 : 1.0, along.y() < -8.0 ? -0.6 : 0.6}, kTextColour, true});
    const Eigen::Vector2d beside(isLeft ? 1.0 : -1.0, 0.0);
    const double depth_mm = (m_state.p_WG - m_state.p_WH).norm();
    const auto middle = [&](const Vec3& p_WG) -> Vec3 { return 0.5 * (p_WG + m_state.p_WH); };
    const std::size_t innerCount = std::min(m_state.innerCount, m_state.inner.size());
    // The depth of the outermost layer is labelled beside the part of the line inside this layer only.
    const Vec3 outerEnd_W = innerCount > 0 ? m_state.inner[0].p_WG : m_state.p_WH;
    items.push_back({millimetres(depth_mm, frame.text), 0.5 * (m_state.p_WG + outerEnd_W), beside, kTextColour, false});
    for (std::size_t i = 0; i < innerCount; ++i) {
        const TouchState::Inner& inner = m_state.inner[i];
        items.push_back(
            {millimetres(inner.depth_mm, frame.text), middle(inner.p_WG), beside, textColourOf(inner.colour), false});
    }
    m_labels.place(items, std::move(taken), frame);
}

void TouchCursor::placeFriction(bool isTouching)
{
    const TouchState::FrictionDisc& disc = m_state.friction;
    const bool isShown = isTouching && disc.radius_mm > 0.0 && disc.p_W.allFinite() && disc.n_W.allFinite();
    for (vtkActor* flat : {m_disc.Get(), m_discRim.Get()}) {
        flat->SetVisibility(isShown);
        if (isShown) {
            layOn(*flat, disc.p_W, disc.n_W, disc.radius_mm);
        }
    }
}

void TouchCursor::placeInner(const ViewFrame& frame, bool isTouching)
{
    for (std::size_t i = 0; i < m_inner.size(); ++i) {
        const TouchState::Inner& inner = m_state.inner[i];
        const bool isShown = isTouching && i < m_state.innerCount && inner.p_WG.allFinite();
        m_inner[i].line.actor()->SetVisibility(isShown);
        m_inner[i].line.actor()->GetProperty()->SetColor(inner.colour[0], inner.colour[1], inner.colour[2]);
        if (isShown) { // drawn over the common line
            const Vec3 lift = 3.0 * frame.mmPerPixel(inner.p_WG) * frame.back_W;
            m_inner[i].line.place(inner.p_WG + lift, m_state.p_WH + lift, frame);
        }
        for (vtkActor* flat : {m_inner[i].dark.Get(), m_inner[i].light.Get(), m_inner[i].mark.Get()}) {
            flat->SetVisibility(isShown);
            if (isShown) {
                placeBillboard(*flat, inner.p_WG, frame);
            }
        }
        m_inner[i].mark->GetProperty()->SetColor(inner.colour[0], inner.colour[1], inner.colour[2]);
    }
}

core::Box TouchCursor::bounds() const
{
    core::Box box;
    if (!m_state.isPresent || !m_state.p_WH.allFinite() || !m_state.p_WG.allFinite()) {
        return box;
    }
    box.extend(m_state.p_WH);
    box.extend(m_state.p_WG);
    const Vec3 patch = Vec3::Constant(m_state.isInContact ? m_patch_mm + m_state.fingertip_mm : 0.0);
    box.extend(Vec3(m_state.p_WG - patch));
    box.extend(Vec3(m_state.p_WG + patch));
    if (m_state.isInContact && m_state.friction.radius_mm > 0.0 && m_state.friction.p_W.allFinite()) {
        const Vec3 half = Vec3::Constant(m_state.friction.radius_mm);
        box.extend(Vec3(m_state.friction.p_W - half));
        box.extend(Vec3(m_state.friction.p_W + half));
    }
    for (std::size_t i = 0; i < std::min(m_state.innerCount, m_state.inner.size()); ++i) {
        if (m_state.inner[i].p_WG.allFinite()) {
            box.extend(m_state.inner[i].p_WG);
        }
    }
    const double force_N = m_state.f_W.norm();
    if (m_state.isInContact && force_N > 0.0) {
        box.extend(Vec3(m_state.p_WG + m_state.f_W / force_N * (1.2 * m_arrow.length_mm())));
    }
    return box;
}

} // namespace palpate::view
