// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneFiles.h"

#include "scene/DocumentPart.h"
#include "shared/Paths.h"
#include "shared/ProgramFolders.h"
#include "shared/SceneSize.h"
#include "shell/Notices.h"
#include "shell/StatusProgress.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>
#include <QMimeData>
#include <QRegularExpression>
#include <QSettings>
#include <QUrl>

#include <algorithm>
#include <utility>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kFolderKey = "folder";

bool isRecording(const std::filesystem::path& file)
{
    return session::isRecordingByNameOrContent(file);
}

/// True for points of 3D Slicer.
bool isMarkups(const std::filesystem::path& file)
{
    return toText(file.filename()).endsWith(QLatin1String(".mrk.json"), Qt::CaseInsensitive);
}

/// Matches the option of the command line in a message about a truncated mesh, in every language.
const QRegularExpression& partialAdvice()
{
    static const QRegularExpression advice(QStringLiteral("\\s*; --partial .*$"));
    return advice;
}

QString lastFolder()
{
    return QSettings().value(QLatin1String(kFolderKey)).toString();
}

/// Files chosen in a dialog; their folder is kept for the next dialog.
std::vector<std::filesystem::path> chosenFiles(const QStringList& chosen)
{
    std::vector<std::filesystem::path> files;
    for (const QString& file : chosen) {
        files.push_back(toPath(file));
    }
    if (!files.empty()) {
        QSettings().setValue(QLatin1String(kFolderKey), toText(files.front().parent_path()));
    }
    return files;
}

} // namespace

SceneFiles::SceneFiles(const WindowCore& core, DocumentPart& document, StatusProgress& progress,
                       ui::WelcomePage& welcome)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_progress(progress)
{
    m_loader.setReader([](const auto& path, const auto& options) { return study::openScene(path, options); });
    connect(&document, &DocumentPart::openWanted, this, [this](const std::filesystem::path& file) { open({file}); });
    connect(&welcome, &ui::WelcomePage::openWanted, this, &SceneFiles::choose);
    connect(&welcome, &ui::WelcomePage::recentWanted, this, [this](const QString& path) { open({toPath(path)}); });
    connect(&welcome, &ui::WelcomePage::phantomWanted, this, &SceneFiles::openPhantom);
    connectLoader();
}

void SceneFiles::connectLoader()
{
    connect(&m_progress, &StatusProgress::cancelled, &m_loader, &ui::SceneLoader::cancel);
    connect(&m_loader, &ui::SceneLoader::progressed, &m_progress, &StatusProgress::show);
    connect(&m_loader, &ui::SceneLoader::sizeKnown, this, &SceneFiles::offerReadingAsMetres);
    connect(&m_loader, &ui::SceneLoader::opened, &m_progress, &StatusProgress::end);
    connect(&m_loader, &ui::SceneLoader::opened, this, [this](const std::shared_ptr<ui::OpenedScene>& scene) {
        const bool isCut = std::any_of(scene->problems.begin(), scene->problems.end(),
                                       [](const QString& line) { return partialAdvice().match(line).hasMatch(); });
        if (isCut && scene->addedTo == 0 && !scene->isReopened) {
            offerPart(tr("Some of the files are cut off."));
        }
    });
    connect(&m_loader, &ui::SceneLoader::failed, this, &SceneFiles::takeFailure);
    connect(&m_loader, &ui::SceneLoader::cancelled, this, [this] {
        m_progress.end();
        m_waitingRecording.reset();
        m_waitingMarkups.clear();
        m_core.notices.say(tr("Opening was cancelled."));
    });
}

void SceneFiles::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("open", ActionGroup::File, tr("Open…"), tr("Open meshes, a scene or a recording"),
                        {QKeySequence(Qt::CTRL | Qt::Key_O)}, ui::Symbol::Open),
            &QAction::triggered, this, &SceneFiles::choose);
    connect(actions.add("add", ActionGroup::File, tr("Add to the scene…"),
                        tr("Add meshes or a scene to the open scene"),
                        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}),
            &QAction::triggered, this, &SceneFiles::chooseAdded);
    connect(actions.add("close", ActionGroup::File, tr("Close the scene"), tr("Close the open scene"),
                        {QKeySequence(Qt::CTRL | Qt::Key_W)}),
            &QAction::triggered, this, &SceneFiles::closeWanted);
}

