// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Recorder.h"

#include "palpate/session/RecordingWriter.h"
#include "store/TimingEvent.h"
#include "tables/Tenths.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace palpate::session {

using core::Status;
using core::StatusCode;
using namespace std::chrono_literals;

namespace {
constexpr auto kDrainInterval = 20ms;
constexpr auto kCommitInterval = 250ms;
constexpr auto kStartTimeout = 2s; // the first tick arrives within two periods
constexpr auto kLastTick = 5ms;    // time until the servo has noticed the end of recording, at any supported rate
} // namespace

std::optional<servo::RecordingStart> beginRecording(servo::ServoLoop& loop)
{
    servo::RecordingStart start;
    servo::TickRecord stale;
    while (loop.popTick(stale) || loop.fetchRecordingStart(start)) {
    }
    loop.startRecording();
    const auto deadline = std::chrono::steady_clock::now() + kStartTimeout;
    while (!loop.fetchRecordingStart(start)) {
        if (std::chrono::steady_clock::now() > deadline) {
            loop.stopRecording();
            return std::nullopt;
        }
        std::this_thread::sleep_for(1ms);
    }
    return start;
}

struct Recorder::Private
{
    explicit Private(servo::ServoLoop& servoLoop)
        : loop(servoLoop)
    {
    }

    void run();
    void drain(bool isLast);
    void store(bool isLast);
    void note(const Status& status);
    [[nodiscard]] bool isOver(bool isLast) const;
    void closeAfterFailure();
    void addTiming();
    [[nodiscard]] double duration_s() const;
    void publish(bool isRecording);

    servo::ServoLoop& loop;
    std::thread thread;

    std::mutex mutex; // guards the following members up to `published`; never locked by the servo thread
    std::condition_variable wake;
    bool isStopRequested = false;
    std::vector<SceneRecord> scenes;
    struct TimedEvent
    {
        std::int64_t time_ns; // monotonic, same clock as the ticks
        RecordingEvent event; // `tick` is set by the recorder thread
    };
    std::vector<TimedEvent> events;
    RecorderStatus published;

    // Used only by the recorder thread while running:
    std::unique_ptr<RecordingWriter> writer;
    std::filesystem::path path;
    std::uint64_t droppedAtStart = 0;
    std::uint64_t skippedAtStart = 0;
    std::uint64_t late = 0;
    std::optional<servo::TickRecord> first;
    std::vector<TimedEvent> waiting; // for the next tick
    std::int64_t lastTick = 0;
    std::int64_t lastTime_ns = 0;
    core::Message problem;
    bool isFull = false; // `problem` is a full disk
    bool hasFailed = false;
    bool hasTiming = false; // the timing event is written
};

/// Processes the result of a write.
void Recorder::Private::note(const Status& status)
{
    if (!status.isOk()) {
        problem = status.text();
        isFull = status.code() == StatusCode::NoSpace;
    }
}

/// Returns true if writing cannot succeed any more: the disk is full, ticks were lost because the disk accepted no data
/// for too long, or writing fails at the end.
bool Recorder::Private::isOver(bool isLast) const
{
    return isFull || writer->ticksDropped() > 0 || (isLast && !problem.isEmpty());
}

void Recorder::Private::addTiming()
{
    if (std::exchange(hasTiming, true)) {
        return;
    }
    const servo::TimingReport timing = loop.timing();
    late = timing.skipped - skippedAtStart;
    (void)writer->addEvent({lastTick, "timing", timingJson(timing, loop.realtime().isRealtime, late)});
}

