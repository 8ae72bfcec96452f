// SPDX-License-Identifier: BSD-3-Clause
// A killed process, the listing of the program, and allocations in the tick, in real time.
#include "EmulatedArm.h"
#include "EmulatedHaply.h"
#include "RealtimeGuard.h"
#include "TestRunner.h"

#include <QCoreApplication>
#include <QProcess>

#include <algorithm>
#include <csignal>
#include <fstream>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

namespace {

constexpr const char* kHaplyChild = "PALPATE_HAPLY_CHILD"; // settings folder of the child process

} // namespace

class HaplyProgram : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHaply> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

  private Q_SLOTS:
    void initTestCase()
    {
        if (std::getenv(kHaplyChild) == nullptr) {
            m_bench = std::make_unique<EmulatedHaply>();
        }
        m_host = shippingPlugins(); // with the settings of the bench
    }
    void cleanupTestCase() { m_bench.reset(); }

    /// The child process: pushes until killed.
    void pushForever()
    {
        const char* const folder = std::getenv(kHaplyChild);
        if (folder == nullptr) {
            QSKIP("run by forceEndsWithAKilledProcess, in a process of its own");
        }
        setenv("XDG_CONFIG_HOME", folder, 1);
        const auto host = shippingPlugins();
        const auto device = makeHaply(*host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        for (;;) {
            pushHaply(*device, Vec3(0, 2, 0), 1.0);
        }
    }

    void forceEndsWithAKilledProcess()
    {
        if (m_bench == nullptr) {
            QSKIP("this is the child");
        }
        m_bench->renew();
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QString::fromLatin1(kHaplyChild), QString::fromStdString(m_bench->folder()));
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("HaplyProgram"), QStringLiteral("pushForever")});
        QVERIFY(child.waitForStarted());
        PALPATE_TRY_VERIFY(m_bench->motors().norm() > 1.0);
        kill(static_cast<pid_t>(child.processId()), SIGKILL);
        QVERIFY(child.waitForFinished());
        PALPATE_TRY_COMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HaplyBench& b) { QCOMPARE(b.openSessions, 0); });
    }

    void ticksNeitherAllocateNorLock()
    {
        if (m_bench == nullptr || !RealtimeGuard::isAvailable()) {
            QSKIP("not counted here");
        }
        m_bench->renew();
        const auto device = makeHaply(*m_host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        std::uint64_t calls = 0;
        for (int i = 0; i < 300; ++i) {
            pass(0.001);
            const RealtimeGuard guard;
            const device::DeviceState state = device->read(core::monotonicNow_ns());
            device->write(state.p_D * 0.01);
            calls += guard.all();
        }
        QCOMPARE(calls, std::uint64_t{0});
        QVERIFY(device->report().states > 50);
        const core::TimingSummary latency = device->report().latency;
        qInfo("%llu states; from a state to its force: %s", static_cast<unsigned long long>(device->report().states),
              qPrintable(QString::number(latency.count)));
        device->stop();
    }

    void programListsTheDevice()
    {
#ifdef PALPATE_PROGRAM
        if (m_bench == nullptr) {
            QSKIP("this is the child");
        }
        m_bench->renew();
        const auto list = [this](const char* file) {
            QProcess program;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("XDG_CONFIG_HOME"), QString::fromStdString(m_bench->folder()));
            environment.insert(QStringLiteral("HOME"), QString::fromStdString(m_bench->folder()));
            program.setProcessEnvironment(environment);
            program.setProcessChannelMode(QProcess::MergedChannels);
            program.start(QString::fromLatin1(file), {QStringLiteral("devices")});
            return program.waitForFinished(kPatience_ms) ? QString::fromUtf8(program.readAll()) : QString();
        };
        const QString with = list(PALPATE_PROGRAM);
        QVERIFY2(with.contains(QLatin1String("on the bus: Haply Inverse3 049D (049D)")), qPrintable(with));
        // Without a service and settings, no word about either.
        m_bench->removeSettings();
        const QString without = list(PALPATE_PROGRAM);
        QVERIFY2(without.contains(QLatin1String("haply 0.1.0")), qPrintable(without));
        QVERIFY2(!without.contains(QLatin1String("Inverse Service does not answer")), qPrintable(without));
        m_bench->configure();
#else
        QSKIP("built without the program");
#endif
    }
};

PALPATE_TEST(HaplyProgram)
#include "tst_HaplyProgram.moc"
