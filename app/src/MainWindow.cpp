// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/ui/Theme.h>

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QProgressBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdlib>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

namespace {

std::filesystem::path toPath(const QString& text)
{
    return std::filesystem::path(text.toStdU16String());
}

QString toText(const std::filesystem::path& path)
{
    return QString::fromStdU16String(path.u16string());
}

/// A new file "2026-11-21 05.12.33" in the user's folder of that kind.
std::filesystem::path newFile(QStandardPaths::StandardLocation kind, const QString& ending)
{
    const QString folder = QStandardPaths::writableLocation(kind) + QStringLiteral("/Palpate");
    QDir().mkpath(folder);
    return toPath(folder + QLatin1Char('/') +
                  QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd hh.mm.ss")) + ending);
}

} // namespace

std::optional<std::filesystem::path> phantomFolder()
{
    std::vector<std::filesystem::path> candidates;
    if (const char* named = std::getenv("PALPATE_DATA_DIR")) {
        candidates.emplace_back(std::filesystem::path(named) / "phantom");
    }
    const std::filesystem::path program = toPath(QCoreApplication::applicationDirPath());
    candidates.push_back(program / "../share/palpate/phantom");
    // In a build tree: the source's data folder is a few folders up.
    for (std::filesystem::path up = program; up.has_relative_path(); up = up.parent_path()) {
        candidates.push_back(up / "data/phantom");
    }
    for (const std::filesystem::path& folder : candidates) {
        std::error_code error;
        if (std::filesystem::exists(folder / "phantom.palpate.json", error)) {
            return std::filesystem::weakly_canonical(folder, error);
        }
    }
    return std::nullopt;
}

MainWindow::MainWindow()
{
    setWindowTitle(tr("Palpate"));
    setAcceptDrops(true);
    setDockNestingEnabled(false);

    m_viewport = new VtkViewport(this);
    m_welcome = new WelcomePage(this);
    m_stack = new QStackedWidget(this);
    m_stack->addWidget(m_welcome);
    m_stack->addWidget(m_viewport);
    m_message = new MessageBar(this);
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_message);
    layout->addWidget(m_stack, 1);
    setCentralWidget(centre);

    makeActions();
    makeDocks();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    m_palpation = new PalpationController(*m_viewport, m_live, m_model, this);
    m_handControl = new HandControl(*m_viewport, m_live, m_model, *m_structures, *m_hand, this);
    m_playback = new Playback(*m_viewport, *m_session, *m_touch, this);
    m_devices = new DeviceChoice(m_live, *m_viewport, *m_playback, this);
    m_keys = new KeysCard(this);
    connectParts();
    styleView();
    refreshRecent();
    showStatus();
    showWhatPlays();

    resize(1280, 800);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
}

MainWindow::~MainWindow()
{
    delete m_devices; // it lets go of what the members below the children hold
}

QAction* MainWindow::makeAction(const QString& text, Symbol symbol, const QKeySequence& key, const QString& tip)
{
    auto* action = new QAction(icon(symbol), text, this);
    action->setShortcut(key);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
    addAction(action); // the key works with menus hidden too
    return action;
}

void MainWindow::makeActions()
{
    m_openAction = makeAction(tr("Open…"), Symbol::Open, QKeySequence::Open, tr("Open meshes, a scene or a recording"));
    m_saveAction =
        makeAction(tr("Save scene as…"), Symbol::Open, QKeySequence::Save, tr("Save the scene with its tissue"));
    m_palpateAction = makeAction(
        tr("Palpate"), Symbol::Hand, QKeySequence(Qt::Key_P),
        tr("Palpate with the pointer: drag to press, wheel for the depth; off: the pointer moves the camera"));
    m_palpateAction->setCheckable(true);
    m_recordAction =
        makeAction(tr("Record"), Symbol::Record, QKeySequence(Qt::Key_R), tr("Record what the hand feels, every tick"));
    m_recordAction->setCheckable(true);
    m_playAction = makeAction(tr("Play"), Symbol::Play, QKeySequence(Qt::Key_K), tr("Play or pause the recording"));
    m_restartAction = makeAction(tr("To the start"), Symbol::Restart, QKeySequence(Qt::Key_Home),
                                 tr("Back to the recording's start"));
    m_snapshotAction =
        makeAction(tr("Snapshot"), Symbol::Snapshot, QKeySequence(Qt::Key_S), tr("Save a picture of the view"));
    m_fitAction = makeAction(tr("Fit"), Symbol::Fit, QKeySequence(Qt::Key_F), tr("Fit everything into the view"));
    m_undoAction =
        makeAction(tr("Undo"), Symbol::Undo, QKeySequence::Undo, tr("Undo the newest change of a structure"));
    m_redoAction = makeAction(tr("Redo"), Symbol::Redo, QKeySequence::Redo, tr("Do it again"));
    m_keysAction = makeAction(tr("All keys"), Symbol::Keys, QKeySequence(QStringLiteral("?")), tr("Show all keys"));
    // Both layouts of "?" and the way back: whatever the keyboard, one of them is there.
    m_keysAction->setShortcuts(
        {QKeySequence(QStringLiteral("?")), QKeySequence(Qt::SHIFT | Qt::Key_Question), QKeySequence(Qt::Key_F1)});
    m_clutchAction = makeAction(tr("Clutch"), Symbol::Hand, QKeySequence(Qt::Key_C),
                                tr("Move the device without the hand in the scene; again to let go"));
    m_clutchAction->setCheckable(true);
    auto* letGo = new QAction(this);
    letGo->setShortcut(Qt::Key_Escape);
    addAction(letGo);
    connect(letGo, &QAction::triggered, this, &MainWindow::letGo);
}

