// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ReportViews.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceColours.h>
#include <palpate/view/SurfaceMesh.h>

#include <QLocale>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QStringList>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace palpate::ui {

namespace {

constexpr int kWidth_px = 1400, kHeight_px = 1050;
constexpr double kPixelRatio = 2.6;  // letters of about 2 mm on paper
constexpr double kCloseUp_mm = 90.0; // shown width around a finding that was marked without a camera

} // namespace

struct ReportViews::Private
{
    QOffscreenSurface surface;
    QOpenGLContext context;
    view::SceneView view;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    const study::ReportFacts* facts = nullptr;
    /// A structure as without a map.
    struct Plain
    {
        std::string name;
        vtkSmartPointer<vtkPolyData> picture;
        view::Appearance look;
    };
    std::vector<Plain> plain;                                            ///< by number in the view
    std::map<std::string, vtkSmartPointer<vtkPolyData>> touchedPictures; ///< by structure, before colouring

    void setScene(const meshio::LoadedScene& scene);
    void showMap(const study::ReportMap* map);
    void colour(std::size_t structure, const session::TouchedSurface& touched, const study::ReportMap& map);
    void aimAt(const core::Finding& finding);
    QImage render();
};

void ReportViews::Private::setScene(const meshio::LoadedScene& scene)
{
    std::vector<view::ViewStructure> structures;
    for (const meshio::LoadedStructure& one : scene.structures) {
        if (one.surface == nullptr) {
            continue;
        }
        const meshio::SceneStructure& look = one.description;
        const geometry::MeshReport& report = one.surface->report;
        plain.push_back(
            {look.name, view::makeSurface(*one.surface), view::Appearance{look.colour, look.opacity, look.visible}});
        structures.push_back({view::StructureActor(plain.back().picture, plain.back().look,
                                                   report.isClosed() && report.insideOutComponents == 0),
                              nullptr});
    }
    view.setStructures(std::move(structures));
    const view::Colour white{1.0, 1.0, 1.0};
    view.setBackground(white, white, {0.1, 0.1, 0.1});
    view::TextStyle text;
    text.fontFile = viewFont();
    text.decimalPoint = QLocale().decimalPoint().toStdString();
    view.setTextStyle(text);
    view.setSmoothEdges(true);
    view.setSortedTransparency(true);
}

/// Colours the touched structures with a legend. @param map  null: all structures in their own colours
void ReportViews::Private::showMap(const study::ReportMap* map)
{
    for (std::size_t i = 0; i < plain.size(); ++i) {
        view.setPicture(i, plain[i].picture);
        view.setAppearance(i, plain[i].look);
        const auto& surfaces = facts->measures.surfaces;
        const auto touched = std::find_if(surfaces.begin(), surfaces.end(), [&](const session::SurfaceMeasures& one) {
            return one.structure == plain[i].name && one.surface != nullptr;
        });
        if (map != nullptr && touched != surfaces.end()) {
            colour(i, *touched->surface, *map);
        }
    }
    if (map == nullptr) {
        view.legend().hide();
        return;
    }
    QStringList lines;
    for (const core::Message& line : map->legend) {
        lines << translated(line);
    }
    view::ColourLegend::Content legend;
    legend.title = lines.join(QLatin1Char('\n')).toStdString();
    legend.range = {0.0, map->end};
    for (const double value : {0.0, 0.5 * map->end, map->end}) {
        legend.marks.push_back({value, numberText(value).toStdString()});
    }
    view.legend().show(legend);
}

void ReportViews::Private::colour(std::size_t structure, const session::TouchedSurface& touched,
                                  const study::ReportMap& map)
{
    geometry::RepairedMesh split;
    split.mesh = touched.mesh(); // its long edges are split
    vtkSmartPointer<vtkPolyData>& picture = touchedPictures[plain[structure].name];
    if (picture == nullptr) {
        picture = view::makeSurface(split);
    }
    std::vector<float> values = study::mapValues(touched, map.quantity);
    std::replace_if(
        values.begin(), values.end(), [](float value) { return !(value > 0.0F); },
        std::numeric_limits<float>::quiet_NaN());
    view::Appearance look = plain[structure].look;
    look.opacity = 1.0;
    view.setAppearance(structure, look);
    view.setPicture(structure, view::coloured(*picture, split, values, false, {0.0, map.end}, look.colour));
}

