// SPDX-License-Identifier: BSD-3-Clause
// Adding and removing structures, tissue presets by name, selection in the view.
#include "shared/LumpLayout.h"
#include "window/MainWindow.h"
#include "shared/Paths.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/EngineTexts.h>
#include <palpate/ui/TissueByName.h>

#include <QFileDialog>
#include <QSettings>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

namespace {

/// Layer of a structure by nesting in structures that were open before others were added.
std::uint32_t layerBefore(const OpenedScene& scene, std::size_t row)
{
    std::uint32_t layer = 0;
    for (auto in = scene.layering.structures[row].in; in; in = scene.layering.structures[*in].in) {
        layer += *in < scene.addedTo ? 1 : 0;
    }
    return std::min<std::uint32_t>(layer, haptics::kMaxLayers - 1);
}

} // namespace

void MainWindow::connectList()
{
    connect(m_addAction, &QAction::triggered, this, &MainWindow::chooseAdded);
    connect(m_closeAction, &QAction::triggered, this, &MainWindow::closeScene);
    connect(m_filterAction, &QAction::triggered, m_structures, &StructurePanel::focusFilter);
    connect(m_renameAction, &QAction::triggered, m_structures, &StructurePanel::renameCurrent);
    connect(m_removeAction, &QAction::triggered, m_structures, &StructurePanel::removeSelected);
    connect(m_structures, &StructurePanel::highlighted, this, [this](const std::vector<int>& rows) {
        m_viewport->view().highlight(rows);
        m_viewport->update();
    });
}

void MainWindow::chooseAdded()
{
    const QStringList chosen = QFileDialog::getOpenFileNames(this, tr("Add to the scene"),
                                                             QSettings().value(QStringLiteral("folder")).toString());
    std::vector<std::filesystem::path> files;
    for (const QString& file : chosen) {
        files.push_back(toPath(file));
    }
    if (!files.empty()) {
        QSettings().setValue(QStringLiteral("folder"), toText(files.front().parent_path()));
        add(files);
    }
}

/// Adds files to the open scene; a recording among them is opened for playback.
void MainWindow::add(const std::vector<std::filesystem::path>& files)
{
    std::vector<std::filesystem::path> meshes;
    for (const std::filesystem::path& file : files) {
        if (session::isRecordingFile(file)) {
            openRecording(file);
        } else {
            meshes.push_back(file);
        }
    }
    if (m_model.rowCount() == 0) {
        open(files);
        return;
    }
    std::vector<OpenSurface> there;
    for (const StructureRow& row : m_model.rows()) {
        there.push_back(row.isRemoved ? OpenSurface() : OpenSurface{row.loaded.surface, row.touch});
    }
    if (!meshes.empty()) {
        m_loader.add(std::move(meshes), m_unit_mm, std::move(there));
    }
}

void MainWindow::takeAdded(OpenedScene& scene)
{
    const int first = m_model.rowCount();
    std::vector<view::ViewStructure> pictures;
    for (const StructureRow& row : scene.rows) {
        pictures.push_back({view::StructureActor(row.picture, StructureModel::appearanceOf(row.loaded.description)),
                            row.loaded.description.palpable ? row.touch : nullptr});
    }
    m_viewport->view().addStructures(std::move(pictures));
    const QString text = scene.rows.size() == 1
                             ? tr("Add %1").arg(readableName(scene.rows.front().loaded.description.name))
                             : tr("Add %1 structures").arg(scene.rows.size());
    const auto count = scene.rows.size();
    std::vector<std::optional<int>> in;
    for (const study::Layering::Structure& one : scene.layering.structures) {
        in.push_back(one.in ? std::optional(static_cast<int>(*one.in)) : std::nullopt);
    }
    m_model.undoStack().beginMacro(text);
    m_model.addRows(std::move(scene.rows), text);
    m_model.setNesting(in);
    if (scene.areMeshes()) {
        applyTissuePresets(scene.layering, first);
    }
    m_document->add(scene);
    arrangeAdded(scene);
    m_model.undoStack().endMacro();
    m_structures->select(first);
    say(count == 1 ? tr("%1 was added to the scene.").arg(readableName(m_model.structure(first).name))
                   : tr("%1 structures were added to the scene.").arg(count));
    if (!scene.problems.isEmpty()) {
        showError(scene.problems.join(QLatin1Char('\n')));
    }
    offerSurfaces();
    m_loader.findGaps(m_model.rows());
    m_viewport->update();
    showWhatPlays();
    Q_EMIT ready();
}

