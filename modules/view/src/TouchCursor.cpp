// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/TouchCursor.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>

namespace palpate::view {

namespace {

constexpr Colour kLight{0.98, 0.98, 0.96};
constexpr double kInnerLift_px = 14.0; // inner marks lie over the spring that leads past them

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

} // namespace

TouchCursor::TouchCursor()
    : m_ball(makeBall())
    , m_rim(makeBall())
    , m_outlineDark(makeRing(0.5 * kBall_px - 0.4, 0.5 * kBall_px + 2.6, kDarkRim, 0.0))
    , m_outline(makeRing(0.5 * kBall_px + 0.4, 0.5 * kBall_px + 1.8, kLight, 0.5))
    , m_hipDark(makeRing(1.6, 5.4, kDarkRim, 0.0))
    , m_hip(makeRing(2.5, 4.5, kLight, 0.5))
    , m_disc(makeRing(0.0, 1.0, kLight, 0.0))
    , m_discRim(makeRing(0.96, 1.0, kLight, 0.0))
    , m_springDark(3.6, kDarkRim)
    , m_spring(1.6, kLight)
{
    for (InnerMark& inner : m_inner) {
        inner.dark = makeRing(4.9, 6.1, kDarkRim, kInnerLift_px);
        inner.light = makeRing(3.7, 5.0, kLight, kInnerLift_px + 0.2);
        inner.mark = makeRing(0.0, 3.8, kLight, kInnerLift_px + 0.4);
    }
    m_disc->GetProperty()->SetOpacity(0.16);
    m_discRim->GetProperty()->SetOpacity(0.6);
    m_ball->GetProperty()->SetAmbient(0.35);
    m_ball->GetProperty()->SetDiffuse(0.7);
    m_ball->GetProperty()->SetSpecular(0.35);
    m_ball->GetProperty()->SetSpecularPower(30.0);
    // The rim is the far side of a slightly larger ball: a dark edge round the ball from everywhere.
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
    overlay.AddActor(m_disc);
    overlay.AddActor(m_discRim);
    for (const InnerMark& inner : m_inner) {
        for (vtkActor* flat : {inner.dark.Get(), inner.light.Get(), inner.mark.Get()}) {
            overlay.AddActor(flat);
        }
    }
    m_arrow.addTo(solid, overlay);
}

void TouchCursor::setForceLimit(double force_N)
{
    m_limit_N = force_N > 0.0 ? force_N : m_limit_N;
}

Colour TouchCursor::ballColour() const
{
    return m_state.isInContact ? cividis(m_state.f_W.norm() / m_limit_N) : kLight;
}

void TouchCursor::place(const ViewFrame& frame)
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
    if (!isThere) {
        return;
    }
    const double pixel_mm = frame.mmPerPixel(m_state.p_WG);
    const double ball_mm = std::max(0.5 * kBall_px * pixel_mm, m_state.fingertip_mm);
    placeBall(*m_ball, m_state.p_WG, ball_mm);
    const Colour colour = ballColour();
    m_ball->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    // A fingertip larger than the cursor must not hide the tissue it presses.
    const bool isLarge = m_state.fingertip_mm > 0.5 * kBall_px * pixel_mm;
    m_ball->GetProperty()->SetOpacity(!isTouching ? 0.35 : isLarge ? 0.5 : 1.0);
    placeBillboard(*m_hip, m_state.p_WH, frame);
    placeBillboard(*m_hipDark, m_state.p_WH, frame);
    if (!isTouching) {
        return;
    }
    placeBall(*m_rim, m_state.p_WG, ball_mm + 1.4 * pixel_mm);
    placeBillboard(*m_outline, m_state.p_WG, frame);
    placeBillboard(*m_outlineDark, m_state.p_WG, frame);
    m_springDark.place(m_state.p_WH, m_state.p_WG, frame);
    m_spring.place(m_state.p_WH, m_state.p_WG, frame);
    // Dark blue, the colour of a light touch, is lost against tissue in shade: the arrow keeps to the brighter half.
    const double share = m_state.f_W.norm() / m_limit_N;
    m_arrow.place(m_state.p_WG, m_state.f_W, cividis(0.55 + 0.45 * share), 0.5 * kBall_px + 2.0, frame);
}

void TouchCursor::placeFriction(bool isTouching)
{
    const TouchState::FrictionDisc& disc = m_state.friction;
    const bool isShown = isTouching && disc.radius_mm > 0.0 && disc.p_W.allFinite() && disc.n_W.allFinite();
    const Vec3 u = disc.n_W.unitOrthogonal(), v = disc.n_W.cross(u);
    for (vtkActor* flat : {m_disc.Get(), m_discRim.Get()}) {
        flat->SetVisibility(isShown);
        vtkNew<vtkMatrix4x4> X;
        for (int i = 0; i < 3; ++i) {
            X->SetElement(i, 0, disc.radius_mm * u[i]);
            X->SetElement(i, 1, disc.radius_mm * v[i]);
            X->SetElement(i, 2, disc.n_W[i]);
            X->SetElement(i, 3, disc.p_W[i]);
        }
        flat->SetUserMatrix(X);
    }
}

void TouchCursor::placeInner(const ViewFrame& frame, bool isTouching)
{
    for (std::size_t i = 0; i < m_inner.size(); ++i) {
        const TouchState::Inner& inner = m_state.inner[i];
        const bool isShown = isTouching && i < m_state.innerCount && inner.p_WG.allFinite();
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
