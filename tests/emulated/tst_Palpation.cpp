// SPDX-License-Identifier: BSD-3-Clause
// Tests the released plugin against the emulated arm, with the product's servo loop, in virtual time.
#include "EmulatedArm.h"
#include "TestRunner.h"

#include <palpate/servo/ServoLoop.h>

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

using namespace palpate;
using namespace palpate::test;

namespace {

/// Deviation of the response forces from the spring's.
struct Compared
{
    double worst_N = 0.0; ///< of a response in contact
    int answers = 0;      ///< in contact
    double deepest_mm = 0.0;
    double bound_N = 0.0; ///< uncertainty due to encoder counts
    double move_mm = 0.0; ///< motion per tick, averaged over kSpan: responses come one by one or in pairs
};

/// @param late  number of reports between a position and the response
Compared compareWithSpring(const std::vector<standin::Taken>& all, double stiffness, std::size_t late)
{
    constexpr std::size_t kSpan = 10;
    Compared compared;
    for (std::size_t i = kSpan + 4; i < all.size(); ++i) {
        const standin::V3& p = all[i - late].sampled_mm;
        if (p[2] > -1.0) {
            continue; // deep enough that the force ramp is over and the contact is old
        }
        ++compared.answers;
        compared.deepest_mm = std::min(compared.deepest_mm, p[2]);
        const standin::V3& f = all[i].f_D;
        compared.worst_N = std::max(compared.worst_N, std::hypot(f[0], f[1], f[2] + stiffness * p[2]));
        const auto& step = all[i].countStep_mm;
        const standin::V3& q = all[i - late - kSpan].sampled_mm;
        compared.move_mm = std::max(compared.move_mm, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / kSpan);
        compared.bound_N = std::max(compared.bound_N, stiffness * 0.5 * (step[0] + step[1] + step[2]));
    }
    return compared;
}

} // namespace

