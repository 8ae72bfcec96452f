// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SectionPicture.h"

#include <palpate/core/Parallel.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate::view {

namespace {

constexpr double kLift = 3e-5; // step between faces, in diagonals of the scene: a few steps of the depth buffer
constexpr double kRim = 0.45;  // brightness of the rim of a filled face
constexpr float kOutlineWidth_px = 2.0F;

vtkSmartPointer<vtkActor> makeFlatActor()
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUseCellData();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    actor->GetProperty()->LightingOff();
    return actor;
}

std::array<unsigned char, 3> faceBytes(const Colour& colour, double brightness)
{
    std::array<unsigned char, 3> bytes{};
    for (std::size_t i = 0; i < 3; ++i) {
        bytes[i] = static_cast<unsigned char>(std::lround(255.0 * std::clamp(brightness * colour[i], 0.0, 1.0)));
    }
    return bytes;
}

/// Flat shapes in one colour each.
class FlatShapes
{
  public:
    vtkIdType point(const core::Vec3& p_W) { return m_points->InsertNextPoint(p_W.data()); }
    void add(vtkIdType count, const vtkIdType* corners, const std::array<unsigned char, 3>& colour)
    {
        m_cells->InsertNextCell(count, corners);
        m_colours->InsertNextTypedTuple(colour.data());
    }
    void show(vtkActor& actor, bool areLines)
    {
        m_colours->SetName("colour");
        vtkNew<vtkPolyData> shape;
        shape->SetPoints(m_points);
        areLines ? shape->SetLines(m_cells) : shape->SetPolys(m_cells);
        shape->GetCellData()->SetScalars(m_colours);
        vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(shape);
        actor.SetVisibility(m_cells->GetNumberOfCells() > 0);
    }
    FlatShapes() { m_colours->SetNumberOfComponents(3); }

  private:
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_cells;
    vtkNew<vtkUnsignedCharArray> m_colours;
};

} // namespace

std::vector<SectionCut> cutsOf(const geometry::SectionPlane& plane, const std::vector<CutSurface>& surfaces)
{
    std::vector<std::size_t> crossed;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!surfaces[i].triangles.empty() && plane.crosses(surfaces[i].bounds)) {
            crossed.push_back(i);
        }
    }
    std::vector<SectionCut> cuts(crossed.size());
    core::parallelFor(crossed.size(), [&](std::size_t i, unsigned) {
        const CutSurface& surface = surfaces[crossed[i]];
        SectionCut& cut = cuts[i];
        cut.structure = crossed[i];
        cut.colour = surface.colour;
        cut.contours = geometry::sectionOf(surface.vertices, surface.triangles, surface.twoSided, plane);
        if (surface.isFilled) {
            cut.strips = geometry::filled(cut.contours);
        }
        cut.area_mm2 = geometry::areaOf(cut.strips);
        for (const geometry::SectionContour& contour : cut.contours) {
            for (const Eigen::Vector2d& p : contour.points) {
                cut.box.extend(p);
            }
        }
    });
    std::erase_if(cuts, [](const SectionCut& cut) { return cut.contours.empty(); });
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const SectionCut& a, const SectionCut& b) { return a.area_mm2 > b.area_mm2; });
    return cuts;
}

SectionPicture::SectionPicture()
    : m_clip(vtkSmartPointer<vtkPlane>::New())
    , m_clipping(vtkSmartPointer<vtkPlaneCollection>::New())
    , m_faces(makeFlatActor())
    , m_outlines(makeFlatActor())
{
    m_clipping->AddItem(m_clip);
    m_outlines->GetProperty()->SetLineWidth(kOutlineWidth_px);
}

void SectionPicture::addTo(vtkRenderer& solid)
{
    solid.AddActor(m_faces);
    solid.AddActor(m_outlines);
}

void SectionPicture::hide()
{
    m_isShown = false;
    m_cuts.clear();
    m_faces->VisibilityOff();
    m_outlines->VisibilityOff();
}

