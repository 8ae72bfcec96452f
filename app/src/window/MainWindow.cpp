// SPDX-License-Identifier: BSD-3-Clause
#include "window/MainWindow.h"
#include "shared/Paths.h"
#include "shared/ProgramFolders.h"

#include <palpate/study/RecordedScene.h>
#include <palpate/ui/PanelScroll.h>
#include <palpate/ui/PointedStructure.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/Tour.h>
#include <palpate/ui/ViewKeys.h>

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

MainWindow::MainWindow()
{
    setWindowTitle(tr("Palpate[*]"));
    setAcceptDrops(true);
    setDockNestingEnabled(false);

    m_viewport = new VtkViewport(this);
    m_welcome = new WelcomePage(this);
    m_stack = new QStackedWidget(this);
    m_stack->addWidget(new PanelScroll(m_welcome, this));
    m_stack->addWidget(m_viewport);
    m_message = new MessageBar(m_messages, this);
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_message);
    layout->addWidget(new FocusFrame(m_stack, m_viewport, centre), 1);
    setCentralWidget(centre);

    m_document = new SceneDocument(m_model, this);
    connect(m_document, &SceneDocument::copyFailed, this, &MainWindow::showError);
    makeActions();
    makeDocks();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    m_recording = new RecordingControl(m_live, *m_recordingChip, *m_session, this);
    makeMessagesDock();
    makeEngineeringDock();
    makeFelt();
    m_palpation = new PalpationController(*m_viewport, m_live, m_model, this);
    m_handControl = new HandControl(*m_viewport, m_live, m_model, *m_structures, *m_hand, this);
    m_playback = new Playback(*m_viewport, m_model, *m_session, *m_touch, this);
    m_devices = new DeviceChoice(m_live, *m_viewport, *m_playback, this);
    m_keys = new KeysCard(m_actions, this);
    m_findingsDesk = new FindingsDesk({*m_document, *m_findings, *m_viewport, m_live, *m_playback, *m_touch}, this);
    m_loader.setReader([](const auto& path, const auto& options) { return study::openScene(path, options); });
    connectActions();
    connectLoading();
    connectTouch();
    connectFindings();
    connectList();
    refreshRecent();
    showStatus();
    showWhatPlays();
    QTimer::singleShot(0, this, &MainWindow::offerLeftover);

    finishShell();
    fitDocks(withText_px(264), withText_px(292), withText_px(128));
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
}

MainWindow::~MainWindow()
{
    // First, because this destructor releases members that are destroyed before the child widgets, and notifies panels.
    delete m_devices;
    delete m_structures;                        // before the model, which receives the text of an open name editor
    delete m_feltDock->findChild<FeltPanel*>(); // same for an open number editor
    // Closing the window hides its docks, at a time when the model is already gone.
    m_feltDock->toggleViewAction()->disconnect(m_felt);
}

void MainWindow::makeDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    const auto dock = [this](const QString& title, const char* name, QWidget* panel, Qt::DockWidgetArea area) {
        auto* one = new QDockWidget(title, this);
        one->setObjectName(QLatin1String(name));
        one->setWidget(new PanelScroll(panel, this)); // a low window has no room for the whole panel
        addDockWidget(area, one);
        m_docks.push_back(one);
        return one;
    };
    m_structures = new StructurePanel(m_model, this);
    m_structures->setGreatest(m_live.maxTissue(), m_live.limitText());
    m_maps = new MapDisplay(*m_viewport, m_model, this);
    m_maps->setGreatest(m_live.maxTissue());
    m_touch = new TouchPanel(this);
    m_touch->setForceLimit(m_live.deviceInfo().maxForce_N);
    m_session = new SessionPanel(this);
    for (QAction* action : {m_recordAction, m_restartAction, m_playAction}) {
        m_session->addAction(action);
    }
    auto* left = dock(tr("Structures"), "structures", m_structures, Qt::LeftDockWidgetArea);
    auto* right = dock(tr("Touch"), "touch", m_touch, Qt::RightDockWidgetArea);
    m_hand = new HandPanel(this);
    m_findings = new FindingsPanel(m_document->findingsModel(), this);
    auto* findings = dock(tr("Findings and measures"), "findings", m_findings, Qt::RightDockWidgetArea);
    tabifyDockWidget(right, findings);
    tabifyDockWidget(findings, dock(tr("Device"), "device", m_hand, Qt::RightDockWidgetArea));
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    right->raise();
    auto* below = dock(tr("Session"), "session", m_session, Qt::BottomDockWidgetArea);
    connect(&m_looks, &Looks::textSizeChanged, this, [this, left, right, below](double ratio) {
        fitDocks(ratio * left->width(), ratio * right->width(), ratio * below->height());
    });
}

