// SPDX-License-Identifier: BSD-3-Clause
#include "ServoThread.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::servo {

namespace {

constexpr std::int64_t kLongestSleep_ns = 5'000'000; // so that a stop is noticed within 10 ms at any rate

/// Ensures zero device force whichever way the servo thread ends.
class ZeroForceAtExit
{
  public:
    explicit ZeroForceAtExit(device::HapticDevice& device) noexcept
        : m_device(device)
    {
    }
    ~ZeroForceAtExit() { m_device.write(Vec3::Zero()); }
    ZeroForceAtExit(const ZeroForceAtExit&) = delete;
    ZeroForceAtExit& operator=(const ZeroForceAtExit&) = delete;

  private:
    device::HapticDevice& m_device;
};

} // namespace

void ServoLoop::Impl::runThread(std::latch& ready) noexcept
{
    const ZeroForceAtExit zeroForce(*device);
    bool isReady = false;
    try {
        run(ready, isReady);
    } catch (...) { // ticks never throw, but the setup may run out of memory
        const auto done = static_cast<std::int64_t>(ticks.load(std::memory_order_relaxed));
        publishFault({FaultKind::LoopFailed, done, core::monotonicNow_ns()});
        device->write(Vec3::Zero());
        isRunning.store(false, std::memory_order_release);
        if (!isReady) {
            ready.count_down();
        }
    }
}

void ServoLoop::Impl::run(std::latch& ready, bool& isReady)
{
    realtime = makeThreadRealtime(request);
    const double rate = rate_Hz.load(std::memory_order_relaxed);
    ServoCore core(limits, rate, passivity);
    core.setMap(map.value().get());
    if (current != nullptr) {
        core.borrowScene(current->scene.get(), current->generation);
    }
    if (isResumed) {
        core.resume(hand);
    }
    isRunning.store(true, std::memory_order_release);
    isReady = true;
    ready.count_down();

    const double period_ns = 1e9 / rate;
    const std::int64_t start_ns = core::monotonicNow_ns();
    const auto deadlineOf = [&](std::int64_t n) { return start_ns + std::llround(static_cast<double>(n) * period_ns); };
    std::int64_t wokeBefore_ns = 0;
    bool isStopping = false;
    for (std::int64_t n = 1;;) {
        const std::int64_t deadline_ns = deadlineOf(n);
        sleepUntil(deadline_ns);
        const std::int64_t woke_ns = core::monotonicNow_ns();
        if (!isStopping && isStopRequested.load(std::memory_order_acquire)) {
            isStopping = true;
            core.beginStop();
        }
        takeRequests(core);

        const bool wasFaulted = core.fault().kind != FaultKind::None;
        const device::DeviceState state = device->read(woke_ns);
        TickRecord record = core.tick(state, woke_ns);
        device->write(core.forceForDevice());
        const std::int64_t end_ns = core::monotonicNow_ns();

        const bool isOverrun = end_ns > deadlineOf(n + 1);
        core.noteOverrun(isOverrun, end_ns);
        if (isOverrun) {
            record.flags |= kOverrun;
            overruns.fetch_add(1, std::memory_order_relaxed);
        }
        history.ticks[history.count++ % kHistory] = record;
        publish(record);
        if (!wasFaulted && core.fault().kind != FaultKind::None) {
            publishFault(core.fault());
        }

        ticks.fetch_add(1, std::memory_order_relaxed);
        if (wokeBefore_ns != 0) {
            notePeriod(woke_ns - wokeBefore_ns, period_ns);
        }
        wokeBefore_ns = woke_ns;
        lateness.add(woke_ns - deadline_ns);
        if ((record.flags & kNoHand) == 0) {
            latency.add(end_ns - state.time_ns);
            solve.add(record.solve_ns);
        }
        if (isStopping && core.gate().isAtRest()) {
            break;
        }

        // Missed periods are skipped, never caught up in a burst. One late tick may follow immediately; after
        // a tick that took longer than a period the thread sleeps, so that the servo loop never occupies a whole CPU.
        if (isOverrun) {
            const auto gone = static_cast<std::int64_t>(std::floor(static_cast<double>(end_ns - start_ns) / period_ns));
            const bool wasLong = static_cast<double>(end_ns - woke_ns) > period_ns;
            const std::int64_t next = std::max(n + 1, wasLong ? gone + 1 : gone);
            skipped.fetch_add(static_cast<std::uint64_t>(next - (n + 1)), std::memory_order_relaxed);
            n = next;
        } else {
            ++n;
        }
    }
    device->write(Vec3::Zero());
    hand = core.hand();
    isRunning.store(false, std::memory_order_release);
}