void MainWindow::makeDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    const auto dock = [this](const QString& title, const char* name, QWidget* panel, Qt::DockWidgetArea area) {
        auto* one = new QDockWidget(title, this);
        one->setObjectName(QLatin1String(name));
        one->setWidget(panel);
        addDockWidget(area, one);
        m_docks.push_back(one);
        return one;
    };
    m_structures = new StructurePanel(m_model, this);
    m_structures->setGreatest(m_live.greatestTissue());
    m_touch = new TouchPanel(this);
    m_touch->setForceLimit(m_live.deviceInfo().maxForce_N);
    m_session = new SessionPanel(this);
    for (QAction* action : {m_recordAction, m_restartAction, m_playAction}) {
        m_session->addAction(action);
    }
    auto* left = dock(tr("Structures"), "structures", m_structures, Qt::LeftDockWidgetArea);
    auto* right = dock(tr("Touch"), "touch", m_touch, Qt::RightDockWidgetArea);
    m_hand = new HandPanel(this);
    dock(tr("Device"), "device", m_hand, Qt::RightDockWidgetArea);
    auto* below = dock(tr("Session"), "session", m_session, Qt::BottomDockWidgetArea);
    resizeDocks({left, right}, {264, 292}, Qt::Horizontal);
    resizeDocks({below}, {128}, Qt::Vertical);
}

void MainWindow::makeStatusBar()
{
    m_hint = new QLabel(this);
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setMinimumWidth(10);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(180);
    m_progress->setAccessibleName(tr("Progress of opening"));
    m_cancel = new QToolButton(this);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Stop opening; what was open stays"));
    m_progress->hide();
    m_cancel->hide();
    auto* notice = new QLabel(tr("Research, training and planning rehearsal. Not a medical device."), this);
    notice->setContentsMargins(8, 2, 10, 2);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(8, 0, 0, 0);
    statusBar()->addWidget(m_hint, 1);
    statusBar()->addWidget(m_progress);
    statusBar()->addWidget(m_cancel);
    statusBar()->addPermanentWidget(notice);
}

