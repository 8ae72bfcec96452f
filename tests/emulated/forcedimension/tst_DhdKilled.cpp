// SPDX-License-Identifier: BSD-3-Clause
// A killed process cannot remove the force: the device's watchdog must, which the driver sets. In real time, with the
// device on a bench that outlives its driver.
#include "EmulatedArm.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <palpate/servo/ServoLoop.h>

#include <QCoreApplication>
#include <QProcess>

#include <csignal>

using namespace palpate;
using namespace palpate::test;

namespace {

constexpr const char* kDhdChild = "PALPATE_DHD_KILLED_CHILD"; // names the bench of the child process

} // namespace

class DhdKilled : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// The child process: presses until killed.
    void pressForever()
    {
        const char* file = std::getenv(kDhdChild);
        if (file == nullptr) {
            QSKIP("run by watchdogTakesTheForceAway, in a process of its own");
        }
        const EmulatedDhd bench(file);
        const auto host = shippingPlugins();
        const auto device = makeDhd(*host);
        QVERIFY(device != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.5));
        const core::Status started = loop.start(*device, {});
        QVERIFY2(started.isOk(), started.message().c_str());
        for (;;) {
            pass(0.05);
            if (loop.fault().isFaulted()) { // on a busy machine a late tick may count as a fault
                loop.rearm();
            }
        }
    }

    void watchdogTakesTheForceAway()
    {
        if (std::getenv(kDhdChild) != nullptr) {
            QSKIP("this is the child");
        }
        EmulatedDhd bench;
        bench.with([](standin::DhdBench& b) { b.devices[0].p = b.devices[0].to = {0.0, 0.010, 0.0}; });
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QString::fromLatin1(kDhdChild), QString::fromStdString(bench.file()));
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("DhdKilled"), QStringLiteral("pressForever")});
        QVERIFY(child.waitForStarted());
        double force_N = 0.0;
        for (int i = 0; i < 30 && force_N < 0.5; ++i) { // again after a fault, on a busy machine
            bench.moveHand({0, 10, 0}, 0.3);
            pass(1.0);
            bench.moveHand({0, -10, 0}, 0.5);
            for (int j = 0; j < 200 && force_N < 0.5; ++j) {
                pass(0.005);
                force_N = bench.motors().norm();
            }
        }
        std::uint64_t watchdogs = 0;
        kill(static_cast<pid_t>(child.processId()), SIGKILL);
        bench.with([&](standin::DhdBench& b) { watchdogs = b.devices[0].watchdogs; });
        QVERIFY2(force_N >= 0.5, child.readAllStandardOutput().constData());
        QVERIFY(child.waitForFinished());
        pass(0.02);
        QCOMPARE(bench.motors().norm(), 0.0);
        bench.with([&](standin::DhdBench& b) {
            QVERIFY(b.devices[0].watchdogs > 0 && b.devices[0].watchdogs >= watchdogs);
            QCOMPARE(b.devices[0].offCause, 3);
            QVERIFY(b.devices[0].longestSilence_ns <= 10'000'000);
        });
        // The next process starts cleanly.
        const auto host = shippingPlugins();
        const auto device = makeDhd(*host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        device->stop();
    }
};

PALPATE_TEST(DhdKilled)
#include "tst_DhdKilled.moc"
