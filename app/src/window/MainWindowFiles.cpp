// SPDX-License-Identifier: BSD-3-Clause
// Opening and saving scenes and recordings; files dropped on the window.
#include "shared/Paths.h"
#include "touch/FingertipMenu.h"
#include "window/MainWindow.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/EngineTexts.h>

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::open(const std::vector<std::filesystem::path>& files, double unit_mm, core::FileFrame frame)
{
    std::vector<std::filesystem::path> meshes;
    std::optional<std::filesystem::path> recording;
    for (const std::filesystem::path& file : files) {
        if (session::isRecordingFile(file)) {
            recording = file;
        } else {
            meshes.push_back(file);
        }
    }
    if (meshes.empty() && recording && m_model.rowCount() == 0) {
        meshes.push_back(*recording); // a recording alone: also opens its scene, see study::sceneOfRecording
    }
    if (!meshes.empty() && !confirmDiscard()) {
        return;
    }
    m_message->forgetScene();
    if (meshes.empty()) {
        if (recording) {
            openRecording(*recording);
        }
        return;
    }
    m_waitingRecording = recording;
    m_unit_mm = unit_mm;
    m_opening = meshes;
    m_openingFrame = frame;
    m_loader.open(meshes, unit_mm, frame);
}

/// Called as soon as the meshes are read, while they are being indexed.
void MainWindow::offerReadingAsMetres(double size_mm)
{
    // No organ is smaller; some libraries write metres to formats that cannot store a unit.
    constexpr double kSmallest_mm = 3.0;
    if (m_unit_mm != 1.0 || size_mm >= kSmallest_mm ||
        std::any_of(m_opening.begin(), m_opening.end(), [](const std::filesystem::path& file) {
            return meshio::isSceneFile(file) || session::isRecordingFile(file);
        })) {
        return;
    }
    m_message->offer(
        tr("This anatomy is %1 mm across: its numbers are probably metres.").arg(QLocale().toString(size_mm, 'g', 2)),
        tr("Read as metres"), [this, files = m_opening, frame = m_openingFrame] { open(files, 1000.0, frame); });
}

/// Reloads the open meshes with other axes.
void MainWindow::readAs(core::FileFrame frame)
{
    if (m_model.rowCount() == 0) {
        return;
    }
    if (m_live.recording().isRecording) {
        say(tr("Stop the recording first: it holds the surfaces as they lie now."));
        return;
    }
    m_waitingRecording.reset();
    m_isEditedSinceReload = false;
    m_loader.reopen(m_document->inFrame(frame), m_files);
}

/// Shows what is known of the patient orientation in the status bar and on the cube in the view.
void MainWindow::showCoordinates()
{
    m_coordinates->show(m_model.rows(), std::any_of(m_files.begin(), m_files.end(),
                                                    [](const auto& file) { return session::isRecordingFile(file); }));
    m_viewport->view().cube().setSidesKnown(m_coordinates->isKnown());
    m_viewport->update();
}

