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
        tick.felt.constraints = 2;
        tick.solve_ns = 321;
        csv.value().write(tick, "liver");
        tick = {};
        tick.tick = 8;
        tick.solve_ns = 40;
        csv.value().write(tick, "");
        QVERIFY(!QFile::exists(path)); // not before it is whole
        QVERIFY(csv.value().finish().isOk());
        QCOMPARE(contents(path),
                 QByteArray("tick,hip_x,hip_y,hip_z,god_x,god_y,god_z,force_x,force_y,force_z,constraints,structure,"
                            "solve_ns\n"
                            "7,1,-2.5,0.10000000000000001,1,2,3,0,0,1e-300,2,liver,321\n"
                            "8,0,0,0,0,0,0,0,0,0,0,,40\n"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
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
            csv.value().write({}, name);
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
            second.value().write({}, "");
        }
        QCOMPARE(contents(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void namesAnOutputThatCannotBeWritten()
    {
        const auto csv = session::TickCsv::create("no-such-folder/t.csv");
        QCOMPARE(csv.status().code(), core::StatusCode::Unreadable);
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