void SceneFiles::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"add", "close"}, state.hasScene);
}

void SceneFiles::open(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options)
{
    if (!offerImage(files, options)) {
        openAll(files, options);
    }
}

/// With an open scene, a volume may be an image of it or a label map.
/// @return true if the user is asked
bool SceneFiles::offerImage(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options)
{
    if (m_core.model.rowCount() == 0 || files.size() != 1 || !meshio::hasLabelMapExtension(files.front())) {
        return false;
    }
    m_core.notices.bar().ask(
        tr("%1: is it an image of the open scene, or a segmentation?").arg(toText(files.front().filename())),
        tr("Show the image"), [this, file = files.front()] { Q_EMIT imageWanted(file); }, tr("Open the segmentation"),
        [this, files, options] { openAll(files, options); });
    return true;
}

void SceneFiles::openAll(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options)
{
    std::vector<std::filesystem::path> meshes;
    std::vector<std::filesystem::path> markups;
    std::optional<std::filesystem::path> recording;
    for (const std::filesystem::path& file : files) {
        if (isRecording(file)) {
            recording = file;
        } else if (isMarkups(file)) {
            markups.push_back(file);
        } else {
            meshes.push_back(file);
        }
    }
    if (meshes.empty() && recording && m_core.model.rowCount() == 0) {
        meshes.push_back(*recording); // a recording alone: also opens its scene, see study::sceneOfRecording
    }
    if (meshes.empty() && !markups.empty() && m_core.model.rowCount() == 0) {
        const QString line =
            tr("%1 has points of 3D Slicer, which become findings. Open the anatomy first, or both at once.")
                .arg(toText(markups.front().filename()));
        m_core.notices.showError(line);
        Q_EMIT openFailed(line);
        return;
    }
    if (!meshes.empty() && !m_document.confirmDiscard()) {
        return;
    }
    m_core.notices.bar().forgetScene();
    if (meshes.empty()) {
        if (recording) {
            Q_EMIT recordingWanted(*recording);
        }
        for (const std::filesystem::path& file : markups) {
            Q_EMIT markupsWanted(file);
        }
        return;
    }
    m_waitingRecording = recording;
    m_waitingMarkups = std::move(markups);
    m_opening = meshes;
    m_options = options;
    m_loader.open(meshes, options);
}

void SceneFiles::add(const std::vector<std::filesystem::path>& files)
{
    if (m_core.model.rowCount() == 0) {
        open(files);
        return;
    }
    std::vector<std::filesystem::path> meshes;
    for (const std::filesystem::path& file : files) {
        if (isRecording(file)) {
            Q_EMIT recordingWanted(file);
        } else if (isMarkups(file)) {
            Q_EMIT markupsWanted(file);
        } else {
            meshes.push_back(file);
        }
    }
    std::vector<ui::OpenSurface> there;
    for (const study::OpenStructure& row : m_core.model.rows()) {
        there.push_back(row.isRemoved ? ui::OpenSurface() : ui::OpenSurface{row.loaded.surface, row.touch});
    }
    if (!meshes.empty()) {
        m_loader.add(std::move(meshes), m_options.unit_mm, std::move(there));
    }
}

std::vector<std::filesystem::path> SceneFiles::filesIn(const QMimeData& data)
{
    std::vector<std::filesystem::path> files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files.push_back(toPath(url.toLocalFile()));
        }
    }
    return files;
}

void SceneFiles::drop(const std::vector<std::filesystem::path>& files)
{
    if (offerImage(files, {})) {
        return;
    }
    if (m_core.model.rowCount() == 0 || std::all_of(files.begin(), files.end(), [](const auto& file) {
            return isRecording(file) || isMarkups(file);
        })) {
        open(files);
        return;
    }
    const QString what = files.size() == 1 ? toText(files.front().filename()) : tr("%1 files").arg(files.size());
    m_core.notices.bar().ask(
        tr("Add %1 to the open scene?").arg(what), tr("Add"), [this, files] { add(files); }, tr("Open instead"),
        [this, files] { open(files); });
}