void MainWindow::takeScene(const std::shared_ptr<OpenedScene>& scene)
{
    if (scene->isReopened && m_isEditedSinceReload) { // edits during reloading are missing: reload again
        readAs(scene->rows.front().loaded.description.frame);
        return;
    }
    m_playback->setRecording(nullptr);
    m_files = scene->files;
    std::vector<view::ViewStructure> pictures;
    pictures.reserve(scene->rows.size());
    for (const StructureRow& row : scene->rows) {
        const geometry::MeshReport& report = row.loaded.surface->report;
        pictures.push_back({view::StructureActor(row.picture, StructureModel::appearanceOf(row.loaded.description),
                                                 report.isClosed() && report.insideOutComponents == 0),
                            row.loaded.description.palpable ? row.touch : nullptr});
    }
    view::SceneView& view = m_viewport->view();
    view.setStructures(std::move(pictures));
    m_model.setRows(std::move(scene->rows), scene->scene.buried);
    m_document->take(*scene);
    m_stack->setCurrentWidget(m_viewport);
    // Drop the minimum size of the welcome page, or a message above the view would enlarge the window.
    m_stack->setMinimumSize(1, 1);
    if (scene->scene.camera) {
        const meshio::SceneCamera& from = *scene->scene.camera;
        view.camera().SetPosition(from.position_W.x(), from.position_W.y(), from.position_W.z());
        view.camera().SetFocalPoint(from.focus_W.x(), from.focus_W.y(), from.focus_W.z());
        view.camera().SetViewUp(from.up_W.x(), from.up_W.y(), from.up_W.z());
        view.camera().SetViewAngle(from.viewAngle_deg);
    } else {
        view.look(view::ViewFrom::Oblique);
    }
    m_palpation->setSceneSize(view.bounds().diagonal().norm());
    const core::Status started = m_live.start();
    if (!started.isOk()) {
        showError(ui::engineText(started));
    }
    m_structures->select(0);
    if (const auto& shown = scene->scene.shownMap) {
        m_structures->colourBy(*shown);
    }
    m_viewport->setFocus();
    m_viewport->update();
    if (scene->files.size() == 1 && meshio::isSceneFile(m_files.front())) {
        m_files.front() = m_document->file(); // restored changes belong to their original scene file
    }
    showTitle();
    // Several files opened one by one are not listed as a recent scene.
    if (m_files.size() == 1 && !m_files.front().empty()) {
        remember(m_files.front());
    }
    const QString how = howToTouch();
    const int notes = listNotes(*scene);
    const QString told = notes == 1 ? tr("1 note on these files") : tr("%1 notes on these files").arg(notes);
    say(notes == 0 ? how : tr("%1  ·  %2 (F4 lists them)").arg(how, told), 60000);
    if (scene->isReopened) {
        say(tr("Read again with coordinates %1: tissue and findings are kept, undo starts anew.")
                .arg(m_coordinates->button().text()),
            20000);
    }
    showWhatPlays();
    if (scene->areMeshes() && !scene->isReopened && !m_waitingRecording) {
        applyTissuePresets(scene->layering, 0);
        m_model.undoStack().setClean(); // automatic changes do not make the document modified
    }
    if (!scene->isReopened) {
        layOut(*scene);
    }
    if (!scene->problems.isEmpty()) {
        showError(scene->problems.join(QLatin1Char('\n')));
    }
    offerSurfaces();
    m_loader.findGaps(m_model.rows());
    if (m_waitingRecording) {
        openRecording(*std::exchange(m_waitingRecording, std::nullopt));
    }
    if (!scene->isReopened) {
        takeFingertip();
    }
    Q_EMIT ready();
}

/// Sets the fingertip radius: as recorded if a recording was opened alone, otherwise as last chosen by the user.
void MainWindow::takeFingertip()
{
    const RecordedTouch* recording = session::isRecordingFile(m_files.front()) ? m_playback->recording() : nullptr;
    const auto first = recording != nullptr ? recording->at(0.0) : std::nullopt;
    const double radius_mm = first ? recording->fingertip_mm(*first) : app::chosenFingertip_mm();
    if (first && radius_mm != m_live.fingertip_mm()) {
        say(radius_mm > 0.0 ? tr("As recorded, the fingertip is a ball of %1 mm radius (Session › Fingertip).")
                                  .arg(QLocale().toString(radius_mm))
                            : tr("As recorded, the fingertip is a point (Session › Fingertip)."),
            20000);
    }
    m_live.setFingertip(radius_mm);
}

void MainWindow::openRecording(const std::filesystem::path& path)
{
    auto recording = RecordedTouch::open(path);
    if (!recording.isOk()) {
        showError(ui::engineText(recording.status()));
        Q_EMIT openFailed(ui::engineText(recording.status()));
        return;
    }
    const QString losses = recording.value()->losses();
    connect(recording.value().get(), &RecordedTouch::damageFound, this, &MainWindow::showError);
    m_palpateAction->setChecked(false);
    m_playback->setRecording(std::move(recording).value());
    remember(path);
    if (!losses.isEmpty()) {
        showError(losses);
    }
    if (m_model.rowCount() == 0) {
        showError(tr("%1 can be played, but the meshes that it was made on are not where they were. Open them to see "
                     "what was touched.")
                      .arg(toText(path.filename())));
        m_stack->setCurrentWidget(m_viewport);
        Q_EMIT ready();
    }
}

meshio::SceneCamera MainWindow::cameraNow() const
{
    vtkCamera& camera = m_viewport->view().camera();
    return {core::Vec3(camera.GetPosition()), core::Vec3(camera.GetFocalPoint()), core::Vec3(camera.GetViewUp()),
            camera.GetViewAngle()};
}

