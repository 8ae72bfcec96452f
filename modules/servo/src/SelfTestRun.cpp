// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/SelfTestRun.h"

#include "palpate/servo/RealtimeSetup.h"

#include "ServoExit.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <thread>
#include <utility>

namespace palpate::servo {

struct SelfTestRun::Impl
{
    device::HapticDevice* device = nullptr;
    std::unique_ptr<SelfTest> test; ///< owned by the thread while running
    std::thread thread;
    std::atomic<bool> isStopRequested{false};
    std::atomic<bool> isRunning{false};
    std::atomic<int> delayTicks{1};
    std::atomic<SelfTestStep> step{SelfTestStep::Wait};
    std::atomic<double> progress{0.0};
    core::TimingSummary latency;

    void run() noexcept;
};

void SelfTestRun::Impl::run() noexcept
{
    RealtimeReport realtime;
    try {
        RealtimeRequest request;
        request.threadName = "palpate-test";
        realtime = makeThreadRealtime(request);
    } catch (...) { // out of memory: the test runs without priority
    }
    const double period_ns = 1e9 / test->record().rate_Hz;
    const std::int64_t start_ns = core::monotonicNow_ns();
    const auto deadlineOf = [&](std::int64_t n) { return start_ns + std::llround(static_cast<double>(n) * period_ns); };
    for (std::int64_t n = 1; !test->isFinished();) {
        core::sleepUntil_ns(deadlineOf(n));
        const std::int64_t now_ns = core::monotonicNow_ns();
        if (isStopRequested.load(std::memory_order_acquire)) {
            test->stop(SelfTestStop::Cancelled);
        }
        test->setDelay(delayTicks.load(std::memory_order_relaxed));
        const device::DeviceState state = device->read(now_ns);
        device->write(test->tick(state, now_ns));
        const std::int64_t end_ns = core::monotonicNow_ns();
        const bool isOverrun = end_ns > deadlineOf(n + 1);
        test->noteOverrun(isOverrun);
        step.store(test->record().step, std::memory_order_relaxed);
        progress.store(test->progress(), std::memory_order_relaxed);
        // Missed periods are skipped, as in the servo loop.
        const auto gone = static_cast<std::int64_t>(std::floor(static_cast<double>(end_ns - start_ns) / period_ns));
        n = isOverrun ? std::max(n + 1, gone + 1) : n + 1;
    }
    device->write(Vec3::Zero());
    releaseRealtime(realtime);
    isRunning.store(false, std::memory_order_release);
}

SelfTestRun::SelfTestRun()
    : m_impl(std::make_unique<Impl>())
{
}

SelfTestRun::~SelfTestRun()
{
    if (m_impl->thread.joinable()) {
        cancel();
        m_impl->thread.join();
        m_impl->device->stop();
    }
    forgetAtExit(m_impl->isStopRequested);
}

core::Status SelfTestRun::start(device::HapticDevice& device, const SelfTestOptions& options)
{
    Impl& impl = *m_impl;
    if (impl.thread.joinable()) {
        return {core::StatusCode::Internal, PALPATE_TEXT("the test is already running")};
    }
    try { // a driver's code may throw
        if (core::Status started = device.start(); !started.isOk()) {
            return started;
        }
        impl.device = &device;
        impl.test = std::make_unique<SelfTest>(device.info(), options);
        impl.isStopRequested.store(false, std::memory_order_relaxed);
        impl.isRunning.store(true, std::memory_order_relaxed);
        stopAtExit(impl.isStopRequested, impl.isRunning);
        impl.thread = std::thread([&impl] { impl.run(); });
    } catch (const std::exception& e) {
        impl.isRunning.store(false, std::memory_order_relaxed);
        device.stop();
        return {core::StatusCode::Internal, PALPATE_TEXT("the device could not be started: %1"), e.what()};
    } catch (...) {
        impl.isRunning.store(false, std::memory_order_relaxed);
        device.stop();
        return {core::StatusCode::Internal, PALPATE_TEXT("the device could not be started: its driver failed")};
    }
    return {};
}

bool SelfTestRun::poll()
{
    Impl& impl = *m_impl;
    if (impl.device == nullptr) {
        return false;
    }
    impl.latency = impl.device->report().latency;
    const int ticks = delayTicksOf(impl.latency, impl.test->record().rate_Hz);
    if (ticks > impl.delayTicks.load(std::memory_order_relaxed)) { // the slowest counts, as in the window
        impl.delayTicks.store(ticks, std::memory_order_relaxed);
    }
    return impl.isRunning.load(std::memory_order_acquire);
}

SelfTestStep SelfTestRun::step() const noexcept
{
    return m_impl->step.load(std::memory_order_relaxed);
}

double SelfTestRun::progress() const noexcept
{
    return m_impl->progress.load(std::memory_order_relaxed);
}

void SelfTestRun::cancel() noexcept
{
    m_impl->isStopRequested.store(true, std::memory_order_release);
}

SelfTestResult SelfTestRun::finish()
{
    Impl& impl = *m_impl;
    impl.thread.join();
    impl.device->stop();
    return evaluate(impl.test->record(), impl.latency);
}

} // namespace palpate::servo
