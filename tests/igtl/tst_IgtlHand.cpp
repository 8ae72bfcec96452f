// SPDX-License-Identifier: BSD-3-Clause
// The released plugin against a server that writes bytes itself: poses become a hand, and nothing that the peer does
// moves a hand that is not there, or delays a tick.
#include "RealtimeGuard.h"
#include "SteppedHand.h"
#include "TestRunner.h"
#include "WireBytes.h"
#include "WirePeer.h"

#include <palpate/core/Clock.h>
#include <palpate/device/PluginHost.h>

#include <QTemporaryDir>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;
using device::DeviceCondition;
using openigtlink::Sample;
using openigtlink::SteppedHand;
using PoseBytes = std::vector<std::uint8_t>;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;

std::unique_ptr<device::PluginHost> pluginsOfBuild()
{
    return std::make_unique<device::PluginHost>(std::vector<std::filesystem::path>{PALPATE_PLUGINS});
}

PoseBytes toolContent(std::string_view name, double x, double y, double z)
{
    return WireBytes().text(name, 20).u8(2).u8(0).f32({1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z}).bytes();
}

} // namespace

class IgtlHand : public QObject
{
    Q_OBJECT

  private:
    QTemporaryDir m_folder;
    WirePeer m_peer;
    std::uint16_t m_port = 0;
    std::unique_ptr<device::PluginHost> m_host;
    std::unique_ptr<device::HapticDevice> m_device;

