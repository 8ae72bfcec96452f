// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Numbers.h>
#include <palpate/session/TickCsv.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <cmath>

using namespace palpate;

class TickCsv : public QObject
{
    Q_OBJECT

    static constexpr auto kNames = [](std::uint32_t number) -> std::string_view {
        return number == 0 ? "lump; a=1, 50%" : "liver";
    };

    static QByteArray contents(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(not there)");
    }

  private Q_SLOTS:
    void writesTheColumnsOfTheDesign()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("t.csv");
        auto csv = session::TickCsv::create(path.toStdString());
        QVERIFY(csv.isOk());
        servo::TickRecord tick;
        tick.tick = 7;
        tick.p_WH = core::Vec3(1, -2.5, 0.1);
        tick.felt.p_WG = core::Vec3(1, 2, 3);
        tick.felt.f_W = core::Vec3(0, 0, 1e-300);
        tick.felt.structure = 1;
        tick.felt.n_W = core::Vec3(0, 0.6, 0.8);
        tick.felt.constraints = 2;
        tick.felt.contactCount = 2;
        tick.felt.contacts[0] = {
            core::Vec3::Zero(),       core::Vec3::Zero(), core::Vec3(0.3, 0, 0.4), 8.25, 1.0, 1, 0, 0,
            haptics::Friction::Slides};
        tick.felt.contacts[1] = {core::Vec3::Zero(),     core::Vec3::Zero(), core::Vec3(0, 0, 3.5), 0.1, 1.0, 0, 0, 1,
                                 haptics::Friction::None};
        tick.solve_ns = 321;
        csv.value().write(tick, kNames);
        tick.felt.contactCount = 1;
        tick.felt.contacts[0].friction = haptics::Friction::Holds;
        csv.value().write(tick, kNames);
        tick = {};
        tick.tick = 8;
        tick.solve_ns = 40;
        csv.value().write(tick, kNames);
        QVERIFY(!QFile::exists(path)); // only when complete
        QVERIFY(csv.value().finish().isOk());
        QCOMPARE(contents(path),
                 QByteArray("tick,hip_x,hip_y,hip_z,god_x,god_y,god_z,force_x,force_y,force_z,constraints,structure,"
                            "solve_ns,normal_x,normal_y,normal_z,slides,layers\n"
                            "7,1,-2.5,0.10000000000000001,1,2,3,0,0,1e-300,2,liver,321,0,0.59999999999999998,"
                            "0.80000000000000004,1,liver=0.5=8.25;lump%3B a%3D1%2C 50%25=3.5=0.10000000000000001\n"
                            "7,1,-2.5,0.10000000000000001,1,2,3,0,0,1e-300,2,liver,321,0,0.59999999999999998,"
                            "0.80000000000000004,0,liver=0.5=8.25\n"
                            "8,0,0,0,0,0,0,0,0,0,0,,40,0,0,0,,\n"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    /// For a recording: the same columns and bytes, followed by time, sent force, depth and events; ticks without a
    /// hand have a row too.
    void aSessionHasEveryTickAndMoreAtTheEnd()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const char* name) { return folder.filePath(name).toStdString(); };
        auto plain = session::TickCsv::create(path("plain.csv"));
        auto csv = session::TickCsv::create(path("session.csv"), session::TickCsv::Rows::Session);
        servo::TickRecord tick;
        tick.tick = 50770;
        tick.time_ns = 1500000;
        tick.p_WH = core::Vec3(0, 0, -4);
        tick.felt.f_W = core::Vec3(0, 3, 4);
        tick.felt.structure = 1;
        tick.felt.contactCount = 1;
        tick.felt.contacts[0] = {core::Vec3::Zero(),     core::Vec3::Zero(), core::Vec3(0, 3, 4), 4, 1.0, 1, 0, 0,
                                 haptics::Friction::None};
        tick.fSent_W = core::Vec3(0, 0.75, 1);
        tick.solve_ns = 9;
        const std::vector<session::RecordingEvent> events{{50770, "note", R"({"text": "hard, 50 %|here"})"},
                                                          {50770, "clutch", R"({"engaged": true})"}};
        plain.value().write(tick, kNames);
        csv.value().write(tick, kNames, events);
        tick.tick = 50771;
        tick.time_ns = 2500000;
        tick.flags = servo::kNoHand;
        csv.value().write(tick, kNames, std::span(events).last(1));
        tick.flags = 0;
        static const haptics::TickResult kNothing{};
        tick.felt = kNothing;
        csv.value().write(tick, kNames);
        QVERIFY(plain.value().finish().isOk());
        QVERIFY(csv.value().finish().isOk());
        const QList<QByteArray> before = contents(folder.filePath("plain.csv")).split('\n');
        const QList<QByteArray> rows = contents(folder.filePath("session.csv")).split('\n');
        QCOMPARE(rows[0], before[0] + ",time_s,sent_x_N,sent_y_N,sent_z_N,force_N,depth_mm,felt_N_per_mm,events");
        QCOMPARE(rows[1], before[1] + ",0.0015,0,0.75,1,5,4,1.25,note=hard%2C 50 %25%7Chere|clutch");
        QCOMPARE(rows[2], QByteArray("50771,,,,,,,,,,,,,,,,,,0.0025000000000000001,,,,,,,clutch"));
        QVERIFY(rows[3].endsWith(",0.0025000000000000001,0,0.75,1,0,0,,"));
        QCOMPARE(rows[2].count(','), rows[0].count(','));
    }