/// Lays out added structures by nesting if all others are laid out that way; otherwise offers to do so.
void MainWindow::arrangeAdded(const OpenedScene& scene)
{
    const LumpLayout layout(m_model, scene.layering, static_cast<int>(scene.addedTo));
    bool isAsFound = m_document->file().empty() && scene.areMeshes();
    bool isOther = false;
    for (const TouchMode& way : layout.ways()) {
        const auto i = static_cast<std::size_t>(way.row);
        const std::uint32_t now = m_model.structure(way.row).layer;
        const bool isThrough = m_model.isTransmitted(way.row);
        const bool isFound =
            i >= scene.addedTo || m_model.rows()[i].isRemoved || isThrough || now == layerBefore(scene, i);
        isAsFound = isAsFound && isFound;
        isOther = isOther || (way.layer ? *way.layer != now : !isThrough);
    }
    if (!isOther) {
        return;
    }
    const QString text = tr("Feel what is inside below what is around it");
    if (isAsFound) {
        feel(m_model, layout.ways(), text);
        if (!layout.lines().isEmpty()) {
            offerOtherLayout(layout, layout.lines().back() + QLatin1Char('.'));
        }
    } else if (!layout.lines().isEmpty()) {
        m_message->offer(
            tr("What was added lies in or around other structures, but the layers that were set are kept."),
            tr("Feel it below"), [this, ways = layout.inLayers(), text] { feel(m_model, ways, text); });
    }
}

/// Applies tissue presets by name to structures from `first` on, and offers to undo.
void MainWindow::applyTissuePresets(const study::Layering& layering, int first)
{
    std::vector<StructureModel::Edited> edits = tissueByName(m_model, layering, first);
    if (edits.empty()) {
        return;
    }
    std::vector<StructureModel::Edited> before;
    for (const StructureModel::Edited& one : edits) {
        before.push_back({one.row, m_model.structure(one.row)});
    }
    m_model.editAll(std::move(edits), tr("Tissue by names"));
    offerTissueBack(std::move(before));
}

void MainWindow::offerTissueBack(std::vector<StructureModel::Edited> before)
{
    QString line = before.size() == 1
                       ? tr("%1 got its tissue by its name.").arg(readableName(before[0].description.name))
                       : tr("%1 structures got tissue by their names.").arg(before.size());
    int unnamed = 0;
    for (const StructureRow& row : m_model.rows()) {
        unnamed += !row.isRemoved && row.loaded.description.tissue == core::Tissue() ? 1 : 0;
    }
    if (unnamed > 0) {
        line += QLatin1Char(' ') + tr("%n did not: felt as “Firm organ”, 0.5 N/mm.", nullptr, unnamed);
    }
    m_message->offer(line, tr("Undo"), [this, before] {
        std::vector<StructureModel::Edited> edits;
        for (const StructureModel::Edited& one : before) { // keeps the current name, layer and colour
            edits.push_back({one.row, m_model.structure(one.row)});
            edits.back().description.tissue = one.description.tissue;
            edits.back().description.opacity = one.description.opacity;
            edits.back().description.palpable = one.description.palpable;
        }
        m_model.editAll(std::move(edits), tr("Tissue as before"));
    });
}

/// Closes the scene and shows the welcome page.
void MainWindow::closeScene()
{
    if (!confirmDiscard()) {
        return;
    }
    if (m_live.recording().isRecording) {
        toggleRecording();
    }
    m_loader.cancel();
    m_palpateAction->setChecked(false);
    m_playback->setRecording(nullptr);
    m_live.stop();
    m_message->forgetScene();
    m_viewport->view().setStructures({});
    m_model.setRows({});
    m_document->take({});
    m_files.clear();
    m_unit_mm = 1.0;
    m_stack->setCurrentIndex(0); // welcome page
    setWindowTitle(tr("Palpate[*]"));
    setWindowModified(false);
    showWhatPlays();
    showStatus();
}