/// Sets the panel sizes but leaves the larger part of the window to the view. [px]
void MainWindow::fitDocks(double left_px, double right_px, double below_px)
{
    constexpr double kMostLeft = 0.22, kMostRight = 0.27, kMostBelow = 0.22; // fractions of the window
    const auto dock = [this](const char* name) { return findChild<QDockWidget*>(QLatin1String(name)); };
    resizeDocks({dock("structures"), dock("touch")},
                {qRound(std::min(left_px, kMostLeft * width())), qRound(std::min(right_px, kMostRight * width()))},
                Qt::Horizontal);
    resizeDocks({dock("session")}, {qRound(std::min(below_px, kMostBelow * height()))}, Qt::Vertical);
}

void MainWindow::makeStatusBar()
{
    m_hint = new HintLine(this);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(180);
    m_progress->setAccessibleName(tr("Progress of opening"));
    m_cancel = new QToolButton(this);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Stop reading; what was open stays"));
    m_progress->hide();
    m_cancel->hide();
    auto* notice = new QLabel(tr("Research, training and planning rehearsal. Not a medical device."), this);
    notice->setContentsMargins(8, 2, 10, 2);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(8, 0, 0, 0);
    statusBar()->addWidget(m_hint, 1);
    statusBar()->addWidget(m_progress);
    statusBar()->addWidget(m_cancel);
    statusBar()->addPermanentWidget(&m_coordinates->button());
    statusBar()->addPermanentWidget(notice);
}

void MainWindow::connectActions()
{
    connect(m_openAction, &QAction::triggered, this, &MainWindow::chooseFiles);
    connect(m_saveAction, &QAction::triggered, this, &MainWindow::saveScene);
    connect(m_saveAsAction, &QAction::triggered, this, &MainWindow::saveSceneAs);
    connect(m_measuresAction, &QAction::triggered, this, &MainWindow::showMeasures);
    connect(m_embedAction, &QAction::toggled, this,
            [](bool isOn) { QSettings().setValue(QStringLiteral("session/embed"), isOn); });
    connect(&m_model.undoStack(), &QUndoStack::cleanChanged, this,
            [this](bool isClean) { setWindowModified(!isClean); });
    connect(&m_model.undoStack(), &QUndoStack::undoTextChanged, this, [this](const QString& text) {
        m_undoAction->setText(text.isEmpty() ? tr("Undo") : tr("Undo: %1").arg(text));
    });
    connect(&m_model.undoStack(), &QUndoStack::redoTextChanged, this, [this](const QString& text) {
        m_redoAction->setText(text.isEmpty() ? tr("Redo") : tr("Redo: %1").arg(text));
    });
    connect(m_palpateAction, &QAction::toggled, this, &MainWindow::setPalpating);
    connect(m_recordAction, &QAction::triggered, this, &MainWindow::toggleRecording);
    connect(m_recording, &RecordingControl::writeProblem, this, &MainWindow::showError);
    connect(m_recording, &RecordingControl::failed, this, [this](const QString& line) {
        m_recordAction->setChecked(false);
        showWhatPlays();
        m_message->offer(line, tr("Open what was recorded"), [this] { openRecording(m_recording->path()); });
    });
    for (QAction* action : m_actions.all()) {
        connect(action, &QAction::triggered, m_recording, &RecordingControl::acknowledge);
    }
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
}

