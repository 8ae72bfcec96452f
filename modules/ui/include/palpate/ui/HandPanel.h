// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandSettings.h"

#include <palpate/device/HapticDevice.h>

#include <QString>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace palpate::ui {

/// What the hand's device is at the moment.
struct HandStatus
{
    enum class Clutch
    {
        None,
        Asked, ///< by key or button
        AtEdge ///< by itself, at the edge of the workspace
    };
    double held_N_per_mm = 0.0; ///< stiffness that may be held, in the scene; infinite: no bound
    bool isMapped = false;      ///< false: the device's coordinates are the scene's
    double scale = 1.0;         ///< mm of the scene a mm of the device
    QString filled;             ///< what fills the workspace
    double force_N = 0.0;       ///< given to the hand
    Clutch clutch = Clutch::None;
    QString inside; ///< the structure that the hand began in and has not left; it is not felt
};

/// The device in the hand: how it lies in the scene and what stiffness it can show.
class HandPanel : public QWidget
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
    void centreWanted();
    void fitWanted(palpate::ui::MapFill fill);
    void clutchWanted(bool isDown);

  private:
    void edit();
    void showWhatApplies(const device::DeviceInfo& info);

    QWidget* makeFits();
    QWidget* makeMapping();
    QWidget* makePress();

    HandSettings m_settings;
    QLabel* m_name = nullptr;
    QLabel* m_force = nullptr;
    QLabel* m_held = nullptr;
    QLabel* m_clutched = nullptr;
    QWidget* m_mapping = nullptr;
    QWidget* m_press = nullptr;
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
    double m_limit_N = 0.0; ///< of the motors; 0: none
};

} // namespace palpate::ui