bool MainWindow::saveScene()
{
    if (m_document->file().empty()) {
        return saveSceneAs();
    }
    if (m_document->isFileChanged()) {
        QMessageBox box(QMessageBox::Warning, tr("The scene was changed elsewhere"),
                        tr("%1 was saved by another window or program since it was opened here. To save it would "
                           "replace what was saved there.")
                            .arg(toText(m_document->file().filename())),
                        QMessageBox::Cancel, this);
        QPushButton* const anyway = box.addButton(tr("Save anyway"), QMessageBox::DestructiveRole);
        QPushButton* const elsewhere = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
        box.setDefaultButton(elsewhere);
        box.exec();
        if (box.clickedButton() != anyway) {
            return box.clickedButton() == elsewhere && saveSceneAs();
        }
    }
    return saveSceneTo(m_document->file());
}

bool MainWindow::saveSceneAs()
{
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Save scene"), toText(m_document->file()),
                                                        tr("Palpate scene (*.palpate.json)"));
    if (chosen.isEmpty()) {
        return false;
    }
    return saveSceneTo(
        toPath(chosen.endsWith(QLatin1String(".json")) ? chosen : chosen + QStringLiteral(".palpate.json")));
}

bool MainWindow::saveSceneTo(const std::filesystem::path& path)
{
    const core::Status saved = m_document->save(path, cameraNow(), m_maps->shown());
    if (saved.isOk()) {
        m_files = {path};
        showTitle();
        remember(path);
        say(tr("Scene saved to %1").arg(toText(path)));
    } else {
        showError(ui::engineText(saved));
    }
    return saved.isOk();
}

/// Asks whether to save unsaved changes. @return false if the user cancels
bool MainWindow::confirmDiscard()
{
    if (!m_document->isModified()) {
        return true;
    }
    const auto answer = QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes to this scene?"),
                                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveScene());
}

void MainWindow::showTitle()
{
    QString name =
        m_files.empty() || m_files.front().empty() ? tr("Unsaved scene") : toText(m_files.front().filename());
    if (m_files.size() > 1) {
        name = tr("%1 and %2 more").arg(name).arg(m_files.size() - 1);
    }
    setWindowTitle(tr("%1[*] – Palpate").arg(name));
    setWindowModified(m_document->isModified());
}

void MainWindow::offerLeftover()
{
    const auto copy = SceneDocument::findLeftover();
    if (copy && m_model.rowCount() == 0) {
        m_message->offer(
            tr("Palpate ended unexpectedly and left unsaved changes of a scene."), tr("Restore"),
            [this, copy] {
                if (m_document->claimLeftover(*copy)) {
                    open({*copy});
                } else {
                    say(tr("These changes were already restored in another window."));
                }
            },
            MessageBar::Keep::UntilAnswered);
    }
}

void MainWindow::chooseFiles()
{
    QString endings = QStringLiteral("*.json *.palpate");
    for (const std::string& extension : meshio::meshExtensions()) {
        endings += QStringLiteral(" *") + QString::fromStdString(extension);
    }
    const QStringList chosen =
        QFileDialog::getOpenFileNames(this, tr("Open anatomy"), QSettings().value(QStringLiteral("folder")).toString(),
                                      tr("Anatomy, scenes and recordings (%1);;All files (*)").arg(endings));
    std::vector<std::filesystem::path> files;
    for (const QString& file : chosen) {
        files.push_back(toPath(file));
    }
    if (!files.empty()) {
        QSettings().setValue(QStringLiteral("folder"), toText(files.front().parent_path()));
        open(files);
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    std::vector<std::filesystem::path> files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            files.push_back(toPath(url.toLocalFile()));
        }
    }
    if (!files.empty()) {
        event->acceptProposedAction();
        const bool hasMeshes =
            std::any_of(files.begin(), files.end(), [](const auto& file) { return !session::isRecordingFile(file); });
        if (m_model.rowCount() == 0 || !hasMeshes) {
            open(files);
            return;
        }
        const QString what = files.size() == 1 ? toText(files.front().filename()) : tr("%1 files").arg(files.size());
        m_message->ask(
            tr("Add %1 to the open scene?").arg(what), tr("Add"), [this, files] { add(files); }, tr("Open instead"),
            [this, files] { open(files); });
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_recording->mayEnd(this) || !confirmDiscard()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState());
    m_live.stop();
    event->accept();
}
