// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/OrientationCube.h"

#include <palpate/core/Types.h>

#include <vtkProperty.h>

#include <algorithm>

namespace palpate::view {

namespace {

constexpr double kSide = 7.0; // in letters
constexpr double kUsual_px = 84.0;
constexpr double kMost = 0.25; // fraction of the view
constexpr double kLeft_px = 10.0;

} // namespace

OrientationCube::OrientationCube()
    : m_cube(vtkSmartPointer<vtkAnnotatedCubeActor>::New())
    , m_renderer(vtkSmartPointer<vtkRenderer>::New())
{
    vtkAnnotatedCubeActor* cube = m_cube;
    setSidesKnown(true);
    cube->SetXFaceTextRotation(0);
    cube->SetYFaceTextRotation(0);
    cube->SetZFaceTextRotation(-90);
    cube->SetTextEdgesVisibility(0);
    cube->GetCubeProperty()->SetColor(0.86, 0.88, 0.90);
    cube->GetCubeProperty()->SetAmbient(0.35);
    cube->GetCubeProperty()->SetDiffuse(0.65);
    for (vtkProperty* letter :
         {cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(), cube->GetYPlusFaceProperty(),
          cube->GetYMinusFaceProperty(), cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty()}) {
        letter->SetColor(0.10, 0.14, 0.20);
        letter->LightingOff();
        letter->SetInterpolationToFlat();
    }
    m_renderer->AddActor(m_cube);
    m_renderer->SetLayer(1);
    m_renderer->InteractiveOff();
}

void OrientationCube::setSidesKnown(bool isKnown)
{
    const std::string mark = isKnown ? "" : "?";
    // LPS: x points to the patient's left, y to the back, z to the head
    m_cube->SetXPlusFaceText(("L" + mark).c_str());
    m_cube->SetXMinusFaceText(("R" + mark).c_str());
    m_cube->SetYPlusFaceText(("P" + mark).c_str());
    m_cube->SetYMinusFaceText(("A" + mark).c_str());
    m_cube->SetZPlusFaceText(("S" + mark).c_str());
    m_cube->SetZMinusFaceText(("I" + mark).c_str());
    m_cube->SetFaceTextScale(isKnown ? 0.62 : 0.48);
}

std::string OrientationCube::left() const
{
    return m_cube->GetXPlusFaceText();
}

void OrientationCube::place(vtkCamera& main, const int size_px[2], const ViewFrame& frame, double below_px)
{
    // The cube grows with the font size but stays small in a small view.
    const double most = std::max(kUsual_px * frame.pixelRatio, kMost * std::min(size_px[0], size_px[1]));
    const double side = std::min(kSide * frame.text.size_px * frame.pixelRatio, most);
    const double left = kLeft_px * frame.pixelRatio;
    const double low = (kLeft_px + below_px) * frame.pixelRatio;
    m_top_px = (low + side) / frame.pixelRatio;
    const double width = std::max(1, size_px[0]);
    const double height = std::max(1, size_px[1]);
    m_renderer->SetViewport(std::min(1.0, left / width), std::min(1.0, low / height),
                            std::min(1.0, (left + side) / width), std::min(1.0, (low + side) / height));
    const core::Vec3 back = (core::Vec3(main.GetPosition()) - core::Vec3(main.GetFocalPoint())).normalized();
    vtkCamera* camera = m_renderer->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(4.2 * back.x(), 4.2 * back.y(), 4.2 * back.z());
    camera->SetViewUp(main.GetViewUp());
    camera->SetViewAngle(26.0);
    camera->SetClippingRange(1.0, 8.0);
}

} // namespace palpate::view
