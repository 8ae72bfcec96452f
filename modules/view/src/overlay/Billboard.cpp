// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/Billboard.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::view {

namespace {

vtkSmartPointer<vtkActor> makeFlat(vtkPolyData* shape, const Colour& colour)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    return actor;
}

constexpr int kSides = 40; // segments of a ring

} // namespace

ViewFrame ViewFrame::of(vtkRenderer& renderer, double pixelRatio)
{
    vtkCamera& camera = *renderer.GetActiveCamera();
    ViewFrame frame;
    frame.eye_W = Vec3(camera.GetPosition());
    frame.back_W = (frame.eye_W - Vec3(camera.GetFocalPoint())).normalized();
    frame.right_W = Vec3(camera.GetViewUp()).cross(frame.back_W).normalized();
    frame.up_W = frame.back_W.cross(frame.right_W);
    frame.width_px = std::max(1.0, renderer.GetSize()[0] / pixelRatio);
    frame.height_px = std::max(1.0, renderer.GetSize()[1] / pixelRatio);
    frame.isParallel = camera.GetParallelProjection() != 0;
    frame.scale = frame.isParallel ? 2.0 * camera.GetParallelScale()
                                   : 2.0 * std::tan(camera.GetViewAngle() * std::numbers::pi / 360.0);
    frame.pixelRatio = pixelRatio;
    return frame;
}

double ViewFrame::mmPerPixel(const Vec3& p_W) const
{
    const double depth = isParallel ? 1.0 : std::max(1e-9, (eye_W - p_W).dot(back_W));
    return scale * depth / height_px;
}

Eigen::Vector2d ViewFrame::pixelOf(const Vec3& p_W) const
{
    const Vec3 fromEye = p_W - eye_W;
    return Eigen::Vector2d(fromEye.dot(right_W), fromEye.dot(up_W)) / mmPerPixel(p_W);
}

Vec3 ViewFrame::towardsViewer(const Vec3& p_W) const
{
    return isParallel ? back_W : Vec3((eye_W - p_W).normalized());
}

void placeBillboard(vtkActor& actor, const Vec3& p_W, const ViewFrame& frame)
{
    const double size = frame.mmPerPixel(p_W);
    vtkNew<vtkMatrix4x4> X;
    for (int i = 0; i < 3; ++i) {
        X->SetElement(i, 0, size * frame.right_W[i]);
        X->SetElement(i, 1, size * frame.up_W[i]);
        X->SetElement(i, 2, size * frame.back_W[i]);
        X->SetElement(i, 3, p_W[i]);
    }
    actor.SetUserMatrix(X);
}

vtkSmartPointer<vtkActor> makeRing(double inner_px, double outer_px, const Colour& colour, double lift_px)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> faces;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        points->InsertNextPoint(inner_px * std::cos(angle), inner_px * std::sin(angle), lift_px);
        points->InsertNextPoint(outer_px * std::cos(angle), outer_px * std::sin(angle), lift_px);
        const vtkIdType next = (i + 1) % kSides;
        const vtkIdType quad[4] = {2 * i, 2 * i + 1, 2 * next + 1, 2 * next};
        faces->InsertNextCell(4, quad);
    }
    vtkNew<vtkPolyData> ring;
    ring->SetPoints(points);
    ring->SetPolys(faces);
    return makeFlat(ring, colour);
}

BillboardLine::BillboardLine(double width_px, const Colour& colour)
    : m_width_px(width_px)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(4);
    for (vtkIdType i = 0; i < 4; ++i) {
        points->SetPoint(i, 0.0, 0.0, 0.0);
    }
    vtkNew<vtkCellArray> faces;
    const vtkIdType quad[4] = {0, 1, 2, 3};
    faces->InsertNextCell(4, quad);
    vtkNew<vtkPolyData> strip;
    strip->SetPoints(points);
    strip->SetPolys(faces);
    m_actor = makeFlat(strip, colour);
}

void BillboardLine::place(const Vec3& from_W, const Vec3& to_W, const ViewFrame& frame)
{
    auto* strip = vtkPolyData::SafeDownCast(m_actor->GetMapper()->GetInput());
    // Perpendicular to the line and to the line of sight. Seen end-on, the direction is undefined and nothing is
    // visible.
    Vec3 across = (to_W - from_W).cross(frame.back_W);
    const double length = across.norm();
    across = length > 0.0 ? Vec3(across / length) : frame.right_W;
    const Vec3 a = across * (0.5 * m_width_px * frame.mmPerPixel(from_W));
    const Vec3 b = across * (0.5 * m_width_px * frame.mmPerPixel(to_W));
    const Vec3 corners[4] = {from_W - a, from_W + a, to_W + b, to_W - b};
    for (vtkIdType i = 0; i < 4; ++i) {
        strip->GetPoints()->SetPoint(i, corners[i].data());
    }
    strip->GetPoints()->Modified();
    strip->Modified();
}

BillboardCircle::BillboardCircle(double width_px, const Colour& colour)
    : m_actor(makeRing(0.0, 1.0, colour, 0.0))
    , m_width_px(width_px)
{
}

void BillboardCircle::place(const Vec3& p_W, double radius_px, const ViewFrame& frame)
{
    auto* ring = vtkPolyData::SafeDownCast(m_actor->GetMapper()->GetInput());
    const double inner_px = std::max(0.0, radius_px - 0.5 * m_width_px);
    const double outer_px = radius_px + 0.5 * m_width_px;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        ring->GetPoints()->SetPoint(2 * i, inner_px * std::cos(angle), inner_px * std::sin(angle), 0.0);
        ring->GetPoints()->SetPoint(2 * i + 1, outer_px * std::cos(angle), outer_px * std::sin(angle), 0.0);
    }
    ring->GetPoints()->Modified();
    ring->Modified();
    placeBillboard(*m_actor, p_W, frame);
}

} // namespace palpate::view
