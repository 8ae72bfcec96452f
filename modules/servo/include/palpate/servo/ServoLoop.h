// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/Fault.h"
#include "palpate/servo/RealtimeSetup.h"
#include "palpate/servo/TickRecord.h"
#include "palpate/servo/TimingReport.h"
#include "palpate/servo/WorkspaceMap.h"

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
    bool askRealtime = true;              ///< SCHED_FIFO and locked memory, when permitted
    int cpu = -1;                         ///< run on this one alone, see checkCpu; -1: on any
    bool isPassivityControlled = true;    ///< adds the damping that keeps a device with motors from oscillating
    std::size_t ringCapacity = 1U << 16U; ///< recorded ticks that wait for the recorder; 65 s at 1 kHz
};

/// Where a recording begins: enough to replay it bit for bit even when it began in mid-touch.
struct RecordingStart
{
    std::int64_t tick = 0;   ///< number of the first recorded tick
    std::uint32_t scene = 0; ///< generation that this tick feels
    haptics::PalpatorState
        state; ///< before this tick, after its change of scene if it has one: restore, then play rows
};

/// A latched fault and what it means.
struct FaultReport
{
    Fault fault;
    const char* message = ""; ///< one line for a person, empty without a fault
    [[nodiscard]] bool isFaulted() const noexcept { return fault.kind != FaultKind::None; }
};

/// Runs the servo thread: absolute deadlines, device read, one ServoCore tick, device written, the tick's record out.
/// All methods wait-free but for start, stop, setScene, collect and ticksBeforeFault, which are not for the servo
/// thread. One thread (the GUI) calls everything, except that the recorder may call popTick, fetchRecordingStart and
/// droppedTicks from one thread of its own.
class ServoLoop
{
  public:
    ServoLoop();
    ~ServoLoop();
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    /// Starts `device` and the thread. Counters, histograms and fault begin anew; scene and recording go on. Ticks that
    /// the recorder has not taken yet stay in the ring, unless ringCapacity changes: then it must not be at work
    /// meanwhile.
    /// @param device  must outlive the run
    /// @return BadCommandLine: options out of range; Internal: already running or no thread; or what the device said
    core::Status start(device::HapticDevice& device, const ServoOptions& options = {});
    /// Runs on with other options, as `start` does, but the device stays open: one that counts from its calibration
    /// pose does not forget it. The force goes away and is eased in again; a hand that stays where it is keeps its
    /// god-objects.
    /// @return BadCommandLine: options out of range, all goes on as before; Internal: not running, or no thread, and
    ///         then the device is stopped
    core::Status restart(const ServoOptions& options);
    /// Takes the force away within 10 ms, ends the thread, stops the device. Nothing when not running.
    void stop() noexcept;
    /// False before start, after stop and after the thread ended by an error.
    [[nodiscard]] bool isRunning() const noexcept;
    /// Of the present run, else the last [Hz].
    [[nodiscard]] double rate_Hz() const noexcept;

    /// Hands a scene to the servo thread, which takes it before its next tick; null = nothing to touch.
    /// @return its generation number, as in TickRecord::scene; 1 for the first, 0 means none was ever set
    std::uint32_t setScene(std::shared_ptr<const haptics::HapticScene> scene);
    /// Frees the scenes that the servo thread gave back. setScene and stop do so too; call it now and then.
    void collect();

    /// Says how the device's workspace lies in the scene, from the next tick on. Kept over runs; direct at first.
    void setMap(const MapSettings& settings) noexcept;

    /// Says how late the device's force acts, see PassivityController; from the next tick on, for the present run. 1 at
    /// first.
    void setDelay(int ticks) noexcept;

    /// Gives the newest tick. @return false when there is none since the last call; `out` is then untouched.
    bool fetchSnapshot(TickRecord& out) noexcept;

    /// From the next tick on, every record goes into the ring; fetchRecordingStart says with which it began.
    void startRecording() noexcept;
    void stopRecording() noexcept;
    /// Gives the oldest recorded tick not yet taken. @return false when there is none. Recorder thread.
    bool popTick(TickRecord& out) noexcept;
    /// Gives the oldest beginning of a recording not yet taken. It is there before its first tick is. Recorder thread.
    bool fetchRecordingStart(RecordingStart& out) noexcept;
    /// Ticks lost since start because the ring was full. Any thread.
    [[nodiscard]] std::uint64_t droppedTicks() const noexcept;

    /// Of the present run, else the last.
    [[nodiscard]] TimingReport timing() const;
    [[nodiscard]] RealtimeReport realtime() const;

    /// Lets force through again after a fault, eased in.
    void rearm() noexcept;
    [[nodiscard]] FaultReport fault() noexcept;
    /// Up to 100 ticks that ended with the one in which the latched fault was raised, oldest first; empty without one.
    [[nodiscard]] std::vector<TickRecord> ticksBeforeFault();

  private:
    core::Status startThread(const ServoOptions& options);
    void endThread() noexcept;

    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::servo
