// SPDX-License-Identifier: BSD-3-Clause
// A killed process cannot remove the force: the device's watchdog must, which the driver sets. In real time, with the
// device on a bench that outlives its driver.
#include "DeviceChecks.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

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
        test::pressForever(bench);
    }

    void watchdogTakesTheForceAway()
    {
        if (std::getenv(kDhdChild) != nullptr) {
            QSKIP("this is the child");
        }
        EmulatedDhd bench;
        QProcess child;
        const double force_N = startPressing(bench, child, kDhdChild, "DhdKilled");
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
        const auto device = bench.make(*host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        device->stop();
    }
};

PALPATE_TEST(DhdKilled)
#include "tst_DhdKilled.moc"
