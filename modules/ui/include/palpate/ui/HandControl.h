// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandPanel.h"
#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/StructurePanel.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace palpate::ui {

/// Maps the device's workspace into the scene according to the panel's settings and follows the camera. The filled
/// region is determined once, when requested; later changes of visibility or selection do not move the hand.
class PALPATE_EXPORT HandControl : public QObject
{
    Q_OBJECT
  public:
    /// All references must outlive this object.
    HandControl(VtkViewport& viewport, LiveTouch& live, StructureModel& model, StructurePanel& structures,
                HandPanel& panel, QObject* parent = nullptr);

    /// Loads the settings of a newly selected device from `live`.
    void takeDevice();
    /// Pins the servo loop to a CPU for this and later devices and overrides their saved settings, until the user
    /// chooses another CPU.
    void useCpu(int cpu);
    /// Changes rate and CPU of the servo loop and saves them for this device. A rejected change keeps the old values
    /// and emits `said`.
    /// @param cpu  reserved CPU; -1: any
    void chooseLoop(int rate_kHz, int cpu);
    /// Engages or releases the clutch by key: while engaged, the device moves and the hand in the scene stays.
    void setClutched(bool isClutched);
    /// Moves the centre of the workspace to the centre of the filled region and restarts the hand there.
    void centre();
    /// Fills the workspace with the scene, an organ or a lump. The organ is the touched structure, else the structure
    /// under the pointer, else the selected structure. The lump is the place of contact, else the finding or surface
    /// under the pointer, else the newest finding. A hand in contact keeps its position and only the scale changes; any
    /// other hand restarts at the centre.
    void fit(MapFill fill);
    /// Selects whether the pointer presses by effort or to the depth set with the wheel. Saved in the settings. No
    /// effect while another device is used.
    void setByEffort(bool isByEffort);
    /// Sets the force limit of a press by effort [N]. Saved in the settings. No effect while another device is used.
    void setEffort(double most_N);
    /// Sets candidate places of lumps, newest last.
    void setFindings(std::vector<core::Vec3> places) { m_findings = std::move(places); }

  Q_SIGNALS:
    /// Emitted with a line for the user after an action, or with the reason of a failure.
    void said(const QString& line);
    /// Emitted when the hand settings change or another device's settings are loaded.
    void settingsTaken(const palpate::ui::HandSettings& settings);

  private:
    struct Filled
    {
        core::Box box; ///< [mm]
        QString name;
    };
    void keep();
    void lay();
    void showStatus();
    void takeScene();
    void takeLoop();
    [[nodiscard]] std::optional<Filled> scene();
    [[nodiscard]] std::optional<Filled> organ();
    [[nodiscard]] std::optional<Filled> lump();
    [[nodiscard]] bool isTouching() const;
    [[nodiscard]] HandStatus::Clutch clutch() const;
    [[nodiscard]] QString inside() const;

    VtkViewport& m_viewport;
    LiveTouch& m_live;
    StructureModel& m_model;
    StructurePanel& m_structures;
    HandPanel& m_panel;
    QTimer m_follow; ///< the camera has no change signal
    Filled m_filled;
    std::vector<core::Vec3> m_findings;
    std::optional<int> m_cpu; ///< requested CPU that overrides the saved one
    std::uint32_t m_centreRequest = 0;
    std::uint32_t m_buttonsBefore = 0;
    bool m_isClutched = false;
};

} // namespace palpate::ui