void MainWindow::connectLoading()
{
    connect(m_cancel, &QToolButton::clicked, &m_loader, &SceneLoader::cancel);
    connect(m_welcome, &WelcomePage::openWanted, this, &MainWindow::chooseFiles);
    connect(m_welcome, &WelcomePage::recentWanted, this, [this](const QString& path) { open({toPath(path)}); });
    connect(m_welcome, &WelcomePage::phantomWanted, this, [this] {
        if (const auto folder = app::phantomFolder()) {
            open({*folder / "phantom.palpate.json", *folder / "palpation.palpate"});
        } else {
            showError(tr("The phantom was not found beside the program."));
            m_around->giveUp();
        }
    });

    connect(&m_loader, &SceneLoader::progressed, this, [this](const QString& what, double share) {
        m_hint->setText(what);
        m_progress->setRange(0, 1000);
        m_progress->setValue(static_cast<int>(share * 1000.0));
        m_progress->show();
        m_cancel->show();
    });
    const auto loadingEnded = [this] {
        m_progress->hide();
        m_cancel->hide();
        m_hint->say({});
    };
    connect(&m_loader, &SceneLoader::opened, this, loadingEnded);
    connect(&m_loader, &SceneLoader::opened, this, [this](const std::shared_ptr<OpenedScene>& scene) {
        if (scene->addedTo > 0) {
            takeAdded(*scene);
        } else {
            takeScene(scene);
        }
    });
    connect(&m_loader, &SceneLoader::failed, this, [this, loadingEnded](const QString& line) {
        loadingEnded();
        showError(line);
        const auto recording = std::exchange(m_waitingRecording, std::nullopt);
        if (recording && m_model.rowCount() == 0) {
            openRecording(*recording); // playback works without the scene of the recording
        } else {
            Q_EMIT openFailed(line);
        }
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
    connect(&m_model, &StructureModel::mapsWanted, this, [this](int row) {
        say(tr("Reading what varies over %1…").arg(readableName(m_model.structure(row).name)), 60000);
        m_progress->setRange(0, 0); // duration unknown
        m_progress->show();
        m_cancel->show();
        m_loader.buildMaps(row, m_model.rows()[static_cast<std::size_t>(row)].loaded);
    });
    connect(&m_loader, &SceneLoader::mapsBuilt, this,
            [this](int row, const std::shared_ptr<meshio::LoadedStructure>& found, const QStringList& problems) {
                const bool isReading = m_loader.isBusy() || m_loader.isBuildingMaps();
                m_progress->setVisible(isReading);
                m_cancel->setVisible(isReading);
                m_model.setMaps(row, found->description.maps, found->maps, problems);
                say(problems.isEmpty() ? tr("The map of %1 is felt.").arg(readableName(found->description.name))
                                       : problems.join(QLatin1Char(' ')));
            });
    connectSurfaces();
    connect(m_structures, &StructurePanel::colourChosen, m_maps, &MapDisplay::show);
    connect(m_coordinates, &CoordinatesChoice::chosen, this, &MainWindow::readAs);
    connect(&m_model.undoStack(), &QUndoStack::indexChanged, this, [this] { m_isEditedSinceReload = true; });
    connect(&m_model, &QAbstractItemModel::modelReset, this, &MainWindow::showCoordinates);
    connect(&m_model, &QAbstractItemModel::rowsInserted, this, &MainWindow::showCoordinates);
    connect(&m_model, &QAbstractItemModel::rowsRemoved, this, &MainWindow::showCoordinates);
}

void MainWindow::connectTouch()
{
    connect(m_palpation, &PalpationController::touched, this, [this](const TouchReading& reading) {
        m_touch->show(reading);
        m_structures->showTouch(reading);
        const session::RecorderStatus recording = m_live.recording();
        if (recording.isRecording) {
            m_session->timeline().addLive(recording.duration_s, reading.force_N);
        }
    });
    connect(m_palpation, &PalpationController::handGone, m_touch, &TouchPanel::showNoHand);
    m_sound->follow(*m_touch);
    connect(m_palpation, &PalpationController::handGone, m_playback,
            &Playback::showAgain); // back to the recording, if one is open
    connect(m_palpation, &PalpationController::textChanged, this, &MainWindow::showMode);
    connect(m_palpation, &PalpationController::palpationWanted, this, [this] { setPalpating(true); });
    connect(m_palpation, &PalpationController::said, this, [this](const QString& line) { say(line); });
    new ViewKeys(*m_viewport, *m_palpation, this);
    auto* pointed = new PointedStructure(*m_viewport, m_model, *m_maps, this);
    pointed->setMore([this](const PointedStructure::Place& place) { return m_felt->textAt(place.row, place.p_W); });
    connect(pointed, &PointedStructure::clicked, this, [this](int row, Qt::KeyboardModifiers modifiers) {
        m_structures->choose(row >= 0 ? std::optional(static_cast<std::size_t>(row)) : std::nullopt,
                             modifiers.testFlag(Qt::ControlModifier));
    });
    connect(m_viewport, &VtkViewport::spaceHeld, this, [this](bool isDown) { m_palpateAction->setChecked(isDown); });
    connect(m_viewport, &VtkViewport::centreWanted, this, [this](const QPointF& place) {
        if (const auto pick = m_viewport->view().pick(m_viewport->rayAt(place))) {
            m_viewport->view().centreOn(pick->hit.p_W);
            m_viewport->update();
        }
    });
    connect(m_playback, &Playback::stateChanged, this, &MainWindow::showWhatPlays);
    connect(m_playback, &Playback::stateChanged, m_findingsDesk, &FindingsDesk::show);
    connect(&m_live, &LiveTouch::statusChanged, this, &MainWindow::showStatus);
    connect(&m_live, &LiveTouch::faulted, this, &MainWindow::tellFault);
    connect(&m_live, &LiveTouch::greatestChanged, this, [this] {
        m_structures->setGreatest(m_live.maxTissue(), m_live.limitText());
        m_maps->setGreatest(m_live.maxTissue());
    });
    connect(&m_live, &LiveTouch::stiffnessRefused, this, [this](const QString& line) { say(line, 20000); });
    auto* mapWarnings = new MapWarnings(m_live, this);
    connect(mapWarnings, &MapWarnings::changed, this,
            [this, mapWarnings] { m_structures->setMapWarnings(mapWarnings->lines()); });
    connect(mapWarnings, &MapWarnings::warned, this, [this](const QString& line) {
        m_messages.add(Messages::Kind::Warning, line);
        m_hint->say(line);
    });
    const auto takePress = [this](const HandSettings& settings) {
        m_effortAction->setEnabled(m_live.usesPointer());
        if (m_live.usesPointer()) {
            m_palpation->setPress(settings);
            m_effortAction->setChecked(settings.isByEffort);
        }
    };
    connect(m_handControl, &HandControl::settingsTaken, this, takePress);
    takePress(m_hand->settings());
    connect(m_effortAction, &QAction::toggled, this, [this](bool isByEffort) {
        m_handControl->setByEffort(isByEffort);
        if (m_model.rowCount() > 0) {
            say(howToTouch(), 60000); // the hint about the wheel is no longer valid
        }
    });
    connect(m_palpation, &PalpationController::effortTurned, m_handControl, &HandControl::setEffort);
    connect(m_clutchAction, &QAction::toggled, m_handControl, &HandControl::setClutched);
    connect(m_fitSceneAction, &QAction::triggered, this, [this] { m_handControl->fit(MapFill::Scene); });
    connect(m_fitOrganAction, &QAction::triggered, this, [this] { m_handControl->fit(MapFill::Organ); });
    connect(m_fitLumpAction, &QAction::triggered, this, [this] { m_handControl->fit(MapFill::Lump); });
    connect(m_handControl, &HandControl::said, this, [this](const QString& line) { say(line); });
    connect(&m_live, &LiveTouch::deviceChanged, m_handControl, &HandControl::takeDevice);
    connect(m_engineering, &EngineeringPanel::loopChosen, m_handControl, &HandControl::chooseLoop);
    connect(m_engineering, &EngineeringPanel::loopChosen, this, &MainWindow::showStatus);
}

void MainWindow::followModel(int row, StructureModel::Change change)
{
    const StructureRow& one = m_model.rows()[static_cast<std::size_t>(row)];
    const meshio::SceneStructure& structure = one.loaded.description;
    if (change == StructureModel::Change::Look) {
        m_viewport->view().setAppearance(static_cast<std::size_t>(row), m_model.appearanceOf(row));
    }
    if (one.isRemoved) { // data is kept for undo
        m_viewport->view().setTouchable(static_cast<std::size_t>(row), nullptr);
        m_viewport->update();
        return;
    }
    // Only palpable structures have a haptic surface.
    if (structure.palpable && one.touch == nullptr) {
        m_loader.buildTouch(row, one.loaded.surface);
    } else if (!structure.palpable && one.touch != nullptr) {
        m_model.setTouch(row, nullptr, {});
        return; // setTouch calls this function again
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
    showWhatPlays(); // updates the displayed force limit
}

void MainWindow::letGo()
{
    if (m_keys->isVisible()) {
        m_keys->hide();
    } else if (!m_around->tour().end() && !m_palpation->letGo()) {
        m_palpateAction->setChecked(false);
    }
}

#include "moc_MainWindow.cpp"
