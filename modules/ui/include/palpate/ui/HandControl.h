// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandPanel.h"
#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/StructurePanel.h"
#include "palpate/ui/VtkViewport.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace palpate::ui {

/// Lays the device's workspace into the scene as the panel says, and keeps it there while the camera turns. What fills
/// the workspace is taken once, when it is asked for: hiding or selecting something changes nothing under the hand.
class HandControl : public QObject
{
    Q_OBJECT
  public:
    /// All must outlive this.
    HandControl(VtkViewport& viewport, LiveTouch& live, StructureModel& model, StructurePanel& structures,
                HandPanel& panel, QObject* parent = nullptr);

    /// The device in `live` is another one: its own settings apply.
    void takeDevice();
    /// Runs the servo loop on a CPU, with this device and others chosen later, whatever was kept for them; choosing
    /// another ends that.
    void useCpu(int cpu);
    /// Runs the servo loop otherwise and keeps that for this device. What is refused stays as it was and is said.
    /// @param cpu  to run on alone; -1: on any
    void chooseLoop(int rate_kHz, int cpu);
    /// By a key: the device moves, the hand in the scene stays.
    void setClutched(bool isClutched);
    /// Puts the middle of the workspace in the middle of what it reaches. The hand then begins anew there.
    void centre();
    /// Fills the workspace. An organ is the one that is touched, else the one under the pointer, else the selected one;
    /// a lump is where the hand touches, else the finding or surface under the pointer, else the newest finding. A hand
    /// in contact stays where it is and only the scale changes; any other begins anew in the middle.
    void fit(MapFill fill);
    /// How the pointer presses: by effort, or as deep as the wheel says. Kept; nothing while another device is the
    /// hand.
    void setByEffort(bool isByEffort);
    /// The force of such a press at most [N]. Kept as the above.
    void setEffort(double most_N);
    /// Places that a lump may be, the newest last.
    void setFindings(std::vector<core::Vec3> places) { m_findings = std::move(places); }

  Q_SIGNALS:
    /// What was done, or why it was not.
    void said(const QString& line);
    /// The hand's settings are others, or those of another device.
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
    QTimer m_follow; ///< the camera says nothing when it turns
    Filled m_filled;
    std::vector<core::Vec3> m_findings;
    std::optional<int> m_cpu; ///< that was asked for instead of the kept one
    std::uint32_t m_centreRequest = 0;
    std::uint32_t m_buttonsBefore = 0;
    bool m_isClutched = false;
};

} // namespace palpate::ui