/// Closes a failed recording and writes the final events from the reserved space.
void Recorder::Private::closeAfterFailure()
{
    loop.stopRecording();
    addTiming();
    (void)writer->abandon({lastTick, "ended", isFull ? R"({"why": "disk-full"})" : R"({"why": "disk-failed"})"});
    hasFailed = true;
    const double felt_s = duration_s();
    const core::Message why = isFull ? core::Message(PALPATE_TEXT("the disk is full"))
                                     : core::Message(PALPATE_TEXT("the disk cannot be written (%1)"), problem);
    problem = writer->newestStored_ns()
                  ? core::Message(PALPATE_TEXT("%1: the recording ended at %2 s because %3; what was felt after is not "
                                               "in it"),
                                  path, internal::tenths(felt_s), why)
                  : core::Message(PALPATE_TEXT("%1: nothing was recorded because %2"), path, why);
}

double Recorder::Private::duration_s() const
{
    const std::int64_t last_ns = hasFailed ? writer->newestStored_ns().value_or(0) : lastTime_ns;
    return first ? std::max(0.0, static_cast<double>(last_ns - first->time_ns) * 1e-9) : 0.0;
}

void Recorder::Private::drain(bool isLast)
{
    std::vector<SceneRecord> newScenes;
    {
        const std::lock_guard lock(mutex);
        newScenes.swap(scenes);
        std::move(events.begin(), events.end(), std::back_inserter(waiting));
        events.clear();
    }
    for (const SceneRecord& scene : newScenes) {
        (void)writer->addScene(scene); // kept until the next commit
    }
    std::size_t told = 0;
    const auto addEventsUntil = [&](std::int64_t time_ns) {
        for (; told < waiting.size() && waiting[told].time_ns < time_ns; ++told) {
            waiting[told].event.tick = lastTick; // the most recent tick at that time
            (void)writer->addEvent(waiting[told].event);
        }
    };
    // While the disk is slower than the servo, the ring is never found empty; only the last drain has to empty it.
    const auto due = std::chrono::steady_clock::now() + kCommitInterval;
    servo::TickRecord tick;
    while ((isLast || std::chrono::steady_clock::now() < due) && loop.popTick(tick)) {
        addEventsUntil(tick.time_ns);
        if (!first) {
            first = tick;
        }
        lastTick = tick.tick;
        lastTime_ns = tick.time_ns;
        note(writer->append(tick));
    }
    if (isLast) {
        addEventsUntil(std::numeric_limits<std::int64_t>::max());
    }
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(told));
}

void Recorder::Private::store(bool isLast)
{
    const std::uint64_t ringDrops = loop.droppedTicks() - droppedAtStart;
    const std::uint64_t lost = ringDrops + writer->ticksDropped();
    if (isLast && lost > 0) {
        (void)writer->addEvent({lastTick, "dropped", "{\"ticks\": " + std::to_string(lost) + "}"});
    }
    if (isLast) {
        addTiming();
    } else {
        late = loop.timing().skipped - skippedAtStart;
    }
    const bool hadProblem = !problem.isEmpty();
    const Status status = isLast ? writer->finish() : writer->commit();
    note(status);
    if (status.isOk() && hadProblem) {
        // The error is over: record it as an event and clear the status.
        problem = {};
        if (!isLast) {
            (void)writer->addEvent({lastTick, "disk", "{\"what\": \"writing failed for a while\"}"});
        }
    }
}

void Recorder::Private::publish(bool isRecording)
{
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(path, ignored);
    const std::lock_guard lock(mutex);
    published.isRecording = isRecording;
    published.ticks = writer->ticksWritten();
    published.dropped = loop.droppedTicks() - droppedAtStart + writer->ticksDropped();
    published.late = late;
    published.duration_s = duration_s();
    published.hasFailed = hasFailed;
    published.fileBytes = ignored ? 0 : bytes;
    published.problem = problem;
}

