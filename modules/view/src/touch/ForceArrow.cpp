// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ForceArrow.h"

#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace palpate::view {

namespace {

/// Actor of a unit shape along +y with its base at the origin.
vtkSmartPointer<vtkActor> makeShape(vtkPolyDataAlgorithm& source)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source.GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->GetProperty()->SetAmbient(0.45);
    actor->GetProperty()->SetDiffuse(0.6);
    return actor;
}

void placeAlong(vtkActor& actor, const Vec3& foot_W, const Vec3& axis, double length, double radius)
{
    const Vec3 side = axis.unitOrthogonal();
    const Vec3 other = side.cross(axis);
    vtkNew<vtkMatrix4x4> X;
    for (int i = 0; i < 3; ++i) {
        X->SetElement(i, 0, radius * side[i]);
        X->SetElement(i, 1, length * axis[i]);
        X->SetElement(i, 2, radius * other[i]);
        X->SetElement(i, 3, foot_W[i]);
    }
    actor.SetUserMatrix(X);
}

} // namespace

ForceArrow::ForceArrow()
    : m_circleDark(6.6, kDarkRim)
    , m_circle(4.2, kDarkRim)
{
    vtkNew<vtkCylinderSource> shaft;
    shaft->SetResolution(20);
    shaft->SetRadius(1.0);
    shaft->SetHeight(1.0);
    shaft->SetCenter(0.0, 0.5, 0.0);
    m_shaft = makeShape(*shaft);
    vtkNew<vtkConeSource> head;
    head->SetResolution(24);
    head->SetRadius(1.0);
    head->SetHeight(1.0);
    head->SetDirection(0.0, 1.0, 0.0);
    head->SetCenter(0.0, 0.5, 0.0);
    m_head = makeShape(*head);
}

void ForceArrow::addTo(vtkRenderer& solid, vtkRenderer& overlay)
{
    solid.AddActor(m_shaft);
    solid.AddActor(m_head);
    overlay.AddActor(m_circleDark.actor());
    overlay.AddActor(m_circle.actor());
}

void ForceArrow::setVisible(bool isVisible)
{
    for (vtkActor* part : {m_shaft.Get(), m_head.Get(), m_circleDark.actor(), m_circle.actor()}) {
        part->SetVisibility(isVisible);
    }
    m_radius_px = isVisible ? m_radius_px : 0.0;
}

void ForceArrow::place(const Vec3& p_W, const Vec3& f_W, const Colour& colour, double gap_px, const ViewFrame& frame)
{
    const double force_N = f_W.norm();
    const double pixel_mm = frame.mmPerPixel(p_W);
    const double longest_mm = kLongest * frame.height_px * pixel_mm;
    m_length_mm = std::min(kLength_mm_per_N * force_N, longest_mm);
    m_tip_W = p_W;
    m_label.clear();
    setVisible(false);
    if (!(force_N > 0.0)) {
        return;
    }
    m_label = fixedText(force_N, 2, frame.text.decimalPoint) + " N";

    const Vec3 axis = f_W / force_N;
    const double turned = std::abs(axis.dot(frame.towardsViewer(p_W)));
    // Weight of the circle.
    const double share = std::clamp((turned - kArrowOnly) / (kCircleOnly - kArrowOnly), 0.0, 1.0);
    const double shown_mm = (1.0 - share) * m_length_mm;
    if (share < 1.0) {
        const Vec3 start = p_W + gap_px * pixel_mm * axis;
        // A short arrow consists of the head only, scaled down to its length.
        const double head_mm = std::min(15.0 * pixel_mm, shown_mm);
        placeAlong(*m_shaft, start, axis, std::max(shown_mm - head_mm, 1e-9 * pixel_mm), 2.2 * pixel_mm);
        placeAlong(*m_head, start + (shown_mm - head_mm) * axis, axis, head_mm, head_mm * (6.0 / 15.0));
        m_tip_W = start + shown_mm * axis;
    }
    if (share > 0.0) {
        m_radius_px = gap_px + kRadius * m_length_mm / pixel_mm;
        m_circleDark.place(p_W, m_radius_px, frame);
        m_circle.place(p_W + 0.5 * pixel_mm * frame.back_W, m_radius_px, frame);
        m_circleDark.actor()->GetProperty()->SetOpacity(share);
        m_circle.actor()->GetProperty()->SetOpacity(share);
    }
    for (vtkActor* part : {m_shaft.Get(), m_head.Get()}) {
        part->SetVisibility(share < 1.0);
        part->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    }
    m_circle.actor()->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    m_circle.actor()->SetVisibility(share > 0.0);
    m_circleDark.actor()->SetVisibility(share > 0.0);
}

} // namespace palpate::view
