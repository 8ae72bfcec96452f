// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/servo/ServoLoop.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

using palpate::core::Status;
using palpate::core::Vec3;
using palpate::device::DeviceInfo;
using palpate::device::DeviceState;

namespace {

/// Presses into a sphere and sends every commanded force to another process.
class TellingDevice final : public palpate::device::HapticDevice
{
  public:
    explicit TellingDevice(int pipe)
        : m_pipe(pipe)
    {
    }
    DeviceInfo info() const override
    {
        DeviceInfo info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        info.workspaceRadius_mm = 0.0;
        return info;
    }
    Status start() override { return {}; }
    void stop() noexcept override {}
    DeviceState read(std::int64_t now_ns) noexcept override
    {
        DeviceState state;
        state.isPresent = true;
        state.time_ns = now_ns;
        state.p_D = Vec3(0, 0, std::max(27.0, 31.0 - 0.005 * static_cast<double>(m_tick++)));
        return state;
    }
    void write(const Vec3& f) noexcept override
    {
        const double force = f.norm();
        if (::write(m_pipe, &force, sizeof force) != sizeof force) {
            _exit(99);
        }
    }

  private:
    int m_pipe;
    std::int64_t m_tick = 0;
};

/// Ways for the child process to end.
enum class End
{
    Exit,      ///< std::exit with the loop running
    Exception, ///< an exception leaves a thread's main function: caught where main would, then exit
    Killed,    ///< no code runs any more
};

[[noreturn]] void child(int pipe, End end)
{
    auto* device = new TellingDevice(pipe); // outlives the destructors at exit, as a driver would
    auto* loop = new palpate::servo::ServoLoop;
    static_cast<void>(loop->setScene(palpate::test::sphereScene(30.0, 2.0)));
    palpate::servo::ServoOptions options;
    options.askRealtime = false;
    if (!loop->start(*device, options).isOk()) {
        _exit(98);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    if (end == End::Killed) {
        ::kill(::getpid(), SIGKILL);
    }
    if (end == End::Exception) {
        try {
            throw std::exception();
        } catch (const std::exception&) {
            std::exit(1);
        }
    }
    std::exit(0);
}

/// Returns all forces until the child has ended.
std::vector<double> forcesOf(End end)
{
    int ends[2] = {};
    if (::pipe(ends) != 0) {
        return {};
    }
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::close(ends[0]);
        child(ends[1], end);
    }
    ::close(ends[1]);
    std::vector<double> forces;
    double force = 0.0;
    while (::read(ends[0], &force, sizeof force) == sizeof force) {
        forces.push_back(force);
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(pid, &status, 0);
    return forces;
}

} // namespace

class ServoExit : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void aProgramThatEndsTakesTheForceAwayFirst_data()
    {
        QTest::addColumn<int>("end");
        QTest::newRow("exit") << static_cast<int>(End::Exit);
        QTest::newRow("exception") << static_cast<int>(End::Exception);
    }
    void aProgramThatEndsTakesTheForceAwayFirst()
    {
        QFETCH(int, end);
        const std::vector<double> forces = forcesOf(static_cast<End>(end));
        QVERIFY(forces.size() > 100);
        QVERIFY(*std::max_element(forces.begin(), forces.end()) > 1.0);
        QCOMPARE(forces.back(), 0.0);
        QVERIFY(forces[forces.size() - 12] > 0.5); // within ten ticks, by a ramp
    }

    /// Only the device's own watchdog helps here; its test is with the emulated device.
    void aKilledProgramLeavesItsForceToTheWatchdog()
    {
        const std::vector<double> forces = forcesOf(End::Killed);
        QVERIFY(!forces.empty());
        QVERIFY(forces.back() > 1.0);
    }
};

PALPATE_TEST(ServoExit)
#include "tst_ServoExit.moc"
