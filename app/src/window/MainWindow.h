// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/CoordinatesChoice.h"
#include "scene/SceneDocument.h"
#include "shell/ShowAround.h"
#include "shell/SoundChoice.h"
#include "touch/FindingsDesk.h"
#include "touch/RecordingControl.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/DeviceChoice.h>
#include <palpate/ui/EngineeringPanel.h>
#include <palpate/ui/FeltOverlay.h>
#include <palpate/ui/FeltPanel.h>
#include <palpate/ui/HandControl.h>
#include <palpate/ui/HandPanel.h>
#include <palpate/ui/HintLine.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Looks.h>
#include <palpate/ui/MapDisplay.h>
#include <palpate/ui/MapWarnings.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/PanelRound.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QMainWindow>

#include <filesystem>
#include <optional>
#include <vector>

class QMenu;
class QProgressBar;
class QStackedWidget;
class QToolButton;

class LumpLayout;

/// Main window of the desktop application: makes and connects all parts.
class MainWindow : public QMainWindow
{
    Q_OBJECT
  public:
    MainWindow();
    ~MainWindow() override;

    /// Opens meshes and scenes as one scene, and the last recording among the files for playback in that scene.
    /// @param frame  axes of mesh files, overriding their tags; Untagged: as tagged
    void open(const std::vector<std::filesystem::path>& files, double unit_mm = 1.0,
              palpate::core::FileFrame frame = palpate::core::FileFrame::Untagged);

    [[nodiscard]] const palpate::ui::ActionList& commands() const noexcept { return m_actions; }
    [[nodiscard]] palpate::ui::VtkViewport& viewport() noexcept { return *m_viewport; }
    [[nodiscard]] palpate::ui::PalpationController& palpation() noexcept { return *m_palpation; }
    [[nodiscard]] palpate::ui::Playback& playback() noexcept { return *m_playback; }
    [[nodiscard]] palpate::ui::Looks& looks() noexcept { return m_looks; }
    void setPalpating(bool isPalpating);
    /// Adds a menu of device plugins. Call once, before `chooseDevice`.
    void setPlugins(std::unique_ptr<palpate::device::PluginHost> plugins);
    /// Sets the hand's device once a scene is open. @param id  "mouse", "simulated", "playback" or a plugin's id
    void chooseDevice(const std::string& id);
    /// Reserves a CPU for the servo loop, overriding the saved setting; see `servo::checkCpu`.
    void useCpu(int cpu);
    [[nodiscard]] bool usesPointer() const noexcept { return m_live.usesPointer(); }

  Q_SIGNALS:
    /// The scene is open and drawn, and a requested recording is loaded.
    void ready();
    void openFailed(const QString& line);
    void deviceRefused(const QString& line);

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void makeActions();
    void makeFileAndEditActions();
    void makeViewActions();
    void makeSessionActions();
    void makeDeviceAndHelpActions();
    void makeShellActions();
    void makeMessagesDock();
    void makeEngineeringDock();
    void showEngineering(bool isShown);
    void makeFelt();
    void showFelt(bool isShown);
    void finishShell();
    void makeMenus();
    void makeToolBar();
    void makeDocks();
    void fitDocks(double left_px, double right_px, double below_px);
    void makeStatusBar();
    void connectActions();
    void connectLoading();
    void connectTouch();

    void chooseFiles();
    bool saveScene();
    bool saveSceneAs();
    bool saveSceneTo(const std::filesystem::path& path);
    bool confirmDiscard();
    void offerLeftover();
    void readAs(palpate::core::FileFrame frame);
    void showCoordinates();
    void showTitle();
    [[nodiscard]] palpate::meshio::SceneCamera cameraNow() const;
    void takeScene(const std::shared_ptr<palpate::ui::OpenedScene>& scene);
    void openRecording(const std::filesystem::path& path);
    void takeFingertip();
    void followModel(int row, palpate::ui::StructureModel::Change change);
    void toggleRecording();
    void togglePlaying();
    void showMeasures();
    void connectFindings();
    void exportFindings();
    void importFindings();
    void raiseFindings();
    void saveSnapshot();
    void letGo();
    void togglePanels();
    void showStatus();
    void showMode();
    void showWhatPlays();
    void remember(const std::filesystem::path& file);
    void refreshRecent();
    void say(const QString& text, int forget_ms = 8000);
    void showError(const QString& line);
    void showMessages();
    int listNotes(const palpate::ui::OpenedScene& scene);
    void listRealtimeWarnings(const palpate::servo::RealtimeReport& report);
    [[nodiscard]] QString handText() const;
    void offerReadingAsMetres(double size_mm);
    void connectSurfaces();
    void offerSurfaces();
    void followSurface(int row);
    void layOut(const palpate::ui::OpenedScene& scene);
    void offerOtherLayout(const LumpLayout& layout, const QString& line);
    void offerLayers(const palpate::study::Layering& layering);
    void connectList();
    void chooseAdded();
    void add(const std::vector<std::filesystem::path>& files);
    void takeAdded(palpate::ui::OpenedScene& scene);
    void arrangeAdded(const palpate::ui::OpenedScene& scene);
    void applyTissuePresets(const palpate::study::Layering& layering, int first);
    void offerTissueBack(std::vector<palpate::ui::StructureModel::Edited> before);
    void closeScene();
    void tellFault(const QString& line);
    [[nodiscard]] QString howToTouch() const;

