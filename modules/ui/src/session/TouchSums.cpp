// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchSums.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/study/RecordedScene.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate::ui {

namespace {

std::vector<float> floats(const std::vector<double>& values)
{
    std::vector<float> out(values.size());
    std::transform(values.begin(), values.end(), out.begin(), [](double value) { return static_cast<float>(value); });
    return out;
}

/// Sums of a recording from its first tick on.
struct Reading
{
    std::unique_ptr<session::TouchedSurfaces> surfaces;
    std::int64_t nextTick = 0;
};

} // namespace

std::shared_ptr<const TouchSums> touchSums(const session::TouchedSurfaces& surfaces,
                                           const session::MeshesByHash& meshes, double time_s, const TouchSums* last)
{
    auto sums = std::make_shared<TouchSums>();
    sums->time_s = time_s;
    for (const auto& [key, touched] : surfaces.touched()) {
        TouchedStructure& one = sums->structures[key];
        if (last != nullptr && last->structures.contains(key)) {
            const TouchedStructure& before = last->structures.at(key);
            one.surface = before.surface;
            one.isSplit = before.isSplit;
        } else {
            one.isSplit = touched->mesh().vertices.size() != touched->givenVertices();
            auto split = std::make_shared<geometry::RepairedMesh>();
            split->mesh = one.isSplit ? touched->mesh() : geometry::TriangleMesh();
            one.surface = one.isSplit ? std::move(split) : meshes.at(key.second);
        }
        one.dwell_s = floats(touched->dwell_s());
        one.peakForce_N = floats(touched->peakForce_N());
        one.stiffness_N_per_mm = floats(touched->stiffness_N_per_mm());
        one.share_mm2 = touched->share_mm2();
    }
    return sums;
}

RecordedTouchSums::RecordedTouchSums(std::filesystem::path recording, session::MeshesByHash meshes,
                                     std::optional<double> distance_mm,
                                     std::function<void(std::shared_ptr<const TouchSums>)> ready,
                                     std::function<void(const core::Status&)> failed)
    : m_recording(std::move(recording))
    , m_meshes(std::move(meshes))
    , m_distance_mm(distance_mm)
    , m_ready(std::move(ready))
    , m_failed(std::move(failed))
    , m_thread([this] { run(); })
{
}

RecordedTouchSums::~RecordedTouchSums()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isClosing = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void RecordedTouchSums::setEnd(double time_s)
{
    {
        const std::lock_guard lock(m_mutex);
        m_end_s = time_s;
    }
    m_changed.notify_all();
}

std::optional<double> RecordedTouchSums::nextEnd()
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_end_s || m_isClosing; });
    return m_isClosing ? std::nullopt : std::exchange(m_end_s, std::nullopt);
}

/// Returns true if reading up to this moment serves no request any more.
bool RecordedTouchSums::isOutdated(double end_s)
{
    const std::lock_guard lock(m_mutex);
    return m_isClosing || (m_end_s && *m_end_s < end_s);
}

void RecordedTouchSums::run()
{
    constexpr std::int64_t kAsk = 4096;                              // ticks between looks at the request
    const auto reader = session::RecordingReader::open(m_recording); // one of its own: not for several threads
    if (!reader.isOk()) {
        m_failed(reader.status());
        return;
    }
    const double dt_s = reader.value()->info().dt_s,
                 distance_mm = m_distance_mm.value_or(study::defaultDistance_mm(*reader.value(), m_meshes));
    const std::int64_t first = reader.value()->extent().firstTick;
    const auto keyOf = [&reader](std::uint32_t scene, std::uint32_t structure) -> session::StructureKey {
        const session::SceneRecord* record = reader.value()->scene(scene);
        return record != nullptr && structure < record->structures.size()
                   ? session::StructureKey(record->structures[structure].name,
                                           record->structures[structure].source.sha256)
                   : session::StructureKey();
    };
    Reading reading;
    std::shared_ptr<const TouchSums> last;
    for (auto end_s = nextEnd(); end_s; end_s = nextEnd()) {
        const std::int64_t end = first + std::llround(std::max(0.0, *end_s) / dt_s);
        if (reading.surfaces == nullptr || end < reading.nextTick - 1) {
            reading = {std::make_unique<session::TouchedSurfaces>(m_meshes, keyOf, distance_mm), first};
        }
        bool isLeft = false;
        const core::Status status = reader.value()->forEach(reading.nextTick, end, [&](const servo::TickRecord& tick) {
            reading.surfaces->add(tick, static_cast<double>(tick.tick - first) * dt_s, dt_s);
            reading.nextTick = tick.tick + 1;
            isLeft = tick.tick % kAsk == 0 && isOutdated(*end_s);
            return !isLeft;
        });
        if (!status.isOk()) {
            m_failed(status);
            return;
        }
        if (!isLeft) {
            reading.nextTick = std::max(reading.nextTick, end + 1);
            last = touchSums(*reading.surfaces, m_meshes, *end_s, last.get());
            m_ready(last);
        }
    }
}

} // namespace palpate::ui
