// SPDX-License-Identifier: BSD-3-Clause
// Measures the cost of a recording: bench_session [SECONDS [FOLDER]], by default 600 s of ticks at 1 kHz, in permanent
// contact with a sphere of 327,680 triangles. Compare the output with resources/docs/recording.md:
//
// file: bytes of the whole recording (10 min: at most 100 MB).
// writer: processor time of packing, hashing and SQLite per tick (below 3 % of one core at 1 kHz).
// open: from the path to a reader that can seek (at most 500 ms).
// seek: any tick, in random order (at most 50 ms).
// verify: every checksum, then the database's own check.
// again: computed again and compared bit for bit (at least 200 x real time).
// 4 kHz: 10 s of the servo loop recorded live (no drop).
#include "Shapes.h"

#include <palpate/core/Clock.h>
#include <palpate/device/PlaybackDevice.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Recorder.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include <time.h>

using namespace palpate;
using core::Vec3;

namespace {

constexpr double kRadius_mm = 50.0;

double processorSeconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wallSeconds()
{
    return static_cast<double>(core::monotonicNow_ns()) * 1e-9;
}

/// Moves back and forth over the sphere, at up to 150 mm/s, 0 to 3 mm deep.
Vec3 handAt(double t_s)
{
    const Vec3 direction(std::sin(1.1 * t_s) + 0.3 * std::sin(7.3 * t_s), std::cos(0.7 * t_s), std::sin(0.43 * t_s));
    return (kRadius_mm - 1.5 - 1.5 * std::sin(9.0 * t_s)) * direction.normalized();
}

std::shared_ptr<const haptics::HapticScene> sphereScene()
{
    haptics::HapticStructure structure;
    structure.name = "sphere";
    structure.surface = test::indexed(test::sphere(128, kRadius_mm));
    structure.tissue = {0.5, 0.001};
    return std::make_shared<haptics::HapticScene>(std::vector{structure});
}

bool said(const core::Status& status)
{
    if (!status.isOk()) {
        std::fprintf(stderr, "%s\n", status.message().c_str());
    }
    return !status.isOk();
}

bool writeSession(const std::filesystem::path& file, const haptics::HapticScene& scene, double seconds)
{
    session::Motion motion;
    for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
        motion.p_WH.push_back(handAt(1e-3 * i));
    }
    session::RecordingInfo info;
    info.firstGeneration = 1;
    std::error_code none;
    std::filesystem::remove(file, none);
    auto writer = session::RecordingWriter::create(file, info);
    if (said(writer.status())) {
        return false;
    }
    session::StructureSource source;
    source.sha256 = "sphere";
    core::Status status = writer.value()->addScene(session::describeScene(1, scene, std::vector{source}));
    double cost_s = 0.0;
    session::replay(scene, motion, [&](const servo::TickRecord& tick) {
        const double start_s = processorSeconds();
        status = writer.value()->append(tick);
        cost_s += processorSeconds() - start_s;
        return status.isOk();
    });
    if (said(status) || said(writer.value()->finish())) {
        return false;
    }
    const double bytes = static_cast<double>(std::filesystem::file_size(file));
    std::printf("file    %.1f MB, %.1f bytes a tick\n", bytes * 1e-6, bytes / static_cast<double>(motion.p_WH.size()));
    std::printf("writer  %.2f us a tick, %.2f %% of a core at 1 kHz\n",
                1e6 * cost_s / static_cast<double>(motion.p_WH.size()), 100.0 * cost_s / seconds);
    return true;
}

bool readSession(const std::filesystem::path& file, const haptics::HapticScene& scene, double seconds)
{
    double start_s = wallSeconds();
    const auto opened = session::RecordingReader::open(file);
    if (said(opened.status())) {
        return false;
    }
    const session::RecordingReader& reader = *opened.value();
    std::printf("open    %.1f ms\n", 1e3 * (wallSeconds() - start_s));
    std::mt19937_64 random(1);
    std::vector<double> seeks;
    for (int i = 0; i < 2000; ++i) {
        const auto tick = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(reader.extent().ticks));
        start_s = wallSeconds();
        if (!reader.at(tick)) {
            return false;
        }
        seeks.push_back(1e3 * (wallSeconds() - start_s));
    }
    std::sort(seeks.begin(), seeks.end());
    std::printf("seek    p50 %.3f ms, p99 %.3f ms, max %.3f ms\n", seeks[1000], seeks[1980], seeks.back());
    start_s = wallSeconds();
    if (said(reader.verify())) {
        return false;
    }
    std::printf("verify  %.2f s, %.0f x real time\n", wallSeconds() - start_s, seconds / (wallSeconds() - start_s));
    start_s = wallSeconds();
    const double processor_s = processorSeconds();
    const auto again = session::resimulate(reader, {{"sphere", scene.structures()[0].surface}});
    if (said(again.status())) {
        return false;
    }
    const double wall_s = wallSeconds() - start_s;
    std::printf("again   %.2f s (%.2f s of it on this thread), %.0f x real time, %s\n", wall_s,
                processorSeconds() - processor_s, seconds / wall_s,
                again.value().isSame() ? "the same bits" : again.value().difference.english().c_str());
    return again.value().isSame();
}

bool recordLive(const std::filesystem::path& file, const std::shared_ptr<const haptics::HapticScene>& scene)
{
    constexpr double kRate_Hz = 4000.0;
    constexpr double kSeconds = 10.0;
    std::vector<Vec3> motion;
    for (int i = 0; i < static_cast<int>(kRate_Hz * (kSeconds + 5.0)); ++i) {
        motion.push_back(handAt(i / kRate_Hz));
    }
    device::PlaybackDevice device(motion);
    servo::ServoLoop loop;
    servo::ServoOptions options;
    options.lockMemory = true;
    options.rate_Hz = kRate_Hz;
    std::error_code none;
    std::filesystem::remove(file, none); // a recording never replaces another file
    const auto generation = loop.setScene(scene);
    session::Recorder recorder(loop);
    if (said(loop.start(device, options)) ||
        said(recorder.start(file, {}, session::describeScene(generation, *scene, {})))) {
        return false;
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(kSeconds));
    const core::Status stopped = recorder.stop();
    const session::RecorderStatus status = recorder.status();
    std::printf("4 kHz   %lld ticks in %.2f s, %llu dropped, %llu overruns of the servo%s\n",
                static_cast<long long>(status.ticks), status.duration_s,
                static_cast<unsigned long long>(status.dropped),
                static_cast<unsigned long long>(loop.timing().overruns),
                stopped.isOk() ? "" : (", " + stopped.message()).c_str());
    loop.stop();
    return status.dropped == 0;
}

} // namespace

int main(int argc, char** argv)
{
    const double seconds = argc > 1 ? std::atof(argv[1]) : 600.0;
    const std::filesystem::path folder =
        argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path();
    const auto file = folder / "bench_session.palpate";
    const auto scene = sphereScene();
    std::printf("%.0f s at 1 kHz, sphere of %u triangles, build %s\n", seconds,
                scene->structures()[0].surface->triangleCount(), session::buildId().c_str());
    const bool isDone = seconds >= 1.0 && writeSession(file, *scene, seconds) && readSession(file, *scene, seconds) &&
                        recordLive(file, scene);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return isDone ? 0 : 1;
}