    void aReplayWithADeviceSaysWhatWasSent()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("device.csv");
        auto csv = session::TickCsv::create(path.toStdString(), session::TickCsv::Rows::Device);
        servo::TickRecord tick;
        tick.fSent_W = core::Vec3(0.5, -0.75, 1);
        csv.value().write(tick, kNames);
        QVERIFY(csv.value().finish().isOk());
        const QList<QByteArray> rows = contents(path).split('\n');
        QVERIFY(rows[0].endsWith(",slides,layers,sent_x,sent_y,sent_z"));
        QVERIFY(rows[1].endsWith(",0.5,-0.75,1"));
        QCOMPARE(rows[1].count(','), rows[0].count(','));
    }

    void everyDoubleComesBack()
    {
        std::uint64_t bits = 88172645463325252u;
        for (int i = 0; i < 100000; ++i) {
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            const double value = std::bit_cast<double>(bits);
            if (!std::isfinite(value)) {
                continue;
            }
            std::string text;
            core::appendNumber(text, value);
            const auto back = core::parseNumber(text);
            QVERIFY2(back && std::bit_cast<std::uint64_t>(*back) == bits, text.c_str());
        }
    }

    void quotesNamesOnlyWhenNeeded()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("t.csv");
        auto csv = session::TickCsv::create(path.toStdString());
        for (const char* name : {"left lobe", "a,b", "say \"ah\""}) {
            servo::TickRecord tick;
            tick.felt.structure = 0;
            csv.value().write(tick, [name](std::uint32_t) { return std::string_view(name); });
        }
        QVERIFY(csv.value().finish().isOk());
        const QByteArray text = contents(path);
        QVERIFY(text.contains(",left lobe,"));
        QVERIFY(text.contains(",\"a,b\","));
        QVERIFY(text.contains(",\"say \"\"ah\"\"\","));
    }

    void leavesNothingAndKeepsTheOldWhenAbandoned()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("t.csv");
        {
            auto first = session::TickCsv::create(path.toStdString());
            QVERIFY(first.value().finish().isOk());
        }
        const QByteArray before = contents(path);
        {
            auto second = session::TickCsv::create(path.toStdString());
            second.value().write({}, kNames);
        }
        QCOMPARE(contents(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void namesAnOutputThatCannotBeWritten()
    {
        const auto csv = session::TickCsv::create("no-such-folder/t.csv");
        QCOMPARE(csv.status().code(), core::StatusCode::NotFound);
        QVERIFY(csv.status().message().starts_with("no-such-folder/t.csv: cannot be written"));
        const QTemporaryDir folder;
        QVERIFY(!session::TickCsv::create(folder.path().toStdString()).isOk());
    }

    void reportsAFullDisk()
    {
        if (!QFile::exists("/dev/full")) {
            QSKIP("no /dev/full on this machine");
        }
        auto csv = session::TickCsv::create("/dev/full");
        QVERIFY(csv.isOk());
        QVERIFY(!csv.value().finish().isOk());
        QVERIFY(QFile::exists("/dev/full"));
    }
};

PALPATE_TEST(TickCsv)
#include "tst_TickCsv.moc"
