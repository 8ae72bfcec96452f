// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchPanel.h"

#include <palpate/core/Export.h>
#include <palpate/core/TimingHistogram.h>
#include <palpate/servo/RealtimeSetup.h>
#include <palpate/servo/TimingReport.h>

#include <QString>
#include <QWidget>

#include <cstdint>
#include <vector>

class QComboBox;
class QLabel;

namespace palpate::ui {

class EnergyBar;
class LiveTouch;

/// State of the servo loop for engineers.
struct EngineeringReading
{
    bool isRunning = false;
    bool hasMotors = false;
    int cpu = -1;              ///< CPU reserved for the loop; -1: any
    double rate_Hz = 0.0;      ///< requested rate
    double measured_Hz = 0.0;  ///< mean over the last half second; 0 during the first
    int constraints = 0;       ///< active constraints of the displayed tick
    int delayTicks = 1;        ///< delay until the force takes effect
    double energy_mJ = 0.0;    ///< observed energy, see servo::TickRecord
    double damping_N = 0.0;    ///< added by the passivity controller
    std::uint64_t dropped = 0; ///< ticks lost from this recording
    servo::TimingReport timing{};
    servo::RealtimeReport realtime{};
    core::TimingSummary roundTrip{}; ///< device::DeviceReport::latency
    std::uint64_t reports = 0;       ///< received from the device
    std::uint64_t refused = 0;       ///< received but implausible
    std::uint64_t losses = 0;        ///< number of times the device was lost
};

/// Collects the state of the servo loop. @param shown  reading of the touch panel, live or from a recording
[[nodiscard]] PALPATE_EXPORT EngineeringReading engineeringReading(const LiveTouch& live, const TouchReading& shown);

/// Summary of the touch loop's health in a few words.
struct RunningState
{
    bool isWell = true;
    QString text; ///< empty while nothing runs
    QString tip;  ///< explanation in one or two sentences
};
[[nodiscard]] PALPATE_EXPORT RunningState runningState(const EngineeringReading& reading);

/// Panel with solver, servo loop and device measurements and the CPU of the loop, for developers who build or tune a
/// device.
class PALPATE_EXPORT EngineeringPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit EngineeringPanel(QWidget* parent = nullptr);

    void show(const EngineeringReading& reading);

  Q_SIGNALS:
    /// Emitted when the user chooses rate or CPU. @param cpu  reserved CPU; -1: any
    void loopChosen(int rate_kHz, int cpu);

  private:
    enum Row
    {
        Constraints,
        Solver,
        MeasuredRate,
        Jitter,
        Late,
        Dropped,
        Energy,
        Damping,
        RoundTrip,
        Delay,
        Reports,
        RowCount
    };
    void makeRows();
    void makeLoop();
    void tell();

    std::vector<QLabel*> m_values; ///< indexed by Row
    EnergyBar* m_energy = nullptr;
    QComboBox* m_rate = nullptr;
    QComboBox* m_cpu = nullptr;
    QLabel* m_realtime = nullptr;
};

} // namespace palpate::ui
