// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/AxisCheck.h>

#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace palpate;
using core::Vec3;
using device::AxisVerdict;

namespace {

using Columns = Eigen::Matrix3d;

/// Moves of a hand that follows the instructions, in U: right, away, up. Each takes 1 s and is followed by a rest.
Vec3 handAt_U(double time_s)
{
    const Vec3 moves[] = {Vec3(50, 0, 0), Vec3(0, 0, -50), Vec3(0, 50, 0)};
    Vec3 p(3, -4, 5);
    for (int i = 0; i < 3; ++i) {
        p += moves[i] * std::clamp(time_s - 1.0 - 2.0 * i, 0.0, 1.0);
    }
    return p + 0.3 * Vec3(std::sin(50.0 * time_s), std::cos(47.0 * time_s), 0); // tremor
}

/// Follows the hand with a device whose positions are `axes` times those of the hand in its frame.
device::AxisCheck followed(const device::DeviceInfo& info, const Columns& axes)
{
    device::AxisCheck check(info);
    for (double time_s = 0.01; time_s < 100.0 && !check.isDone(); time_s += 0.02) {
        device::DeviceState state;
        state.isPresent = true;
        state.p_D = info.q_UD.inverse() * (axes * handAt_U(time_s));
        check.follow(state, time_s);
    }
    return check;
}

Columns columns(const Vec3& x, const Vec3& y, const Vec3& z)
{
    Columns m;
    m << x, y, z;
    return m;
}

} // namespace
Q_DECLARE_METATYPE(Columns)

class AxisCheck : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void statesHowEachAxisMoves_data()
    {
        QTest::addColumn<Columns>("axes");
        QTest::addColumn<QString>("verdicts"); // of right, away, up: f follows, m mirrored, s swapped, o oblique
        QTest::addColumn<bool>("isMirrored");
        const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
        QTest::newRow("right") << columns(x, y, z) << "fff" << false;
        QTest::newRow("x mirrored") << columns(-x, y, z) << "mff" << true;
        QTest::newRow("z mirrored") << columns(x, y, -z) << "fmf" << true;
        QTest::newRow("y mirrored") << columns(x, -y, z) << "ffm" << true;
        QTest::newRow("turned by 180 degrees about y") << columns(-x, y, -z) << "mmf" << false;
        QTest::newRow("turned by 90 degrees about y") << columns(-z, y, x) << "ssf" << false;
        QTest::newRow("y and z swapped") << columns(x, z, y) << "fss" << true;
        QTest::newRow("turned by 90 degrees about x") << columns(x, z, -y) << "fss" << false;
        const double c = std::sqrt(0.5);
        QTest::newRow("turned by 45 degrees about y") << columns(c * (x - z), y, c * (x + z)) << "oof" << false;
        QTest::newRow("turned by 20 degrees about y")
            << Columns(Eigen::AngleAxisd(0.35, Vec3::UnitY()).toRotationMatrix()) << "fff" << false;
    }

    void statesHowEachAxisMoves()
    {
        QFETCH(const Columns, axes);
        QFETCH(const QString, verdicts);
        QFETCH(const bool, isMirrored);
        device::DeviceInfo info;
        info.name = "arm";
        info.q_UD = core::Quaternion(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitX()));
        const device::AxisCheck check = followed(info, axes);
        QVERIFY(check.isDone());
        for (std::size_t i = 0; i < 3; ++i) {
            const char letters[] = {'p', 'f', 'm', 's', 'o', 'u'};
            QCOMPARE(QChar::fromLatin1(letters[static_cast<int>(check.results()[i].verdict)]),
                     verdicts[static_cast<int>(i)]);
            QVERIFY(!check.statement(i).english().empty());
        }
        QCOMPARE(check.isMirrored(), isMirrored);
        QCOMPARE(check.isRight(), verdicts == QLatin1String("fff"));
        QCOMPARE(check.remedy().english().empty(), check.isRight());
        if (isMirrored) {
            QVERIFY(check.remedy().english().find("mirrors") != std::string::npos);
        } else if (!check.isRight()) {
            QVERIFY(check.remedy().english().find("turn its base") != std::string::npos);
        }
    }

    void namesTheMotion()
    {
        const device::AxisCheck check =
            followed({}, columns(Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY())); // y and z swapped
        QCOMPARE(check.statement(0).english(), std::string("Asked to move to the right: the device follows."));
        QVERIFY(check.statement(1).english().find("away from you: the device shows a motion down") !=
                std::string::npos);
        QVERIFY(check.statement(2).english().find("up: the device shows a motion towards you") != std::string::npos);
    }

    void endsWithoutMotionAndWithBadPositions_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("at rest") << 0;
        QTest::newRow("absent") << 1;
        QTest::newRow("NaN") << 2;
    }

    void endsWithoutMotionAndWithBadPositions()
    {
        QFETCH(const int, kind);
        device::AxisCheck check(device::DeviceInfo{});
        double time_s = 0.01;
        for (; time_s < 200.0 && !check.isDone(); time_s += 0.02) {
            device::DeviceState state;
            state.isPresent = kind != 1;
            state.p_D = Vec3::Constant(kind == 2 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
            check.follow(state, time_s);
        }
        QVERIFY(check.isDone());
        QVERIFY(time_s < 3.0 * device::AxisCheck::kLongest_s + 5.0);
        for (const device::AxisResult& result : check.results()) {
            QCOMPARE(result.verdict, AxisVerdict::Unmoved);
            QVERIFY(result.moved_mm.allFinite());
        }
        QVERIFY(!check.isRight() && !check.isMirrored());
        QVERIFY(!check.remedy().english().empty());
    }

    void smallWorkspacesNeedASmallerWay()
    {
        device::DeviceInfo info;
        info.workspaceRadius_mm = 40.0;
        QCOMPARE(device::AxisCheck(info).way_mm(), 12.0);
    }
};

PALPATE_TEST(AxisCheck)
#include "tst_AxisCheck.moc"
