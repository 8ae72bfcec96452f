// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/ServoLoop.h"

#include "palpate/servo/ServoCore.h"

#include <palpate/core/Clock.h>
#include <palpate/core/SpscRing.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/PlainCopy.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <latch>
#include <string>
#include <thread>
#include <utility>

namespace palpate::servo {

using core::Status;
using core::StatusCode;
using device::PlainCopy;

namespace {

constexpr double kLowestRate_Hz = 1.0;
constexpr double kHighestRate_Hz = 10000.0;
constexpr std::size_t kLargestRing = 1U << 24U;
constexpr std::int64_t kLongestSleep_ns = 5'000'000; // so that a stop is noticed within 10 ms at any rate
constexpr std::size_t kHistory = 100;

struct SceneNode
{
    std::shared_ptr<const haptics::HapticScene> scene;
    std::uint32_t generation = 0;
};

/// The newest ticks, and those that led to a fault.
struct History
{
    std::array<TickRecord, kHistory> ticks;
    std::size_t count = 0; // ever added
};

/// Whatever ends the servo thread, the device is left without force.
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
    std::atomic<std::uint32_t> recordingEpoch{0}; // odd while recording; another value is another recording
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

    // The servo thread's while it runs, else the owner's.
    SceneNode* current = nullptr;
    SceneNode* retired = nullptr; // waits for room in `returned`
    History history;
    std::uint32_t epochSeen = 0;
    bool hasDropped = false;

    // The owner's.
    std::uint32_t lastGeneration = 0;
    std::atomic<std::uint64_t> droppedBefore{0}; // by runs before this one

