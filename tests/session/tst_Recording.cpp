// SPDX-License-Identifier: BSD-3-Clause
#include "Sessions.h"
#include "TestRunner.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <bit>
#include <cstring>
#include <limits>

#include <sys/resource.h>

using namespace palpate;
using session::RecordingReader;

class Recording : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static std::vector<servo::TickRecord> all(const RecordingReader& reader)
    {
        std::vector<servo::TickRecord> ticks;
        const auto status = reader.forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const auto& tick) {
            ticks.push_back(tick);
            return true;
        });
        return status.isOk() ? ticks : std::vector<servo::TickRecord>();
    }

    core::Result<std::unique_ptr<session::RecordingWriter>> create(const char* name, core::ExistingFile old) const
    {
        return session::RecordingWriter::create(path(name), {}, session::RecordingWriter::Sync::AtEnd,
                                                session::RecordingWriter::Events::AsGiven, old);
    }
    /// Lists the recording with that name, its companion files and temporary files.
    QStringList left(const char* name) const
    {
        return QDir(m_folder.path()).entryList({name, ".palpate-*"}, QDir::AllEntries | QDir::Hidden);
    }

  private Q_SLOTS:
    void givesBackEveryBit()
    {
        auto ticks = test::palpationTicks(2000);
        // Values that a table may alter: the sign of zero, the smallest and largest numbers, integers.
        ticks[10].p_WH = core::Vec3(-0.0, 0.0, 5e-324);
        ticks[10].felt.p_WG = core::Vec3(0.0, 0.0, 5e-324);
        ticks[10].felt.f_W = core::Vec3(-0.0, 0.0, 0.0);
        ticks[11].fSent_W = core::Vec3(3.0, -7.0, 1e30);
        ticks[12].buttons = 0xffffffffu;
        ticks[12].solve_ns = 0xffffffffu;
        QVERIFY(test::writeRecording(path("a.palpate"), ticks));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const auto read = all(*reader.value());
        QCOMPARE(read.size(), ticks.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            QVERIFY2(test::isSameTick(read[i], ticks[i]), std::to_string(i).c_str());
        }
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        QCOMPARE(reader.value()->extent().ticks, std::int64_t{2000});
        QVERIFY(reader.value()->extent().isComplete);
        QCOMPARE(QDir(m_folder.path()).entryList({"a.palpate*"}, QDir::Files).size(), 1);
    }

    void keepsScenesEventsAndStart()
    {
        session::RecordingInfo info;
        info.device.name = "a device";
        info.device.maxForce_N = 3.3;
        info.scene = "liver.palpate.json";
        info.firstTick = 41;
        info.firstGeneration = 1;
        info.start.layers[1].p_WG = core::Vec3(0.1, -0.0, 1e300);
        info.start.layers[1].side[2] = -1;
        info.start.layers[1].constraints = 3;
        info.start.layers[1].placed = haptics::GodObjectState::kTight;
        info.start.started = 1;
        {
            auto writer = session::RecordingWriter::create(path("b.palpate"), info);
            QVERIFY(writer.isOk());
            for (const auto& scene : test::palpationScenes()) {
                QVERIFY(writer.value()->addScene(scene).isOk());
            }
            QVERIFY(writer.value()->addEvent({50, "note", "{\"text\": \"h\\u00e4rter\"}"}).isOk());
            QVERIFY(writer.value()->finish().isOk());
        }
        const auto opened = RecordingReader::open(path("b.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const RecordingReader& reader = *opened.value();
        QCOMPARE(reader.info().device.name, std::string("a device"));
        QCOMPARE(reader.info().device.maxForce_N, 3.3);
        QCOMPARE(reader.info().scene, info.scene);
        QCOMPARE(reader.info().firstTick, std::int64_t{41});
        QVERIFY(std::signbit(reader.info().start.layers[1].p_WG.y()));
        QCOMPARE(reader.info().start.layers[1].p_WG, info.start.layers[1].p_WG);
        QCOMPARE(reader.info().start.layers[1].side[2], std::int8_t{-1});
        QCOMPARE(reader.info().start.layers[1].placed, haptics::GodObjectState::kTight);
        QCOMPARE(reader.info().start.started, 1u);
        QCOMPARE(reader.scenes().size(), std::size_t{2});
        QCOMPARE(reader.scene(2)->structures.at(0).name, std::string("box"));
        QCOMPARE(reader.scene(2)->structures.at(0).tissue.stiffness_N_per_mm, 0.9);
        QCOMPARE(reader.scene(2)->structures.at(0).source.mesh, std::string("box.stl"));
        QVERIFY(reader.scene(3) == nullptr);
        QCOMPARE(reader.events().size(), std::size_t{1});
        QCOMPARE(reader.events()[0].kind, std::string("note"));
        QCOMPARE(reader.extent().ticks, std::int64_t{0});
    }

    void seeksByTick()
    {
        auto ticks = test::palpationTicks(1000);
        ticks.erase(ticks.begin() + 500, ticks.begin() + 600);
        QVERIFY(test::writeRecording(path("c.palpate"), ticks));
        const auto reader = RecordingReader::open(path("c.palpate"));
        QVERIFY(reader.isOk());
        QCOMPARE(reader.value()->at(499)->tick, std::int64_t{499});
        QCOMPARE(reader.value()->at(550)->tick, std::int64_t{499});
        QCOMPARE(reader.value()->at(600)->tick, std::int64_t{600});
        QVERIFY(!reader.value()->at(-1));
        QCOMPARE(reader.value()->extent().dropped, std::int64_t{100});
        QVERIFY(reader.value()->verify().isOk());
        QCOMPARE(reader.value()->motion().value().p_WH.size(), std::size_t{1000 - 100 - 20}); // 20 ticks without a hand
    }

    /// Sizes of a ten-minute recording from resources/docs/recording.md, in MB.
    void tenMinutesTakeWhatTheDocumentSays_data()
    {
        QTest::addColumn<int>("layers");
        QTest::addColumn<bool>("isGateActing");
        QTest::addColumn<double>("said_MB");
        QTest::newRow("one layer") << 1 << false << 75.0;
        QTest::newRow("two layers") << 2 << false << 185.0;
        QTest::newRow("one layer, and the gate acts in each tick") << 1 << true << 100.0;
    }
    void tenMinutesTakeWhatTheDocumentSays()
    {
        QFETCH(int, layers);
        QFETCH(bool, isGateActing);
        QFETCH(double, said_MB);
        auto ticks = test::palpationTicks(350);
        while (!ticks.empty() && ticks.back().felt.structure < 0) {
            ticks.pop_back();
        }
        QVERIFY(!ticks.empty());
        servo::TickRecord pattern = ticks.back(); // presses
        pattern.felt.triangle = pattern.felt.contacts[0].triangle = 1'000'000;
        if (layers == 2) {
            pattern.felt.contacts[1] = pattern.felt.contacts[0];
            pattern.felt.contacts[1].structure = 1;
            pattern.felt.contactCount = 2;
        }
        ticks.clear();
        constexpr int kTicks = 20000;
        for (int i = 0; i < kTicks; ++i) {
            servo::TickRecord tick = pattern;
            tick.tick = 600000 + i;
            tick.time_ns = tick.tick * 1000003;
            tick.solve_ns = 70000;
            tick.fSent_W = tick.felt.f_W + (isGateActing ? core::Vec3(0.1, 0.1, 0.1) : core::Vec3::Zero());
            ticks.push_back(tick);
        }
        const auto bytesATick = [&](const core::Vec3& v_WH) {
            for (servo::TickRecord& tick : ticks) {
                tick.v_WH = v_WH;
            }
            const bool isWritten = test::writeRecording(path("d.palpate"), ticks);
            return isWritten ? double(std::filesystem::file_size(path("d.palpate"))) / kTicks : 1e9;
        };
        const double undamped = bytesATick(core::Vec3::Zero()), tenMinutes_MB = 0.6 * undamped;
        QVERIFY2(tenMinutes_MB < 1.05 * said_MB && tenMinutes_MB > 0.8 * said_MB,
                 qPrintable(QString("%1 bytes a tick, %2 MB").arg(undamped).arg(tenMinutes_MB)));
        const double damped = bytesATick(core::Vec3(0.1, 0.2, 0.3));
        QVERIFY(damped - undamped < 28.0); // three numbers of nine bytes, and page overhead
    }

    void findsAChangedTickAndNamesItsRange_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("range");
        QTest::newRow("a bit of the HIP") << "UPDATE ticks SET hip_z = hip_z + 1e-9 WHERE tick = 1234"
                                          << "ticks 1000 to 1249";
        QTest::newRow("a button") << "UPDATE ticks SET buttons = 1 WHERE tick = 3"
                                  << "ticks 0 to 249";
        QTest::newRow("lost row") << "DELETE FROM ticks WHERE tick = 700"
                                  << "ticks 500 to 749";
        QTest::newRow("lost block") << "DELETE FROM ticks WHERE tick BETWEEN 500 AND 749;"
                                       "DELETE FROM checks WHERE first = 500"
                                    << "a part of the recording was taken out";
        QTest::newRow("added row") << "CREATE TEMP TABLE added AS SELECT * FROM ticks WHERE tick = 9;"
                                      "UPDATE added SET tick = 5000; INSERT INTO ticks SELECT * FROM added"
                                   << "ticks 2000 to 5000";
        QTest::newRow("start state") << "UPDATE meta SET value = zeroblob(length(value)) WHERE key = 'start';"
                                        "UPDATE meta SET value = 'x' WHERE key = 'device_name'"
                                     << "metadata: found other bits";
        QTest::newRow("tissue") << "UPDATE structures SET stiffness_N_per_mm = 0.6 WHERE generation = 2"
                                << "scene 2: found other bits";
        QTest::newRow("name of a mesh") << "UPDATE meshes SET path = 'bow.stl'"
                                        << "scene 1: found other bits";
        QTest::newRow("lost structure") << "DELETE FROM structures WHERE generation = 1"
                                        << "scene 1: found 0 rows, expected 1";
        QTest::newRow("lost scene") << "DELETE FROM scenes WHERE generation = 2"
                                    << "scene 2: found 0 rows, expected 1";
        QTest::newRow("added scene") << "INSERT INTO scenes VALUES(3, 0, 0)"
                                     << "scene 3: found without a checksum";
        QTest::newRow("event") << "UPDATE events SET tick = tick + 1 WHERE kind = 'clutch'"
                               << "events 2 to ";
        QTest::newRow("added event") << "INSERT INTO events VALUES(99, 5, 'note', '{}')"
                                     << "event 99: found without a checksum";
        QTest::newRow("a line of the checks") << "DELETE FROM checks WHERE id = 4"
                                              << "a part of the recording was taken out";
        QTest::newRow("a hash") << "UPDATE checks SET sha256 = zeroblob(32) WHERE first = 500"
                                << "ticks 500 to 749: found other bits";
    }

    void findsAChangedTickAndNamesItsRange()
    {
        QFETCH(QString, sql);
        QFETCH(QString, range);
        QVERIFY(test::writeRecording(path("e.palpate"), test::palpationTicks(2000)));
        QVERIFY(test::runSql(path("e.palpate"), sql.toStdString()));
        const auto reader = RecordingReader::open(path("e.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const core::Status status = reader.value()->verify();
        QVERIFY2(status.message().find(range.toStdString()) != std::string::npos, status.message().c_str());
    }

    /// Blocks that were intact are read again without SHA-256, but not without a check.
    void findsATickThatChangesAfterItWasRead()
    {
        QVERIFY(test::writeRecording(path("again.palpate"), test::palpationTicks(2000)));
        const auto reader = RecordingReader::open(path("again.palpate"));
        const auto read = [&reader] {
            int ticks = 0;
            return reader.value()->forEach(0, 1999, [&](const servo::TickRecord&) { return ++ticks > 0; }).isOk()
                       ? ticks
                       : -1;
        };
        QCOMPARE(read(), 2000);
        QCOMPARE(read(), 2000);
        QVERIFY(reader.value()->faults().empty() && reader.value()->verify().isOk());
        QVERIFY(test::runSql(path("again.palpate"), "UPDATE ticks SET hip_x = hip_x + 1e-12 WHERE tick = 700"));
        QCOMPARE(read(), 1750); // without the block of 250 ticks
        QCOMPARE(reader.value()->faults().size(), std::size_t{1});
        QVERIFY(reader.value()->faults().front().english().find("ticks 500 to 749") != std::string::npos);
    }

    void checksCanBeCancelled()
    {
        QVERIFY(test::writeRecording(path("again.palpate"), test::palpationTicks(2000)));
        const auto reader = RecordingReader::open(path("again.palpate"));
        QCOMPARE(reader.value()->verify([](double) { return false; }).code(), core::StatusCode::Cancelled);
        QVERIFY(reader.value()->verify([](double share) { return share >= 0.0 && share <= 1.0; }).isOk());
    }

    /// Numbers that would give unbounded forces: the file is rejected, and the intact part can be recovered.
    void refusesATissueThatNoSceneHas_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("wrong");
        QTest::newRow("stiffness") << "UPDATE structures SET stiffness_N_per_mm = 1e300"
                                   << "for stiffness_N_per_mm, expected 0 to 1000";
        QTest::newRow("negative") << "UPDATE structures SET friction_static = -1"
                                  << "found -1 for friction_static, expected 0 to 5";
        QTest::newRow("nothing") << "UPDATE structures SET damping_Ns_per_mm = NULL"
                                 << "found nan for damping_Ns_per_mm";
        QTest::newRow("layer") << "UPDATE structures SET layer = -5"
                               << "found the layer -5, expected one from 0";
    }

    void refusesATissueThatNoSceneHas()
    {
        QFETCH(QString, sql);
        QFETCH(QString, wrong);
        QVERIFY(test::writeRecording(path("e.palpate"), test::palpationTicks(2000)));
        QVERIFY(test::runSql(path("e.palpate"), sql.toStdString()));
        const auto reader = RecordingReader::open(path("e.palpate"));
        QCOMPARE(reader.status().code(), core::StatusCode::BadFormat);
        QVERIFY2(reader.status().message().find(wrong.toStdString()) != std::string::npos,
                 reader.status().message().c_str());
    }

    /// Any flipped bit, sampled over the whole file, is detected and named or has no effect.
    void findsFlippedBits()
    {
        const auto ticks = test::palpationTicks(600);
        QVERIFY(test::writeRecording(path("f.palpate"), ticks));
        QFile original(m_folder.filePath("f.palpate"));
        QVERIFY(original.open(QIODevice::ReadOnly));
        const QByteArray good = original.readAll();
        const auto whole = RecordingReader::open(path("f.palpate"));
        const auto events = whole.value()->events().size();
        int flipped = 0;
        int inTicks = 0;
        int elsewhere = 0;
        int atOpening = 0;
        constexpr qsizetype kStride = 211; // bytes, to hit all kinds of positions
        for (qsizetype place = 0; place < good.size(); place += kStride) {
            QByteArray bad = good;
            bad[place] = static_cast<char>(bad[place] ^ (1 << (flipped % 8)));
            ++flipped;
            QFile file(m_folder.filePath("g.palpate"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bad);
            file.close();
            const auto reader = RecordingReader::open(path("g.palpate"));
            const core::Status status = reader.isOk() ? reader.value()->verify() : reader.status();
            if (!status.isOk()) {
                const QString said = QString::fromStdString(status.message());
                QVERIFY2(said.startsWith(m_folder.filePath("g.palpate") + ": "), qPrintable(said));
                QVERIFY2(!said.contains("cannot be written"), qPrintable(said)); // nothing is to be
                static const QRegularExpression kTicks("ticks -?\\d+ to \\d+");
                static const QRegularExpression kPart(
                    "metadata|scene \\d|event|checks|meta |damaged|malformed|table|view");
                inTicks += said.contains(kTicks) ? 1 : 0;
                elsewhere += !said.contains(kTicks) && said.contains(kPart) ? 1 : 0;
                atOpening += !said.contains(kTicks) && !said.contains(kPart) ? 1 : 0;
                continue;
            }
            const auto read = all(*reader.value());
            QCOMPARE(read.size(), ticks.size());
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                QVERIFY2(test::isSameTick(read[i], ticks[i]), std::to_string(place).c_str());
            }
            QCOMPARE(reader.value()->events().size(), events);
        }
        qInfo("%d bits flipped: %d found and named by their ticks, %d by another part, %d as no recording, %d changed "
              "nothing",
              flipped, inTicks, elsewhere, atOpening, flipped - inTicks - elsewhere - atOpening);
        QVERIFY(inTicks > flipped / 3);
        QVERIFY(atOpening < 20);
    }

    /// As with another user's file. The superuser could read such a file, so here the process may not open further
    /// files.
    void aFileThatCannotBeOpenedSaysWhy()
    {
        QVERIFY(test::writeRecording(path("closed.palpate"), test::palpationTicks(10)));
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_NOFILE, &before), 0);
        const rlimit none{0, before.rlim_max};
        QCOMPARE(::setrlimit(RLIMIT_NOFILE, &none), 0);
        const auto reader = RecordingReader::open(path("closed.palpate"));
        QCOMPARE(::setrlimit(RLIMIT_NOFILE, &before), 0);
        QCOMPARE(reader.status().code(), core::StatusCode::Unreadable);
        QVERIFY2(reader.status().message().ends_with("closed.palpate: cannot be opened: Too many open files"),
                 reader.status().message().c_str());
    }

    void refusesWhatIsNotItsOwn_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("message");
        QTest::newRow("newer") << "PRAGMA user_version = 6"
                               << "found a recording of version 6, expected at most 5";
        QTest::newRow("another program's") << "PRAGMA application_id = 7"
                                           << "found another program's SQLite database";
        QTest::newRow("no meta") << "DROP TABLE meta"
                                 << "found no table \"meta\"";
        QTest::newRow("value missing") << "DELETE FROM meta WHERE key = 'dt_s'"
                                       << "meta has no value \"dt_s\"";
        QTest::newRow("bad period") << "UPDATE meta SET value = '-1' WHERE key = 'dt_s'"
                                    << "\"dt_s\" is not a valid number";
        QTest::newRow("bad start") << "UPDATE meta SET value = x'00' WHERE key = 'start'"
                                   << "\"start\" is not a state";
        QTest::newRow("no ticks") << "DROP VIEW tick_values; DROP TABLE ticks"
                                  << "found no table \"ticks\"";
    }

    void refusesWhatIsNotItsOwn()
    {
        QFETCH(QString, sql);
        QFETCH(QString, message);
        QVERIFY(test::writeRecording(path("h.palpate"), test::palpationTicks(300)));
        QVERIFY(test::runSql(path("h.palpate"), sql.toStdString()));
        const auto reader = RecordingReader::open(path("h.palpate"));
        QVERIFY(!reader.isOk());
        const std::string& said = reader.status().message();
        QVERIFY2(said.starts_with(path("h.palpate").string() + ": "), said.c_str());
        QVERIFY2(said.find(message.toStdString()) != std::string::npos, said.c_str());
        QVERIFY2(said.find('\n') == std::string::npos, said.c_str());
    }

    /// Truncated at every page and at odd offsets: an error or a prefix, never a crash.
    void survivesTruncation()
    {
        QVERIFY(test::writeRecording(path("i.palpate"), test::palpationTicks(600)));
        QFile original(m_folder.filePath("i.palpate"));
        QVERIFY(original.open(QIODevice::ReadOnly));
        const QByteArray good = original.readAll();
        for (qsizetype size = 0; size < good.size(); size += 1021) {
            QFile file(m_folder.filePath("j.palpate"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(good.left(size));
            file.close();
            const auto reader = RecordingReader::open(path("j.palpate"));
            QVERIFY(!reader.isOk() || !reader.value()->verify().isOk());
        }
        QCOMPARE(RecordingReader::open(path("nowhere.palpate")).status().code(), core::StatusCode::NotFound);
    }

    /// No existing file is replaced or removed, whatever its name.
    void refusesANameThatIsTaken()
    {
        QVERIFY(test::writeRecording(path("k.palpate"), test::palpationTicks(300)));
        QVERIFY(!session::RecordingWriter::create(path("k.palpate"), {}).isOk());
        QCOMPARE(RecordingReader::open(path("k.palpate")).value()->extent().ticks, std::int64_t{300});
        QVERIFY(QFile::link("nowhere.palpate", m_folder.filePath("link.palpate")));
        QVERIFY(!session::RecordingWriter::create(path("link.palpate"), {}).isOk());
        QVERIFY(!session::RecordingWriter::create(path("no-such-folder/k.palpate"), {}).isOk());
        QVERIFY(!session::RecordingWriter::create(m_folder.path().toStdString(), {}).isOk());
        for (const auto old : {core::ExistingFile::Refuse, core::ExistingFile::Replace}) {
            for (const char* suffix : {"-journal", "-wal", "-shm"}) {
                const QString side = m_folder.filePath("s.palpate") + suffix;
                QFile file(side);
                QVERIFY(file.open(QIODevice::WriteOnly) && file.write("theirs") == 6);
                file.close();
                const auto made = create("s.palpate", old);
                QVERIFY(!made.isOk());
                QVERIFY2(made.status().message().find(std::string("s.palpate") + suffix) != std::string::npos,
                         made.status().message().c_str());
                QCOMPARE(QFileInfo(side).size(), qint64{6});
                QVERIFY(QFile::remove(side));
            }
        }
        QVERIFY(!QFile::exists(m_folder.filePath("s.palpate")));
    }

    void replacesAnOldFileWhenItIsComplete()
    {
        QVERIFY(test::writeRecording(path("o.palpate"), test::palpationTicks(300)));
        QVERIFY(QFile::setPermissions(m_folder.filePath("o.palpate"), QFile::ReadOwner | QFile::WriteOwner));
        const auto ticks = [this] { return RecordingReader::open(path("o.palpate")).value()->extent().ticks; };
        {
            auto writer = create("o.palpate", core::ExistingFile::Replace);
            QVERIFY2(writer.isOk(), writer.status().message().c_str());
            servo::TickRecord tick;
            QVERIFY(writer.value()->append(tick).isOk());
            QVERIFY(writer.value()->commit().isOk());
        } // abandoned
        QCOMPARE(ticks(), std::int64_t{300});
        auto writer = create("o.palpate", core::ExistingFile::Replace);
        const auto second = create("o.palpate", core::ExistingFile::Replace);
        QVERIFY(second.status().message().find("another program is recording into it") != std::string::npos);
        servo::TickRecord tick;
        QVERIFY(writer.value()->append(tick).isOk());
        QCOMPARE(ticks(), std::int64_t{300});
        QVERIFY(writer.value()->finish().isOk());
        QCOMPARE(ticks(), std::int64_t{1});
        QCOMPARE(QFileInfo(m_folder.filePath("o.palpate")).permissions() & (QFile::ReadGroup | QFile::ReadOther),
                 QFile::Permissions());
        QCOMPARE(left("o.palpate*"), QStringList{"o.palpate"});
    }

    /// For another process or another writer in this process, the first writer continues.
    void aSecondWriterIsRefused()
    {
        auto first = create("t.palpate", core::ExistingFile::Refuse);
        servo::TickRecord tick;
        QVERIFY(first.value()->append(tick).isOk());
        for (const auto old : {core::ExistingFile::Refuse, core::ExistingFile::Replace}) {
            QVERIFY(!create("t.palpate", old).isOk());
        }
        tick.tick = 1;
        QVERIFY(first.value()->append(tick).isOk());
        QVERIFY(first.value()->finish().isOk());
        first = core::Status(core::StatusCode::Internal, core::Message());
        QCOMPARE(RecordingReader::open(path("t.palpate")).value()->extent().ticks, std::int64_t{2});
    }

    void neverRemovesOrReplacesAnothersFile()
    {
        const auto put = [this](const char* name) {
            (void)QFile::remove(m_folder.filePath(name));
            QFile file(m_folder.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write("theirs") == 6;
        };
        auto writer = create("u.palpate", core::ExistingFile::Refuse);
        QVERIFY(put("u.palpate"));
        writer.value()->discard();
        QCOMPARE(QFileInfo(m_folder.filePath("u.palpate")).size(), qint64{6});
        auto own = create("v.palpate", core::ExistingFile::Refuse);
        own.value()->discard();
        QCOMPARE(left("v.palpate*"), QStringList());

        auto late = create("w.palpate", core::ExistingFile::Replace); // no file existed at the start
        QVERIFY(put("w.palpate"));
        const core::Status kept = late.value()->finish();
        QVERIFY2(kept.message().ends_with("kept as w (2).palpate"), kept.message().c_str());
        QCOMPARE(QFileInfo(m_folder.filePath("w.palpate")).size(), qint64{6});
        QVERIFY(RecordingReader::open(path("w (2).palpate")).isOk());
    }

    void refusesTicksThatDoNotAscend()
    {
        auto writer = session::RecordingWriter::create(path("l.palpate"), {});
        servo::TickRecord tick;
        tick.tick = 5;
        QVERIFY(writer.value()->append(tick).isOk());
        QVERIFY(!writer.value()->append(tick).isOk());
    }
};

PALPATE_TEST(Recording)
#include "tst_Recording.moc"
