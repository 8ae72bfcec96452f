// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/PuckReader.h>

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <vector>

using namespace palpate;

namespace {

/// A 6-axis mouse under constant downward push; calibration gives one state without a hand and returns to the origin.
class PushedPuck final : public device::HapticDevice
{
  public:
    double speed_mm_per_s = 30.0;
    bool isThere = true;
    int calibrations = 0;

    device::DeviceInfo info() const override
    {
        device::DeviceInfo info;
        info.workspaceRadius_mm = 10.0; // reaches half of the range in a sixth of a second
        info.isRateControlled = true;
        return info;
    }
    core::Status start() override { return {}; }
    void stop() noexcept override {}
    device::DeviceState read(std::int64_t now_ns) noexcept override
    {
        device::DeviceState state;
        if (m_isRecentring) {
            m_isRecentring = false;
            m_from_ns = now_ns;
            return state;
        }
        m_from_ns = m_from_ns == 0 ? now_ns : m_from_ns;
        state.p_D.z() = -speed_mm_per_s * static_cast<double>(now_ns - m_from_ns) * 1e-9;
        state.isPresent = isThere;
        return state;
    }
    void write(const core::Vec3& /*f_D*/) noexcept override {}
    core::Status calibrate() override
    {
        ++calibrations;
        m_isRecentring = true;
        return {};
    }

  private:
    std::int64_t m_from_ns = 0;
    bool m_isRecentring = false;
};

} // namespace

class PuckReader : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void thePushIsTheSpeedDown()
    {
        device::DeviceState from, to;
        from.isPresent = to.isPresent = true;
        to.p_D = {3.0, -2.0, -0.3}; // mm in 10 ms; sideways motion is ignored
        QCOMPARE(ui::pushOf(from, to, 0.01), 0.5);
        to.p_D.z() = -3.0;
        QCOMPARE(ui::pushOf(from, to, 0.01), 1.0);
        to.p_D.z() = 0.3;
        QCOMPARE(ui::pushOf(from, to, 0.01), 0.0); // pulled
        to.p_D.z() = -0.3;
        QCOMPARE(ui::pushOf(from, to, 0.0), 0.0);
        QCOMPARE(ui::pushOf(from, to, std::nan("")), 0.0);
        to.isPresent = false;
        QCOMPARE(ui::pushOf(from, to, 0.01), 0.0);
    }
    /// While held down, the push continues past the end of the device's workspace without a gap; unplugged, the push is
    /// zero.
    void aHeldPushHasNoEnd()
    {
        ui::PuckReader reader;
        std::vector<double> shares;
        connect(&reader, &ui::PuckReader::moved, this,
                [&](const device::DeviceState& from, const device::DeviceState& to, double passed_s) {
                    shares.push_back(ui::pushOf(from, to, passed_s));
                });
        auto made = std::make_unique<PushedPuck>();
        PushedPuck& puck = *made;
        QVERIFY(reader.use(std::move(made)).isOk());
        PALPATE_TRY_VERIFY(puck.calibrations >= 3 && shares.size() > 20);
        for (const double share : shares) {
            QVERIFY2(std::abs(share - 0.5) < 1e-6, qPrintable(QString::number(share)));
        }
        puck.isThere = false;
        shares.clear();
        PALPATE_TRY_VERIFY(shares.size() > 2);
        QCOMPARE(shares.back(), 0.0);
        QVERIFY(reader.use(nullptr).isOk());
        QVERIFY(!reader.isOn());
    }
};

PALPATE_TEST(PuckReader)
#include "tst_PuckReader.moc"