    void runThread(std::latch& ready) noexcept;
    void run(std::latch& ready, bool& isReady);
    void takeScene(ServoCore& core) noexcept PALPATE_NONBLOCKING;
    void beginRecording(const ServoCore& core) noexcept PALPATE_NONBLOCKING;
    void publish(TickRecord& record) noexcept PALPATE_NONBLOCKING;
    void publishFault(const Fault& newFault) noexcept PALPATE_NONBLOCKING;
    void sleepUntil(std::int64_t deadline_ns) const noexcept;
};

void ServoLoop::Impl::runThread(std::latch& ready) noexcept
{
    const ZeroForceAtExit zeroForce(*device);
    bool isReady = false;
    try {
        run(ready, isReady);
    } catch (...) { // nothing in a tick throws; what sets the thread up may run out of memory
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
    if (current != nullptr) {
        core.setScene(current->scene.get(), current->generation);
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
        if (isRearmRequested.exchange(false, std::memory_order_acq_rel)) {
            core.rearm();
            publishFault({});
        }
        takeScene(core);
        beginRecording(core);

        const bool wasFaulted = core.fault().kind != FaultKind::None;
        const device::DeviceState state = device->read(woke_ns);
        TickRecord record = core.tick(state, woke_ns);
        device->write(record.fSent_W);
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
            const std::int64_t waited_ns = woke_ns - wokeBefore_ns;
            period.add(waited_ns);
            periodError.add(std::llround(std::abs(static_cast<double>(waited_ns) - period_ns)));
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

        // Periods that were missed are left out, never made up for in a burst. One late tick may follow at once; after
        // one that itself took longer than a period the thread sleeps, so that it never takes a whole CPU.
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
    isRunning.store(false, std::memory_order_release);
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
    // Without room to give the old one back, the new one waits.
    if (retired != nullptr || incoming.load(std::memory_order_relaxed) == nullptr) {
        return;
    }
    SceneNode* const node = incoming.exchange(nullptr, std::memory_order_acq_rel);
    if (node == nullptr) {
        return;
    }
    core.setScene(node->scene.get(), node->generation);
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
            return; // nobody fetched 64 of them: without its beginning a recording is worth nothing, so try again
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

ServoLoop::ServoLoop()
    : m_impl(std::make_unique<Impl>())
{
}

ServoLoop::~ServoLoop()
{
    stop();
    collect();
    delete m_impl->incoming.exchange(nullptr);
    delete m_impl->current;
    delete m_impl->retired;
}

Status ServoLoop::start(device::HapticDevice& device, const ServoOptions& options)
{
    Impl& impl = *m_impl;
    if (isRunning()) {
        return {StatusCode::Internal, "the servo loop is already running"};
    }
    stop(); // what is left of a thread that ended by an error
    if (!(options.rate_Hz >= kLowestRate_Hz && options.rate_Hz <= kHighestRate_Hz)) {
        return {StatusCode::BadCommandLine,
                "servo rate is " + std::to_string(options.rate_Hz) + " Hz, expected 1 to 10000"};
    }
    if (options.ringCapacity < 2 || options.ringCapacity > kLargestRing) {
        return {StatusCode::BadCommandLine, "the servo ring holds " + std::to_string(options.ringCapacity) +
                                                " ticks, expected 2 to " + std::to_string(kLargestRing)};
    }
    try { // a driver is other people's code
        if (Status started = device.start(); !started.isOk()) {
            return started;
        }
        const device::DeviceInfo info = device.info();
        impl.limits = GateLimits::forDevice(info);
        impl.passivity = PassivityLimits::forDevice(info);
        impl.passivity.isOn = impl.passivity.isOn && options.isPassivityControlled;
        if (impl.ring == nullptr || impl.ring->capacity() < options.ringCapacity ||
            impl.ring->capacity() / 2 >= options.ringCapacity) {
            impl.ring = std::make_unique<core::SpscRing<PlainCopy<TickRecord>>>(options.ringCapacity);
        }
        impl.device = &device;
        impl.request = {};
        impl.request.askPriority = options.askRealtime;
        impl.request.cpu = options.cpu;
        impl.rate_Hz.store(options.rate_Hz, std::memory_order_relaxed);
        impl.isStopRequested.store(false, std::memory_order_relaxed);
        impl.isRearmRequested.store(false, std::memory_order_relaxed);
        impl.ticks.store(0, std::memory_order_relaxed);
        impl.overruns.store(0, std::memory_order_relaxed);
        impl.skipped.store(0, std::memory_order_relaxed);
        for (TimingHistogram* h : {&impl.period, &impl.periodError, &impl.lateness, &impl.latency, &impl.solve}) {
            h->clear();
        }
        impl.history.count = 0;
        impl.epochSeen = 0;
        impl.hasDropped = false;
        impl.droppedBefore.store(impl.ring->dropped(), std::memory_order_relaxed);
        impl.fault.write(Fault{});

        std::latch ready(1);
        impl.thread = std::thread([&impl, &ready] { impl.runThread(ready); });
        ready.wait();
    } catch (const std::exception& e) {
        device.stop();
        return {StatusCode::Internal, std::string("the device or the servo thread could not be started: ") + e.what()};
    } catch (...) {
        device.stop();
        return {StatusCode::Internal, "the device could not be started: its driver failed"};
    }
    if (!isRunning()) {
        stop();
        return {StatusCode::Internal, "the servo thread could not be set up"};
    }
    return {};
}

void ServoLoop::stop() noexcept
{
    Impl& impl = *m_impl;
    if (!impl.thread.joinable()) {
        return;
    }
    impl.isStopRequested.store(true, std::memory_order_release);
    impl.thread.join();
    impl.device->stop();
    impl.device = nullptr;
    releaseRealtime(impl.realtime);
    collect();
}

bool ServoLoop::isRunning() const noexcept
{
    return m_impl->isRunning.load(std::memory_order_acquire);
}

double ServoLoop::rate_Hz() const noexcept
{
    return m_impl->rate_Hz.load(std::memory_order_relaxed);
}

std::uint32_t ServoLoop::setScene(std::shared_ptr<const haptics::HapticScene> scene)
{
    Impl& impl = *m_impl;
    collect();
    auto node = std::make_unique<SceneNode>(SceneNode{std::move(scene), ++impl.lastGeneration});
    if (impl.thread.joinable()) {
        delete impl.incoming.exchange(node.release(), std::memory_order_acq_rel);
    } else {
        delete impl.incoming.exchange(nullptr, std::memory_order_relaxed);
        delete std::exchange(impl.current, node.release());
    }
    return impl.lastGeneration;
}

void ServoLoop::collect()
{
    SceneNode* node = nullptr;
    while (m_impl->returned.pop(node)) {
        delete node;
    }
}

bool ServoLoop::fetchSnapshot(TickRecord& out) noexcept
{
    if (!m_impl->snapshot.fetch()) {
        return false;
    }
    out = m_impl->snapshot.value().get();
    return true;
}

void ServoLoop::startRecording() noexcept
{
    const std::uint32_t epoch = m_impl->recordingEpoch.load(std::memory_order_relaxed);
    m_impl->recordingEpoch.store(epoch % 2 == 1 ? epoch + 2 : epoch + 1, std::memory_order_release);
}

void ServoLoop::stopRecording() noexcept
{
    const std::uint32_t epoch = m_impl->recordingEpoch.load(std::memory_order_relaxed);
    if (epoch % 2 == 1) {
        m_impl->recordingEpoch.store(epoch + 1, std::memory_order_release);
    }
}

bool ServoLoop::popTick(TickRecord& out) noexcept
{
    PlainCopy<TickRecord> record;
    if (m_impl->ring == nullptr || !m_impl->ring->pop(record)) {
        return false;
    }
    out = record.get();
    return true;
}

bool ServoLoop::fetchRecordingStart(RecordingStart& out) noexcept
{
    PlainCopy<RecordingStart> start;
    if (!m_impl->recordingStarts.pop(start)) {
        return false;
    }
    out = start.get();
    return true;
}

std::uint64_t ServoLoop::droppedTicks() const noexcept
{
    return m_impl->ring == nullptr ? 0
                                   : m_impl->ring->dropped() - m_impl->droppedBefore.load(std::memory_order_relaxed);
}

TimingReport ServoLoop::timing() const
{
    const Impl& impl = *m_impl;
    TimingReport report;
    report.period = impl.period.summary();
    report.periodError = impl.periodError.summary();
    report.lateness = impl.lateness.summary();
    report.latency = impl.latency.summary();
    report.solve = impl.solve.summary();
    report.ticks = impl.ticks.load(std::memory_order_relaxed);
    report.overruns = impl.overruns.load(std::memory_order_relaxed);
    report.skipped = impl.skipped.load(std::memory_order_relaxed);
    return report;
}

RealtimeReport ServoLoop::realtime() const
{
    return m_impl->realtime;
}

void ServoLoop::rearm() noexcept
{
    m_impl->isRearmRequested.store(true, std::memory_order_release);
}

FaultReport ServoLoop::fault() noexcept
{
    m_impl->fault.fetch();
    FaultReport report;
    report.fault = m_impl->fault.value().get();
    report.message = text(report.fault.kind);
    return report;
}

std::vector<TickRecord> ServoLoop::ticksBeforeFault()
{
    std::vector<TickRecord> out;
    if (!fault().isFaulted()) {
        return out;
    }
    m_impl->faultHistory.fetch();
    const auto history = std::make_unique<History>(m_impl->faultHistory.value().get());
    const std::size_t kept = std::min(history->count, kHistory);
    out.reserve(kept);
    for (std::size_t i = history->count - kept; i < history->count; ++i) {
        out.push_back(history->ticks[i % kHistory]);
    }
    return out;
}

} // namespace palpate::servo