void SectionPicture::setFilled(bool isFilled)
{
    m_isFilled = isFilled;
}

void SectionPicture::show(const geometry::SectionPlane& plane, const std::vector<CutSurface>& surfaces)
{
    m_plane = plane;
    m_isShown = true;
    core::Box all;
    for (const CutSurface& surface : surfaces) {
        all.extend(surface.bounds);
    }
    m_cuts = cutsOf(plane, surfaces);
    const double step_mm = all.isEmpty() ? 0.0 : kLift * all.diagonal().norm();
    liftInner(step_mm);
    drawFaces();
    drawOutlines(step_mm);
    // VTK draws the side that the plane's normal points to.
    m_clip->SetOrigin(plane.p_W.x(), plane.p_W.y(), plane.p_W.z());
    m_clip->SetNormal(-plane.n_W.x(), -plane.n_W.y(), -plane.n_W.z());
}

/// Lifts each face above all larger ones that it may overlap.
void SectionPicture::liftInner(double step_mm)
{
    m_lifts_mm.assign(m_cuts.size(), 0.0);
    for (std::size_t i = 0; i < m_cuts.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (m_cuts[k].box.intersects(m_cuts[i].box)) {
                m_lifts_mm[i] = std::max(m_lifts_mm[i], m_lifts_mm[k] + step_mm);
            }
        }
    }
}

void SectionPicture::drawFaces()
{
    FlatShapes shapes;
    for (std::size_t i = 0; i < m_cuts.size(); ++i) {
        const SectionCut& cut = m_cuts[i];
        const auto colour = faceBytes(cut.colour, 1.0);
        const core::Vec3 lift_W = m_lifts_mm[i] * m_plane.n_W;
        const auto point = [&](double x, double y) { return shapes.point(m_plane.inWorld({x, y}) + lift_W); };
        for (const geometry::SectionStrip& strip : cut.strips) {
            const vtkIdType corners[4] = {point(strip.leftLow, strip.low), point(strip.rightLow, strip.low),
                                          point(strip.rightHigh, strip.high), point(strip.leftHigh, strip.high)};
            shapes.add(4, corners, colour);
        }
    }
    shapes.show(*m_faces, false);
    if (!m_isFilled) {
        m_faces->VisibilityOff();
    }
}

void SectionPicture::drawOutlines(double step_mm)
{
    FlatShapes shapes;
    std::vector<vtkIdType> line;
    for (std::size_t i = 0; i < m_cuts.size(); ++i) {
        const SectionCut& cut = m_cuts[i];
        const core::Vec3 lift_W = (m_lifts_mm[i] + 0.5 * step_mm) * m_plane.n_W;
        for (const geometry::SectionContour& contour : cut.contours) {
            line.clear();
            for (const Eigen::Vector2d& p : contour.points) {
                line.push_back(shapes.point(m_plane.inWorld(p) + lift_W));
            }
            if (contour.isClosed) {
                line.push_back(line.front());
            }
            shapes.add(static_cast<vtkIdType>(line.size()), line.data(),
                       faceBytes(cut.colour, !cut.strips.empty() && contour.isClosed && m_isFilled ? kRim : 1.0));
        }
    }
    shapes.show(*m_outlines, true);
}

std::optional<std::size_t> SectionPicture::structureAt(const core::Vec3& p_W) const
{
    const Eigen::Vector2d q = m_plane.inPlane(p_W);
    for (auto cut = m_cuts.rbegin(); cut != m_cuts.rend(); ++cut) {
        if (cut->box.contains(q) &&
            std::any_of(cut->strips.begin(), cut->strips.end(), [&](const auto& strip) { return strip.contains(q); })) {
            return cut->structure;
        }
    }
    return std::nullopt;
}

double SectionPicture::area_mm2(std::size_t structure) const
{
    const auto cut = std::find_if(m_cuts.begin(), m_cuts.end(),
                                  [structure](const SectionCut& one) { return one.structure == structure; });
    return cut == m_cuts.end() ? 0.0 : cut->area_mm2;
}

} // namespace palpate::view
