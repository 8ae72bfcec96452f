// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/MarginColours.h"

#include "palpate/view/SurfaceColours.h"
#include "palpate/view/TextStyle.h"
#include "surfaces/ArrayShader.h"

#include <palpate/core/Types.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace palpate::view {

namespace {

constexpr const char* kDistances = "MarginDistance_mm";
constexpr const char* kLimits = "MarginLimits_mm";

std::string numberText(double value)
{
    return fixedText(value, 6, ".");
}

/// Writes the fragment program: steps of colour and, at each border, a dark line between light rims.
std::string bandProgram(vtkDataArray& limits)
{
    const auto count = static_cast<std::size_t>(limits.GetNumberOfTuples());
    const auto vec = [count](std::size_t band) {
        const Colour c = marginColour(band, count + 1);
        return "vec3(" + numberText(c[0]) + ", " + numberText(c[1]) + ", " + numberText(c[2]) + ")";
    };
    std::string program = "//VTK::Color::Impl\n"
                          "  vec3 band = " +
                          vec(0) +
                          ";\n"
                          "  float perPixel = max(fwidth(shadedVSOutput), 1e-6);\n"
                          "  float far = 1e6;\n";
    for (std::size_t i = 0; i < count; ++i) {
        const std::string limit = numberText(limits.GetComponent(static_cast<vtkIdType>(i), 0));
        program += "  if (shadedVSOutput >= " + limit + ") { band = " + vec(i + 1) + "; }\n";
        program += "  far = min(far, abs(shadedVSOutput - " + limit + ") / perPixel);\n";
    }
    return program + "  band = mix(band, vec3(1.0), clamp(2.6 - far, 0.0, 1.0));\n"
                     "  band = mix(band, vec3(0.05, 0.06, 0.08), clamp(1.6 - far, 0.0, 1.0));\n"
                     "  ambientColor = ambientIntensity * band;\n"
                     "  diffuseColor = diffuseIntensity * band;\n"
                     "  opacity = 1.0;\n";
}

double longestEdge_mm(vtkPoints& points, const vtkIdType* corners)
{
    double longest2 = 0.0;
    for (int k = 0; k < 3; ++k) {
        const core::Vec3 a(points.GetPoint(corners[k])), b(points.GetPoint(corners[(k + 1) % 3]));
        longest2 = std::max(longest2, (a - b).squaredNorm());
    }
    return std::sqrt(longest2);
}

/// Number of parts of each edge. @return 1: not split
int partsOf(double edge_mm, double longest_mm)
{
    constexpr double kMostParts = 64.0;
    return static_cast<int>(std::clamp(std::ceil(longest_mm / edge_mm), 1.0, kMostParts));
}

/// Splits a triangle into n² equal ones.
class Splitter
{
  public:
    explicit Splitter(vtkPolyData& from)
        : m_from(from)
        , m_to(vtkSmartPointer<vtkPolyData>::New())
    {
        m_points->SetDataType(from.GetPoints()->GetDataType());
        m_to->GetPointData()->InterpolateAllocate(from.GetPointData());
    }
    void add(const vtkIdType* corners, int n)
    {
        const core::Vec3 a(m_from.GetPoint(corners[0])), b(m_from.GetPoint(corners[1])), c(m_from.GetPoint(corners[2]));
        m_corners->SetNumberOfIds(3);
        for (vtkIdType k = 0; k < 3; ++k) {
            m_corners->SetId(k, corners[k]);
        }
        const vtkIdType first = m_points->GetNumberOfPoints();
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n - i; ++j) {
                std::array<double, 3> weights{0.0, double(i) / n, double(j) / n};
                weights[0] = 1.0 - weights[1] - weights[2];
                const core::Vec3 p = weights[0] * a + weights[1] * b + weights[2] * c;
                const vtkIdType at = m_points->InsertNextPoint(p.data());
                m_to->GetPointData()->InterpolatePoint(m_from.GetPointData(), at, m_corners, weights.data());
            }
        }
        // Row i has n - i + 1 points.
        const auto number = [first, n](int i, int j) { return first + i * (n + 1) - i * (i - 1) / 2 + j; };
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n - i; ++j) {
                insert(number(i, j), number(i + 1, j), number(i, j + 1));
                if (j + 1 < n - i) {
                    insert(number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
                }
            }
        }
    }
    vtkSmartPointer<vtkPolyData> result()
    {
        m_to->SetPoints(m_points);
        m_to->SetPolys(m_cells);
        return m_to;
    }

  private:
    void insert(vtkIdType a, vtkIdType b, vtkIdType c)
    {
        const vtkIdType corners[3] = {a, b, c};
        m_cells->InsertNextCell(3, corners);
    }
    vtkPolyData& m_from;
    vtkSmartPointer<vtkPolyData> m_to;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_cells;
    vtkNew<vtkIdList> m_corners;
};

} // namespace

