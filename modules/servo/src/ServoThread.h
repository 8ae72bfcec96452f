// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/ServoCore.h"
#include "palpate/servo/ServoLoop.h"

#include <palpate/core/SpscRing.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/PlainCopy.h>

#include <array>
#include <atomic>
#include <latch>
#include <thread>

namespace palpate::servo {

using device::PlainCopy;

inline constexpr std::size_t kHistory = 100; // ticks stored with a fault

struct SceneNode
{
    std::shared_ptr<const haptics::HapticScene> scene;
    std::uint32_t generation = 0;
};

/// The newest ticks, and the ticks that led to a fault.
struct History
{
    std::array<TickRecord, kHistory> ticks;
    std::size_t count = 0; // total number added
};

/// State shared by the owner of a loop and the servo thread, and the work of the thread.
struct ServoLoop::Impl
{
    // Set before the thread starts, read by both.
    device::HapticDevice* device = nullptr;
    GateLimits limits;
    PassivityLimits passivity;
    RealtimeRequest request;
    std::atomic<double> rate_Hz{0.0};
    std::thread thread;

    // To the servo thread.
    std::atomic<bool> isStopRequested{false};
    std::atomic<bool> isRearmRequested{false};
    std::atomic<int> delayTicks{1};
    std::atomic<std::uint32_t> recordingEpoch{0}; // odd while recording; changes with each recording
    core::TripleBuffer<PlainCopy<MapSettings>> map;
    std::atomic<SceneNode*> incoming{nullptr};
    static_assert(std::atomic<SceneNode*>::is_always_lock_free);

    // From the servo thread.
    std::atomic<bool> isRunning{false};
    core::SpscRing<SceneNode*> returned{8};
    core::TripleBuffer<PlainCopy<TickRecord>> snapshot;
    std::unique_ptr<core::SpscRing<PlainCopy<TickRecord>>> ring;
    core::SpscRing<PlainCopy<RecordingStart>> recordingStarts{64};
    core::TripleBuffer<PlainCopy<Fault>> fault;
    core::TripleBuffer<PlainCopy<History>> faultHistory;
    std::atomic<std::uint64_t> ticks{0};
    std::atomic<std::uint64_t> overruns{0};
    std::atomic<std::uint64_t> skipped{0};
    TimingHistogram period;
    TimingHistogram periodError;
    TimingHistogram lateness;
    TimingHistogram latency;
    TimingHistogram solve;
    RealtimeReport realtime; // complete before start returns

    // Owned by the servo thread while running, otherwise by the owner of the loop.
    SceneNode* current = nullptr;
    SceneNode* retired = nullptr; // waits for space in `returned`
    History history;
    std::uint32_t epochSeen = 0;
    bool hasDropped = false;
    ServoHand hand; // of the previous run, after its end

    // State of the owner of the loop.
    bool isResumed = false; // the next run continues with `hand`
    std::uint32_t lastGeneration = 0;
    std::atomic<std::uint64_t> droppedBefore{0}; // records dropped by earlier runs

    void runThread(std::latch& ready) noexcept;
    void run(std::latch& ready, bool& isReady);
    void takeRequests(ServoCore& core) noexcept PALPATE_NONBLOCKING;
    void notePeriod(std::int64_t waited_ns, double period_ns) noexcept PALPATE_NONBLOCKING;
    void takeScene(ServoCore& core) noexcept PALPATE_NONBLOCKING;
    void beginRecording(const ServoCore& core) noexcept PALPATE_NONBLOCKING;
    void publish(TickRecord& record) noexcept PALPATE_NONBLOCKING;
    void publishFault(const Fault& newFault) noexcept PALPATE_NONBLOCKING;
    void sleepUntil(std::int64_t deadline_ns) const noexcept;
};

} // namespace palpate::servo