    palpate::ui::ActionList m_actions{this};
    palpate::ui::Looks m_looks{m_actions, this}; ///< declared before the parts that use its styles
    palpate::ui::Messages m_messages;
    palpate::ui::PanelRound m_round;
    palpate::ui::StructureModel m_model;
    palpate::ui::LiveTouch m_live{m_model};
    palpate::ui::SceneLoader m_loader;
    palpate::ui::VtkViewport* m_viewport = nullptr;
    QStackedWidget* m_stack = nullptr;
    palpate::ui::WelcomePage* m_welcome = nullptr;
    palpate::ui::MessageBar* m_message = nullptr;
    palpate::ui::StructurePanel* m_structures = nullptr;
    palpate::ui::TouchPanel* m_touch = nullptr;
    palpate::ui::SessionPanel* m_session = nullptr;
    palpate::ui::FindingsPanel* m_findings = nullptr;
    palpate::ui::HandPanel* m_hand = nullptr;
    palpate::ui::EngineeringPanel* m_engineering = nullptr;
    palpate::ui::MapDisplay* m_maps = nullptr;
    palpate::ui::FeltOverlay* m_felt = nullptr;
    palpate::ui::HandControl* m_handControl = nullptr;
    palpate::ui::PalpationController* m_palpation = nullptr;
    palpate::ui::Playback* m_playback = nullptr;
    palpate::ui::DeviceChoice* m_devices = nullptr;
    palpate::ui::KeysCard* m_keys = nullptr;
    CoordinatesChoice* m_coordinates = nullptr;
    palpate::app::ShowAround* m_around = nullptr;
    palpate::app::SoundChoice* m_sound = nullptr;
    bool m_isEditedSinceReload = false; ///< since reloading of the open meshes began
    palpate::ui::Chip* m_deviceChip = nullptr;
    palpate::ui::Chip* m_recordingChip = nullptr;
    palpate::ui::Chip* m_runningChip = nullptr;
    palpate::ui::Chip* m_depthChip = nullptr;
    palpate::ui::HintLine* m_hint = nullptr;
    QStringList m_realtimeWarnings; ///< latest warnings about the servo thread
    QProgressBar* m_progress = nullptr;
    QToolButton* m_cancel = nullptr;
    QMenu* m_recentMenu = nullptr;
    std::vector<QDockWidget*> m_docks;
    QDockWidget* m_messagesDock = nullptr;    ///< list of messages, hidden until requested
    QDockWidget* m_feltDock = nullptr;        ///< shown together with the palpability map
    QDockWidget* m_engineeringDock = nullptr; ///< hidden until requested, then restored as left

    QAction* m_openAction = nullptr;
    QAction* m_addAction = nullptr;
    QAction* m_closeAction = nullptr;
    QAction* m_filterAction = nullptr;
    QAction* m_renameAction = nullptr;
    QAction* m_removeAction = nullptr;
    QAction* m_saveAction = nullptr;
    QAction* m_saveAsAction = nullptr;
    QAction* m_findingAction = nullptr;
    QAction* m_findingNoteAction = nullptr;
    QAction* m_nextFindingAction = nullptr;
    QAction* m_previousFindingAction = nullptr;
    QAction* m_exportFindingsAction = nullptr;
    QAction* m_importFindingsAction = nullptr;
    QAction* m_showFindingsAction = nullptr;
    QAction* m_noteAction = nullptr;
    QAction* m_measuresAction = nullptr;
    QAction* m_embedAction = nullptr;
    QAction* m_palpateAction = nullptr;
    QAction* m_effortAction = nullptr;
    QAction* m_recordAction = nullptr;
    QAction* m_playAction = nullptr;
    QAction* m_restartAction = nullptr;
    QAction* m_snapshotAction = nullptr;
    QAction* m_fitAction = nullptr;
    QAction* m_undoAction = nullptr;
    QAction* m_redoAction = nullptr;
    QAction* m_keysAction = nullptr;
    QAction* m_clutchAction = nullptr;
    QAction* m_engineeringAction = nullptr;
    QAction* m_feltAction = nullptr;
    QAction* m_fitSceneAction = nullptr;
    QAction* m_fitOrganAction = nullptr;
    QAction* m_fitLumpAction = nullptr;

    SceneDocument* m_document = nullptr;
    FindingsDesk* m_findingsDesk = nullptr;
    std::vector<std::filesystem::path> m_files;
    double m_unit_mm = 1.0;                                                       ///< with which the files were read
    std::vector<std::filesystem::path> m_opening;                                 ///< meshes of the latest open request
    palpate::core::FileFrame m_openingFrame = palpate::core::FileFrame::Untagged; ///< axes chosen for these meshes
    std::optional<std::filesystem::path> m_waitingRecording;                      ///< opened once its scene is open
    RecordingControl* m_recording = nullptr;
};
