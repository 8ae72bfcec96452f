// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PalpationView.h"

#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/PalpationController.h"
#include "palpate/ui/StructureModel.h"
#include "palpate/ui/Translated.h"
#include "palpate/ui/ViewKeys.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/view/SurfaceMesh.h>
#include <palpate/vtk/PolyData.h>

#include <QVBoxLayout>

#include <utility>

namespace palpate::ui {

using core::Result;
using core::Status;
using core::StatusCode;

struct PalpationView::Private
{
    explicit Private(PalpationView& view)
        : viewport(&view)
        , live(model)
        , palpation(viewport, live, model)
        , keys(viewport, palpation)
    {
    }

    [[nodiscard]] Status checkNumber(int structure) const
    {
        const int count = model.rowCount();
        return structure >= 0 && structure < count
                   ? Status()
                   : Status(StatusCode::OutOfRange, PALPATE_TEXT("found structure %1, expected a number below %2"),
                            structure, count);
    }

    Status edit(int structure, const meshio::SceneStructure& description)
    {
        if (Status status = core::check(description.tissue); !status.isOk()) {
            return status.at(description.name);
        }
        model.edit(structure, description);
        return {};
    }

    void draw(int row);
    void follow(int row);

    StructureModel model;
    VtkViewport viewport;
    LiveTouch live;
    PalpationController palpation;
    ViewKeys keys;
};

/// Adds the picture of a new structure and fits the scene into the view.
void PalpationView::Private::draw(int row)
{
    const study::OpenStructure& one = model.rows()[static_cast<std::size_t>(row)];
    std::vector<view::ViewStructure> pictures;
    pictures.push_back(
        {view::StructureActor(model.picture(row), model.appearanceOf(row), one.loaded.surface->report.isClosed()),
         one.touch, one.loaded.surface});
    view::SceneView& scene = viewport.view();
    scene.addStructures(std::move(pictures));
    scene.fitAll();
    palpation.setSceneSize(scene.bounds().diagonal().norm());
    viewport.update();
}

/// Updates the view after an edit.
void PalpationView::Private::follow(int row)
{
    const auto index = static_cast<std::size_t>(row);
    if (index < viewport.view().structureCount()) { // not while a structure is being added
        viewport.view().setAppearance(index, model.appearanceOf(row));
        viewport.update();
    }
}

void PalpationView::prepareApplication()
{
    QSurfaceFormat::setDefaultFormat(VtkViewport::surfaceFormat());
}

PalpationView::PalpationView(QWidget* parent)
    : QWidget(parent)
    , m_d(std::make_unique<Private>(*this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&m_d->viewport);
    setFocusProxy(&m_d->viewport);
    m_d->model.undoStack().setUndoLimit(1); // edits cannot be undone here
    Private& d = *m_d;
    connect(&d.model, &StructureModel::edited, this, [&d](int row) { d.follow(row); });
    connect(&d.palpation, &PalpationController::touched, this, &PalpationView::touched);
    connect(&d.palpation, &PalpationController::handGone, this, &PalpationView::handGone);
    connect(&d.palpation, &PalpationController::said, this, &PalpationView::notice);
    connect(&d.palpation, &PalpationController::palpationWanted, this, [this] { setPalpating(true); });
    connect(&d.viewport, &VtkViewport::spaceHeld, this, &PalpationView::setPalpating);
    connect(&d.viewport, &VtkViewport::centreWanted, this, [&d](const QPointF& place) {
        if (const auto pick = d.viewport.view().pick(d.viewport.rayAt(place))) {
            d.viewport.view().centreOn(pick->hit.p_W);
            d.viewport.update();
        }
    });
    connect(&d.live, &LiveTouch::faulted, this, &PalpationView::faulted);
    connect(&d.live, &LiveTouch::stiffnessRefused, this, &PalpationView::notice);
    const auto takeLimit = [&d] { d.viewport.view().cursor().setForceLimit(d.live.deviceInfo().maxForce_N); };
    connect(&d.live, &LiveTouch::deviceChanged, this, takeLimit);
    takeLimit();
}

PalpationView::~PalpationView()
{
    m_d->live.stop();
}

Result<int> PalpationView::add(vtkPolyData* surface, const Organ& organ)
{
    Result<geometry::RepairedMesh> repaired = vtk::surfaceOf(surface, {.unit_mm = organ.unit_mm});
    const Status tissue = core::check(organ.tissue);
    if (!repaired.isOk() || !tissue.isOk()) {
        return (repaired.isOk() ? tissue : repaired.status()).at(organ.name);
    }
    StructureRow row;
    row.loaded.description.name = organ.name;
    row.loaded.description.tissue = organ.tissue;
    row.loaded.description.colour = organ.colour;
    row.loaded.description.opacity = organ.opacity;
    row.loaded.description.layer = organ.layer;
    row.loaded.surface = std::make_shared<const geometry::RepairedMesh>(std::move(repaired).value());
    row.loaded.asRead = row.loaded.surface;
    row.touch = study::indexed(*row.loaded.surface);
    row.sha256 = session::geometryHash(row.loaded.surface->mesh);
    row.picture = view::makeSurface(*row.loaded.surface);
    std::vector<StructureRow> rows;
    rows.push_back(std::move(row));
    const int number = m_d->model.rowCount();
    m_d->model.addRows(std::move(rows), {});
    m_d->draw(number);
    if (const Status status = m_d->live.start(); !status.isOk()) {
        Q_EMIT notice(text(status)); // of an external device: the pointer is used instead
    }
    return number;
}

QStringList PalpationView::notes(int structure) const
{
    return m_d->checkNumber(structure).isOk() ? m_d->model.findings(structure) : QStringList();
}

std::shared_ptr<const geometry::RepairedMesh> PalpationView::surface(int structure) const
{
    return m_d->checkNumber(structure).isOk() ? m_d->model.rows()[static_cast<std::size_t>(structure)].loaded.surface
                                              : nullptr;
}

QString PalpationView::text(const Status& status) const
{
    return translated(status);
}

Status PalpationView::setStiffness(int structure, double stiffness_N_per_mm)
{
    if (Status status = m_d->checkNumber(structure); !status.isOk()) {
        return status;
    }
    core::Tissue tissue = m_d->model.structure(structure).tissue;
    tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    return setTissue(structure, tissue);
}

Status PalpationView::setTissue(int structure, const core::Tissue& tissue)
{
    if (Status status = m_d->checkNumber(structure); !status.isOk()) {
        return status;
    }
    meshio::SceneStructure description = m_d->model.structure(structure);
    description.tissue = tissue;
    return m_d->edit(structure, description);
}

Status PalpationView::setShown(int structure, bool isShown)
{
    if (Status status = m_d->checkNumber(structure); !status.isOk()) {
        return status;
    }
    meshio::SceneStructure description = m_d->model.structure(structure);
    description.visible = isShown;
    return m_d->edit(structure, description);
}

void PalpationView::setFingertip(double radius_mm)
{
    m_d->live.setFingertip(radius_mm);
}

void PalpationView::setPalpating(bool isPalpating)
{
    m_d->palpation.setPalpating(isPalpating);
}

Status PalpationView::useDevice(std::unique_ptr<device::HapticDevice> device)
{
    return m_d->live.useDevice(std::move(device));
}

void PalpationView::rearm()
{
    m_d->live.rearm();
}

Status PalpationView::startRecording(const std::filesystem::path& path, Embed embed)
{
    return m_d->live.startRecording(path, {}, embed == Embed::Yes);
}

Status PalpationView::stopRecording()
{
    return m_d->live.stopRecording();
}

bool PalpationView::isRecording() const
{
    return m_d->live.recording().isRecording;
}

} // namespace palpate::ui

#include "palpate/ui/moc_PalpationView.cpp"
