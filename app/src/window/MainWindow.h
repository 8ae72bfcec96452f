// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/MeshFile.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Looks.h>
#include <palpate/ui/StructureModel.h>

#include <QMainWindow>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class QStackedWidget;

namespace palpate::device {
class PluginHost;
}

namespace palpate::ui {
class ChipRow;
class PalpationController;
class Playback;
class VtkViewport;
class WelcomePage;
} // namespace palpate::ui

namespace palpate::app {
class CoordinatesPart;
class DevicePart;
class DistancesPart;
class Docks;
class DocumentPart;
class HelpPart;
class Notices;
class RecordingPart;
class SceneChanges;
class SceneFiles;
class TouchPart;
class ViewPart;
class WindowPart;
} // namespace palpate::app

/// Main window of the desktop application: makes the parts, orders their commands and panels, and connects signals
/// between parts and window.
class MainWindow : public QMainWindow
{
    Q_OBJECT
  public:
    MainWindow();
    ~MainWindow() override;

    /// Opens meshes and scenes as one scene, and the last recording among the files for playback in that scene.
    void open(const std::vector<std::filesystem::path>& files, const palpate::meshio::ReadOptions& options = {});

    [[nodiscard]] const palpate::ui::ActionList& commands() const noexcept { return m_actions; }
    [[nodiscard]] const palpate::ui::StructureModel& model() const noexcept { return m_model; }
    [[nodiscard]] palpate::ui::VtkViewport& viewport() noexcept { return *m_viewport; }
    [[nodiscard]] palpate::ui::PalpationController& palpation() noexcept;
    [[nodiscard]] palpate::ui::Playback& playback() noexcept;
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
    void makeCentre();
    void makeParts();
    void makeMenus();
    void makeStatusBar();
    void connectParts();
    void connectTour();
    void restoreLayout();
    void showState();
    void showPage(bool isView);

    template<class Part>
    Part* keep(Part* part)
    {
        m_parts.push_back(part);
        return part;
    }

    palpate::ui::ActionList m_actions{this};
    palpate::ui::Looks m_looks{m_actions, this}; ///< declared before the parts that use its styles
    palpate::ui::StructureModel m_model;
    palpate::ui::LiveTouch m_live{m_model};
    palpate::ui::VtkViewport* m_viewport = nullptr;
    palpate::ui::WelcomePage* m_welcome = nullptr;
    QStackedWidget* m_pages = nullptr; ///< welcome page and view
    palpate::ui::ChipRow* m_chips = nullptr;
    QMenu* m_recentMenu = nullptr;

    using Parts = std::vector<palpate::app::WindowPart*>;
    Parts m_parts; ///< each after the parts that it uses
    palpate::app::Notices* m_notices = nullptr;
    palpate::app::Docks* m_docks = nullptr;
    palpate::app::DocumentPart* m_document = nullptr;
    palpate::app::TouchPart* m_touch = nullptr;
    palpate::app::RecordingPart* m_recording = nullptr;
    palpate::app::DevicePart* m_device = nullptr;
    palpate::app::DistancesPart* m_distances = nullptr;
    palpate::app::SceneFiles* m_files = nullptr;
    palpate::app::CoordinatesPart* m_coordinates = nullptr;
    palpate::app::ViewPart* m_view = nullptr;
    palpate::app::HelpPart* m_help = nullptr;
    palpate::app::SceneChanges* m_changes = nullptr;
};