    void setSettings(const QByteArray& more = {})
    {
        QFile file(m_folder.filePath(QStringLiteral("Palpate/openigtlink.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"host\": \"127.0.0.1\", \"port\": " + QByteArray::number(m_port) + more + '}');
    }

    /// Starts the device against the peer.
    void begin(const QByteArray& more = {})
    {
        m_port = m_peer.listen();
        QVERIFY(m_port != 0);
        setSettings(more);
        auto made = m_host->make("openigtlink");
        QVERIFY2(made.isOk(), made.status().message().c_str());
        m_device = std::move(made).value();
        const core::Status started = m_device->start();
        QVERIFY2(started.isOk(), started.message().c_str());
        QVERIFY(m_peer.accept());
    }

    device::DeviceState tick(const Vec3& f_D = Vec3::Zero())
    {
        const device::DeviceState state = m_device->read(core::monotonicNow_ns());
        m_device->write(f_D);
        return state;
    }

    /// Ticks until the hand is at a place. @return false after ten seconds
    bool isAt(const Vec3& p_D, const Vec3& f_D = Vec3::Zero())
    {
        return QTest::qWaitFor(
            [&] {
                const device::DeviceState state = tick(f_D);
                return state.isPresent && (state.p_D - p_D).norm() < 1e-3;
            },
            10000);
    }

    /// Ticks until there is no hand.
    bool isAway()
    {
        return QTest::qWaitFor([&] { return !tick().isPresent; }, 10000);
    }

    QString reportText() const { return QString::fromStdString(m_device->report().text); }

  private Q_SLOTS:
    void initTestCase()
    {
        qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8()); // independent of the user's settings
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("Palpate")));
        m_host = pluginsOfBuild();
    }

    void cleanup()
    {
        m_device.reset();
        m_peer.closeAll();
        QFile::remove(m_folder.filePath(QStringLiteral("Palpate/openigtlink.json")));
    }

    void movesTheHand_data()
    {
        QTest::addColumn<PoseBytes>("message");
        QTest::addColumn<QByteArray>("settings");
        QTest::addColumn<double>("sign");
        const PoseBytes position = WireBytes().f32({10, 20, 30, 0, 0, 0, 1}).bytes();
        PoseBytes tools = toolContent("Other", 1, 1, 1);
        const PoseBytes stylus = toolContent("Stylus", 10, 20, 30);
        tools.insert(tools.end(), stylus.begin(), stylus.end());
        for (const unsigned version : {1U, 2U}) {
            const auto name = [version](const char* text) {
                return std::string(text) + ", header " + std::to_string(version);
            };
            const Framing framing{.version = version};
            QTest::newRow(name("TRANSFORM").c_str())
                << transformAt("Stylus", 10, 20, 30, framing) << QByteArray() << -1.0;
            QTest::newRow(name("POSITION").c_str())
                << wireMessage("POSITION", "Stylus", position, framing) << QByteArray() << -1.0;
            QTest::newRow(name("TDATA").c_str())
                << wireMessage("TDATA", "tracker", tools, framing) << QByteArray(", \"tool\": \"Stylus\"") << -1.0;
        }
        QTest::newRow("LPS") << transformAt("Stylus", 10, 20, 30) << QByteArray(", \"frame\": \"LPS\"") << 1.0;
        QTest::newRow("name without a zero") << transformAt("12345678901234567890", 10, 20, 30)
                                             << QByteArray(", \"tool\": \"12345678901234567890\"") << -1.0;
        QTest::newRow("time far ahead") << transformAt("Stylus", 10, 20, 30, {.timestamp = ~std::uint64_t{0}})
                                        << QByteArray() << -1.0;
    }

    void movesTheHand()
    {
        QFETCH(const PoseBytes, message);
        QFETCH(const QByteArray, settings);
        QFETCH(const double, sign);
        begin(settings);
        QVERIFY(!tick().isPresent);
        // Byte by byte.
        QVERIFY(m_peer.write(message, 1));
        QVERIFY(isAt(Vec3(sign * 10, sign * 20, 30)));
        QVERIFY(m_device->report().refused == 0);
    }

    void staysAwayWithoutAPose_data()
    {
        QTest::addColumn<PoseBytes>("message");
        QTest::addColumn<QString>("error");
        const auto matrix = [](std::initializer_list<double> numbers) {
            return wireMessage("TRANSFORM", "Stylus", WireBytes().f32(numbers).bytes());
        };
        QTest::newRow("singular") << matrix({1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 2, 3}) << "singular, scaled, mirrored";
        QTest::newRow("scaled") << matrix({2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 2, 3}) << "singular, scaled, mirrored";
        QTest::newRow("mirrored") << matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3}) << "singular, scaled, mirrored";
        QTest::newRow("too short") << wireMessage("TRANSFORM", "Stylus", PoseBytes(44))
                                   << "found 44 bytes, expected 48";
        QTest::newRow("tracking data cut") << wireMessage("TDATA", "t", PoseBytes(75)) << "expected a multiple of 70";
        QTest::newRow("wrong checksum") << transformAt("Stylus", 1, 2, 3, {.isChecksumWrong = true})
                                        << "wrong checksum";
        QTest::newRow("unknown type") << wireMessage("IMAGE", "Stylus", PoseBytes(5000)) << "";
        QTest::newRow("a surface") << wireMessage("POLYDATA", "Stylus", tetrahedron()) << "";
        QTest::newRow("other types") << wireMessage("STATUS", "Stylus", PoseBytes(30)) << "";
        QTest::newRow("own hand") << transformAt("PalpateHand", 1, 2, 3) << "";
    }

    void staysAwayWithoutAPose()
    {
        QFETCH(const PoseBytes, message);
        QFETCH(const QString, error);
        begin();
        QVERIFY(m_peer.write(message));
        if (!error.isEmpty()) {
            PALPATE_TRY_COMPARE(m_device->report().refused, std::uint64_t{1});
            QVERIFY2(reportText().contains(error), qPrintable(reportText()));
        }
        QVERIFY(!tick().isPresent);
        QCOMPARE(m_device->report().states, std::uint64_t{0});
        QVERIFY(m_peer.write(transformAt("Stylus", 1, 2, 3))); // in the same stream
        QVERIFY(isAt(Vec3(-1, -2, 3)));
    }

    void closesWithASenderOfNonsense_data()
    {
        QTest::addColumn<PoseBytes>("bytes");
        QTest::newRow("2^31") << transformAt("Stylus", 1, 2, 3, {.size = std::int64_t{1} << 31});
        QTest::newRow("another protocol") << PoseBytes(100, 'G');
    }

    void closesWithASenderOfNonsense()
    {
        QFETCH(const PoseBytes, bytes);
        begin();
        QVERIFY(m_peer.write(bytes));
        QVERIFY(m_peer.isClosedByOther(10000));
        QVERIFY(m_peer.accept()); // and tries again
        QVERIFY(m_peer.write(transformAt("Stylus", 1, 2, 3)));
        QVERIFY(isAt(Vec3(-1, -2, 3)));
        QCOMPARE(m_device->report().losses, std::uint64_t{1});
    }

    void losesTheHandWithStaleData_data()
    {
        QTest::addColumn<bool>("isRepeated");
        QTest::addColumn<std::uint64_t>("first");
        QTest::addColumn<std::uint64_t>("second");
        QTest::newRow("silence") << false << std::uint64_t{5} << std::uint64_t{6};
        QTest::newRow("one pose again and again") << true << std::uint64_t{5} << std::uint64_t{5};
    }

    void losesTheHandWithStaleData()
    {
        QFETCH(const bool, isRepeated);
        QFETCH(const std::uint64_t, first);
        QFETCH(const std::uint64_t, second);
        begin(", \"stale_after_s\": 0.05");
        QVERIFY(m_peer.write(transformAt("Stylus", 1, 2, 3, {.timestamp = first})));
        QVERIFY(isAt(Vec3(-1, -2, 3)));
        bool isGone = false;
        for (int i = 0; i < 200 && !isGone; ++i) {
            if (isRepeated) {
                QVERIFY(m_peer.write(transformAt("Stylus", 1, 2, 3, {.timestamp = second})));
            }
            QTest::qWait(5);
            isGone = !tick().isPresent;
        }
        QVERIFY(isGone);
        QVERIFY2(reportText().contains(QLatin1String("no position of \"Stylus\" arrives")), qPrintable(reportText()));
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
    }

    /// The clock of a sender may be missing, set back, or wrong.
    void keepsTheHandWithOddTimes()
    {
        begin();
        double x = 0.0;
        for (const std::uint64_t time : {std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{1} << 40, std::uint64_t{7},
                                         ~std::uint64_t{0}, std::uint64_t{8}}) {
            x += 1.0;
            QVERIFY(m_peer.write(transformAt("Stylus", x, 0, 0, {.timestamp = time})));
            QVERIFY2(isAt(Vec3(-x, 0, 0)), qPrintable(QString::number(time)));
        }
    }

    void statesTheRateAndWhatCanBeFelt_data()
    {
        QTest::addColumn<QByteArray>("settings");
        QTest::addColumn<QString>("text");
        QTest::newRow("shown only") << QByteArray() << "The force is displayed, not felt";
        QTest::newRow("with a force") << QByteArray(", \"force\": \"Force\"")
                                      << "hard contact, edges and vibration cannot";
    }

    void statesTheRateAndWhatCanBeFelt()
    {
        QFETCH(const QByteArray, settings);
        QFETCH(const QString, text);
        begin(settings);
        const std::int64_t begin_ns = core::monotonicNow_ns();
        int count = 0;
        for (; count < 20; ++count) {
            QVERIFY(m_peer.write(transformAt("Stylus", count, 0, 0)));
            QTest::qWait(20);
        }
        const double rate_Hz = count * 1e9 / static_cast<double>(core::monotonicNow_ns() - begin_ns);
        PALPATE_TRY_COMPARE(m_device->report().states, static_cast<std::uint64_t>(count));
        QVERIFY(m_peer.write(transformAt("Stylus", count, 0, 0)));
        PALPATE_TRY_VERIFY(reportText().contains(text) || reportText().contains(QLatin1String("too few")));
        const double stated_Hz =
            reportText().section(QLatin1String(": "), 1).section(QLatin1Char(' '), 0, 0).toDouble();
        // A mean of the latest intervals on a busy machine.
        QVERIFY2(stated_Hz > 0.3 * rate_Hz && stated_Hz < 3.0 * rate_Hz, qPrintable(reportText()));
    }

    void answersEachPoseWithTheForce()
    {
        begin(", \"force\": \"Force\", \"max_force_N\": 1.5");
        QCOMPARE(m_device->info().actuatedAxes, 3);
        QCOMPARE(m_device->info().maxForce_N, 1.5);
        QVERIFY(m_peer.write(transformAt("Stylus", 0, 0, 0)));
        QVERIFY(isAt(Vec3(0, 0, 0), Vec3(0.1, 0.2, 0.3)));
        // The first answer may have been due before the first tick.
        WireText force;
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)tick(Vec3(0.1, 0.2, 0.3));
                (void)m_peer.write(transformAt("Stylus", 0, 0, 0));
                force = m_peer.read("TRANSFORM", 20);
                return force.f32(36) != 0.0;
            },
            10000));
        QCOMPARE(force.name, std::string("Force"));
        QVERIFY(force.isChecksumRight);
        QVERIFY(std::abs(force.f32(36) + 0.1) < 1e-6); // RAS
        QVERIFY(std::abs(force.f32(40) + 0.2) < 1e-6);
        QVERIFY(std::abs(force.f32(44) - 0.3) < 1e-6);
        // Never more than allowed.
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)tick(Vec3(0, 0, 100));
                (void)m_peer.write(transformAt("Stylus", 0, 0, 0));
                force = m_peer.read("TRANSFORM", 20);
                return force.f32(44) > 1.0;
            },
            10000));
        QVERIFY(std::abs(force.f32(44) - 1.5) < 1e-6);
        // Zero when the servo thread is silent, although poses go on.
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)m_peer.write(transformAt("Stylus", 0, 0, 0));
                force = m_peer.read("TRANSFORM", 20);
                return !force.type.empty() && force.f32(44) == 0.0;
            },
            10000));
    }

    void sendsZeroWhenPosesEnd()
    {
        begin(", \"force\": \"Force\", \"stale_after_s\": 0.1");
        WireText force;
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)m_peer.write(transformAt("Stylus", 0, 0, 0));
                for (int i = 0; i < 3; ++i) {
                    (void)tick(Vec3(0, 0, 1));
                    QTest::qWait(1);
                }
                force = m_peer.read("TRANSFORM", 20);
                return force.f32(44) != 0.0;
            },
            10000));
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)tick(Vec3(0, 0, 1)); // a force is wanted, but for a pose that is stale
                force = m_peer.read("TRANSFORM", 5);
                return !force.type.empty() && force.f32(44) == 0.0;
            },
            10000));
        QVERIFY(m_peer.write(transformAt("Stylus", 0, 0, 0)));
        m_device->stop();
        do {
            force = m_peer.read("TRANSFORM", 1000);
        } while (force.f32(44) != 0.0);
        QCOMPARE(force.name, std::string("Force")); // the last one is zero
    }

    void findsTheServerAgain()
    {
        begin();
        QVERIFY(m_peer.write(transformAt("Stylus", 1, 2, 3)));
        QVERIFY(isAt(Vec3(-1, -2, 3)));
        m_peer.closeAll();
        PALPATE_TRY_COMPARE(m_device->report().condition, DeviceCondition::Lost);
        QVERIFY(isAway());
        QVERIFY2(reportText().contains(QString::number(m_port)), qPrintable(reportText()));
        QCOMPARE(m_peer.listen(m_port), m_port);
        QVERIFY(m_peer.accept());
        QVERIFY(m_peer.write(transformAt("Stylus", 4, 5, 6)));
        QVERIFY(isAt(Vec3(-4, -5, 6)));
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
        QCOMPARE(m_device->report().losses, std::uint64_t{1});
    }

    /// A peer that sends without end and never reads: the servo thread neither waits nor allocates.
    void delaysNoTick()
    {
        begin(", \"force\": \"Force\"");
        const PoseBytes pose = transformAt("Stylus", 1, 2, 3);
        std::atomic<bool> isOver{false};
        std::thread sender([&] {
            while (!isOver && m_peer.write(pose)) {
            }
        });
        std::int64_t slowest_ns = 0;
        std::uint64_t calls = 0;
        std::uint64_t present = 0;
        for (int i = 0; i < 2000; ++i) {
            const std::int64_t before_ns = core::monotonicNow_ns();
            {
                const RealtimeGuard guard;
                present += m_device->read(before_ns).isPresent ? 1 : 0;
                m_device->write(Vec3(0, 0, 1));
                calls += guard.all();
            }
            slowest_ns = std::max(slowest_ns, core::monotonicNow_ns() - before_ns);
            core::sleepUntil_ns(before_ns + kMs_ns / 2);
        }
        const std::int64_t stopped_ns = core::monotonicNow_ns();
        m_device->stop();
        QVERIFY(core::monotonicNow_ns() - stopped_ns < 2000 * kMs_ns);
        isOver = true;
        m_peer.isClosedByOther(100);
        sender.join();
        QCOMPARE(calls, std::uint64_t{0});
        QVERIFY(present > 500);
        QVERIFY2(slowest_ns < 200 * kMs_ns, qPrintable(QString::number(slowest_ns))); // preemption on a busy machine
    }

    void requestsTrackingData()
    {
        begin(", \"request_every_ms\": 25");
        const WireText request = m_peer.read("STT_TDATA");
        QCOMPARE(request.content.size(), std::size_t{36});
        QCOMPARE(request.content[3], std::uint8_t{25});
        // The answer may come before, after, or without the data.
        QVERIFY(m_peer.write(wireMessage("RTS_TDATA", "", {1})));
        QVERIFY(m_peer.write(wireMessage("TDATA", "tracker", toolContent("Stylus", 1, 2, 3))));
        QVERIFY(m_peer.write(wireMessage("RTS_TDATA", "", {0})));
        QVERIFY(isAt(Vec3(-1, -2, 3)));
    }

    void setsTheCentreOfAWorkspace()
    {
        begin(", \"workspace_radius_mm\": 100");
        QCOMPARE(m_device->info().workspaceRadius_mm, 100.0);
        QVERIFY(m_peer.write(transformAt("Stylus", 500, 0, 0)));
        QVERIFY(isAt(Vec3(-500, 0, 0)));
        QVERIFY(m_device->calibrate().isOk());
        QVERIFY(m_peer.write(transformAt("Stylus", 500, 0, 0)));
        QVERIFY(isAt(Vec3(0, 0, 0)));
        // Forward in the frame of the sender is away from the user: minus z.
        const Vec3 p_U = m_device->info().q_UD * Vec3(-1, -2, 3);
        QVERIFY((p_U - Vec3(1, 3, -2)).norm() < 1e-12);
    }

    void refusesToSetACentreInSceneCoordinates()
    {
        begin();
        QCOMPARE(m_device->calibrate().code(), core::StatusCode::Unsupported);
    }

    void listsTheToolWithItsRate()
    {
        m_port = m_peer.listen();
        setSettings();
        std::thread sender([&] {
            if (m_peer.accept()) {
                for (int i = 0; i < 200 && m_peer.write(transformAt("Stylus", i, 0, 0)); ++i) {
                    core::sleepUntil_ns(core::monotonicNow_ns() + 10 * kMs_ns);
                }
            }
        });
        const auto found = m_host->find("openigtlink");
        sender.join();
        QVERIFY(found.isOk());
        QCOMPARE(found.value().size(), std::size_t{1});
        const QString name = QString::fromStdString(found.value()[0].name);
        QVERIFY2(name.startsWith(QLatin1String("Stylus, ")) && name.contains(QLatin1String("positions a second")),
                 qPrintable(name));
        QVERIFY(found.value()[0].problem.empty());
    }

    void listsAServerThatSendsNothing()
    {
        m_port = m_peer.listen();
        setSettings();
        const auto found = m_host->find("openigtlink");
        QVERIFY(found.isOk());
        QCOMPARE(found.value().size(), std::size_t{1});
        QCOMPARE(found.value()[0].problem, std::string("the server answers, but sends no position"));
    }

    void namesTheServerThatIsMissing()
    {
        m_port = m_peer.listen();
        m_peer.closeAll();
        setSettings();
        auto made = m_host->make("openigtlink");
        QVERIFY(made.isOk());
        const core::Status status = made.value()->start();
        QCOMPARE(status.code(), core::StatusCode::NotFound);
        QVERIFY2(status.message().find(std::to_string(m_port)) != std::string::npos, status.message().c_str());
        QVERIFY2(status.message().find("openigtlink.json") != std::string::npos, status.message().c_str());
        QCOMPARE(m_host->find("openigtlink").value().size(), std::size_t{1}); // with the reason
    }

    void refusesBadSettings_data()
    {
        QTest::addColumn<QByteArray>("settings");
        QTest::addColumn<QString>("error");
        QTest::newRow("frame") << QByteArray(", \"frame\": \"ras\"") << "expected \"RAS\" or \"LPS\"";
        QTest::newRow("tool") << QByteArray(", \"tool\": 5") << "tool: expected a text of at most 20 bytes";
        QTest::newRow("force") << QByteArray(", \"force\": \"more than twenty bytes\"") << "at most 20 bytes";
        QTest::newRow("stiffness") << QByteArray(", \"max_stiffness_N_per_mm\": 100") << "max_stiffness_N_per_mm";
    }

    void refusesBadSettings()
    {
        QFETCH(const QByteArray, settings);
        QFETCH(const QString, error);
        setSettings(settings);
        const auto made = m_host->make("openigtlink");
        QVERIFY(!made.isOk());
        const QString line = QString::fromStdString(made.status().message());
        QVERIFY2(line.contains(error) && line.contains(QLatin1String("openigtlink.json")), qPrintable(line));
    }

    void takesNoNameFromANameServer()
    {
        m_port = 1;
        QFile file(m_folder.filePath(QStringLiteral("Palpate/openigtlink.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"host\": \"tracker.example\"}");
        file.close();
        auto made = m_host->make("openigtlink");
        QVERIFY(made.isOk());
        const core::Status status = made.value()->start();
        QCOMPARE(status.code(), core::StatusCode::BadCommandLine);
        QVERIFY2(status.message().find("192.168.0.10") != std::string::npos, status.message().c_str());
    }

    /// Between samples 50 ms apart, each tick moves the hand by no more than its share of the way.
    void movesInSmallSteps()
    {
        SteppedHand hand(0.2);
        Sample sample;
        sample.isPresent = true;
        sample.interval_ns = 50 * kMs_ns;
        std::int64_t now_ns = kMs_ns;
        Vec3 last = Vec3::Zero();
        double longest_mm = 0.0;
        for (int i = 0; i < 20; ++i) {
            sample.p_D = Vec3(10.0 * i, 0, 0);
            sample.time_ns = now_ns;
            ++sample.number;
            for (int t = 0; t < 50; ++t) {
                const device::DeviceState state = hand.advance(sample, now_ns);
                QVERIFY(state.isPresent);
                QCOMPARE(state.time_ns, now_ns); // never stale by the servo loop's measure
                longest_mm = std::max(longest_mm, (state.p_D - last).norm());
                last = state.p_D;
                now_ns += kMs_ns;
            }
        }
        QVERIFY2(longest_mm < 0.25, qPrintable(QString::number(longest_mm))); // 10 mm in 50 ticks
        QVERIFY(last.x() > 180.0);
    }

    void restartsAfterAJump()
    {
        SteppedHand hand(0.2);
        Sample sample;
        sample.isPresent = true;
        sample.interval_ns = 20 * kMs_ns;
        sample.number = 1;
        sample.time_ns = kMs_ns;
        QVERIFY(hand.advance(sample, kMs_ns).isPresent);
        sample.p_D = Vec3(1000, 0, 0);
        sample.number = 2;
        QVERIFY(!hand.advance(sample, 2 * kMs_ns).isPresent);
        const device::DeviceState state = hand.advance(sample, 3 * kMs_ns);
        QVERIFY(state.isPresent);
        QCOMPARE(state.p_D, sample.p_D);
        QVERIFY(!hand.advance(sample, 300 * kMs_ns).isPresent); // stale
    }
};

PALPATE_TEST(IgtlHand)
#include "tst_IgtlHand.moc"
