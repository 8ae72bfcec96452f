// SPDX-License-Identifier: BSD-3-Clause
#include "scene/DocumentPart.h"

#include "scene/RecentFiles.h"
#include "shared/Paths.h"
#include "shared/ProgramFolders.h"
#include "shell/Notices.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/MapDisplay.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QUndoStack>

#include <algorithm>

namespace palpate::app {

using ui::ActionGroup;

namespace {

meshio::SceneCamera sceneCamera(ui::VtkViewport& viewport)
{
    vtkCamera& camera = viewport.view().camera();
    return {core::Vec3(camera.GetPosition()), core::Vec3(camera.GetFocalPoint()), core::Vec3(camera.GetViewUp()),
            camera.GetViewAngle()};
}

/// Returns whether the scene is the sample that comes with the program, not saved elsewhere yet.
bool isUnsavedSample(const SceneDocument& document, const std::vector<std::filesystem::path>& files)
{
    return document.file().empty() && files.size() == 1 && isSampleFile(files.front());
}

} // namespace

DocumentPart::DocumentPart(const WindowCore& core, ui::MapDisplay& maps, RecentFiles& recent)
    : WindowPart(&core.window)
    , m_core(core)
    , m_maps(maps)
    , m_recent(recent)
    , m_document(core.model)
{
    connect(&recent, &RecentFiles::chosen, this, &DocumentPart::openWanted);
    connect(&m_document, &SceneDocument::copyFailed, &core.notices, &Notices::showError);
}

void DocumentPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("save", ActionGroup::File, tr("Save scene"), tr("Save the scene with its tissue"),
                        {QKeySequence(Qt::CTRL | Qt::Key_S)}),
            &QAction::triggered, this, &DocumentPart::save);
    // Not QKeySequence::SaveAs, which is empty without a platform theme.
    connect(actions.add("save-as", ActionGroup::File, tr("Save scene as…"),
                        tr("Save the scene with its tissue to another file"),
                        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}),
            &QAction::triggered, this, &DocumentPart::saveAs);
    QUndoStack& stack = m_core.model.undoStack();
    QAction* undo = actions.add("undo", ActionGroup::Edit, tr("Undo"), tr("Undo the last change"),
                                {QKeySequence(Qt::CTRL | Qt::Key_Z)}, ui::Symbol::Undo);
    QAction* redo = actions.add("redo", ActionGroup::Edit, tr("Redo"), tr("Redo the last undone change"),
                                {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                                ui::Symbol::Redo);
    actions.addSeparator(ActionGroup::Edit);
    undo->setEnabled(false);
    redo->setEnabled(false);
    connect(undo, &QAction::triggered, &stack, &QUndoStack::undo);
    connect(redo, &QAction::triggered, &stack, &QUndoStack::redo);
    connect(&stack, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
    connect(&stack, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
    connect(&stack, &QUndoStack::undoTextChanged, undo,
            [undo](const QString& text) { undo->setText(text.isEmpty() ? tr("Undo") : tr("Undo: %1").arg(text)); });
    connect(&stack, &QUndoStack::redoTextChanged, redo,
            [redo](const QString& text) { redo->setText(text.isEmpty() ? tr("Redo") : tr("Redo: %1").arg(text)); });
    connect(&stack, &QUndoStack::cleanChanged, &m_core.window,
            [&window = m_core.window](bool isClean) { window.setWindowModified(!isClean); });
}

void DocumentPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"save", "save-as"}, state.hasScene);
}

bool DocumentPart::isFromRecording() const
{
    return std::any_of(m_files.begin(), m_files.end(),
                       [](const std::filesystem::path& file) { return session::isRecordingByNameOrContent(file); });
}

void DocumentPart::takeFiles()
{
    if (m_files.size() == 1 && meshio::isSceneFile(m_files.front()) && !isSampleFile(m_files.front())) {
        m_files.front() = m_document.file(); // restored changes belong to their original scene file
    }
    showTitle();
    // Several files opened one by one are not listed as a recent scene.
    if (m_files.size() == 1 && !m_files.front().empty()) {
        m_recent.add(m_files.front());
    }
}

bool DocumentPart::save()
{
    if (m_document.file().empty()) {
        return saveAs();
    }
    if (m_document.isFileChanged()) {
        QMessageBox box(
            QMessageBox::Warning, tr("The scene was changed elsewhere"),
            tr("Another window or program has saved %1 since it was opened here. Saving would replace that version.")
                .arg(toText(m_document.file().filename())),
            QMessageBox::Cancel, &m_core.window);
        QPushButton* const anyway = box.addButton(tr("Save anyway"), QMessageBox::DestructiveRole);
        QPushButton* const elsewhere = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
        box.setDefaultButton(elsewhere);
        box.exec();
        if (box.clickedButton() != anyway) {
            return box.clickedButton() == elsewhere && saveAs();
        }
    }
    return saveTo(m_document.file());
}

bool DocumentPart::saveAs()
{
    QString proposed = toText(m_document.file());
    if (isUnsavedSample(m_document, m_files)) {
        proposed = documentsFolder() + QLatin1Char('/') + toText(m_files.front().filename());
    }
    const QString chosen =
        QFileDialog::getSaveFileName(&m_core.window, tr("Save scene"), proposed, tr("Palpate scene (*.palpate.json)"));
    if (chosen.isEmpty()) {
        return false;
    }
    return saveTo(toPath(chosen.endsWith(QLatin1String(".json")) ? chosen : chosen + QStringLiteral(".palpate.json")));
}

bool DocumentPart::saveTo(const std::filesystem::path& path)
{
    const core::Status saved = m_document.save(path, sceneCamera(m_core.viewport), m_maps.shown());
    if (saved.isOk()) {
        m_files = {path};
        showTitle();
        m_recent.add(path);
        m_core.notices.say(tr("Scene saved to %1").arg(toText(path)));
    } else {
        m_core.notices.showError(ui::translated(saved));
    }
    return saved.isOk();
}

bool DocumentPart::confirmDiscard()
{
    if (!m_document.isModified()) {
        return true;
    }
    const auto answer =
        QMessageBox::question(&m_core.window, tr("Unsaved changes"), tr("Save the changes to this scene?"),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void DocumentPart::showTitle()
{
    QMainWindow& window = m_core.window;
    if (m_core.model.rowCount({}) == 0) {
        window.setWindowTitle(tr("Palpate[*]"));
        window.setWindowModified(false);
        return;
    }
    QString name =
        m_files.empty() || m_files.front().empty() ? tr("Unsaved scene") : toText(m_files.front().filename());
    if (isUnsavedSample(m_document, m_files)) {
        name = tr("Unsaved copy of %1").arg(name);
    }
    if (m_files.size() > 1) {
        name = tr("%1 and %2 more").arg(name).arg(m_files.size() - 1);
    }
    window.setWindowTitle(tr("%1[*] – Palpate").arg(name));
    window.setWindowModified(m_document.isModified());
}

void DocumentPart::offerLeftover()
{
    const auto copy = SceneDocument::findLeftover();
    if (copy && m_core.model.rowCount() == 0) {
        m_core.notices.bar().offer(
            tr("Palpate ended unexpectedly. Unsaved changes of a scene can be restored."), tr("Restore"),
            [this, copy] {
                if (m_document.claimLeftover(*copy)) {
                    Q_EMIT openWanted(*copy);
                } else {
                    m_core.notices.say(tr("These changes were already restored in another window."));
                }
            },
            ui::MessageBar::Keep::UntilAnswered);
    }
}

} // namespace palpate::app

#include "moc_DocumentPart.cpp"
