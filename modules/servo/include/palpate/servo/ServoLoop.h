// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/Fault.h"
#include "palpate/servo/RealtimeSetup.h"
#include "palpate/servo/TickRecord.h"
#include "palpate/servo/TimingReport.h"
#include "palpate/servo/WorkspaceMap.h"

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/Palpator.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::servo {

struct ServoOptions
{
    double rate_Hz = 1000.0;              ///< 1 to 10000
    bool askRealtime = true;              ///< SCHED_FIFO, when permitted
    bool lockMemory = false;              ///< lock the memory of the whole process, when permitted; RealtimeSetup.h
    int cpu = -1;                         ///< CPU to pin the thread to, see checkCpu; -1: any
    bool isPassivityControlled = true;    ///< add damping to keep a device with motors from oscillating
    std::size_t ringCapacity = 1U << 16U; ///< capacity for ticks that wait for the recorder; 65 s at 1 kHz
};

/// Start state of a recording, sufficient for a bit-exact replay even from mid-contact.
struct RecordingStart
{
    std::int64_t tick = 0;   ///< number of the first recorded tick
    std::uint32_t scene = 0; ///< scene generation of this tick
    haptics::PalpatorState
        state; ///< before this tick, after its change of scene if it has one: restore, then play rows
};

/// A latched fault with the message for the user.
struct FaultReport
{
    Fault fault;
    core::Message message; ///< for the user, empty without a fault
    [[nodiscard]] bool isFaulted() const noexcept { return fault.kind != FaultKind::None; }
};

/// Runs the servo thread with absolute deadlines: reads the device, runs one ServoCore tick, writes the device, and
/// publishes the record. All methods are wait-free except start, stop, setScene, collect and ticksBeforeFault, which
/// must not run on the servo thread. One thread (the GUI) makes all calls, except that the recorder may call popTick,
/// fetchRecordingStart and droppedTicks from a single separate thread.
class PALPATE_EXPORT ServoLoop
{
  public:
    ServoLoop();
    ~ServoLoop();
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    /// Starts `device` and the thread. Resets counters, histograms and fault; keeps scene and recording. Ticks not yet
    /// taken by the recorder stay in the ring unless ringCapacity changes; in that case the recorder must not run
    /// during the call.
    /// @param device  must outlive the run
    /// @return BadCommandLine: options out of range; Internal: already running or no thread; or the error of the device
    core::Status start(device::HapticDevice& device, const ServoOptions& options = {});
    /// Restarts the thread with other options, like `start`, but keeps the device open, so that a device that counts
    /// from a calibration pose stays calibrated. The force drops and is eased in again; a hand that stays in place
    /// keeps the god-objects.
    /// @return BadCommandLine: options out of range, and the run continues unchanged; Internal: not running, or no
    /// thread,
    ///         and then the device is stopped
    core::Status restart(const ServoOptions& options);
    /// Removes the force within 10 ms, ends the thread, and stops the device. No effect when not running.
    void stop() noexcept;
    /// @return false before start, after stop and after an error ended the thread.
    [[nodiscard]] bool isRunning() const noexcept;
    /// Rate of the current or last run [Hz].
    [[nodiscard]] double rate_Hz() const noexcept;

    /// Passes a scene to the servo thread, which applies it before the next tick; null: empty scene.
    /// @return generation number as in TickRecord::scene; 1 for the first scene, 0 means no scene
    std::uint32_t setScene(std::shared_ptr<const haptics::HapticScene> scene);
    /// Frees the scenes returned by the servo thread. setScene and stop do the same; call periodically.
    void collect();

    /// Sets the mapping of the device workspace to the scene from the next tick on. Kept across runs; direct by
    /// default.
    void setMap(const MapSettings& settings) noexcept;

    /// Sets the delay of the device force (see PassivityController) from the next tick on, for the current run.
    /// Default 1.
    void setDelay(int ticks) noexcept;

    /// Gets the latest tick. @return false without a new tick since the last call; `out` is then unchanged.
    bool fetchSnapshot(TickRecord& out) noexcept;

    /// Starts to write every record to the ring from the next tick on; for the start state see fetchRecordingStart.
    void startRecording() noexcept;
    void stopRecording() noexcept;
    /// Takes the oldest recorded tick from the ring. @return false when the ring is empty. Recorder thread.
    bool popTick(TickRecord& out) noexcept;
    /// Takes the oldest pending recording start, which is available before the first tick. Recorder thread.
    bool fetchRecordingStart(RecordingStart& out) noexcept;
    /// Ticks lost since start because the ring was full. Any thread.
    [[nodiscard]] std::uint64_t droppedTicks() const noexcept;

    /// Statistics of the current or last run.
    [[nodiscard]] TimingReport timing() const;
    [[nodiscard]] RealtimeReport realtime() const;

    /// Re-enables the force after a fault, with easing.
    void rearm() noexcept;
    [[nodiscard]] FaultReport fault();
    /// Up to 100 ticks up to and including the tick that raised the latched fault, oldest first; empty without a fault.
    [[nodiscard]] std::vector<TickRecord> ticksBeforeFault();

  private:
    core::Status startThread(const ServoOptions& options);
    void endThread() noexcept;

    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::servo