/// Looks as the examiner did when marking, otherwise from outside onto the place.
void ReportViews::Private::aimAt(const core::Finding& finding)
{
    vtkCamera& camera = view.camera();
    core::ViewPose pose;
    if (finding.camera) {
        pose = *finding.camera;
    } else {
        const core::Vec3 outwards = finding.p_W - view.bounds().center();
        const core::Vec3 from = outwards.norm() > 1e-6 ? core::Vec3(outwards.normalized()) : core::Vec3(0, -1, 0);
        const double away_mm = std::max(2.0 * kCloseUp_mm, 0.6 * view.bounds().diagonal().norm());
        pose.focus_W = finding.p_W;
        pose.position_W = finding.p_W + away_mm * from;
        pose.up_W = std::abs(from.z()) > 0.9 ? core::Vec3(0, -1, 0) : core::Vec3(0, 0, 1);
    }
    camera.SetPosition(pose.position_W.data());
    camera.SetFocalPoint(pose.focus_W.data());
    camera.SetViewUp(pose.up_W.data());
    camera.SetViewAngle(pose.viewAngle_deg);
}

QImage ReportViews::Private::render()
{
    context.makeCurrent(&surface);
    vtkOpenGLState* state = window->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL); // as VTK relies on; Qt leaves GL_LESS
    window->SetReadyForRendering(true);
    window->SetIsCurrent(true);
    view.prepareFrame(kPixelRatio);
    window->Render();
    // The picture is read upwards from its lower left corner.
    unsigned char* const bytes = window->GetRGBACharPixelData(0, 0, kWidth_px - 1, kHeight_px - 1, 0);
    QImage picture =
        QImage(bytes, kWidth_px, kHeight_px, QImage::Format_RGBX8888).mirrored().convertToFormat(QImage::Format_RGB888);
    delete[] bytes;
    state->Pop();
    return picture;
}

ReportViews::ReportViews(std::unique_ptr<Private> d)
    : m_d(std::move(d))
{
}

ReportViews::~ReportViews()
{
    m_d->context.makeCurrent(&m_d->surface);
    m_d->view.detach();
    m_d->window->Finalize();
    m_d->window->SetReadyForRendering(false);
    m_d->context.doneCurrent();
}

core::Result<std::unique_ptr<ReportViews>> ReportViews::create(const study::ReportFacts& facts)
{
    auto d = std::make_unique<Private>();
    const QSurfaceFormat format = VtkViewport::surfaceFormat();
    d->surface.setFormat(format);
    d->surface.create();
    d->context.setFormat(format);
    if (!d->context.create() || !d->context.makeCurrent(&d->surface)) {
        return core::Status(core::StatusCode::Unsupported,
                            PALPATE_TEXT("found no display with OpenGL to draw them; app/run.sh draws without a "
                                         "display"));
    }
    d->window->SetOwnContext(0);
    d->window->SetFrameBlitModeToNoBlit();
    d->window->SetReadyForRendering(true);
    d->window->SetMapped(1);
    d->window->SetIsCurrent(true);
    d->window->InitializeFromCurrentContext();
    d->window->SetSize(kWidth_px, kHeight_px);
    d->view.attach(*d->window);
    d->facts = &facts;
    d->setScene(*facts.scene);
    return std::unique_ptr<ReportViews>(new ReportViews(std::move(d)));
}

QImage ReportViews::draw(const study::Report& report, std::size_t number)
{
    const study::ReportView& of = report.views[number];
    view::SceneView& view = m_d->view;
    std::vector<view::FindingMark> marks;
    m_d->showMap(of.map ? &report.maps[*of.map] : nullptr);
    for (std::size_t i = 0; i < report.places.size() && !of.map; ++i) {
        const core::Finding& place = report.places[i];
        if (of.from != study::ReportView::From::Finding || i == of.finding) {
            marks.push_back({place.p_W, place.type, i + 1, place.name});
        }
    }
    view.findings().set(std::move(marks));
    view.findings().select(0);
    switch (of.from) {
    case study::ReportView::From::Front:
        view.look(view::ViewFrom::Front);
        break;
    case study::ReportView::From::Left:
        view.look(view::ViewFrom::Left);
        break;
    case study::ReportView::From::Finding:
        m_d->aimAt(report.places[of.finding]);
        break;
    }
    if (of.map) {
        view.camera().Dolly(0.8); // room for the legend beside the tissue
    }
    return m_d->render();
}

} // namespace palpate::ui
