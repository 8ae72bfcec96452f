// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandSettings.h"

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>

#include <QString>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace palpate::ui {

/// Current state of the haptic device.
struct HandStatus
{
    enum class Clutch
    {
        None,
        Asked, ///< by key or button
        AtEdge ///< automatic, at the edge of the workspace
    };
    double held_N_per_mm = 0.0; ///< largest stable stiffness, in scene units; infinite: unlimited
    bool isMapped = false;      ///< false: device coordinates equal scene coordinates
    double scale = 1.0;         ///< scene millimetres per device millimetre
    QString filled;             ///< region that fills the workspace
    double force_N = 0.0;       ///< force on the hand
    Clutch clutch = Clutch::None;
    QString inside; ///< structure in which the hand started; without force until the hand leaves
};

/// Panel with the device's mapping into the scene and the stiffness range of the device.
class PALPATE_EXPORT HandPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit HandPanel(QWidget* parent = nullptr);

    void setDevice(const device::DeviceInfo& info, const HandSettings& settings);
    [[nodiscard]] const HandSettings& settings() const noexcept { return m_settings; }
    void setSettings(const HandSettings& settings);
    void show(const HandStatus& status);

  Q_SIGNALS:
    void settingsChanged();
    /// Emitted after `settingsChanged` when another device for the simulated hand was chosen.
    void presetChanged();
    void centreWanted();
    void fitWanted(palpate::ui::MapFill fill);
    void clutchWanted(bool isDown);

  private:
    void edit();
    void showWhatApplies(const device::DeviceInfo& info);

    QWidget* makeFits();
    QWidget* makeMapping();
    QWidget* makePress();
    QWidget* makeSimulated();

    HandSettings m_settings;
    QLabel* m_name = nullptr;
    QLabel* m_force = nullptr;
    QLabel* m_held = nullptr;
    QLabel* m_clutched = nullptr;
    QWidget* m_mapping = nullptr;
    QWidget* m_press = nullptr;
    QWidget* m_simulated = nullptr;
    QComboBox* m_preset = nullptr;
    QComboBox* m_pressBy = nullptr;
    QDoubleSpinBox* m_effort = nullptr;
    QLabel* m_reach = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    QComboBox* m_turn = nullptr;
    QCheckBox* m_leftHanded = nullptr;
    std::array<QComboBox*, 2> m_buttons{};
    QPushButton* m_clutch = nullptr;
    QPushButton* m_centre = nullptr;
    bool m_isShowing = false;
    double m_limit_N = 0.0; ///< force limit of the motors; 0: no motors
};

} // namespace palpate::ui
