// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandSettings.h"

#include <palpate/servo/ServoLoop.h>

#include <QString>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace palpate::ui {

class EnergyBar;

/// What the hand's device is at the moment.
struct HandStatus
{
    double held_N_per_mm = 0.0; ///< stiffness that may be held, in the scene; infinite: no bound
    double rate_Hz = 0.0;
    int delayTicks = 1;     ///< after which the force acts
    double scale = 1.0;     ///< mm of the scene a mm of the device
    double energy_mJ = 0.0; ///< observed, see servo::TickRecord
    double damping_N = 0.0; ///< that the passivity controller adds
    bool isClutched = false;
    servo::TimingReport timing;
    servo::RealtimeReport realtime;
};

/// The device in the hand: how it lies in the scene, what stiffness it holds, the energy at it and how regular its loop
/// is.
class HandPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit HandPanel(QWidget* parent = nullptr);

    void setDevice(const device::DeviceInfo& info, const HandSettings& settings);
    [[nodiscard]] const HandSettings& settings() const noexcept { return m_settings; }
    void show(const HandStatus& status);

  signals:
    void settingsChanged();
    void centreWanted();
    void clutchWanted(bool isDown);

  private:
    void edit();
    void showSettings();

    HandSettings m_settings;
    QLabel* m_name = nullptr;
    QLabel* m_held = nullptr;
    QLabel* m_energyText = nullptr;
    EnergyBar* m_energy = nullptr;
    QWidget* m_mapping = nullptr;
    QComboBox* m_fill = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    QComboBox* m_turn = nullptr;
    QCheckBox* m_leftHanded = nullptr;
    std::array<QComboBox*, 2> m_buttons{};
    QPushButton* m_clutch = nullptr;
    QPushButton* m_centre = nullptr;
    QLabel* m_timing = nullptr;
    bool m_isShowing = false;
    bool m_hasMotors = false;
};

} // namespace palpate::ui
