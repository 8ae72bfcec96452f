// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "FileLimits.h"
#include "Sessions.h"
#include "TestRunner.h"
#include "Trials.h"
#include "recording/RecordingCopy.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <limits>
#include <map>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palpate;
using session::RecordingReader;

class Recovery : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    QByteArray bytes(const char* name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    void write(const char* name, const QByteArray& content) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }

    static QByteArray read(const std::filesystem::path& name)
    {
        QFile file(QString::fromStdString(name.string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Lists the temporary files of a recovery.
    QStringList scratch() const
    {
        return QDir(m_folder.path())
            .entryList({".palpate-*", "*-part*", "*-source*", "*-pages*"},
                       QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoSymLinks);
    }

    static bool says(const session::Recovery& recovery, const char* text)
    {
        return std::any_of(recovery.losses.begin(), recovery.losses.end(),
                           [&](const core::Message& line) { return line.english().find(text) != std::string::npos; });
    }

    /// Counts ticks of the copy that differ from every recorded tick in any bit. Times are compared relative to the
    /// copy's first tick.
    static int foreignTicks(const RecordingReader& copy, const std::vector<servo::TickRecord>& recorded)
    {
        int foreign = 0;
        std::optional<std::int64_t> shift_ns;
        (void)copy.forEach(0, std::numeric_limits<std::int64_t>::max(), [&](servo::TickRecord tick) {
            if (tick.tick >= static_cast<std::int64_t>(recorded.size())) {
                ++foreign;
                return true;
            }
            const servo::TickRecord& was = recorded[static_cast<std::size_t>(tick.tick)];
            shift_ns = shift_ns.value_or(was.time_ns - tick.time_ns);
            tick.time_ns += *shift_ns;
            foreign += test::isSameTick(tick, was) ? 0 : 1;
            return true;
        });
        return foreign;
    }

  private Q_SLOTS:
    void ofASoundRecordingLosesNothing()
    {
        const auto ticks = test::palpationTicks(1100);
        QVERIFY(test::writeRecording(path("a.palpate"), ticks));
        const auto result = session::recoverRecording(path("a.palpate"), path("b.palpate"));
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().losses.empty(),
                 result.value().losses.empty() ? "" : result.value().losses[0].english().c_str());
        QCOMPARE(result.value().ticks, std::int64_t{1100});
        const auto from = RecordingReader::open(path("a.palpate"));
        const auto to = RecordingReader::open(path("b.palpate"));
        QVERIFY2(to.isOk(), to.status().message().c_str());
        QVERIFY(to.value()->extent().isComplete);
        QVERIFY2(to.value()->verify().isOk(), to.value()->verify().message().c_str());
        QCOMPARE(foreignTicks(*to.value(), ticks), 0);
        QCOMPARE(to.value()->info().startedUtc, from.value()->info().startedUtc);
        QCOMPARE(to.value()->events().size(), from.value()->events().size());
        QVERIFY(session::resimulate(*to.value(), test::boxSurfaces()).value().isSame());
        QVERIFY(!session::recoverRecording(path("a.palpate"), path("a.palpate")).isOk());
        QVERIFY(!session::recoverRecording(path("none.palpate"), path("b.palpate")).isOk());
    }

    void ofACutOffOneSaysThatTheEndIsMissing()
    {
        QVERIFY(test::writeRecording(path("c.palpate"), test::palpationTicks(700), false));
        const auto result = session::recoverRecording(path("c.palpate"), path("d.palpate"));
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QCOMPARE(result.value().losses.size(), std::size_t{1});
        QVERIFY(says(result.value(), "nothing is known after tick 699"));
        const auto copy = RecordingReader::open(path("d.palpate"));
        QVERIFY(!copy.value()->extent().isComplete);
        QCOMPARE(copy.value()->events().back().kind, std::string("recovered"));
        QVERIFY(copy.value()->verify().isOk());
    }

    void leavesOutWhatIsNotAsItWasWritten()
    {
        const auto ticks = test::palpationTicks(2000);
        QVERIFY(test::writeRecording(path("e.palpate"), ticks));
        QVERIFY(test::runSql(path("e.palpate"), "UPDATE ticks SET hip_x = hip_x + 1e-9 WHERE tick = 1234;"
                                                "UPDATE meta SET value = 'nonsense' WHERE key = 'dt_s'"));
        const QByteArray before = bytes("e.palpate");
        const auto result = session::recoverRecording(path("e.palpate"), path("f.palpate"));
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY(says(result.value(), "ticks 1000 to 1249: left out"));
        QVERIFY(says(result.value(), "dt_s cannot be read"));
        QCOMPARE(result.value().ticks, std::int64_t{1750});
        QCOMPARE(bytes("e.palpate"), before);
        const auto copy = RecordingReader::open(path("f.palpate"));
        QVERIFY2(copy.isOk(), copy.status().message().c_str());
        QCOMPARE(copy.value()->extent().dropped, std::int64_t{250});
        QCOMPARE(foreignTicks(*copy.value(), ticks), 0);
        const auto again = session::resimulate(*copy.value(), test::boxSurfaces());
        QVERIFY2(again.isOk() && again.value().isSame(), again.isOk() ? "" : again.status().message().c_str());
        QVERIFY(again.value().compared > 1000);
    }

    /// Overwrites one page after the other: no altered data is recovered, whichever page is hit, and the content of the
    /// other pages is, even if the first page or an inner page led to them.
    void savesWhatADamagedPageLeaves_data()
    {
        QTest::addColumn<bool>("isZeroed");
        QTest::newRow("other bytes") << false;
        QTest::newRow("zeros") << true;
    }
    void savesWhatADamagedPageLeaves()
    {
        QFETCH(const bool, isZeroed);
        const auto ticks = test::palpationTicks(1500);
        QVERIFY(test::writeRecording(path("g.palpate"), ticks));
        const QByteArray good = bytes("g.palpate");
        constexpr qsizetype kPage = 4096;
        int pages = 0;
        std::int64_t saved = 0;
        std::int64_t least = 1500;
        int refused = 0;
        for (qsizetype page = 0; page * kPage < good.size(); ++page) {
            QByteArray bad = good;
            for (qsizetype i = page * kPage; i < std::min(bad.size(), (page + 1) * kPage); ++i) {
                bad[i] = isZeroed ? char(0) : static_cast<char>(bad[i] ^ static_cast<char>(37 * i + 11));
            }
            write("h.palpate", bad);
            QFile::remove(m_folder.filePath("i.palpate"));
            ++pages;
            const auto damaged = RecordingReader::open(path("h.palpate"));
            QVERIFY2(damaged.isOk() || damaged.status().message().ends_with("; copy the readable parts with `palpate "
                                                                            "session recover`"),
                     damaged.status().message().c_str());
            refused += damaged.isOk() ? 0 : 1;
            const auto result = session::recoverRecording(path("h.palpate"), path("i.palpate"));
            QVERIFY2(result.isOk(), result.status().message().c_str());
            const auto copy = RecordingReader::open(path("i.palpate"));
            QVERIFY2(copy.isOk(), copy.status().message().c_str());
            QVERIFY2(copy.value()->verify().isOk(), copy.value()->verify().message().c_str());
            QCOMPARE(foreignTicks(*copy.value(), ticks), 0);
            QCOMPARE(copy.value()->extent().ticks, result.value().ticks);
            QVERIFY2(result.value().ticks == 1500 || !result.value().losses.empty(), qPrintable(QString::number(page)));
            saved += result.value().ticks;
            least = std::min(least, result.value().ticks);
        }
        QCOMPARE(scratch(), QStringList());
        qInfo("%d pages damaged one by one: %.1f %% of the ticks saved, at least %lld of 1500", pages,
              100.0 * double(saved) / (1500.0 * pages), static_cast<long long>(least));
        QVERIFY(refused > 0);
        QVERIFY(least >= 1000); // a page holds ticks of one or two blocks of 250
    }

    /// Truncates the file at any position, as after an interrupted copy or on a damaged file system.
    void savesWhatACutLeaves()
    {
        const auto ticks = test::palpationTicks(20'000);
        QVERIFY(test::writeRecording(path("l.palpate"), ticks));
        const QByteArray good = bytes("l.palpate");
        for (const int share : {25, 50, 75, 99}) {
            write("m.palpate", good.left(good.size() * share / 100));
            const auto result = session::recoverRecording(path("m.palpate"), path("n.palpate"));
            QVERIFY2(result.isOk(), result.status().message().c_str());
            const auto copy = RecordingReader::open(path("n.palpate"));
            QVERIFY2(copy.isOk(), copy.status().message().c_str());
            QCOMPARE(foreignTicks(*copy.value(), ticks), 0);
            QVERIFY(session::resimulate(*copy.value(), test::boxSurfaces()).value().isSame());
            qInfo("cut at %d %%: %lld of 20000 ticks saved", share, static_cast<long long>(result.value().ticks));
            QVERIFY(result.value().ticks >= 200 * share - 500); // pages are written in tick order
            // The mark of a closed recording is in the part that is left.
            QVERIFY(!copy.value()->extent().isComplete);
            QVERIFY(says(result.value(), "the end may be missing"));
        }
    }

    /// The report includes the reason for the rejection, and the ticks are recovered nevertheless.
    void anotherProgramsHeaderIsNamed()
    {
        QVERIFY(test::writeRecording(path("foreign.palpate"), test::palpationTicks(2000)));
        QVERIFY(test::runSql(path("foreign.palpate"), "PRAGMA application_id = 7"));
        const auto result = session::recoverRecording(path("foreign.palpate"), path("foreign-copy.palpate"));
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QCOMPARE(result.value().ticks, std::int64_t{2000});
        const std::string loss = result.value().losses.front().english();
        QVERIFY2(loss.starts_with("found another program's SQLite database"), loss.c_str());
    }

    void aFileThatIsNoRecordingIsLeftAlone()
    {
        for (const QByteArray& content : {QByteArray(), QByteArray("no database"), QByteArray(40960, 0),
                                          QByteArray(40960, 0x0d), QByteArray(40960, char(0xff))}) {
            write("o.palpate", content);
            const auto result = session::recoverRecording(path("o.palpate"), path("p.palpate"));
            QVERIFY(!result.isOk());
            QVERIFY(result.status().message().find("found no SQLite database") != std::string::npos);
            QVERIFY(!QFile::exists(m_folder.filePath("p.palpate")));
        }
    }

    void aPipeOrDeviceIsNotReplaced()
    {
        QVERIFY(test::writeRecording(path("e.palpate"), test::palpationTicks(2000)));
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        const auto recovered = session::recoverRecording(path("e.palpate"), path("pipe"));
        QVERIFY(recovered.status().message().ends_with("pipe: cannot be written: not a file"));
        QVERIFY(std::filesystem::is_fifo(path("pipe")));
    }

    /// File names in the copy's folder may belong to other users.
    void followsNoLink()
    {
        QVERIFY(test::writeRecording(path("q.palpate"), test::palpationTicks(300)));
        write("precious", "theirs");
        const QString pid = QString::number(QCoreApplication::applicationPid());
        for (const QString& name : {"r.palpate-source" + pid, "r.palpate-pages" + pid, "r.palpate-part" + pid,
                                    "." + pid + ".part", QString("r.palpate")}) {
            QVERIFY(QFile::link("precious", m_folder.filePath(name)));
        }
        QVERIFY(session::recoverRecording(path("q.palpate"), path("r.palpate")).isOk());
        QCOMPARE(bytes("precious"), QByteArray("theirs"));
        QVERIFY(!std::filesystem::is_symlink(path("r.palpate"))); // replaces the link itself
        QVERIFY(RecordingReader::open(path("r.palpate")).isOk());

        QVERIFY(QFile::link("precious", m_folder.filePath("q.palpate-journal")));
        const auto refused = session::recoverRecording(path("q.palpate"), path("s.palpate"));
        QVERIFY2(refused.status().message().find("q.palpate-journal: found something else than a file") !=
                     std::string::npos,
                 refused.status().message().c_str());
        QCOMPARE(bytes("precious"), QByteArray("theirs"));
        QVERIFY(QFile::remove(m_folder.filePath("q.palpate-journal")));
        QCOMPARE(scratch(), QStringList());
    }

    /// A file with a nominal size of a terabyte costs no more than its allocated pages.
    void copiesOnlyWhatSqliteCounts()
    {
        QVERIFY(test::writeRecording(path("t.palpate"), test::palpationTicks(1000)));
        const std::uintmax_t size = std::filesystem::file_size(path("t.palpate"));
        std::filesystem::resize_file(path("t.palpate"), std::uintmax_t{1} << 40);
        const auto recovered = session::recoverRecording(path("t.palpate"), path("u.palpate"));
        QVERIFY2(recovered.isOk(), recovered.status().message().c_str());
        QCOMPARE(recovered.value().ticks, std::int64_t{1000});
        QVERIFY(std::filesystem::file_size(path("u.palpate")) < 2 * size);

        const auto folder = core::Scratch::create(path("u.palpate"), core::Scratch::Kind::Folder);
        QVERIFY(
            session::internal::copyRecording(path("t.palpate"), *folder.value(), "counted", path("u.palpate")).isOk());
        QCOMPARE(std::filesystem::file_size(folder.value()->path() / "counted"), size);
        std::filesystem::resize_file(path("t.palpate"), size);
        QCOMPARE(read(folder.value()->path() / "counted"), bytes("t.palpate"));
        // Without a valid header: the whole file including holes.
        write("v", QByteArray(5000, 'x'));
        std::filesystem::resize_file(path("v"), std::uintmax_t{1} << 30);
        QVERIFY(session::internal::copyRecording(path("v"), *folder.value(), "all", path("u.palpate")).isOk());
        struct stat is
        {
        };
        QCOMPARE(::stat((folder.value()->path() / "all").c_str(), &is), 0);
        QCOMPARE(is.st_size, off_t{1} << 30);
        QVERIFY2(is.st_blocks < 1000, qPrintable(QString::number(is.st_blocks)));
        QVERIFY(!session::internal::copyRecording(path("v"), *folder.value(), "all", path("u.palpate")).isOk());
    }

    void aFullDiskLeavesNothing()
    {
        QVERIFY(test::writeRecording(path("w.palpate"), test::palpationTicks(1000)));
        const auto size = static_cast<rlim_t>(std::filesystem::file_size(path("w.palpate")));
        write("x.palpate", bytes("w.palpate").left(4096));
        const QByteArray old = bytes("x.palpate");
        for (rlim_t limit = 0; limit < size; limit += test::kIsSanitized ? 30'011 : 3'001) {
            const test::FileLimit full(limit);
            const auto recovered = session::recoverRecording(path("w.palpate"), path("x.palpate"));
            QVERIFY(!recovered.isOk());
            QCOMPARE(bytes("x.palpate"), old);
            QCOMPARE(scratch(), QStringList());
        }
    }

    void aKilledOneLeavesNothing()
    {
        QVERIFY(test::writeRecording(path("y.palpate"), test::palpationTicks(30'000)));
        int killed = 0;
        for (const int signal : {SIGTERM, SIGHUP, SIGINT, SIGTERM}) {
            const pid_t child = ::fork();
            if (child == 0) {
                (void)std::signal(signal, SIG_DFL); // Qt Test installs its own handler
                core::removeScratchOnSignals();
                ::_exit(session::recoverRecording(path("y.palpate"), path("z.palpate")).isOk() ? 0 : 1);
            }
            PALPATE_TRY_VERIFY(!scratch().isEmpty() || ::waitpid(child, nullptr, WNOHANG) != 0);
            (void)::kill(child, signal);
            int status = 0;
            ::waitpid(child, &status, 0);
            killed += WIFSIGNALED(status) && WTERMSIG(status) == signal ? 1 : 0;
            QCOMPARE(scratch(), QStringList());
        }
        QVERIFY(killed > 0);
    }

    void keepsEmbeddedSurfaces()
    {
        const geometry::RepairedMesh box =
            geometry::repair(test::box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20), 4));
        const std::string hash = session::geometryHash(box.mesh);
        auto scene = test::palpationScenes()[0];
        scene.structures[0].source.sha256 = hash;
        scene.structures[0].source.embed = std::make_shared<const geometry::RepairedMesh>(box);
        {
            auto writer = session::RecordingWriter::create(path("j.palpate"), {});
            QVERIFY(writer.value()->addScene(scene).isOk());
            QVERIFY(!writer.value()->addScene(scene).isOk()); // already described
            scene.generation = 2;                             // the same surface again
            QVERIFY(writer.value()->addScene(scene).isOk());
            QVERIFY(writer.value()->finish().isOk());
        }
        QVERIFY(session::recoverRecording(path("j.palpate"), path("k.palpate")).value().losses.empty());
        for (const char* name : {"j.palpate", "k.palpate"}) {
            const auto reader = RecordingReader::open(path(name));
            QCOMPARE(reader.value()->embeddedHashes(), std::vector<std::string>{hash});
            const auto surface = reader.value()->embedded(hash);
            QVERIFY2(surface.isOk(), surface.status().message().c_str());
            QVERIFY(surface.value().mesh.vertices == box.mesh.vertices);
            QVERIFY(surface.value().mesh.triangles == box.mesh.triangles);
            QCOMPARE(surface.value().source, box.source);
            QCOMPARE(surface.value().twoSided, box.twoSided);
            QCOMPARE(reader.value()->embedded("none").status().code(), core::StatusCode::NotFound);
        }
        QVERIFY(test::runSql(path("j.palpate"), "UPDATE embedded SET two_sided = zeroblob(length(two_sided) - 1)"));
        const auto reader = RecordingReader::open(path("j.palpate"));
        QCOMPARE(reader.value()->embedded(hash).status().code(), core::StatusCode::Mismatch);
        QVERIFY(reader.value()->verify().message().find("embedded surface") != std::string::npos);
        QVERIFY(says(session::recoverRecording(path("j.palpate"), path("k.palpate")).value(), "embedded surface"));
    }

    /// Each change is reported with its tick, whether the scene is described before or after its first use.
    void eventsSayWhatChangedAndWhen()
    {
        QVERIFY(test::writeRecording(path("l.palpate"), test::palpationTicks(600)));
        const auto reader = RecordingReader::open(path("l.palpate"));
        std::multimap<std::string, std::int64_t> events;
        for (const auto& event : reader.value()->events()) {
            events.emplace(event.kind, event.tick);
        }
        QCOMPARE(events.count("scene"), std::size_t{2});
        QCOMPARE(events.find("tissue")->second, std::int64_t{250});
        QCOMPARE(events.count("clutch"), std::size_t{2});
        QCOMPARE(events.find("clutch")->second, std::int64_t{400});

        auto scenes = test::palpationScenes();
        scenes[1].structures[0].palpable = false;
        scenes[1].structures[0].layer = 2;
        auto writer = session::RecordingWriter::create(path("late.palpate"), {});
        servo::TickRecord tick;
        for (tick.tick = 0; tick.tick < 6; ++tick.tick) {
            tick.scene = tick.tick < 3 ? 1 : 2;
            QVERIFY(writer.value()->append(tick).isOk());
        }
        QVERIFY(writer.value()->commit().isOk());
        QVERIFY(writer.value()->addScene(scenes[1]).isOk());
        QVERIFY(writer.value()->addScene(scenes[0]).isOk());
        QVERIFY(writer.value()->finish().isOk());
        QStringList kinds;
        const auto late = RecordingReader::open(path("late.palpate"));
        for (const auto& event : late.value()->events()) {
            kinds << QString("%1@%2").arg(QString::fromStdString(event.kind)).arg(event.tick);
        }
        QCOMPARE(kinds, (QStringList{"scene@0", "scene@3", "hidden@3", "tissue@3", "layer@3"}));
    }
};

PALPATE_TEST(Recovery)
#include "tst_Recovery.moc"