void Recorder::Private::run()
{
    auto lastCommit = std::chrono::steady_clock::now();
    for (bool isLast = false; !isLast;) {
        {
            std::unique_lock lock(mutex);
            wake.wait_for(lock, kDrainInterval, [this] { return isStopRequested; });
            isLast = isStopRequested;
        }
        if (!loop.isRunning()) {
            isLast = true; // no further ticks
        }
        if (isLast) {
            loop.stopRecording();
            std::this_thread::sleep_for(kLastTick);
        }
        try {
            drain(isLast);
            const auto now = std::chrono::steady_clock::now();
            const bool isDue = isLast || now - lastCommit >= kCommitInterval;
            if (isDue && !isOver(false)) {
                lastCommit = now;
                store(isLast);
            }
            if (isOver(isLast)) {
                closeAfterFailure();
                isLast = true;
            }
        } catch (const std::exception& error) { // out of memory: haptic rendering continues without the recording
            problem = core::Message(PALPATE_TEXT("%1: recording ended: %2"), path, error.what());
            loop.stopRecording();
            hasFailed = true;
            isLast = true;
        }
        publish(!isLast);
    }
}

Recorder::Recorder(servo::ServoLoop& loop)
    : m_d(std::make_unique<Private>(loop))
{
}

Recorder::~Recorder()
{
    (void)stop();
}

Status Recorder::start(const std::filesystem::path& path, const RecordingInfo& info, const SceneRecord& scene)
{
    Private& d = *m_d;
    if (d.thread.joinable()) {
        if (status().isRecording) {
            return {StatusCode::Internal, PALPATE_TEXT("%1: is still being recorded"), d.path};
        }
        d.thread.join();
    }
    if (!d.loop.isRunning()) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: cannot be recorded: the servo loop is not running"), path};
    }
    d.droppedAtStart = d.loop.droppedTicks();
    d.skippedAtStart = d.loop.timing().skipped;
    d.late = 0;
    const auto start = beginRecording(d.loop);
    if (!start) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: cannot be recorded: the servo loop does not answer"), path};
    }
    RecordingInfo filled = info;
    filled.rate_Hz = d.loop.rate_Hz();
    filled.dt_s = 1.0 / filled.rate_Hz;
    filled.firstTick = start->tick;
    filled.firstGeneration = start->scene;
    filled.start = start->state;
    auto created = RecordingWriter::create(path, filled);
    if (!created.isOk()) {
        d.loop.stopRecording();
        return created.status();
    }
    d.writer = std::move(created).value();
    d.path = path;
    d.first.reset();
    d.lastTick = start->tick;
    d.problem = {};
    d.isFull = d.hasFailed = d.hasTiming = false;
    d.isStopRequested = false;
    d.scenes.clear();
    d.events.clear();
    d.waiting.clear();
    d.published = {};
    d.published.isRecording = true;
    (void)d.writer->addScene(scene);
    d.thread = std::thread([this] { m_d->run(); });
    return {};
}

void Recorder::addScene(const SceneRecord& scene)
{
    const std::lock_guard lock(m_d->mutex);
    if (m_d->published.isRecording) {
        m_d->scenes.push_back(scene);
    }
}

void Recorder::addEvent(const std::string& kind, const std::string& json)
{
    const std::lock_guard lock(m_d->mutex);
    if (m_d->published.isRecording) {
        m_d->events.push_back({core::monotonicNow_ns(), {0, kind, json}});
    }
}

void Recorder::requestStop()
{
    const std::lock_guard lock(m_d->mutex);
    if (m_d->published.isRecording) {
        m_d->loop.stopRecording(); // at once: what is left to write does not grow while the thread is busy
    }
    m_d->isStopRequested = true;
    m_d->wake.notify_all();
}

Status Recorder::stop()
{
    Private& d = *m_d;
    if (!d.thread.joinable()) {
        return {};
    }
    requestStop();
    d.thread.join();
    d.writer.reset();
    const RecorderStatus last = status();
    if (!last.problem.isEmpty()) {
        return {d.isFull ? StatusCode::NoSpace : StatusCode::Unreadable, last.problem};
    }
    if (last.dropped > 0) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("%1: %2 ticks were lost"), d.path, last.dropped};
    }
    return {};
}

RecorderStatus Recorder::status() const
{
    const std::lock_guard lock(m_d->mutex);
    return m_d->published;
}

} // namespace palpate::session
