// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchPanel.h"

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

/// How the servo loop runs at the moment, in an engineer's terms.
struct EngineeringReading
{
    bool isRunning = false;
    bool hasMotors = false;
    int cpu = -1;              ///< that the loop runs on alone; -1: on any
    double rate_Hz = 0.0;      ///< asked for
    double measured_Hz = 0.0;  ///< over the last half second; 0 in the first
    int constraints = 0;       ///< active ones of the shown tick
    int delayTicks = 1;        ///< after which the force acts
    double energy_mJ = 0.0;    ///< observed, see servo::TickRecord
    double damping_N = 0.0;    ///< that the passivity controller adds
    std::uint64_t dropped = 0; ///< ticks of this recording that were lost
    servo::TimingReport timing{};
    servo::RealtimeReport realtime{};
    core::TimingSummary roundTrip{}; ///< device::DeviceReport::latency
    std::uint64_t reports = 0;       ///< of the device
    std::uint64_t refused = 0;       ///< of those
    std::uint64_t losses = 0;        ///< of the device
};

/// @param shown  what the touch panel shows: of the live hand or of a recording
[[nodiscard]] EngineeringReading engineeringReading(const LiveTouch& live, const TouchReading& shown);

/// Whether touch runs as it should, in a few plain words.
struct RunningState
{
    bool isWell = true;
    QString text; ///< empty when nothing runs
    QString tip;  ///< why, a sentence or two
};
[[nodiscard]] RunningState runningState(const EngineeringReading& reading);

/// Solver, servo loop and device in numbers, and where the loop runs: for people who build or tune a device.
class EngineeringPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit EngineeringPanel(QWidget* parent = nullptr);

    void show(const EngineeringReading& reading);

  Q_SIGNALS:
    /// @param cpu  to run on alone; -1: on any
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

    std::vector<QLabel*> m_values; ///< by row
    EnergyBar* m_energy = nullptr;
    QComboBox* m_rate = nullptr;
    QComboBox* m_cpu = nullptr;
    QLabel* m_realtime = nullptr;
};

} // namespace palpate::ui
