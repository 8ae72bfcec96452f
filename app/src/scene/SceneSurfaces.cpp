// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneSurfaces.h"

#include "scene/LayerOffers.h"
#include "shared/SceneSize.h"
#include "shell/Notices.h"
#include "shell/StatusProgress.h"

#include <palpate/study/Layers.h>
#include <palpate/ui/VtkViewport.h>

#include <memory>
#include <palpate/ui/Translated.h>

#include <optional>
#include <utility>

namespace palpate::app {

using ui::StructureModel;
using ui::StructureRow;

namespace {

/// Closed surfaces with outward normals are drawn without their inside.
bool isSolid(const study::OpenStructure& row)
{
    const geometry::MeshReport& report = row.loaded.surface->report;
    return report.isClosed() && report.insideOutComponents == 0;
}

view::ViewStructure pictureOf(const study::OpenStructure& row, const vtkSmartPointer<vtkPolyData>& picture,
                              const view::Appearance& appearance, bool isSolid)
{
    return {view::StructureActor(picture, appearance, isSolid),
            row.loaded.description.palpable && !row.isRemoved ? row.touch : nullptr, row.loaded.surface};
}

} // namespace

SceneSurfaces::SceneSurfaces(const WindowCore& core, ui::SceneLoader& loader, StatusProgress& progress,
                             LayerOffers& layers, QObject* parent)
    : QObject(parent)
    , m_core(core)
    , m_loader(loader)
    , m_progress(progress)
    , m_layers(layers)
{
    connect(&core.model, &StructureModel::edited, this, &SceneSurfaces::follow);
    connect(&core.model, &StructureModel::mapsWanted, this, &SceneSurfaces::requestMaps);
    connect(&core.model, &StructureModel::surfaceWanted, this, [this](int row) {
        m_core.notices.say(tr("Computing the surface of %1…").arg(nameOf(row)), 60000);
        m_loader.buildSurface(row, m_core.model.rows()[static_cast<std::size_t>(row)].loaded);
    });
    connect(&core.model, &StructureModel::surfaceReplaced, this, &SceneSurfaces::followSurface);
    connectLoader();
}

void SceneSurfaces::connectLoader()
{
    StructureModel& model = m_core.model;
    connect(&m_loader, &ui::SceneLoader::touchBuilt, this,
            [&model](int row, const std::shared_ptr<const geometry::SurfaceIndex>& touch, const QString& sha256) {
                model.setTouch(row, touch, sha256.toStdString());
            });
    connect(&m_loader, &ui::SceneLoader::surfaceBuilt, this,
            [&model](int row, const std::shared_ptr<StructureRow>& built) { model.setSurface(row, *built); });
    connect(&m_loader, &ui::SceneLoader::mapsBuilt, this,
            [this, &model](int row, const std::shared_ptr<meshio::LoadedStructure>& found,
                           const std::vector<core::Message>& problems) {
                if (!m_loader.isBusy() && !m_loader.isBuildingMaps()) {
                    m_progress.hide();
                }
                model.setMaps(row, found->description.maps, found->maps, problems);
                QStringList lines;
                for (const core::Message& problem : problems) {
                    lines << ui::translated(problem);
                }
                m_core.notices.say(lines.isEmpty()
                                       ? tr("The map of %1 was applied.").arg(ui::readableName(found->description.name))
                                       : lines.join(QLatin1Char(' ')));
            });
    connect(&m_loader, &ui::SceneLoader::notesFound, &m_core.notices, &Notices::warn);
}

void SceneSurfaces::draw(const std::vector<StructureRow>& rows)
{
    std::vector<view::ViewStructure> pictures;
    pictures.reserve(rows.size());
    for (const StructureRow& row : rows) {
        pictures.push_back(
            pictureOf(row, row.picture, StructureModel::appearanceOf(row.loaded.description), isSolid(row)));
    }
    m_core.viewport.view().setStructures(std::move(pictures));
}

void SceneSurfaces::drawAdded(const std::vector<StructureRow>& rows)
{
    std::vector<view::ViewStructure> pictures;
    for (const StructureRow& row : rows) {
        pictures.push_back(pictureOf(row, row.picture, StructureModel::appearanceOf(row.loaded.description), false));
    }
    m_core.viewport.view().addStructures(std::move(pictures));
}

void SceneSurfaces::requestMaps(int row)
{
    m_core.notices.say(tr("Reading the maps of %1…").arg(nameOf(row)), 60000);
    m_progress.showBusy();
    m_loader.buildMaps(row, m_core.model.rows()[static_cast<std::size_t>(row)].loaded);
}

/// Updates the view after an edit.
void SceneSurfaces::follow(int row, StructureModel::Change change)
{
    const auto index = static_cast<std::size_t>(row);
    const study::OpenStructure& one = m_core.model.rows()[index];
    const meshio::SceneStructure& structure = one.loaded.description;
    view::SceneView& view = m_core.viewport.view();
    if (change == StructureModel::Change::Look) {
        view.setAppearance(index, m_core.model.appearanceOf(row));
    }
    if (one.isRemoved) { // data is kept for undo
        view.setTouchable(index, nullptr);
        m_core.viewport.update();
        return;
    }
    // Only palpable structures have a haptic surface.
    if (structure.palpable && one.touch == nullptr) {
        m_loader.buildTouch(row, one.loaded.surface);
    } else if (!structure.palpable && one.touch != nullptr) {
        m_core.model.setTouch(row, nullptr, {});
        return; // setTouch calls this function again
    }
    view.setTouchable(index, structure.palpable ? one.touch : nullptr);
    m_core.viewport.update();
}

/// Draws a structure's new surface and updates the nesting, which may have changed.
void SceneSurfaces::followSurface(int row)
{
    StructureModel& model = m_core.model;
    const study::OpenStructure& changed = model.rows()[static_cast<std::size_t>(row)];
    m_core.viewport.view().setStructure(
        static_cast<std::size_t>(row),
        pictureOf(changed, model.picture(row), model.appearanceOf(row), isSolid(changed)));
    std::vector<study::LayeredSurface> surfaces;
    for (const study::OpenStructure& one : model.rows()) {
        surfaces.push_back(one.isRemoved ? study::LayeredSurface{}
                                         : study::LayeredSurface{one.loaded.surface.get(), one.touch.get()});
    }
    const study::Layering found = study::layering(surfaces);
    std::vector<std::optional<std::size_t>> in;
    bool isNestedAnew = false, isFlat = model.buried() == meshio::BuriedTouch::Layers;
    for (std::size_t i = 0; i < found.structures.size(); ++i) {
        const auto around = found.structures[i].in;
        in.push_back(around);
        isNestedAnew = isNestedAnew || (around && model.rows()[i].in != in.back());
        isFlat = isFlat && model.structure(static_cast<int>(i)).layer == 0;
    }
    model.setNesting(in);
    if (isNestedAnew && changed.loaded.closing) {
        m_layers.layOutClosed(found);
    } else if (isNestedAnew && isFlat) { // structures nested in an organ that was inverted before
        m_layers.offer(found);
    }
    m_core.viewport.update();
    m_core.notices.say(model.defects(row).isEmpty() ? tr("The surface of %1 was replaced.").arg(nameOf(row))
                                                    : model.defects(row).join(QStringLiteral(". ")));
}

void SceneSurfaces::offerRepairs()
{
    offerSmoothing();
    offerTurning();
    if (m_core.viewport.view().bounds().diagonal().norm() >= kSmallestScene_mm) {
        m_loader.findGaps(m_core.model.rows());
    }
}

void SceneSurfaces::offerSmoothing()
{
    StructureModel& model = m_core.model;
    const std::vector<int> rows = model.steppedRows();
    if (rows.empty()) {
        return;
    }
    const core::Vec3& voxel = model.rows()[static_cast<std::size_t>(rows.front())].loaded.staircase->voxel_mm;
    const QString size =
        tr("%1 × %2 × %3 mm")
            .arg(ui::numberText(voxel.x(), 3), ui::numberText(voxel.y(), 3), ui::numberText(voxel.z(), 3));
    m_core.notices.bar().offer(
        rows.size() == 1
            ? tr("%1 has voxel steps of about %2, which can be felt.").arg(nameOf(rows.front()), size)
            : tr("%1 surfaces have voxel steps of about %2, which can be felt.").arg(rows.size()).arg(size),
        rows.size() == 1 ? tr("Smooth it") : tr("Smooth them"), [&model] { model.smooth(model.steppedRows()); });
}

void SceneSurfaces::offerTurning()
{
    StructureModel& model = m_core.model;
    const std::vector<int> rows = model.insideOutRows();
    if (rows.empty()) {
        return;
    }
    m_core.notices.bar().offer(
        rows.size() == 1 ? tr("%1 is inside out: it can be felt only from inside.").arg(nameOf(rows.front()))
                         : tr("%1 surfaces are inside out: they can be felt only from inside.").arg(rows.size()),
        rows.size() == 1 ? tr("Turn it around") : tr("Turn them around"),
        [&model] { model.turnOutwards(model.insideOutRows()); });
}

QString SceneSurfaces::nameOf(int row) const
{
    return ui::readableName(m_core.model.structure(row).name);
}

} // namespace palpate::app

#include "moc_SceneSurfaces.cpp"
