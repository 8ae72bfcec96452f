// SPDX-License-Identifier: BSD-3-Clause
#include "window/SceneChanges.h"

#include "exercise/ExercisePart.h"
#include "scene/CoordinatesPart.h"
#include "scene/DocumentPart.h"
#include "scene/LayerOffers.h"
#include "scene/SceneFiles.h"
#include "scene/SceneSurfaces.h"
#include "scene/StructuresPart.h"
#include "scene/TissueOffer.h"
#include "shell/Notices.h"
#include "touch/DevicePart.h"
#include "touch/RecordingPart.h"
#include "touch/TouchPart.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QHash>
#include <QMainWindow>
#include <QSet>
#include <QUndoStack>

#include <optional>
#include <utility>
#include <vector>

namespace palpate::app {

namespace {

void setSceneCamera(view::SceneView& view, const std::optional<meshio::SceneCamera>& from)
{
    if (!from) {
        view.look(view::ViewFrom::Oblique);
        return;
    }
    view.camera().SetPosition(from->position_W.x(), from->position_W.y(), from->position_W.z());
    view.camera().SetFocalPoint(from->focus_W.x(), from->focus_W.y(), from->focus_W.z());
    view.camera().SetViewUp(from->up_W.x(), from->up_W.y(), from->up_W.z());
    view.camera().SetViewAngle(from->viewAngle_deg);
}

} // namespace

SceneChanges::SceneChanges(const WindowCore& core, const Parts& parts)
    : QObject(&core.window)
    , m_core(core)
    , m_parts(parts)
    , m_layers(new LayerOffers(core.model, core.notices.bar(), this))
    , m_surfaces(new SceneSurfaces(core, parts.files.loader(), parts.progress, *m_layers, this))
{
    const ui::SceneLoader& loader = parts.files.loader();
    connect(&loader, &ui::SceneLoader::structuresReady, this,
            [this](const std::shared_ptr<std::vector<ui::StructureRow>>& rows) { preview(*rows); });
    connect(&loader, &ui::SceneLoader::structuresDropped, this, &SceneChanges::dropPreview);
    connect(&loader, &ui::SceneLoader::opened, this, &SceneChanges::take);
    connect(&parts.files, &SceneFiles::closeWanted, this, &SceneChanges::close);
}

/// Shows structures of a scene that is being opened. The document stays empty until all are read: nothing of the
/// preview can be touched, edited or saved. An open scene or recording stays in the view instead.
void SceneChanges::preview(const std::vector<ui::StructureRow>& rows)
{
    if (m_core.model.rowCount() > 0 || m_parts.recording.playback().recording() != nullptr) {
        return;
    }
    m_surfaces->drawAdded(rows);
    view::SceneView& view = m_core.viewport.view();
    if (m_isPreview) {
        view.fitAll();
    } else {
        m_isPreview = true;
        view.look(view::ViewFrom::Oblique);
        Q_EMIT viewChanged(true);
    }
    m_core.viewport.update();
}

/// Shows the welcome page again.
void SceneChanges::dropPreview()
{
    if (std::exchange(m_isPreview, false)) {
        m_core.viewport.view().setStructures({});
        Q_EMIT viewChanged(false);
    }
}

void SceneChanges::take(const std::shared_ptr<ui::OpenedScene>& scene)
{
    m_isPreview = false;
    if (scene->addedTo > 0) {
        add(*scene);
    } else if (scene->isReopened && m_parts.coordinates.isEditedSince()) {
        // Edits during reading are missing: read again.
        m_parts.coordinates.readAs(scene->rows.front().loaded.description.frame);
    } else {
        replace(*scene);
    }
}

void SceneChanges::replace(ui::OpenedScene& scene)
{
    m_parts.recording.playback().setRecording(nullptr);
    m_parts.document.setFiles(scene.files);
    const bool isReview = m_parts.files.hasWaitingRecording() || m_parts.document.isFromRecording();
    for (ui::StructureRow& row : scene.rows) {
        row.loaded.description.isHiddenTarget = row.loaded.description.isHiddenTarget && !isReview;
    }
    m_surfaces->draw(scene.rows);
    m_core.model.setRows(std::move(scene.rows), scene.scene.buried, scene.scene.exercise);
    m_parts.document.document().take(scene);
    m_parts.exercise.takeScene();
    show(scene);
    m_parts.document.takeFiles();
    greet(scene);
    Q_EMIT stateChanged();
    const bool isSecret = m_core.model.scene().hiddenTargets() > 0;
    if (!isSecret) {
        arrange(scene); // offers name structures inside others
    }
    showProblems(scene);
    if (scene.scene.exercise && isReview) {
        m_core.notices.warn({tr("The scene has an exercise. Its targets are shown, because a recording is opened.")});
    }
    m_surfaces->offerRepairs();
    m_parts.files.openWaiting();
    if (!scene.isReopened) {
        m_parts.recording.takeFingertip();
    }
    Q_EMIT ready();
}

/// Shows the new scene in view and panels and starts the touch.
void SceneChanges::show(const ui::OpenedScene& scene)
{
    Q_EMIT viewChanged(true);
    view::SceneView& view = m_core.viewport.view();
    setSceneCamera(view, scene.scene.camera);
    m_parts.touch.palpation().setSceneSize(view.bounds().diagonal().norm());
    if (const core::Status started = m_core.live.start(); !started.isOk()) {
        m_core.notices.showError(ui::translated(started));
    }
    ui::StructurePanel& panel = m_parts.structures.panel();
    panel.select(0);
    if (const auto& shown = scene.scene.shownMap) {
        panel.colourBy(*shown);
    }
    m_core.viewport.setFocus();
    m_core.viewport.update();
}

/// Shows how to touch and the number of notes on the files in the status line.
void SceneChanges::greet(const ui::OpenedScene& scene)
{
    const QString how = m_parts.device.howToTouch();
    const int notes = listNotes(scene);
    const QString told = notes == 1 ? tr("1 note on these files") : tr("%1 notes on these files").arg(notes);
    m_core.notices.say(notes == 0 ? how : tr("%1  ·  %2 (F4 lists them)").arg(how, told), 60000);
    if (scene.isReopened) {
        m_core.notices.say(tr("The meshes were read again with coordinates %1. Tissue and findings are kept; earlier "
                              "changes cannot be undone.")
                               .arg(m_parts.coordinates.axesText()),
                           20000);
    }
}

/// Gives a new scene tissue and layers where the files have none.
void SceneChanges::arrange(const ui::OpenedScene& scene)
{
    if (scene.isReopened) {
        return;
    }
    const bool hasRecording = m_parts.files.hasWaitingRecording();
    if (scene.areMeshes() && !hasRecording) {
        m_parts.structures.colourAsChosen(0);
        applyTissueByName(m_core.model, m_core.notices.bar(), scene.layering, 0);
        m_core.model.undoStack().setClean(); // automatic changes do not make the document modified
    }
    m_layers->layOut(scene, hasRecording);
}

void SceneChanges::showProblems(const ui::OpenedScene& scene)
{
    if (const QStringList problems = namable(scene.problems); !problems.isEmpty()) {
        m_core.notices.showError(problems.join(QLatin1Char('\n')));
    }
}

/// Leaves out texts that name a hidden target, and states their number.
QStringList SceneChanges::namable(const QStringList& texts) const
{
    QStringList kept;
    for (const QString& text : texts) {
        if (!m_core.model.scene().givesTargetAway(text.toStdString())) {
            kept << text;
        }
    }
    if (const auto withheld = static_cast<int>(texts.size() - kept.size()); withheld > 0) {
        kept << tr("%n note(s) on hidden targets are withheld", nullptr, withheld);
    }
    return kept;
}

/// Adds notes from opening to the list of messages. Structures with the same defects share a note. @return the number
/// of notes
int SceneChanges::listNotes(const ui::OpenedScene& scene)
{
    const ui::StructureModel& model = m_core.model;
    QSet<QString> details; // the same as warnings, which are given in the notes on the defects
    QStringList kinds;     // in the order of the structures
    QHash<QString, std::vector<int>> rowsOf;
    for (int row = 0; row < model.rowCount(); ++row) {
        const QStringList found = model.isListed(row) ? model.findings(row) : QStringList();
        if (found.isEmpty()) {
            continue;
        }
        for (const QString& detail : found) {
            details << ui::translated(
                core::Message(PALPATE_TEXT("%1: %2"), model.structure(row).name, detail.toStdString()));
        }
        const QString kind = model.defects(row).join(QStringLiteral("; "));
        if (!rowsOf.contains(kind)) {
            kinds << kind;
        }
        rowsOf[kind].push_back(row);
    }
    QStringList notes;
    for (const QString& warning : namable(scene.warnings)) {
        if (!details.contains(warning)) {
            notes << warning;
        }
    }
    for (const QString& kind : kinds) {
        const std::vector<int>& rows = rowsOf[kind];
        const QString first = ui::readableName(model.structure(rows.front()).name);
        notes << (rows.size() == 1
                      ? tr("%1: %2 (%3)").arg(first, kind, model.findings(rows.front()).join(QStringLiteral("; ")))
                      : tr("%1 structures: %2 (%3 and others; the sign in the list of structures has the details)")
                            .arg(rows.size())
                            .arg(kind, first));
    }
    m_core.notices.warn(notes);
    return static_cast<int>(notes.size());
}

void SceneChanges::add(ui::OpenedScene& scene)
{
    const int first = m_core.model.rowCount();
    const auto count = scene.rows.size();
    m_surfaces->drawAdded(scene.rows);
    addRows(scene, first);
    m_parts.structures.panel().select(first);
    m_core.notices.say(count == 1
                           ? tr("%1 was added to the scene.").arg(ui::readableName(m_core.model.structure(first).name))
                           : tr("%1 structures were added to the scene.").arg(count));
    showProblems(scene);
    m_surfaces->offerRepairs();
    m_core.viewport.update();
    Q_EMIT stateChanged();
    Q_EMIT ready();
}

/// Adds structures, findings, tissue and layers as one undo step.
void SceneChanges::addRows(ui::OpenedScene& scene, int first)
{
    ui::StructureModel& model = m_core.model;
    const QString text = scene.rows.size() == 1
                             ? tr("Add %1").arg(ui::readableName(scene.rows.front().loaded.description.name))
                             : tr("Add %1 structures").arg(scene.rows.size());
    std::vector<std::optional<std::size_t>> in;
    for (const study::Layering::Structure& one : scene.layering.structures) {
        in.push_back(one.in);
    }
    model.undoStack().beginMacro(text);
    model.addRows(std::move(scene.rows), text);
    model.setNesting(in);
    if (scene.areMeshes()) {
        m_parts.structures.colourAsChosen(first);
        applyTissueByName(model, m_core.notices.bar(), scene.layering, first);
    }
    SceneDocument& document = m_parts.document.document();
    document.add(scene);
    m_layers->layOutAdded(scene, document.file().empty());
    model.undoStack().endMacro();
}

/// Closes the scene and shows the welcome page.
void SceneChanges::close()
{
    if (!m_parts.document.confirmDiscard()) {
        return;
    }
    if (m_parts.recording.isRecording()) {
        m_parts.recording.toggle();
    }
    m_parts.files.forget();
    m_core.actions.at("palpate").setChecked(false);
    m_parts.recording.playback().setRecording(nullptr);
    m_core.live.stop();
    m_core.notices.bar().forgetScene();
    m_core.viewport.view().setStructures({});
    m_core.model.setRows({});
    m_parts.document.document().take({});
    m_parts.exercise.takeScene();
    m_parts.document.setFiles({});
    Q_EMIT viewChanged(false);
    m_parts.document.showTitle();
    Q_EMIT stateChanged();
}

} // namespace palpate::app

#include "moc_SceneChanges.cpp"