void MainWindow::connectParts()
{
    connect(m_openAction, &QAction::triggered, this, &MainWindow::chooseFiles);
    connect(m_saveAction, &QAction::triggered, this, &MainWindow::saveScene);
    connect(m_palpateAction, &QAction::toggled, this, &MainWindow::setPalpating);
    connect(m_recordAction, &QAction::triggered, this, &MainWindow::toggleRecording);
    connect(m_playAction, &QAction::triggered, this, &MainWindow::togglePlaying);
    connect(m_restartAction, &QAction::triggered, m_playback, &Playback::toStart);
    connect(m_snapshotAction, &QAction::triggered, this, &MainWindow::saveSnapshot);
    connect(m_fitAction, &QAction::triggered, this, [this] {
        m_viewport->view().fitAll();
        m_viewport->update();
    });
    connect(m_keysAction, &QAction::triggered, m_keys, &KeysCard::toggle);
    connect(m_undoAction, &QAction::triggered, &m_model.undoStack(), &QUndoStack::undo);
    connect(m_redoAction, &QAction::triggered, &m_model.undoStack(), &QUndoStack::redo);
    connect(&m_model.undoStack(), &QUndoStack::canUndoChanged, m_undoAction, &QAction::setEnabled);
    connect(&m_model.undoStack(), &QUndoStack::canRedoChanged, m_redoAction, &QAction::setEnabled);
    connect(m_cancel, &QToolButton::clicked, &m_loader, &SceneLoader::cancel);

    connect(m_welcome, &WelcomePage::openWanted, this, &MainWindow::chooseFiles);
    connect(m_welcome, &WelcomePage::recentWanted, this, [this](const QString& path) { open({toPath(path)}); });
    connect(m_welcome, &WelcomePage::phantomWanted, this, [this] {
        if (const auto folder = phantomFolder()) {
            open({*folder / "phantom.palpate.json", *folder / "palpation.palpate"});
        }
    });

    connect(&m_loader, &SceneLoader::progressed, this, [this](const QString& what, double share) {
        m_hint->setText(what);
        m_progress->setValue(static_cast<int>(share * 1000.0));
        m_progress->show();
        m_cancel->show();
    });
    const auto loadingEnded = [this] {
        m_progress->hide();
        m_cancel->hide();
        m_hint->clear();
    };
    connect(&m_loader, &SceneLoader::opened, this, loadingEnded);
    connect(&m_loader, &SceneLoader::opened, this, &MainWindow::takeScene);
    connect(&m_loader, &SceneLoader::failed, this, [this, loadingEnded](const QString& line) {
        loadingEnded();
        m_waitingRecording.reset();
        showError(line);
        emit openFailed(line);
    });
    connect(&m_loader, &SceneLoader::cancelled, this, [this, loadingEnded] {
        loadingEnded();
        m_waitingRecording.reset();
        say(tr("Opening was cancelled."));
    });
    connect(&m_loader, &SceneLoader::touchBuilt, this,
            [this](int row, const std::shared_ptr<const geometry::SurfaceIndex>& touch, const QString& sha256) {
                m_model.setTouch(row, touch, sha256.toStdString());
            });
    connect(&m_model, &StructureModel::edited, this, &MainWindow::followModel);

    connect(m_palpation, &PalpationController::touched, this, [this](const TouchReading& reading) {
        m_touch->show(reading);
        const session::RecorderStatus recording = m_live.recording();
        if (recording.isRecording) {
            m_session->timeline().addLive(recording.duration_s, reading.force_N);
        }
    });
    connect(m_palpation, &PalpationController::handGone, m_touch, &TouchPanel::showNoHand);
    connect(m_palpation, &PalpationController::depthChanged, this, &MainWindow::showStatus);
    connect(m_viewport, &VtkViewport::spaceHeld, this, [this](bool isDown) { m_palpateAction->setChecked(isDown); });
    connect(m_viewport, &VtkViewport::panelsToggled, this, &MainWindow::togglePanels);
    connect(m_viewport, &VtkViewport::centreWanted, this, [this](const QPointF& place) {
        if (const auto pick = m_viewport->view().pick(m_viewport->rayAt(place))) {
            m_viewport->view().centreOn(pick->hit.p_W);
            m_viewport->update();
        }
    });
    connect(m_playback, &Playback::stateChanged, this, &MainWindow::showWhatPlays);
    connect(&m_live, &LiveTouch::statusChanged, this, &MainWindow::showStatus);
    connect(&m_live, &LiveTouch::faulted, this, &MainWindow::tellFault);
    connect(&m_live, &LiveTouch::greatestChanged, this, [this] { m_structures->setGreatest(m_live.greatestTissue()); });
    connect(&m_live, &LiveTouch::stiffnessRefused, this, [this](const QString& line) { say(line, 20000); });
    connect(m_clutchAction, &QAction::toggled, m_handControl, &HandControl::setClutched);
    connect(&m_live, &LiveTouch::deviceChanged, m_handControl, &HandControl::takeDevice);
}

void MainWindow::styleView()
{
    if (isDarkTheme()) {
        m_viewport->view().setBackground({0.07, 0.085, 0.10}, {0.20, 0.235, 0.27}, {0.93, 0.95, 0.97});
    } else {
        m_viewport->view().setBackground({0.33, 0.38, 0.44}, {0.60, 0.66, 0.72}, {1.0, 1.0, 1.0});
    }
}

