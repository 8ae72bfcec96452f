// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyDisk.h"
#include "FileLimits.h"
#include "Sessions.h"
#include "TestRunner.h"

#include <palpate/device/PlaybackDevice.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Recorder.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <thread>

using namespace palpate;
using session::RecordingReader;
using session::RecordingWriter;
using test::FaultyDisk;

/// Tests the effect of disk faults on a recording.
class DiskFaults : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    std::string bytes(const char* name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }

    static core::Result<std::unique_ptr<RecordingWriter>> begin(const std::filesystem::path& file)
    {
        session::RecordingInfo info;
        info.firstGeneration = 1;
        auto writer = RecordingWriter::create(file, info);
        for (const auto& scene : test::palpationScenes()) {
            if (writer.isOk()) {
                (void)writer.value()->addScene(scene);
            }
        }
        return writer;
    }

    /// @return number of ticks of a recording that is an intact prefix of `ticks`; otherwise -1 with a warning
    static std::int64_t prefixOf(const std::vector<servo::TickRecord>& ticks, const std::filesystem::path& file)
    {
        const auto reader = RecordingReader::open(file);
        core::Status status = reader.isOk() ? reader.value()->verify() : reader.status();
        std::int64_t count = 0;
        bool isSame = true;
        if (status.isOk()) {
            status = reader.value()->forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const auto& tick) {
                isSame = count < static_cast<std::int64_t>(ticks.size()) &&
                         test::isSameTick(tick, ticks[static_cast<std::size_t>(count)]);
                ++count;
                return isSame;
            });
        }
        if (!status.isOk() || !isSame) {
            qWarning("%s: %s", file.c_str(), status.isOk() ? "not what was recorded" : status.message().c_str());
            return -1;
        }
        return count;
    }

    static std::vector<core::Vec3> circling(int ticks)
    {
        std::vector<core::Vec3> motion;
        for (int i = 0; i < ticks; ++i) {
            const double t = i * 1e-3;
            motion.emplace_back(10.0 * std::sin(3.0 * t), 10.0 * std::cos(3.0 * t), 20.5 - std::sin(5.0 * t));
        }
        return motion;
    }

  private Q_SLOTS:
    /// Simulates a power loss after each operation; unsynced data are lost, kept, torn or reordered.
    void powerLossLeavesACleanPrefix()
    {
        const auto ticks = test::palpationTicks(1500);
        std::vector<FaultyDisk::Operation> log;
        test::DiskState before;
        {
            FaultyDisk disk;
            auto writer = begin(path("power.palpate"));
            QVERIFY2(writer.isOk(), writer.status().message().c_str());
            before["power.palpate"] = bytes("power.palpate");
            disk.startLog();
            for (const auto& tick : ticks) {
                disk.mark(tick.tick + 1); // in contact, so expected in the file
                QVERIFY(writer.value()->append(tick).isOk());
            }
            QVERIFY(writer.value()->finish().isOk());
            log = disk.takeLog();
        }
        QVERIFY(QDir(m_folder.path()).mkdir("after"));
        int states = 0;
        int rolledBack = 0;
        std::int64_t felt = 0;
        std::int64_t worst = 0;
        for (std::size_t end = 0; end <= log.size(); ++end) {
            if (end > 0 && log[end - 1].kind == FaultyDisk::Operation::Mark) {
                felt = log[end - 1].offset;
                continue; // no disk operation
            }
            for (std::uint32_t seed = 0; seed < 5; ++seed) {
                const auto files = test::afterPowerLoss(before, log, end, seed);
                for (const char* name : {"power.palpate", "power.palpate-journal"}) {
                    QFile::remove(m_folder.filePath(QString("after/") + name));
                }
                for (const auto& [name, content] : files) {
                    QFile file(m_folder.filePath("after/" + QString::fromStdString(name)));
                    QVERIFY(file.open(QIODevice::WriteOnly));
                    QCOMPARE(file.write(content.data(), static_cast<qint64>(content.size())), qint64(content.size()));
                }
                ++states;
                rolledBack += files.contains("power.palpate-journal") ? 1 : 0;
                const std::int64_t found = prefixOf(ticks, path("after/power.palpate"));
                QVERIFY2(found >= 0, qPrintable(QString("operation %1, seed %2").arg(end).arg(seed)));
                worst = std::max(worst, felt - found);
            }
        }
        qInfo("power lost in %d ways (%d with a journal left): each time a clean prefix, at most %lld ticks of 1 ms "
              "short",
              states, rolledBack, static_cast<long long>(worst));
        QVERIFY(states > 500 && rolledBack > 100);
        QVERIFY(worst <= 1000);
    }

    void anErrorAtAnyOperationLosesNothing_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("isLasting");
        QTest::newRow("one operation fails") << SQLITE_IOERR << false;
        QTest::newRow("the disk is full for a moment") << SQLITE_FULL << false;
        QTest::newRow("the disk is gone") << SQLITE_IOERR << true;
        QTest::newRow("the disk stays full") << SQLITE_FULL << true;
    }

    void anErrorAtAnyOperationLosesNothing()
    {
        QFETCH(int, code);
        QFETCH(bool, isLasting);
        const auto ticks = test::palpationTicks(1100);
        int failed = 0;
        int unmade = 0;
        for (std::int64_t k = 0;; ++k) {
            FaultyDisk disk;
            const auto file = path("error.palpate");
            std::filesystem::remove(file);
            std::filesystem::remove(path("error.palpate-journal"));
            disk.failAt(k, isLasting, code);
            auto writer = begin(file);
            if (!writer.isOk()) {
                QVERIFY(!std::filesystem::exists(file)); // and no companion file
                QCOMPARE(QDir(m_folder.path()).entryList({"error*"}, QDir::Files).size(), 0);
                QVERIFY(writer.status().message().find("error.palpate: cannot be written") != std::string::npos);
                ++unmade;
                continue;
            }
            for (const auto& tick : ticks) {
                (void)writer.value()->append(tick);
            }
            core::Status ended = writer.value()->finish();
            if (!ended.isOk() && !isLasting) {
                ended = writer.value()->finish(); // the error lost no data
            }
            const bool hasHappened = disk.operations() > k;
            writer = core::Status(core::StatusCode::Internal, core::Message()); // closes the file while the disk fails
            disk.heal();
            const std::int64_t found = prefixOf(ticks, file);
            QVERIFY2(found >= 0, qPrintable(QString("operation %1").arg(k)));
            if (!isLasting || !hasHappened) {
                QVERIFY2(ended.isOk(), ended.message().c_str());
                QCOMPARE(found, std::int64_t{1100});
            } else {
                QVERIFY(!ended.isOk());
            }
            if (!hasHappened) {
                break;
            }
            ++failed;
        }
        qInfo("%d operations failed one by one while recording, %d while the file was made", failed, unmade);
        QVERIFY(failed > 50 && unmade > 5);
    }

    /// As with a quota: SQLite's error does not name the cause, and errno may belong to a later call.
    void aLimitBelowTheSizeOfTheFileIsAFullDisk()
    {
        test::FaultyDisk disk;
        disk.loseErrno();
        auto writer = begin(path("limit.palpate"));
        QVERIFY2(writer.isOk(), writer.status().message().c_str());
        core::Status status;
        const auto ticks = test::palpationTicks(40'000);
        const auto append = [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to && status.isOk(); ++i) {
                status = writer.value()->append(ticks[i]);
            }
        };
        append(0, 20'000);
        QVERIFY2(status.isOk(), status.message().c_str());
        QVERIFY(std::filesystem::file_size(path("limit.palpate")) > 1'000'000);
        {
            const test::FileLimit limit(
                100'000); // the journal of a transaction fits, so it is the recording that fails
            append(20'000, 40'000);
            status = status.isOk() ? writer.value()->finish() : status;
        }
        QVERIFY2(status.code() == core::StatusCode::NoSpace, status.message().c_str());
    }

    /// The disk blocks for more than a second, three times: the servo loop continues and no tick is lost.
    void aStallingDiskNeverStallsTheTouch()
    {
        FaultyDisk disk;
        device::PlaybackDevice device(circling(60000));
        servo::ServoLoop loop;
        servo::ServoOptions options;
        options.askRealtime = false;
        loop.setScene(test::boxScene(0.5, 0.001));
        session::Recorder recorder(loop);
        QVERIFY(loop.start(device, options).isOk());
        QVERIFY(recorder.start(path("stall.palpate"), {}, test::palpationScenes()[0]).isOk());
        for (int i = 0; i < 3; ++i) {
            QVERIFY(test::letPass(loop, 300));
            disk.hold();
            QVERIFY(test::letPass(loop, 1000)); // the servo does not wait for the disk
            recorder.addEvent("note", "{}");    // nor does the GUI thread
            QVERIFY(recorder.status().isRecording);
            disk.release();
        }
        const core::Status stopped = recorder.stop();
        QVERIFY2(stopped.isOk(), stopped.message().c_str());
        loop.stop();
        const auto reader = RecordingReader::open(path("stall.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->extent().dropped, std::int64_t{0});
        QCOMPARE(reader.value()->extent().late, std::optional(static_cast<std::int64_t>(recorder.status().late)));
        QVERIFY(reader.value()->extent().ticks >= 3900);
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        qInfo("three stalls of 1000 ticks: %lld ticks recorded, none dropped",
              static_cast<long long>(reader.value()->extent().ticks));
    }

    /// On a disk slower than the servo the recording goes on, and stops with the tick at which it is told to.
    void aSlowDiskDelaysTheEndButNotForEver()
    {
        FaultyDisk disk;
        device::PlaybackDevice device(circling(60000));
        servo::ServoLoop loop;
        servo::ServoOptions options;
        options.askRealtime = false;
        loop.setScene(test::boxScene(0.5, 0.001));
        session::Recorder recorder(loop);
        QVERIFY(loop.start(device, options).isOk());
        QVERIFY(recorder.start(path("slow.palpate"), {}, test::palpationScenes()[0]).isOk());
        disk.slowDown(20); // a store of 250 ticks has some 30 writes
        QVERIFY(test::letPass(loop, 1500));
        const auto written = recorder.status().ticks;
        PALPATE_TRY_VERIFY(recorder.status().ticks > written);

        const auto newestTick = [&loop] {
            servo::TickRecord tick;
            while (loop.isRunning() && !loop.fetchSnapshot(tick)) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return tick.tick;
        };
        const std::int64_t before = newestTick();
        recorder.requestStop();
        const std::int64_t after = newestTick();
        auto stopping = std::async(std::launch::async, [&] { return recorder.stop(); });
        const auto state = stopping.wait_for(std::chrono::minutes(1));
        disk.slowDown(0); // so that the test ends
        QCOMPARE(state, std::future_status::ready);
        const core::Status stopped = stopping.get();
        QVERIFY2(stopped.isOk(), stopped.message().c_str());
        loop.stop();
        const auto reader = RecordingReader::open(path("slow.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const session::RecordingExtent& extent = reader.value()->extent();
        QCOMPARE(extent.end, session::RecordingEnd::Closed);
        QCOMPARE(extent.dropped, std::int64_t{0});
        // When the request came, the tick that follows the snapshot `after` may have begun.
        QVERIFY2(extent.lastTick >= before && extent.lastTick <= after + 1,
                 qPrintable(QString("%1 %2 %3").arg(before).arg(extent.lastTick).arg(after)));
    }

    void aDiskThatGetsFullEndsTheRecording_data()
    {
        QTest::addColumn<bool>("hasRoomForLastWords");
        QTest::newRow("with room for its last words") << true;
        QTest::newRow("without") << false;
    }

    /// The recording ends at once with a reason and a valid file; the servo loop continues.
    void aDiskThatGetsFullEndsTheRecording()
    {
        QFETCH(bool, hasRoomForLastWords);
        FaultyDisk disk;
        device::PlaybackDevice device(circling(60000));
        servo::ServoLoop loop;
        servo::ServoOptions options;
        options.askRealtime = false;
        loop.setScene(test::boxScene(0.5, 0.001));
        session::Recorder recorder(loop);
        QVERIFY(loop.start(device, options).isOk());
        const auto file = path("full.palpate");
        std::filesystem::remove(file); // from the previous row
        std::filesystem::remove(path("next.palpate"));
        QVERIFY(recorder.start(file, {}, test::palpationScenes()[0]).isOk());
        QVERIFY(test::letPass(loop, 900));
        disk.failAt(0, !hasRoomForLastWords, SQLITE_FULL); // the reserve has room for all writes but the first
        PALPATE_TRY_VERIFY(!recorder.status().isRecording);
        const session::RecorderStatus status = recorder.status();
        QVERIFY(status.hasFailed);
        QVERIFY2(
            QString::fromStdString(status.problem.english())
                .contains(QRegularExpression("^.*full\\.palpate: the recording ended at \\d\\.\\d s because the disk "
                                             "is full; what was felt after is not in it$")),
            status.problem.english().c_str());
        QVERIFY(test::letPass(loop, 300));
        const core::Status stopped = recorder.stop();
        QCOMPARE(stopped.code(), core::StatusCode::NoSpace);
        QCOMPARE(stopped.message(), status.problem.english());
        disk.heal();

        const auto reader = RecordingReader::open(file);
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        const session::RecordingExtent& extent = reader.value()->extent();
        QCOMPARE(extent.ticks, status.ticks);
        QVERIFY(extent.ticks > 500 && std::abs(extent.duration_s - status.duration_s) < 0.01);
        QCOMPARE(extent.dropped, std::int64_t{0});
        QVERIFY(!extent.isComplete);
        QCOMPARE(extent.end, hasRoomForLastWords ? session::RecordingEnd::DiskFull : session::RecordingEnd::CutOff);
        const std::string ending = session::endingText(extent).english();
        QVERIFY2(ending.find(hasRoomForLastWords ? "because the disk was full" : "or a full disk") != std::string::npos,
                 ending.c_str());
        QVERIFY(session::resimulate(*reader.value(), test::boxSurfaces()).value().isSame());
        // The next recording is complete.
        QVERIFY(recorder.start(path("next.palpate"), {}, test::palpationScenes()[0]).isOk());
        QVERIFY(test::letPass(loop, 300) && !recorder.status().hasFailed);
        QVERIFY(recorder.stop().isOk());
        QCOMPARE(RecordingReader::open(path("next.palpate")).value()->extent().end, session::RecordingEnd::Closed);
    }

    /// A small ring cannot hold the ticks of a long block: the loss is counted, and the rest is valid.
    void whatAStallCostsIsCounted()
    {
        FaultyDisk disk;
        device::PlaybackDevice device(circling(60000));
        servo::ServoLoop loop;
        servo::ServoOptions options;
        options.askRealtime = false;
        options.ringCapacity = 256;
        loop.setScene(test::boxScene(0.5, 0.001));
        session::Recorder recorder(loop);
        QVERIFY(loop.start(device, options).isOk());
        QVERIFY(recorder.start(path("drop.palpate"), {}, test::palpationScenes()[0]).isOk());
        QVERIFY(test::letPass(loop, 600));
        disk.hold();
        QVERIFY(test::letPass(loop, 1200));
        disk.release();
        QVERIFY(test::letPass(loop, 600));
        const core::Status stopped = recorder.stop();
        QVERIFY(stopped.message().find("ticks were lost") != std::string::npos); // the user is informed
        loop.stop();
        const auto lost = static_cast<std::int64_t>(recorder.status().dropped);
        const auto reader = RecordingReader::open(path("drop.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(lost >= 500);
        QCOMPARE(reader.value()->extent().dropped, lost);
        const auto& events = reader.value()->events();
        const auto told = std::find_if(events.begin(), events.end(),
                                       [](const session::RecordingEvent& event) { return event.kind == "dropped"; });
        QVERIFY(told != events.end());
        QCOMPARE(QString::fromStdString(told->json), QString("{\"ticks\": %1}").arg(lost));
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        std::int64_t expected = reader.value()->extent().firstTick;
        int gaps = 0;
        int marked = 0;
        QVERIFY(reader.value()
                    ->forEach(0, std::numeric_limits<std::int64_t>::max(),
                              [&](const servo::TickRecord& tick) {
                                  gaps += tick.tick != std::exchange(expected, tick.tick + 1) ? 1 : 0;
                                  marked += (tick.flags & servo::kDroppedBefore) != 0 ? 1 : 0;
                                  return true;
                              })
                    .isOk());
        QVERIFY(gaps >= 1);
        QCOMPARE(marked, gaps);
        QVERIFY(session::resimulate(*reader.value(), test::boxSurfaces()).value().isSame());
        qInfo("a stall of 1200 ticks with room for 256: %lld dropped and counted", static_cast<long long>(lost));
    }
};

PALPATE_TEST(DiskFaults)
#include "tst_DiskFaults.moc"