class Palpation : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedBench> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    /// Advances time and collects the reports that the firmware received, before its ring buffer wraps.
    standin::ArmUnit passAndHear(double seconds, std::vector<standin::Taken>& all)
    {
        standin::ArmUnit unit;
        std::uint64_t heard = 0;
        m_bench->with([&](standin::Bench& b) { heard = b.arm.takenCount; });
        for (double left = seconds; left > 0.0; left -= 1.0) {
            pass(std::min(1.0, left));
            m_bench->with([&](standin::Bench& b) {
                for (; heard < b.arm.takenCount; ++heard) {
                    all.push_back(b.arm.taken[heard % b.arm.taken.size()]);
                }
                unit = b.arm.unit;
            });
        }
        return unit;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedBench>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
    }

    /// Fine encoders count more than 16 bits between the rest pose and the workspace.
    void countersThatWrapLoseNoTurn()
    {
        constexpr int kCountsPerTurn = 20000;
        QFile config(QFileInfo(QString::fromStdString(m_bench->file())).path() + QStringLiteral("/woodenhaptics.json"));
        QVERIFY(config.open(QIODevice::WriteOnly));
        config.write(QStringLiteral(R"({"cpr_encoder_a": %1, "cpr_encoder_b": %1, "cpr_encoder_c": %1})")
                         .arg(kCountsPerTurn)
                         .toUtf8());
        config.close();
        m_bench->with([](standin::Bench& b) {
            b.arm = {};
            b.arm.unit.countsPerTurn.fill(kCountsPerTurn);
            b.arm.q = standin::restPose(b.arm.unit);
        });
        m_bench->moveHand({{1.0, {0, 0, 20}}, {2.0, {30, 40, -30}}});
        auto made = m_host->make("woodenhaptics");
        QVERIFY2(config.remove(), "the other tests have the kit's encoders");
        QVERIFY2(made.isOk(), made.status().message().c_str());
        QVERIFY(made.value()->start().isOk());
        pass(3.0);
        const device::DeviceState state = made.value()->read(core::monotonicNow_ns());
        m_bench->with([&](standin::Bench& b) {
            const auto counts = standin::countsOf(b.arm.unit, b.arm.q);
            QVERIFY(std::max({std::abs(counts[0]), std::abs(counts[1]), std::abs(counts[2])}) > 32767.0);
            const standin::V3 p = standin::tipOf(b.arm.unit, b.arm.q);
            QVERIFY((state.p_D - core::Vec3(p[0], p[1], p[2])).norm() < 0.05); // tremor within 2 ms
        });
        made.value()->stop();
    }

    void forceFollowsTheSpringWithinQuantisation_data()
    {
        QTest::addColumn<int>("protocol");
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<bool>("isControlled");
        QTest::addColumn<double>("slowness"); // 1: 14 mm/s at most
        QTest::newRow("protocol 2, soft") << 2 << 0.2 << true << 1.0;
        QTest::newRow("protocol 2, hard") << 2 << 0.8 << true << 1.0;
        QTest::newRow("protocol 2, slow") << 2 << 0.5 << true << 2.0;
        QTest::newRow("protocol 1") << 1 << 0.5 << true << 1.0;
        QTest::newRow("protocol 1, slow, hard") << 1 << 0.8 << true << 2.0;
        QTest::newRow("without passivity controller") << 2 << 0.5 << false << 1.0;
    }

    void forceFollowsTheSpringWithinQuantisation()
    {
        QFETCH(const int, protocol);
        QFETCH(const double, stiffness);
        QFETCH(const bool, isControlled);
        QFETCH(const double, slowness);
        m_bench->with([&](standin::Bench& b) {
            b.arm = {};
            b.arm.unit.protocol = protocol;
            b.arm.q = standin::restPose(b.arm.unit);
        });
        // Down into the block, along it, and out again.
        std::vector<standin::Knot> path{
            {1.0, {0, 0, 20}}, {2.0, {0, 0, 5}}, {3.0, {0, 0, -6}}, {4.5, {30, 20, -8}}, {5.5, {30, 20, 10}}};
        for (standin::Knot& knot : path) {
            knot.time_s *= slowness;
        }
        m_bench->moveHand(path);
        auto made = m_host->make("woodenhaptics");
        QVERIFY2(made.isOk(), made.status().message().c_str());
        const std::unique_ptr<device::HapticDevice> arm = std::move(made).value();
        servo::ServoLoop loop;
        loop.setScene(blockScene(stiffness));
        const core::Status started = loop.start(*arm, {.askRealtime = false, .isPassivityControlled = isControlled});
        QVERIFY2(started.isOk(), started.message().c_str());
        std::vector<standin::Taken> all;
        const standin::ArmUnit unit = passAndHear(6.0 * slowness, all);
        const servo::FaultReport fault = loop.fault();
        const device::DeviceReport report = arm->report();
        loop.stop();
        QVERIFY2(!fault.isFaulted(), fault.message.english().c_str());

        // The response lags by a fixed number of reports; the bound is the resolution of counts and milliamperes.
        Compared best;
        std::size_t lateness = 0;
        double bound_N = 0.0, move_mm = 0.0;
        for (std::size_t late = 0; late < 4; ++late) {
            const Compared compared = compareWithSpring(all, stiffness, late);
            bound_N = std::max(bound_N, compared.bound_N);
            move_mm = std::max(move_mm, compared.move_mm);
            if (late == 0 || compared.worst_N < best.worst_N) {
                best = compared;
                lateness = late;
            }
        }
        // Half a milliampere per motor, and the rotation of the arm during the latency (2 ms at 30 mm/s).
        const double currents_N = 0.5e-3 * unit.torqueConstant[0] * 16.0 / 0.15 * 2.0 + 2.0 * 0.06 / 200.0;
        // The controller damps the energy that a spring gains by sample-and-hold and one tick of delay, (1/2 + 1) K T
        // (PassivityController.h), with an exact sensor too.
        const double damping_N = isControlled ? 1.5 * stiffness * move_mm : 0.0;
        const double allowed_N = bound_N + currents_N + damping_N;
        qInfo(
            "%d answers in contact, deepest %.2f mm; force within %.4f N of k (g - p), bound %.4f N; %zu reports late; "
            "latency p50 %.2f ms, p99 %.2f ms, max %.2f ms",
            best.answers, -best.deepest_mm, best.worst_N, allowed_N, lateness,
            static_cast<double>(report.latency.p50_ns) * 1e-6, static_cast<double>(report.latency.p99_ns) * 1e-6,
            static_cast<double>(report.latency.max_ns) * 1e-6);
        QVERIFY(best.answers > 1000);
        QVERIFY(best.deepest_mm < -2.0);
        QVERIFY2(best.worst_N <= allowed_N,
                 qPrintable(QStringLiteral("%1 N against %2 N").arg(best.worst_N).arg(allowed_N)));
        QVERIFY(report.refused < 5);
        QCOMPARE(report.losses, std::uint64_t{0});
        m_bench->with([&](standin::Bench& b) { // stopped: the motors are off
            QCOMPARE(b.arm.amps, (standin::V3{0, 0, 0}));
        });
    }
};

PALPATE_TEST(Palpation)
#include "tst_Palpation.moc"