void SceneFiles::reopen(meshio::SceneFile scene)
{
    m_waitingRecording.reset();
    m_waitingMarkups.clear();
    m_loader.reopen(std::move(scene), m_document.files());
}

void SceneFiles::forget()
{
    m_loader.cancel();
    m_options = {};
}

void SceneFiles::openWaiting()
{
    if (const auto recording = std::exchange(m_waitingRecording, std::nullopt)) {
        Q_EMIT recordingWanted(*recording);
    }
    for (const std::filesystem::path& file : std::exchange(m_waitingMarkups, {})) {
        Q_EMIT markupsWanted(file);
    }
}

void SceneFiles::openPhantom()
{
    if (const auto folder = phantomFolder()) {
        open({*folder / "phantom.palpate.json", *folder / "palpation.palpate"});
        return;
    }
    const QString line = tr("The phantom was not found next to the program.");
    m_core.notices.showError(line);
    Q_EMIT openFailed(line);
}

void SceneFiles::takeFailure(const QString& line)
{
    m_progress.end();
    m_waitingMarkups.clear();
    if (m_waitingRecording && m_opening == std::vector{*m_waitingRecording}) {
        m_core.notices.warn({line}); // the recording itself offers to find its meshes
    } else {
        showFailure(line);
    }
    if (m_waitingRecording && m_core.model.rowCount() == 0) {
        openWaiting(); // playback works without the scene of the recording
    } else {
        m_waitingRecording.reset();
        Q_EMIT openFailed(line);
    }
}

/// Shows why nothing was opened. For a truncated mesh the message of the command line names an option; here it is a
/// button.
void SceneFiles::showFailure(const QString& line)
{
    const auto advice = partialAdvice().match(line);
    if (advice.hasMatch()) {
        offerPart(line.left(advice.capturedStart()));
    } else {
        m_core.notices.showError(line);
    }
}

/// Offers to open truncated meshes as far as they are there.
void SceneFiles::offerPart(const QString& line)
{
    meshio::ReadOptions partial = m_options;
    partial.isPartial = true;
    m_core.notices.bar().offer(
        line, tr("Open the part that is there"), [this, files = m_opening, partial] { openAll(files, partial); },
        ui::MessageBar::Keep::UntilAnswered);
}

/// Called as soon as the meshes are read, while they are being indexed.
void SceneFiles::offerReadingAsMetres(double size_mm)
{
    if (m_options.unit_mm != 1.0 || size_mm >= kSmallestScene_mm ||
        std::any_of(m_opening.begin(), m_opening.end(),
                    [](const std::filesystem::path& file) { return meshio::isSceneFile(file) || isRecording(file); })) {
        return;
    }
    meshio::ReadOptions inMetres = m_options;
    inMetres.unit_mm = 1000.0;
    m_core.notices.bar().offer(tr("This anatomy is only %1 mm across. Its coordinates are probably in metres.")
                                   .arg(ui::numberText(size_mm, 2)),
                               tr("Read as metres"), [this, files = m_opening, inMetres] { open(files, inMetres); });
}

void SceneFiles::choose()
{
    QString endings = QStringLiteral("*.json *.palpate *.vtm *.pvd *.vtpd *.vtpc *.mrml");
    for (const std::string& extension : meshio::meshExtensions()) {
        endings += QStringLiteral(" *") + QString::fromStdString(extension);
    }
    const auto files = chosenFiles(
        QFileDialog::getOpenFileNames(&m_core.window, tr("Open anatomy"), lastFolder(),
                                      tr("Anatomy, scenes and recordings (%1);;All files (*)").arg(endings)));
    if (!files.empty()) {
        open(files);
    }
}

void SceneFiles::chooseAdded()
{
    const auto files = chosenFiles(QFileDialog::getOpenFileNames(&m_core.window, tr("Add to the scene"), lastFolder()));
    if (!files.empty()) {
        add(files);
    }
}

} // namespace palpate::app

#include "moc_SceneFiles.cpp"