Colour marginColour(std::size_t band, std::size_t count)
{
    return surfaceColour(count > 1 ? 1.0 - static_cast<double>(band) / static_cast<double>(count - 1) : 1.0);
}

vtkSmartPointer<vtkPolyData> refinedPicture(vtkPolyData& picture, double edge_mm, std::size_t most)
{
    vtkPoints& points = *picture.GetPoints();
    std::vector<double> longest_mm;
    std::vector<std::array<vtkIdType, 3>> triangles;
    vtkNew<vtkIdList> cell;
    for (vtkIdType i = 0; i < picture.GetPolys()->GetNumberOfCells(); ++i) {
        picture.GetPolys()->GetCellAtId(i, cell);
        triangles.push_back({cell->GetId(0), cell->GetId(1), cell->GetId(2)});
        longest_mm.push_back(longestEdge_mm(points, triangles.back().data()));
    }
    const auto count = [&longest_mm](double edge) {
        std::size_t sum = 0;
        for (const double longest : longest_mm) {
            const auto n = static_cast<std::size_t>(partsOf(edge, longest));
            sum += n * n;
        }
        return sum;
    };
    std::size_t all = count(edge_mm);
    while (all > std::max(most, triangles.size())) {
        edge_mm *= 1.5;
        all = count(edge_mm);
    }
    if (all == triangles.size()) {
        return &picture;
    }
    Splitter splitter(picture);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        splitter.add(triangles[i].data(), partsOf(edge_mm, longest_mm[i]));
    }
    return splitter.result();
}

vtkSmartPointer<vtkPolyData> marginColoured(vtkPolyData& picture, std::span<const float> distance_mm,
                                            std::span<const double> limits_mm)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(&picture);
    vtkNew<vtkFloatArray> distances;
    distances->SetName(kDistances);
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("Colours");
    colours->SetNumberOfComponents(3);
    for (const float distance : distance_mm) {
        const auto band = std::upper_bound(limits_mm.begin(), limits_mm.end(), double{distance}) - limits_mm.begin();
        const Colour c = marginColour(static_cast<std::size_t>(band), limits_mm.size() + 1);
        distances->InsertNextValue(distance);
        colours->InsertNextTuple3(std::round(255.0 * c[0]), std::round(255.0 * c[1]), std::round(255.0 * c[2]));
    }
    vtkNew<vtkDoubleArray> limits;
    limits->SetName(kLimits);
    for (const double limit_mm : limits_mm) {
        limits->InsertNextValue(limit_mm);
    }
    data->GetPointData()->SetScalars(colours);
    data->GetPointData()->AddArray(distances);
    vtkNew<vtkFieldData> fields; // the picture's own are shared
    fields->PassData(picture.GetFieldData());
    fields->AddArray(limits);
    data->SetFieldData(fields);
    return data;
}

void drawMarginBands(vtkActor& actor, vtkPolyData& picture)
{
    vtkDataArray* limits = picture.GetFieldData()->GetArray(kLimits);
    if (limits != nullptr && picture.GetPointData()->GetArray(kDistances) != nullptr) {
        shadeByArray(actor, kDistances, 1, bandProgram(*limits));
    }
}

} // namespace palpate::view
