// SPDX-License-Identifier: BSD-3-Clause
// A process that ends while it presses: with any signal but SIGKILL and with exit(), zero is the last force that it
// sends; after SIGKILL only the watchdog of the device is left. In real time, with the device on a bench that outlives
// its driver.
#include "DeviceChecks.h"
#include "EmulatedHd.h"
#include "TestRunner.h"

#include <QFile>

#include <csignal>

using namespace palpate;
using namespace palpate::test;

namespace {

constexpr const char* kHdChild = "PALPATE_HD_KILLED_CHILD"; // names the bench of the child process

/// File that tells the child to call exit().
QString exitMark(const std::string& bench)
{
    return QString::fromStdString(bench) + QStringLiteral(".exit");
}

} // namespace

class HdKilled : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// The child process: presses until killed, or until it calls exit().
    void pressForever()
    {
        const char* file = std::getenv(kHdChild);
        if (file == nullptr) {
            QSKIP("run by zeroIsTheLastForce, in a process of its own");
        }
        for (const int crash : {SIGSEGV, SIGTERM, SIGINT}) { // QtTest has handlers that print and abort
            (void)std::signal(crash, SIG_DFL);
        }
        const EmulatedHd bench(file);
        test::pressForever(bench, [file] { return QFile::exists(exitMark(file)); });
    }

    void zeroIsTheLastForce_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGSEGV") << SIGSEGV;
        QTest::newRow("exit()") << 0;
        QTest::newRow("SIGKILL") << SIGKILL;
    }

    void zeroIsTheLastForce()
    {
        if (std::getenv(kHdChild) != nullptr) {
            QSKIP("this is the child");
        }
        QFETCH(const int, signal);
        EmulatedHd bench;
        QProcess child;
        const double force_N = startPressing(bench, child, kHdChild, "HdKilled");
        std::uint64_t watchdogs = 0;
        bench.with([&](standin::HdBench& b) { watchdogs = b.devices[0].watchdogs; });
        if (signal == 0) {
            QFile mark(exitMark(bench.file()));
            QVERIFY(mark.open(QIODevice::WriteOnly));
        } else {
            kill(static_cast<pid_t>(child.processId()), signal);
        }
        QVERIFY2(force_N >= 0.5, child.readAllStandardOutput().constData());
        QVERIFY(child.waitForFinished());
        QCOMPARE(child.exitStatus(), signal == 0 ? QProcess::NormalExit : QProcess::CrashExit);
        if (signal != 0) {
            QCOMPARE(child.exitCode(), signal); // the signal's own effect follows
        }
        pass(0.02);
        QCOMPARE(bench.motors().norm(), 0.0);
        bench.with([&](standin::HdBench& b) {
            const standin::HdDevice& d = b.devices[0];
            QVERIFY(d.longestSilence_ns <= 10'000'000);
            const core::Vec3 last(d.forces[(d.forceCount - 1) % d.forces.size()].f.data());
            if (signal == SIGKILL) {
                QVERIFY(d.watchdogs > watchdogs); // it saw the silence
            } else {
                QCOMPARE(last.norm(), 0.0);
            }
        });
        // The next process starts cleanly.
        const auto host = shippingPlugins();
        const auto device = bench.make(*host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        device->stop();
    }
};

PALPATE_TEST(HdKilled)
#include "tst_HdKilled.moc"
