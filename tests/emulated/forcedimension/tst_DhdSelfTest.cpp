// SPDX-License-Identifier: BSD-3-Clause
// The self-test with the released plugin and the emulated device, in virtual time: its numbers are those of the bench,
// the held stiffness is the one that `palpate stability` predicts, and every fault ends it without force and page.
#include "EmulatedArm.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <palpate/evaluation/Stability.h>
#include <palpate/servo/SelfTestRun.h>
#include <palpate/study/SelfTestPage.h>

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using servo::SelfTestStep;
using servo::SelfTestStop;

namespace {

struct Break
{
    std::function<void(standin::DhdBench&)> begin;
};

servo::SelfTestOptions quick()
{
    servo::SelfTestOptions options;
    options.lead_s = 0.5;
    options.handTimeout_s = 3.0;
    options.pulses = 40;
    return options;
}

/// The bench's own properties as a device, and its hand as a grip (DhdBench.cpp).
evaluation::stability::Setup emulated(int delayTicks, bool isControlled)
{
    evaluation::stability::Setup setup;
    setup.preset = *device::findDevicePreset("omega");
    setup.preset.mechanics.friction_N = 0.0;
    setup.preset.mechanics.mass_kg = 0.15;
    setup.preset.mechanics.damping_Ns_per_mm = 0.001;
    setup.delayTicks = delayTicks;
    setup.isControlled = isControlled;
    setup.hands = {{"the hand of the bench", 0.1, 0.5, 0.005}};
    return setup;
}

/// Prediction of `palpate stability` for the wall. It knows whole ticks of delay only: 1 / K is linear in between
/// (Hulin), at 1 kHz.
double predicted(bool isControlled, double delay_ms)
{
    const auto wall = evaluation::stability::standardShapes().front();
    const double whole = std::floor(delay_ms), share = delay_ms - whole;
    const auto at = [&](double ticks) {
        return evaluation::stability::largestStiffness(wall, emulated(static_cast<int>(ticks), isControlled));
    };
    return 1.0 / ((1.0 - share) / at(whole) + share / at(whole + 1.0));
}

} // namespace
Q_DECLARE_METATYPE(Break)
Q_DECLARE_METATYPE(servo::SelfTestStep)

class DhdSelfTest : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedDhd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;
    std::unique_ptr<device::HapticDevice> m_device;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedDhd>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
    }
    void init()
    {
        m_bench->renew();
        m_device = m_bench->make(*m_host);
        QVERIFY(m_device != nullptr);
    }
    void cleanup()
    {
        m_device.reset();
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QCOMPARE(m_bench->violation(7.5), QString());
    }

    void holdsTheStiffnessThatStabilityPredicts()
    {
        servo::SelfTestRun test;
        QVERIFY(test.start(*m_device, quick()).isOk());
        while (test.poll()) {
            pass(0.05);
        }
        const servo::SelfTestResult result = test.finish();
        QVERIFY2(result.isComplete(),
                 servo::unmeasured(result).empty() ? "" : servo::unmeasured(result).front().english().c_str());
        const double plain = predicted(false, result.roundTrip->median_ms);
        const double controlled = predicted(true, result.roundTrip->median_ms);
        for (const core::Message& line : study::selfTestLines(result)) {
            qInfo("%s", line.english().c_str());
        }
        qInfo("held %.3g and %.3g N/mm, predicted %.3g and %.3g for a delay of %.2f ms", *result.held_N_per_mm,
              *result.heldControlled_N_per_mm, plain, controlled, result.roundTrip->median_ms);
        QVERIFY(std::abs(*result.held_N_per_mm / plain - 1.0) < 0.1);
        QVERIFY(*result.heldControlled_N_per_mm > 0.9 * controlled); // the end of the range without a delay
        QVERIFY(std::abs(result.roundTrip->mass_kg - 0.25) < 0.05);
        QVERIFY(result.roundTrip->median_ms > 0.0 && result.roundTrip->median_ms < 3.0);
        QVERIFY(*result.friction_N < 0.05);

        // The page: complete, and replaced as a whole.
        QTemporaryDir folder;
        const std::filesystem::path out = folder.path().toStdString() + "/new/folder";
        QVERIFY(study::writeSelfTest(out, result).isOk());
        QFile json(QString::fromStdString((out / "selftest.json").string()));
        QVERIFY(json.open(QIODevice::ReadOnly));
        const QJsonObject object = QJsonDocument::fromJson(json.readAll()).object();
        QCOMPARE(object["held_with_n_per_mm"].toDouble(), *result.heldControlled_N_per_mm);
        QCOMPARE(object["complete"].toBool(), true);
        QCOMPARE(object["prediction"].toString(),
                 QStringLiteral("palpate stability --device omega --rate 1000 --delay %1").arg(result.delayTicks));
        QFile html(QString::fromStdString((out / "selftest.html").string()));
        QVERIFY(html.open(QIODevice::ReadOnly));
        const QByteArray text = html.readAll();
        QCOMPARE(text.count("<svg"), 5);
        QVERIFY(text.trimmed().endsWith("</html>"));
        QVERIFY(!text.contains("nan") && !text.contains("inf "));
    }

    void endsWithoutForce_data()
    {
        QTest::addColumn<SelfTestStep>("step");
        QTest::addColumn<Break>("fault");
        const auto first = [](standin::DhdBench& b) -> standin::DhdDevice& { return b.devices[0]; };
        const auto wall = SelfTestStep::Walls;
        QTest::newRow("dies at a wall") << wall << Break{[=](auto& b) { standin::plugDhd(first(b), false); }};
        QTest::newRow("frozen from the start")
            << SelfTestStep::Rest << Break{[=](auto& b) { first(b).faults.isFrozen = true; }};
    }

    void endsWithoutForce()
    {
        QFETCH(const SelfTestStep, step);
        QFETCH(const Break, fault);
        servo::SelfTestRun test;
        QVERIFY(test.start(*m_device, quick()).isOk());
        bool isBroken = false;
        double waited_s = 0.0;
        while (test.poll()) {
            pass(0.05);
            waited_s += test.step() == step ? 0.05 : 0.0;
            if (!isBroken && waited_s > 1.0) {
                m_bench->with(fault.begin);
                isBroken = true;
            }
        }
        const servo::SelfTestResult result = test.finish();
        QVERIFY(isBroken);
        QVERIFY(result.stopped != SelfTestStop::None);
        QVERIFY(!result.heldControlled_N_per_mm);
        QVERIFY(!servo::unmeasured(result).front().english().empty());
        m_bench->with([](standin::DhdBench& b) { b.devices[0].faults = {}; });
    }

    void removesTheForceWhenItsOwnerLeaves()
    {
        {
            servo::SelfTestRun test;
            QVERIFY(test.start(*m_device, quick()).isOk());
            while (test.step() != SelfTestStep::Walls && test.poll()) {
                pass(0.05);
            }
            pass(1.0);
            QVERIFY2(m_bench->motors().norm() > 1.0, "a wall presses");
        }
        pass(0.02);
        QCOMPARE(m_bench->motors().norm(), 0.0);
    }
};

PALPATE_TEST(DhdSelfTest)
#include "tst_DhdSelfTest.moc"
