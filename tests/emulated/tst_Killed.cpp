// SPDX-License-Identifier: BSD-3-Clause
// A killed process cannot remove the force: the arm's own watchdog must, and the next process starts cleanly. In real
// time, with the device on a bench that outlives its driver.
#include "EmulatedArm.h"
#include "TestRunner.h"

#include <palpate/servo/ServoLoop.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcess>

#include <cmath>
#include <csignal>

using namespace palpate;
using namespace palpate::test;

namespace {

constexpr const char* kChild = "PALPATE_KILLED_CHILD"; // names the bench of the child process

} // namespace

class Killed : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// The child process: presses until killed.
    void pressForever()
    {
        const char* file = std::getenv(kChild);
        if (file == nullptr) {
            QSKIP("run by watchdogTakesTheForceAway, in a process of its own");
        }
        setenv("PALPATE_STANDIN", file, 1);
        const auto host = shippingPlugins();
        auto made = host->make("woodenhaptics");
        QVERIFY2(made.isOk(), made.status().message().c_str());
        const std::unique_ptr<device::HapticDevice> arm = std::move(made).value();
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.5));
        const core::Status started = loop.start(*arm, {});
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
        if (std::getenv(kChild) != nullptr) {
            QSKIP("this is the child");
        }
        EmulatedBench bench;
        bench.moveHand({{1.0, {0, 0, 10}}, {2.0, {0, 0, -8}}});
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QString::fromLatin1(kChild), QString::fromStdString(bench.file()));
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("Killed"), QStringLiteral("pressForever")});
        QVERIFY(child.waitForStarted());
        double force_N = 0.0;
        // On a busy machine each late tick takes the force away for a while.
        QElapsedTimer since;
        since.start();
        while (force_N < 0.5 && since.elapsed() < kPatience_ms) {
            pass(0.01);
            bench.with([&](standin::Bench& b) {
                const standin::V3 f = standin::forceOf(b.arm.unit, b.arm.q, b.arm.amps);
                force_N = std::hypot(f[0], f[1], f[2]);
            });
        }
        kill(static_cast<pid_t>(child.processId()), SIGKILL);
        QVERIFY2(force_N >= 0.5, child.readAllStandardOutput().constData());
        QVERIFY(child.waitForFinished());
        standin::V3 amps{};
        std::int64_t last_ns = 0;
        bench.with([&](standin::Bench& b) {
            last_ns = b.arm.lastHost_ns;
            amps = b.arm.amps;
        });
        QVERIFY2(amps != (standin::V3{0, 0, 0}), "the motors drive on after their program is gone");
        pass(0.7);
        bench.with([&](standin::Bench& b) {
            QCOMPARE(b.arm.amps, (standin::V3{0, 0, 0}));
            QCOMPARE(b.arm.watchdogs, std::uint64_t{1});
            QVERIFY(b.arm.sim_ns - last_ns >= 500'000'000);
        });
    }
};

PALPATE_TEST(Killed)
#include "tst_Killed.moc"
