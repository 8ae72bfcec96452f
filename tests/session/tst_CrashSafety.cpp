// SPDX-License-Identifier: BSD-3-Clause
#include "Sessions.h"
#include "TestRunner.h"

#include <palpate/device/PlaybackDevice.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Recorder.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QDir>
#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palpate;
using namespace std::chrono_literals;

namespace {

/// A number shared by a child process and its parent.
class SharedTick
{
  public:
    SharedTick()
        : m_value(static_cast<std::atomic<std::int64_t>*>(::mmap(
              nullptr, sizeof(std::atomic<std::int64_t>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
    {
        new (m_value) std::atomic<std::int64_t>(-1);
    }
    ~SharedTick() { ::munmap(m_value, sizeof *m_value); }
    SharedTick(const SharedTick&) = delete;
    SharedTick& operator=(const SharedTick&) = delete;
    std::atomic<std::int64_t>& value() { return *m_value; }

  private:
    std::atomic<std::int64_t>* m_value;
};

std::vector<core::Vec3> circling(int ticks)
{
    std::vector<core::Vec3> motion;
    for (int i = 0; i < ticks; ++i) {
        const double t = i * 1e-3;
        motion.emplace_back(10.0 * std::sin(3.0 * t), 10.0 * std::cos(3.0 * t), 20.5 - std::sin(5.0 * t));
    }
    return motion;
}

/// What the recording process shares with its parent.
struct Shared
{
    SharedTick began;  ///< a tick after the start of the recording, which takes a second on a busy machine
    SharedTick newest; ///< newest tick of the servo loop
    SharedTick taken;  ///< number of ticks that the recorder has taken from the loop
    SharedTick stall;  ///< longest time in which it took none because it waited for the disk, in ticks
};

/// Records the servo loop until killed.
[[noreturn]] void recordForever(const std::filesystem::path& path, Shared& shared)
{
    device::PlaybackDevice device(circling(60000));
    servo::ServoLoop loop;
    servo::ServoOptions options;
    options.askRealtime = false;
    loop.setScene(test::boxScene(0.5, 0.001));
    session::Recorder recorder(loop);
    if (!loop.start(device, options).isOk() || !recorder.start(path, {}, test::palpationScenes()[0]).isOk()) {
        ::_exit(1);
    }
    std::int64_t changed = 0;
    for (bool isFirst = true;;) {
        servo::TickRecord tick;
        const auto taken = static_cast<std::int64_t>(recorder.status().ticks);
        if (loop.fetchSnapshot(tick)) {
            if (isFirst) {
                shared.began.value().store(tick.tick);
                isFirst = false;
                changed = tick.tick;
            }
            if (shared.taken.value().exchange(taken) != taken) {
                changed = tick.tick;
            }
            shared.stall.value().store(std::max(shared.stall.value().load(), tick.tick - changed));
            shared.newest.value().store(tick.tick);
        }
        std::this_thread::sleep_for(1ms);
    }
}

} // namespace

class CrashSafety : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

  private Q_SLOTS:
    /// Killed at different times, also in the middle of a transaction. The second holds where the disk takes at most
    /// 0.3 s for a commit: 0.25 s until one is due, 0.3 s for it and for the next, which was not finished.
    void aKilledProgramLosesAtMostTheLastSecond()
    {
        std::int64_t worst = 0;
        constexpr std::int64_t kSlow = 300; // ticks
        for (int round = 0; round < 6; ++round) {
            const auto file = path(qPrintable(QString("killed%1.palpate").arg(round)));
            Shared shared;
            const auto ticks = [&shared] { return shared.newest.value().load() - shared.began.value().load(); };
            const pid_t child = ::fork();
            QVERIFY(child >= 0);
            if (child == 0) {
                recordForever(file, shared);
            }
            const std::int64_t goal = 1200 + round * 37;
            for (int i = 0; i < 60000 && ticks() < goal; ++i) {
                std::this_thread::sleep_for(1ms);
            }
            ::kill(child, SIGKILL);
            int status = 0;
            ::waitpid(child, &status, 0);
            QVERIFY(WIFSIGNALED(status));
            const std::int64_t last = shared.newest.value().load();
            QVERIFY(ticks() >= goal);

            const auto reader = session::RecordingReader::open(file);
            QVERIFY2(reader.isOk(), reader.status().message().c_str());
            const auto& extent = reader.value()->extent();
            QVERIFY(!extent.isComplete);
            worst = std::max(worst, last - extent.lastTick);
            if (const std::int64_t stall = shared.stall.value().load(); stall > kSlow) {
                qInfo("the disk took up to %lld ms for a commit: the loss of %lld ms is not judged",
                      static_cast<long long>(stall), static_cast<long long>(last - extent.lastTick));
            } else {
                QVERIFY2(last - extent.lastTick <= 1000, std::to_string(last - extent.lastTick).c_str());
            }
            if (extent.ticks == 0) {
                QVERIFY(shared.stall.value().load() > kSlow); // killed in the first commit
                continue;
            }
            QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
            std::int64_t expected = extent.firstTick; // a prefix without gaps
            QVERIFY(reader.value()
                        ->forEach(0, std::numeric_limits<std::int64_t>::max(),
                                  [&expected](const servo::TickRecord& tick) { return tick.tick == expected++; })
                        .isOk());
            QCOMPARE(expected, extent.lastTick + 1);
            const auto result = session::resimulate(*reader.value(), test::boxSurfaces());
            QVERIFY2(result.isOk(), result.status().message().c_str());
            QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
        }
        qInfo("killed 6 times: at most %lld ticks of 1 ms lost", static_cast<long long>(worst));
    }

    void recordsWhatTheServoDoesAndStops()
    {
        device::PlaybackDevice device(circling(5000));
        servo::ServoLoop loop;
        servo::ServoOptions options;
        options.askRealtime = false;
        const auto generation = loop.setScene(test::boxScene(0.5, 0.001));
        QVERIFY(!session::Recorder(loop).start(path("early.palpate"), {}, {}).isOk()); // no servo loop
        QVERIFY(loop.start(device, options).isOk());
        session::Recorder recorder(loop);
        const auto scenes = test::palpationScenes();
        QCOMPARE(scenes[0].generation, generation);
        QVERIFY(!recorder.start(path("no-such-folder/a.palpate"), {}, scenes[0]).isOk());
        QVERIFY(recorder.start(path("live.palpate"), {}, scenes[0]).isOk());
        QVERIFY(!recorder.start(path("second.palpate"), {}, scenes[0]).isOk());
        QVERIFY(test::letPass(loop, 300));
        QCOMPARE(loop.setScene(test::boxScene(0.9, 0.001)), 2u);
        recorder.addScene(scenes[1]);
        recorder.addEvent("note", "{\"text\": \"firmer\"}");
        QVERIFY(test::letPass(loop, 300));
        QVERIFY(recorder.status().isRecording);
        const core::Status stopped = recorder.stop();
        QVERIFY2(stopped.isOk(), stopped.message().c_str());
        QVERIFY(!recorder.status().isRecording);
        loop.stop();

        const auto reader = session::RecordingReader::open(path("live.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(reader.value()->extent().isComplete);
        QVERIFY(reader.value()->extent().ticks > 400);
        QCOMPARE(reader.value()->extent().dropped, std::int64_t{0});
        // Two scenes, the change of tissue, the note, and the loop's timing.
        QCOMPARE(reader.value()->events().size(), std::size_t{5});
        const auto& timing = reader.value()->events().back();
        QCOMPARE(timing.kind, std::string("timing"));
        QVERIFY(timing.json.find("\"periodError\": {\"count\": ") != std::string::npos);
        const auto result = session::resimulate(*reader.value(), test::boxSurfaces());
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
    }

    /// A file size limit simulates a full disk.
    void aFullDiskIsSaidAndWhatWasWrittenStaysValid()
    {
        const auto ticks = test::palpationTicks(20000);
        const auto file = path("full.palpate");
        const pid_t child = ::fork();
        QVERIFY(child >= 0);
        if (child == 0) {
            std::signal(SIGXFSZ, SIG_IGN);
            session::RecordingInfo info;
            info.firstGeneration = 1;
            auto writer = session::RecordingWriter::create(file, info);
            (void)writer.value()->addScene(test::palpationScenes()[0]);
            (void)writer.value()->addScene(test::palpationScenes()[1]);
            rlimit limit{300000, 300000};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            bool isSaid = false;
            for (const auto& tick : ticks) {
                isSaid = !writer.value()->append(tick).isOk() || isSaid;
            }
            ::_exit(isSaid ? 42 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 42);
        const auto reader = session::RecordingReader::open(file);
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(reader.value()->extent().ticks > 500);
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        QVERIFY(session::resimulate(*reader.value(), test::boxSurfaces()).value().isSame());
    }

    void whatTheDiskRefusedIsWrittenWhenItComesBack()
    {
        const auto ticks = test::palpationTicks(2000);
        const auto file = path("back.palpate");
        session::RecordingInfo info;
        info.firstGeneration = 1;
        auto created = session::RecordingWriter::create(file, info);
        QVERIFY(created.isOk());
        session::RecordingWriter& writer = *created.value();
        for (const auto& scene : test::palpationScenes()) {
            QVERIFY(writer.addScene(scene).isOk());
        }
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        ::getrlimit(RLIMIT_FSIZE, &before);
        int refused = 0;
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            if (i == 600 || i == 1400) {
                const rlimit limit{i == 600 ? 1000 : before.rlim_cur, before.rlim_max};
                ::setrlimit(RLIMIT_FSIZE, &limit);
            }
            refused += writer.append(ticks[i]).isOk() ? 0 : 1;
        }
        QVERIFY(refused > 0);
        QVERIFY(writer.finish().isOk());
        QCOMPARE(writer.ticksDropped(), std::uint64_t{0});
        const auto reader = session::RecordingReader::open(file);
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->extent().ticks, std::int64_t{2000});
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        QVERIFY(session::resimulate(*reader.value(), test::boxSurfaces()).value().isSame());
    }
};

PALPATE_TEST(CrashSafety)
#include "tst_CrashSafety.moc"
