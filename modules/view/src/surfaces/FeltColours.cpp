// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/FeltColours.h"

#include "palpate/view/SurfaceColours.h"
#include "surfaces/ArrayShader.h"

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstddef>

namespace palpate::view {

namespace {

constexpr const char* kArray = "FeltLines"; // change [%], and 1 where not evaluated

/// Contour lines at the thresholds. The first line is dark between light rims; the others have a light core between
/// dark rims and are wider. This keeps them distinguishable and visible on every colour and background. Palpable
/// regions are opaque, the others show the layers below.
constexpr const char* kFragment = R"(//VTK::Color::Impl
  if (shadedVSOutput.y > 0.001) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0);
    vec3 hatch = stripe < 3.0 ? vec3(0.36) : vec3(0.74);
    ambientColor = ambientIntensity * hatch;
    diffuseColor = diffuseIntensity * hatch;
    opacity = max(opacity, 0.55);
  } else {
    float perPixel = max(fwidth(shadedVSOutput.x), 1e-6);
    float far7 = abs(shadedVSOutput.x - 7.0) / perPixel;
    float far14 = abs(shadedVSOutput.x - 14.0) / perPixel;
    float far28 = abs(shadedVSOutput.x - 28.0) / perPixel;
    float dark = max(max(2.6 - far7, 2.4 - far14), 3.4 - far28);
    float light = max(max(min(far7 - 0.9, 2.6 - far7), 1.2 - far14), 2.2 - far28);
    float ink = clamp(dark, 0.0, 1.0);
    vec3 line = mix(vec3(0.05, 0.06, 0.08), vec3(1.0), clamp(light, 0.0, 1.0));
    ambientColor = mix(ambientColor, 0.5 * line, ink);
    diffuseColor = mix(diffuseColor, 0.5 * line, ink);
    opacity = max(opacity, max(ink, mix(0.5, 0.92, clamp(shadedVSOutput.x / 14.0, 0.0, 1.0))));
  }
)";

} // namespace

vtkSmartPointer<vtkPolyData> palpabilityColoured(vtkPolyData& picture, const geometry::TriangleMesh& mesh,
                                                 const FeltColours& colours)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(&picture);
    auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
    bytes->SetName("Colours");
    bytes->SetNumberOfComponents(3);
    bytes->SetNumberOfTuples(picture.GetNumberOfPoints());
    auto lines = vtkSmartPointer<vtkFloatArray>::New();
    lines->SetName(kArray);
    lines->SetNumberOfComponents(2);
    lines->SetNumberOfTuples(picture.GetNumberOfPoints());
    vtkDataArray* points = picture.GetPolys()->GetConnectivityArray();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) { // at feature edges, a vertex has several points
            const auto point = static_cast<vtkIdType>(points->GetComponent(static_cast<vtkIdType>(3 * t + c), 0));
            const std::size_t v = mesh.triangles[t][c];
            const float change = colours.change_percent[v];
            const Colour colour = surfaceColour(double{change} / colours.greatest_percent);
            bytes->SetTuple3(point, std::round(255.0 * colour[0]), std::round(255.0 * colour[1]),
                             std::round(255.0 * colour[2]));
            lines->SetTuple2(point, change, colours.isNotJudged[v] != 0 ? 1.0 : 0.0);
        }
    }
    data->GetPointData()->SetScalars(bytes);
    data->GetPointData()->AddArray(lines);
    return data;
}

void drawPalpabilityContours(vtkActor& actor, vtkPolyData& picture)
{
    if (picture.GetPointData()->GetArray(kArray) != nullptr) {
        shadeByArray(actor, kArray, 2, kFragment);
    }
}

} // namespace palpate::view
