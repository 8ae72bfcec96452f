// SPDX-License-Identifier: BSD-3-Clause
// Contours a ball with VTK, presses 2 mm into it, and puts a map of how a hard lump below is felt on the points of the
// contour.
#include <palpate/buried/FeltSurface.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/vtk/PolyData.h>

#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSampleFunction.h>
#include <vtkSphere.h>

#include <cstdio>

using namespace palpate;

namespace {

vtkSmartPointer<vtkPolyData> ball(double x_mm, double radius_mm, double step_mm)
{
    const double half_mm = radius_mm + 2.0 * step_mm;
    const int side = static_cast<int>(2.0 * half_mm / step_mm) + 1;
    const vtkNew<vtkSphere> sphere;
    sphere->SetCenter(x_mm, 0.0, 0.0);
    sphere->SetRadius(radius_mm);
    const vtkNew<vtkSampleFunction> samples;
    samples->SetImplicitFunction(sphere);
    samples->SetModelBounds(x_mm - half_mm, x_mm + half_mm, -half_mm, half_mm, -half_mm, half_mm);
    samples->SetSampleDimensions(side, side, side);
    const vtkNew<vtkMarchingCubes> contour;
    contour->SetInputConnection(samples->GetOutputPort());
    contour->SetValue(0, 0.0);
    contour->Update();
    return contour->GetOutput();
}

} // namespace

int main()
{
    const vtkSmartPointer<vtkPolyData> organ = ball(0.0, 40.0, 2.0);
    const auto surface = palpate::vtk::surfaceOf(organ); // checked, repaired and turned outwards
    const auto lump = palpate::vtk::surfaceOf(ball(30.0, 5.0, 1.0));
    if (!surface.isOk() || !lump.isOk()) {
        std::fprintf(stderr, "%s\n", (surface.isOk() ? lump.status() : surface.status()).message().c_str());
        return 1;
    }
    for (const palpate::core::Message& sentence : surface.value().report.sentences()) {
        std::printf("organ: %s\n", sentence.english().c_str());
    }

    const auto index = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(surface.value()));
    const auto scene = haptics::HapticScene::make({{"organ", index, {0.5, 0.0}, 0}}); // 0.5 N/mm
    if (!scene.isOk()) {
        std::fprintf(stderr, "%s\n", scene.status().message().c_str());
        return 1;
    }
    haptics::Palpator palpator;
    palpator.setScene(scene.value());
    haptics::TickResult touch;
    for (int tick = 0; tick <= 60; ++tick) { // from 1 mm outside to 2 mm inside
        touch = palpator.step({0.1, 0.2, 41.0 - 0.05 * tick}, 1e-3);
    }
    std::printf("force %.1f N\n", touch.f_W.norm());

    const auto shared = std::make_shared<const geometry::RepairedMesh>(lump.value());
    const auto felt = buried::feltSurface("organ", surface.value(), {{"lump", shared, buried::RatioRange(10.0)}});
    if (!felt.isOk()) {
        std::fprintf(stderr, "%s\n", felt.status().message().c_str());
        return 1;
    }
    const auto map = palpate::vtk::atPoints(surface.value(), felt.value().press[0].ratio, "k/k0");
    organ->GetPointData()->SetScalars(map.value());
    std::printf("stiffness %.1f to %.1f times that of the organ at %lld points\n", map.value()->GetRange()[0],
                map.value()->GetRange()[1], static_cast<long long>(organ->GetNumberOfPoints()));
    return 0;
}
