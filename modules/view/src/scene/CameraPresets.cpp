// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/CameraPresets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::view {

using core::Vec3;

namespace {

struct ViewDirection
{
    Vec3 from_W; ///< direction from the patient to the viewer
    Vec3 up_W;
};

ViewDirection viewDirection(ViewFrom from)
{
    switch (from) {
    case ViewFrom::Front:
        return {-Vec3::UnitY(), Vec3::UnitZ()};
    case ViewFrom::Back:
        return {Vec3::UnitY(), Vec3::UnitZ()};
    case ViewFrom::Left:
        return {Vec3::UnitX(), Vec3::UnitZ()};
    case ViewFrom::Right:
        return {-Vec3::UnitX(), Vec3::UnitZ()};
    case ViewFrom::Head:
        return {Vec3::UnitZ(), -Vec3::UnitY()};
    case ViewFrom::Feet:
        return {-Vec3::UnitZ(), -Vec3::UnitY()};
    case ViewFrom::Oblique:
        break;
    }
    return {Vec3(0.55, -1.0, 0.45).normalized(), Vec3::UnitZ()};
}

} // namespace

void fit(vtkCamera& camera, const core::Box& bounds, double aspect)
{
    if (bounds.isEmpty()) {
        return;
    }
    const Vec3 centre = bounds.center();
    const Vec3 position = Vec3(camera.GetPosition());
    const Vec3 back = (position - Vec3(camera.GetFocalPoint())).normalized();
    const Vec3 right = Vec3(camera.GetViewUp()).cross(back).normalized();
    const Vec3 up = back.cross(right);
    const double tangent = std::tan(camera.GetViewAngle() * std::numbers::pi / 360.0);
    // Each corner gives the distance at which it just fits; the margin leaves room for scale bar and cube.
    const double margin = 1.12;
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = bounds.corner(static_cast<core::Box::CornerType>(corner)) - centre;
        const double wide = std::abs(p.dot(right)) / (tangent * std::max(aspect, 1e-3));
        const double high = std::abs(p.dot(up)) / tangent;
        distance = std::max(distance, margin * std::max(wide, high) + p.dot(back));
    }
    distance = std::max(distance, 1e-6);
    camera.SetFocalPoint(centre.x(), centre.y(), centre.z());
    const Vec3 stand = centre + distance * back;
    camera.SetPosition(stand.x(), stand.y(), stand.z());
    camera.OrthogonalizeViewUp();
}

void lookFrom(vtkCamera& camera, ViewFrom from, const core::Box& bounds, double aspect)
{
    const ViewDirection stand = viewDirection(from);
    const Vec3 centre = bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(bounds.center());
    const Vec3 position = centre + stand.from_W;
    camera.SetFocalPoint(centre.x(), centre.y(), centre.z());
    camera.SetPosition(position.x(), position.y(), position.z());
    camera.SetViewUp(stand.up_W.x(), stand.up_W.y(), stand.up_W.z());
    fit(camera, bounds, aspect);
}

void turn(vtkCamera& camera, double right_deg, double up_deg)
{
    camera.Azimuth(right_deg);
    camera.Elevation(up_deg);
    camera.OrthogonalizeViewUp();
}

void shift(vtkCamera& camera, double right, double up)
{
    const Vec3 position(camera.GetPosition()), focus(camera.GetFocalPoint());
    const Vec3 back = (position - focus).normalized();
    const Vec3 right_W = Vec3(camera.GetViewUp()).cross(back).normalized();
    const double height_mm =
        camera.GetParallelProjection() != 0
            ? 2.0 * camera.GetParallelScale()
            : 2.0 * std::tan(camera.GetViewAngle() * std::numbers::pi / 360.0) * (position - focus).norm();
    const Vec3 way = height_mm * (right * right_W + up * back.cross(right_W));
    const Vec3 stand = position + way, seen = focus + way;
    camera.SetPosition(stand.x(), stand.y(), stand.z());
    camera.SetFocalPoint(seen.x(), seen.y(), seen.z());
}

} // namespace palpate::view
