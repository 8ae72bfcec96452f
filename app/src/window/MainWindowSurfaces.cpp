// SPDX-License-Identifier: BSD-3-Clause
// Inverted, stair-stepped or nearly touching surfaces: messages and offers to fix them.
#include "window/MainWindow.h"

#include <palpate/study/Layers.h>

#include <QLocale>

using namespace palpate;
using namespace palpate::ui;

namespace {

view::ViewStructure pictureOf(const StructureModel& model, int row)
{
    const StructureRow& one = model.rows()[static_cast<std::size_t>(row)];
    const geometry::MeshReport& report = one.loaded.surface->report;
    return {view::StructureActor(one.picture, model.appearanceOf(row),
                                 report.isClosed() && report.insideOutComponents == 0),
            one.loaded.description.palpable && !one.isRemoved ? one.touch : nullptr};
}

} // namespace

void MainWindow::connectSurfaces()
{
    connect(&m_model, &StructureModel::surfaceWanted, this, [this](int row) {
        say(tr("Making the surface of %1…").arg(readableName(m_model.structure(row).name)), 60000);
        m_loader.buildSurface(row, m_model.rows()[static_cast<std::size_t>(row)].loaded);
    });
    connect(&m_loader, &SceneLoader::surfaceBuilt, this,
            [this](int row, const std::shared_ptr<StructureRow>& built) { m_model.setSurface(row, *built); });
    connect(&m_model, &StructureModel::surfaceReplaced, this, &MainWindow::followSurface);
    connect(&m_loader, &SceneLoader::sizeKnown, this, &MainWindow::offerReadingAsMetres);
    connect(&m_loader, &SceneLoader::notesFound, this, [this](const QStringList& lines) {
        for (const QString& line : lines) {
            m_messages.add(Messages::Kind::Warning, line);
        }
    });
}

/// Offers fixes with a single click.
void MainWindow::offerSurfaces()
{
    const auto name = [this](int row) { return readableName(m_model.structure(row).name); };
    if (const std::vector<int> rows = m_model.steppedRows(); !rows.empty()) {
        const core::Vec3& voxel = m_model.rows()[static_cast<std::size_t>(rows.front())].loaded.staircase->voxel_mm;
        const QLocale locale;
        const QString size = tr("%1 × %2 × %3 mm")
                                 .arg(locale.toString(voxel.x(), 'g', 3), locale.toString(voxel.y(), 'g', 3),
                                      locale.toString(voxel.z(), 'g', 3));
        m_message->offer(
            rows.size() == 1
                ? tr("%1 is a staircase of about %2 voxels: the hand feels its steps.").arg(name(rows.front()), size)
                : tr("%1 surfaces are staircases, of about %2 voxels: the hand feels their steps.")
                      .arg(rows.size())
                      .arg(size),
            rows.size() == 1 ? tr("Smooth it") : tr("Smooth them"), [this] { m_model.smooth(m_model.steppedRows()); });
    }
    if (const std::vector<int> rows = m_model.insideOutRows(); !rows.empty()) {
        m_message->offer(rows.size() == 1 ? tr("%1 is inside out: felt from within only.").arg(name(rows.front()))
                                          : tr("%1 surfaces are inside out: felt from within only.").arg(rows.size()),
                         rows.size() == 1 ? tr("Turn it around") : tr("Turn them around"),
                         [this] { m_model.turnOutwards(m_model.insideOutRows()); });
    }
}

/// Draws a structure's new surface and updates the nesting, which may have changed.
void MainWindow::followSurface(int row)
{
    m_viewport->view().setStructure(static_cast<std::size_t>(row), pictureOf(m_model, row));
    std::vector<study::LayeredSurface> surfaces;
    for (const StructureRow& one : m_model.rows()) {
        surfaces.push_back(one.isRemoved ? study::LayeredSurface{}
                                         : study::LayeredSurface{one.loaded.surface.get(), one.touch.get()});
    }
    const study::Layering found = study::layering(surfaces);
    std::vector<std::optional<int>> in;
    bool isNestedAnew = false, isFlat = m_model.buried() == meshio::BuriedTouch::Layers;
    for (std::size_t i = 0; i < found.structures.size(); ++i) {
        const auto around = found.structures[i].in;
        in.push_back(around ? std::optional(static_cast<int>(*around)) : std::nullopt);
        isNestedAnew = isNestedAnew || (around && m_model.rows()[i].in != in.back());
        isFlat = isFlat && m_model.structure(static_cast<int>(i)).layer == 0;
    }
    m_model.setNesting(in);
    if (isNestedAnew && isFlat) { // structures nested in an organ that was inverted before
        offerLayers(found);
    }
    m_viewport->update();
    say(m_model.defects(row).isEmpty()
            ? tr("%1 has another surface now.").arg(readableName(m_model.structure(row).name))
            : m_model.defects(row).join(QStringLiteral(". ")));
}
