// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfaceColours.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace palpate::view {

namespace {

constexpr double kCutShare = 0.02;  // clipped at each end
constexpr double kLightened = 0.18; // blended with white

std::array<unsigned char, 3> bytesOf(const Colour& colour)
{
    std::array<unsigned char, 3> bytes{};
    for (std::size_t c = 0; c < bytes.size(); ++c) {
        bytes[c] = static_cast<unsigned char>(std::lround(255.0 * colour[c]));
    }
    return bytes;
}

std::array<unsigned char, 3> bytesOf(float value, const ColourRange& range, const Colour& unknown)
{
    const double width = range.high - range.low;
    return bytesOf(!std::isfinite(value) ? unknown
                                         : surfaceColour(width > 0.0 ? (double{value} - range.low) / width : 0.5));
}

/// Makes an array for the colours of this many tuples.
vtkSmartPointer<vtkUnsignedCharArray> colourArray(vtkIdType tuples)
{
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetName("Colours");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(tuples);
    return colours;
}

/// Colours the points of a picture. At feature edges a vertex has several points, so points are looked up per corner.
/// @param bytesAt  colour of a vertex
template<class BytesAt>
void colourPoints(vtkPolyData& picture, const std::vector<geometry::Triangle>& triangles, const BytesAt& bytesAt)
{
    const auto colours = colourArray(picture.GetNumberOfPoints());
    vtkDataArray* points = picture.GetPolys()->GetConnectivityArray();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto corner = static_cast<vtkIdType>(3 * t + c);
            colours->SetTypedTuple(static_cast<vtkIdType>(points->GetComponent(corner, 0)),
                                   bytesAt(triangles[t][c]).data());
        }
    }
    picture.GetPointData()->SetScalars(colours);
}

} // namespace

Colour surfaceColour(double t) noexcept
{
    Colour colour = cividis(t);
    for (double& c : colour) {
        c += kLightened * (1.0 - c);
    }
    return colour;
}

ColourRange colourRange(std::span<const float> values)
{
    std::vector<float> known;
    known.reserve(values.size());
    std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](float v) { return std::isfinite(v); });
    ColourRange range;
    range.hasUnknown = known.size() < values.size();
    if (known.empty()) {
        return range;
    }
    const auto [least, largest] = std::minmax_element(known.begin(), known.end());
    const double low = *least, high = *largest;
    const auto at = [&known](double share) {
        const auto place =
            known.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(known.size() - 1) + 0.5);
        std::nth_element(known.begin(), place, known.end());
        return double{*place};
    };
    range.low = at(kCutShare);
    range.high = at(1.0 - kCutShare);
    if (!(range.high > range.low)) {
        range.low = low;
        range.high = high;
    }
    range.isLowCut = low < range.low;
    range.isHighCut = high > range.high;
    return range;
}

vtkSmartPointer<vtkPolyData> coloured(vtkPolyData& picture, const geometry::RepairedMesh& surface,
                                      std::span<const float> values, bool isPerTriangle, const ColourRange& range,
                                      const Colour& unknown)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(&picture);
    const std::vector<geometry::Triangle>& triangles = surface.mesh.triangles;
    if (values.size() != (isPerTriangle ? triangles.size() : surface.mesh.vertices.size())) {
        return data;
    }
    const auto bytes = [&](std::size_t i) { return bytesOf(values[i], range, unknown); };
    if (!isPerTriangle) {
        colourPoints(*data, triangles, bytes);
        return data;
    }
    const auto colours = colourArray(static_cast<vtkIdType>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        colours->SetTypedTuple(static_cast<vtkIdType>(t), bytes(t).data());
    }
    data->GetCellData()->SetScalars(colours);
    return data;
}

vtkSmartPointer<vtkPolyData> coloured(vtkPolyData& picture, const geometry::RepairedMesh& surface,
                                      std::span<const Colour> colours)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(&picture);
    if (colours.size() == surface.mesh.vertices.size()) {
        colourPoints(*data, surface.mesh.triangles, [&](std::size_t i) { return bytesOf(colours[i]); });
    }
    return data;
}

} // namespace palpate::view
