// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MotionControl.h"

#include <palpate/core/Export.h>

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace palpate::ui {

/// Controls of moving tissue: play or pause, hold breath, rate and amplitude.
class PALPATE_EXPORT MotionPanel : public QWidget
{
    Q_OBJECT
  public:
    static constexpr double kLeastRate = 0.1, kMostRate = 3.0;

    explicit MotionPanel(QWidget* parent = nullptr);

    /// @param hasBreath  enables what only changes breaths and frames
    void show(const MotionSettings& settings, bool hasBreath);

  Q_SIGNALS:
    /// Emitted when the user changed a control.
    void chosen(const palpate::ui::MotionSettings& settings);

  private:
    void choose();
    void showAmplitude(int percent);

    MotionSettings m_shown;
    QToolButton* m_play = nullptr;
    QToolButton* m_hold = nullptr;
    QDoubleSpinBox* m_rate = nullptr;
    QSlider* m_amplitude = nullptr;
    QLabel* m_percent = nullptr;
};

} // namespace palpate::ui
