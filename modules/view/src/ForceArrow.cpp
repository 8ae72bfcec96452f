// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ForceArrow.h"

#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cstdio>

namespace palpate::view {

namespace {

/// A unit shape along +y, standing on the origin.
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
    : m_label(vtkSmartPointer<vtkBillboardTextActor3D>::New())
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

    m_label->PickableOff();
    vtkTextProperty* text = m_label->GetTextProperty();
    text->SetBold(true);
    text->SetColor(1.0, 1.0, 1.0);
    text->SetBackgroundColor(0.08, 0.09, 0.11);
    text->SetBackgroundOpacity(0.72);
    text->SetJustificationToLeft();
    text->SetVerticalJustificationToCentered();
}

ForceArrow::~ForceArrow() = default;

void ForceArrow::addTo(vtkRenderer& solid, vtkRenderer& overlay)
{
    solid.AddActor(m_shaft);
    solid.AddActor(m_head);
    overlay.AddActor(m_label);
}

void ForceArrow::setVisible(bool isVisible)
{
    m_shaft->SetVisibility(isVisible);
    m_head->SetVisibility(isVisible);
    m_label->SetVisibility(isVisible);
}

void ForceArrow::place(const Vec3& p_W, const Vec3& f_W, const Colour& colour, double gap_px, const ViewFrame& frame)
{
    const double force_N = f_W.norm();
    const double pixel_mm = frame.mmPerPixel(p_W);
    const double longest_mm = kLongest * frame.height_px * pixel_mm;
    m_length_mm = std::min(kLength_mm_per_N * force_N, longest_mm);
    if (!(force_N > 0.0)) {
        setVisible(false);
        return;
    }
    const Vec3 axis = f_W / force_N;
    const Vec3 start = p_W + gap_px * pixel_mm * axis;
    // A short arrow is all head, shrunk to its length.
    const double head_mm = std::min(15.0 * pixel_mm, m_length_mm);
    placeAlong(*m_shaft, start, axis, std::max(m_length_mm - head_mm, 1e-9 * pixel_mm), 2.2 * pixel_mm);
    placeAlong(*m_head, start + (m_length_mm - head_mm) * axis, axis, head_mm, head_mm * (6.0 / 15.0));
    for (vtkActor* part : {m_shaft.Get(), m_head.Get()}) {
        part->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    }

    char value[32];
    std::snprintf(value, sizeof value, " %.2f N ", force_N);
    m_label->SetInput(value);
    m_label->GetTextProperty()->SetFontSize(std::max(8, static_cast<int>(15.0 * frame.pixelRatio)));
    Vec3 tip = start + m_length_mm * axis;
    m_label->SetPosition(tip.data());
    // Beyond the tip, on the side that the arrow points to, so that it never covers the arrow.
    const bool isLeft = axis.dot(frame.right_W) < -0.2;
    const double below = axis.dot(frame.up_W);
    isLeft ? m_label->GetTextProperty()->SetJustificationToRight()
           : m_label->GetTextProperty()->SetJustificationToLeft();
    m_label->SetDisplayOffset(static_cast<int>((isLeft ? -12 : 12) * frame.pixelRatio),
                              static_cast<int>(14 * below * frame.pixelRatio));
    setVisible(true);
}

std::string ForceArrow::label() const
{
    const char* text = m_label->GetInput();
    const std::string padded = text != nullptr ? text : "";
    const auto first = padded.find_first_not_of(' ');
    return first == std::string::npos ? "" : padded.substr(first, padded.find_last_not_of(' ') - first + 1);
}

} // namespace palpate::view
