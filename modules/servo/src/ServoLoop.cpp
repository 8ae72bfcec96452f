// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/ServoLoop.h"

#include "ServoExit.h"
#include "ServoThread.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace palpate::servo {

using core::Status;
using core::StatusCode;

namespace {

constexpr double kLowestRate_Hz = 1.0;
constexpr double kHighestRate_Hz = 10000.0;
constexpr std::size_t kLargestRing = 1U << 24U;

Status checkOptions(const ServoOptions& options)
{
    if (!(options.rate_Hz >= kLowestRate_Hz && options.rate_Hz <= kHighestRate_Hz)) {
        return {StatusCode::BadCommandLine, PALPATE_TEXT("servo rate is %1 Hz, expected 1 to 10000"), options.rate_Hz};
    }
    if (options.ringCapacity < 2 || options.ringCapacity > kLargestRing) {
        return {StatusCode::BadCommandLine, PALPATE_TEXT("the servo ring holds %1 ticks, expected 2 to %2"),
                options.ringCapacity, kLargestRing};
    }
    return checkCpu(options.cpu);
}

} // namespace

ServoLoop::ServoLoop()
    : m_impl(std::make_unique<Impl>())
{
}

ServoLoop::~ServoLoop()
{
    stop();
    forgetAtExit(m_impl->isStopRequested);
    collect();
    delete m_impl->incoming.exchange(nullptr);
    delete m_impl->current;
    delete m_impl->retired;
}

Status ServoLoop::start(device::HapticDevice& device, const ServoOptions& options)
{
    if (isRunning()) {
        return {StatusCode::Internal, PALPATE_TEXT("the servo loop is already running")};
    }
    stop(); // cleans up after a thread that ended by an error
    if (Status status = checkOptions(options); !status.isOk()) {
        return status;
    }
    try { // a driver's code may throw
        if (Status started = device.start(); !started.isOk()) {
            return started;
        }
    } catch (const std::exception& e) {
        device.stop();
        return {StatusCode::Internal, PALPATE_TEXT("the device could not be started: %1"), e.what()};
    } catch (...) {
        device.stop();
        return {StatusCode::Internal, PALPATE_TEXT("the device could not be started: its driver failed")};
    }
    m_impl->device = &device;
    m_impl->isResumed = false;
    return startThread(options);
}

Status ServoLoop::restart(const ServoOptions& options)
{
    if (!isRunning()) {
        return {StatusCode::Internal, PALPATE_TEXT("the servo loop is not running")};
    }
    if (Status status = checkOptions(options); !status.isOk()) {
        return status;
    }
    endThread();
    m_impl->isResumed = true;
    return startThread(options);
}

/// Stops the device, which is already started, if the thread cannot be created.
Status ServoLoop::startThread(const ServoOptions& options)
{
    Impl& impl = *m_impl;
    try {
        const device::DeviceInfo info = impl.device->info();
        impl.limits = GateLimits::forDevice(info);
        impl.passivity = PassivityLimits::forDevice(info);
        impl.delayTicks.store(impl.passivity.delayTicks, std::memory_order_relaxed);
        impl.passivity.isOn = impl.passivity.isOn && options.isPassivityControlled;
        if (impl.ring == nullptr || impl.ring->capacity() < options.ringCapacity ||
            impl.ring->capacity() / 2 >= options.ringCapacity) {
            impl.ring = std::make_unique<core::SpscRing<PlainCopy<TickRecord>>>(options.ringCapacity);
        }
        impl.request = {};
        impl.request.askPriority = options.askRealtime;
        impl.request.lockMemory = options.lockMemory;
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
        stopAtExit(impl.isStopRequested, impl.isRunning);
        impl.thread = std::thread([&impl, &ready] { impl.runThread(ready); });
        ready.wait();
    } catch (const std::exception& e) {
        std::exchange(impl.device, nullptr)->stop();
        return {StatusCode::Internal, PALPATE_TEXT("the device or the servo thread could not be started: %1"),
                e.what()};
    } catch (...) {
        std::exchange(impl.device, nullptr)->stop();
        return {StatusCode::Internal, PALPATE_TEXT("the device could not be started: its driver failed")};
    }
    if (!isRunning()) {
        stop();
        return {StatusCode::Internal, PALPATE_TEXT("the servo thread could not be set up")};
    }
    return {};
}

void ServoLoop::endThread() noexcept
{
    Impl& impl = *m_impl;
    impl.isStopRequested.store(true, std::memory_order_release);
    impl.thread.join();
    releaseRealtime(impl.realtime);
    collect();
}

void ServoLoop::stop() noexcept
{
    Impl& impl = *m_impl;
    if (!impl.thread.joinable()) {
        return;
    }
    endThread();
    impl.device->stop();
    impl.device = nullptr;
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

void ServoLoop::setMap(const MapSettings& settings) noexcept
{
    m_impl->map.write(settings);
}

void ServoLoop::setDelay(int ticks) noexcept
{
    m_impl->delayTicks.store(ticks, std::memory_order_relaxed);
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

FaultReport ServoLoop::fault()
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