void MainWindow::open(const std::vector<std::filesystem::path>& files, double unit_mm)
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
        // A recording alone: what it was made on is opened with it, as far as it is still there.
        const auto reader = session::RecordingReader::open(*recording);
        if (reader.isOk() && !reader.value()->scenes().empty()) {
            for (const session::StructureRecord& one : reader.value()->scenes().front().structures) {
                const std::filesystem::path mesh = one.source.mesh;
                std::error_code error;
                if (std::find(meshes.begin(), meshes.end(), mesh) == meshes.end() &&
                    std::filesystem::exists(mesh, error)) {
                    meshes.push_back(mesh);
                    unit_mm = one.source.unit_mm;
                }
            }
        }
    }
    m_message->hide();
    if (meshes.empty()) {
        if (recording) {
            openRecording(*recording);
        }
        return;
    }
    m_waitingRecording = recording;
    m_unit_mm = unit_mm;
    m_loader.open(meshes, unit_mm);
}

void MainWindow::offerMetres()
{
    // No organ is this small; reference libraries write metres into files that cannot say so.
    constexpr double kSmallest_mm = 3.0;
    const double size_mm = m_viewport->view().bounds().diagonal().norm();
    if (m_unit_mm != 1.0 || size_mm >= kSmallest_mm || meshio::isSceneFile(m_files.front())) {
        return;
    }
    m_message->offer(
        tr("This anatomy is %1 mm across: its numbers are probably metres.").arg(QLocale().toString(size_mm, 'g', 2)),
        tr("Read as metres"), [this] { open(m_files, 1000.0); });
}

void MainWindow::takeScene(const std::shared_ptr<OpenedScene>& scene)
{
    m_playback->setRecording(nullptr);
    m_files = scene->files;
    std::vector<scene::ViewStructure> pictures;
    pictures.reserve(scene->rows.size());
    for (const StructureRow& row : scene->rows) {
        pictures.push_back({scene::StructureActor(row.picture, StructureModel::appearanceOf(row.loaded.description)),
                            row.loaded.description.palpable ? row.touch : nullptr});
    }
    scene::SceneView& view = m_viewport->view();
    view.setStructures(std::move(pictures));
    m_model.setRows(std::move(scene->rows));
    m_stack->setCurrentWidget(m_viewport);
    if (scene->scene.camera) {
        const meshio::SceneCamera& from = *scene->scene.camera;
        view.camera().SetPosition(from.position_W.x(), from.position_W.y(), from.position_W.z());
        view.camera().SetFocalPoint(from.focus_W.x(), from.focus_W.y(), from.focus_W.z());
        view.camera().SetViewUp(from.up_W.x(), from.up_W.y(), from.up_W.z());
        view.camera().SetViewAngle(from.viewAngle_deg);
    } else {
        view.look(scene::ViewFrom::Oblique);
    }
    m_palpation->setSceneSize(view.bounds().diagonal().norm());
    const core::Status started = m_live.start();
    if (!started.isOk()) {
        showError(QString::fromStdString(started.message()));
    }
    m_structures->select(0);
    m_viewport->setFocus();
    m_viewport->update();
    const QString name = toText(m_files.front().filename());
    setWindowTitle(tr("%1 – Palpate").arg(name));
    if (m_files.size() == 1) { // the parts of a scene opened one by one are no scene to come back to
        remember(m_files.front());
    }
    const QString how = tr("P palpate, drag to press, wheel for depth");
    const auto notes = static_cast<int>(scene->warnings.size());
    const QString told = notes == 1 ? tr("1 note on these files") : tr("%1 notes on these files").arg(notes);
    say(notes == 0 ? how : tr("%1  ·  %2 (point here to read)").arg(how, told), 60000);
    constexpr int kToolTipLines = 24;
    QStringList lines = scene->warnings.mid(0, kToolTipLines);
    if (notes > kToolTipLines) {
        lines << tr("… and %1 more").arg(notes - kToolTipLines);
    }
    m_hint->setToolTip(notes == 0 ? how : lines.join(QLatin1Char('\n')));
    showWhatPlays();
    if (!scene->problems.isEmpty()) {
        showError(scene->problems.join(QLatin1Char('\n')));
    }
    offerMetres();
    if (m_waitingRecording) {
        openRecording(*std::exchange(m_waitingRecording, std::nullopt));
    }
    emit ready();
}

void MainWindow::openRecording(const std::filesystem::path& path)
{
    auto recording = RecordedTouch::open(path);
    if (!recording.isOk()) {
        showError(QString::fromStdString(recording.status().message()));
        emit openFailed(QString::fromStdString(recording.status().message()));
        return;
    }
    const QString losses = recording.value()->losses();
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
        emit ready();
    }
}