/// Requests of the owner since the last tick.
void ServoLoop::Impl::takeRequests(ServoCore& core) noexcept PALPATE_NONBLOCKING
{
    if (isRearmRequested.exchange(false, std::memory_order_acq_rel)) {
        core.rearm();
        publishFault({});
    }
    if (map.fetch()) {
        core.setMap(map.value().get());
    }
    core.setDelay(delayTicks.load(std::memory_order_relaxed));
    takeScene(core);
    beginRecording(core);
}

void ServoLoop::Impl::notePeriod(std::int64_t waited_ns, double period_ns) noexcept PALPATE_NONBLOCKING
{
    period.add(waited_ns);
    periodError.add(std::llround(std::abs(static_cast<double>(waited_ns) - period_ns)));
}

void ServoLoop::Impl::sleepUntil(std::int64_t deadline_ns) const noexcept
{
    for (;;) {
        const std::int64_t now_ns = core::monotonicNow_ns();
        if (now_ns >= deadline_ns) {
            return;
        }
        if (deadline_ns - now_ns <= kLongestSleep_ns) {
            core::sleepUntil_ns(deadline_ns);
            return;
        }
        core::sleepUntil_ns(now_ns + kLongestSleep_ns);
        if (isStopRequested.load(std::memory_order_acquire)) {
            return;
        }
    }
}

void ServoLoop::Impl::takeScene(ServoCore& core) noexcept PALPATE_NONBLOCKING
{
    if (retired != nullptr && returned.push(retired)) {
        retired = nullptr;
    }
    // While `returned` has no space for the old scene, the new scene waits.
    if (retired != nullptr || incoming.load(std::memory_order_relaxed) == nullptr) {
        return;
    }
    SceneNode* const node = incoming.exchange(nullptr, std::memory_order_acq_rel);
    if (node == nullptr) {
        return;
    }
    core.borrowScene(node->scene.get(), node->generation);
    retired = std::exchange(current, node);
    if (retired != nullptr && returned.push(retired)) {
        retired = nullptr;
    }
}

void ServoLoop::Impl::beginRecording(const ServoCore& core) noexcept PALPATE_NONBLOCKING
{
    const std::uint32_t epoch = recordingEpoch.load(std::memory_order_acquire);
    if (epoch == epochSeen) {
        return;
    }
    if (epoch % 2 == 1) {
        RecordingStart start;
        start.tick = core.nextTick();
        start.scene = core.sceneGeneration();
        start.state = core.palpatorState();
        if (!recordingStarts.push(start)) {
            return; // ring of starts is full; a recording needs its start, so retry in the next tick
        }
        hasDropped = false;
    }
    epochSeen = epoch;
}

void ServoLoop::Impl::publish(TickRecord& record) noexcept PALPATE_NONBLOCKING
{
    if (epochSeen % 2 == 1) {
        if (hasDropped) {
            record.flags |= kDroppedBefore;
        }
        hasDropped = !ring->push(record);
    }
    snapshot.write(record);
}

void ServoLoop::Impl::publishFault(const Fault& newFault) noexcept PALPATE_NONBLOCKING
{
    if (newFault.kind == FaultKind::None) {
        fault.write(newFault);
        return;
    }
    faultHistory.write(history);
    fault.write(newFault);
}

} // namespace palpate::servo