void MainWindow::followModel(int row, StructureModel::Change change)
{
    const StructureRow& one = m_model.rows()[static_cast<std::size_t>(row)];
    const meshio::SceneStructure& structure = one.loaded.description;
    if (change == StructureModel::Change::Look) {
        m_viewport->view().setAppearance(static_cast<std::size_t>(row), StructureModel::appearanceOf(structure));
    }
    // A structure has its haptic copy while it is palpable, and only then.
    if (structure.palpable && one.touch == nullptr) {
        m_loader.buildTouch(row, one.loaded.surface);
    } else if (!structure.palpable && one.touch != nullptr) {
        m_model.setTouch(row, nullptr, {});
        return; // it comes back here
    }
    m_viewport->view().setTouchable(static_cast<std::size_t>(row), structure.palpable ? one.touch : nullptr);
    m_viewport->update();
}

void MainWindow::setPalpating(bool isPalpating)
{
    m_palpateAction->setChecked(isPalpating);
    if (isPalpating) {
        m_playback->pause();
        m_viewport->setFocus();
    }
    m_palpation->setPalpating(isPalpating);
    showStatus();
}

void MainWindow::letGo()
{
    if (m_keys->isVisible()) {
        m_keys->hide();
    } else if (!m_palpation->letGo()) {
        m_palpateAction->setChecked(false);
    }
}

void MainWindow::toggleRecording()
{
    if (m_live.recording().isRecording) {
        const core::Status stopped = m_live.stopRecording();
        if (!stopped.isOk()) {
            showError(QString::fromStdString(stopped.message()));
        }
        m_recordAction->setChecked(false);
        const bool wasPalpating = m_palpation->isPalpating();
        openRecording(m_recordingPath);
        setPalpating(wasPalpating);
        say(tr("Recorded to %1").arg(toText(m_recordingPath)), 20000);
    } else {
        m_playback->setRecording(nullptr);
        m_recordingPath = newFile(QStandardPaths::DocumentsLocation, QStringLiteral(".palpate"));
        const core::Status started = m_live.startRecording(m_recordingPath);
        m_recordAction->setChecked(started.isOk());
        if (!started.isOk()) {
            showError(QString::fromStdString(started.message()));
        } else {
            m_touch->clearHistory();
            m_session->showTitle(tr("Recording %1").arg(toText(m_recordingPath.filename())));
            setPalpating(true);
        }
    }
    showStatus();
    showWhatPlays();
}

void MainWindow::togglePlaying()
{
    if (m_playback->isPlaying()) {
        m_playback->pause();
    } else {
        m_palpateAction->setChecked(false);
        m_playback->play();
    }
}

void MainWindow::saveSnapshot()
{
    const std::filesystem::path file = newFile(QStandardPaths::PicturesLocation, QStringLiteral(".png"));
    m_viewport->refineNext();
    if (m_viewport->grabFramebuffer().save(toText(file))) {
        say(tr("Picture saved to %1").arg(toText(file)), 15000);
    } else {
        showError(tr("%1: the picture could not be written. Is the folder writable and the disk not full?")
                      .arg(toText(file)));
    }
}

void MainWindow::saveScene()
{
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Save scene"), {}, tr("Palpate scene (*.palpate.json)"));
    if (chosen.isEmpty()) {
        return;
    }
    meshio::SceneFile scene;
    for (const StructureRow& row : m_model.rows()) {
        scene.structures.push_back(row.loaded.description);
    }
    vtkCamera& camera = m_viewport->view().camera();
    scene.camera = meshio::SceneCamera{core::Vec3(camera.GetPosition()), core::Vec3(camera.GetFocalPoint()),
                                       core::Vec3(camera.GetViewUp()), camera.GetViewAngle()};
    const std::filesystem::path path =
        toPath(chosen.endsWith(QLatin1String(".json")) ? chosen : chosen + QStringLiteral(".palpate.json"));
    const core::Status saved = meshio::writeScene(path, scene);
    if (saved.isOk()) {
        remember(path);
        say(tr("Scene saved to %1").arg(toText(path)));
    } else {
        showError(QString::fromStdString(saved.message()));
    }
}

void MainWindow::chooseFiles()
{
    const QStringList chosen = QFileDialog::getOpenFileNames(
        this, tr("Open anatomy"), QSettings().value(QStringLiteral("folder")).toString(),
        tr("Anatomy, scenes and recordings (*.stl *.vtp *.obj *.ply *.json *.palpate);;All files (*)"));
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
        open(files);
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState());
    m_live.stop();
    event->accept();
}
