// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <Models.h>
#include <Puck.h>
#include <RateHand.h>

#include <QFile>
#include <QRegularExpression>

#include <random>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t kMs = 1'000'000;

} // namespace

class Puck : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsBothLayouts()
    {
        spacemouse::Puck seven;
        // 350, -175, 70; then 0, 350, -350.
        QVERIFY(seven.take(Bytes{1, 0x5e, 0x01, 0x51, 0xff, 0x46, 0x00}));
        QVERIFY(seven.take(Bytes{2, 0x00, 0x00, 0x5e, 0x01, 0xa2, 0xfe}));
        spacemouse::Puck thirteen;
        QVERIFY(thirteen.take(Bytes{1, 0x5e, 0x01, 0x51, 0xff, 0x46, 0x00, 0x00, 0x00, 0x5e, 0x01, 0xa2, 0xfe}));
        for (const auto& puck : {seven, thirteen}) {
            QCOMPARE(puck.held().shift, Vec3(1.0, 0.5, -0.2));
            QCOMPARE(puck.held().turn, Vec3(0.0, -1.0, 1.0));
        }
    }

    void readsButtonsOfAnyLength()
    {
        spacemouse::Puck puck;
        QVERIFY(puck.take(Bytes{3, 0x02, 0x01}));
        QCOMPARE(puck.held().buttons, 0x0102U);
        QVERIFY(puck.take(Bytes{3, 0x01, 0, 0, 0x80, 0xff, 0xff}));
        QCOMPARE(puck.held().buttons, 0x80000001U);
    }

    void refusesEverythingElse()
    {
        spacemouse::Puck puck;
        for (const Bytes& wrong : {Bytes{}, Bytes{1}, Bytes{1, 2, 3, 4, 5, 6}, Bytes{2, 1, 2, 3, 4, 5}, Bytes(8, 1),
                                   Bytes(12, 1), Bytes(14, 1), Bytes(13, 2), Bytes{9, 1, 2, 3, 4, 5, 6}}) {
            QVERIFY(!puck.take(wrong));
        }
        QCOMPARE(puck.held().shift, Vec3(0, 0, 0));
        // For any input, the fraction stays in its range.
        std::mt19937 random(1);
        for (int i = 0; i < 100'000; ++i) {
            Bytes wild(random() % 20);
            for (auto& b : wild) {
                b = static_cast<std::uint8_t>(random());
            }
            (void)puck.take(wild);
            QVERIFY(puck.held().shift.cwiseAbs().maxCoeff() <= 1.0 && puck.held().turn.cwiseAbs().maxCoeff() <= 1.0);
        }
    }

    void knowsItsModelsAndNoOthers()
    {
        for (const auto& model : spacemouse::models()) {
            QCOMPARE(spacemouse::findModel(model.vendor, model.product), &model);
        }
        QVERIFY(spacemouse::findModel(0x046d, 0xc626) != nullptr);
        QVERIFY(spacemouse::findModel(0x256f, 0xc652) != nullptr);
        for (const int product :
             {0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657, 0xc658, 0xc664, 0xc665, 0xc668, 0xc62c}) {
            QVERIFY(spacemouse::findModel(0x256f, static_cast<std::uint16_t>(product)) == nullptr);
        }
    }

    void theUdevRuleIsForThemAndNoOthers()
    {
        QFile file(QStringLiteral(PALPATE_SOURCE_DIR "/plugins/spacemouse/70-palpate-spacemouse.rules"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        std::size_t named = 0;
        for (const QByteArray& line : file.readAll().split('\n')) {
            const QRegularExpression ids(QStringLiteral("idVendor}==\"(....)\".*idProduct}==\"([^\"]*)\""));
            const auto match = ids.match(QString::fromUtf8(line));
            for (const QString& product : match.captured(2).split(QLatin1Char('|'), Qt::SkipEmptyParts)) {
                QVERIFY2(spacemouse::findModel(static_cast<std::uint16_t>(match.captured(1).toInt(nullptr, 16)),
                                               static_cast<std::uint16_t>(product.toInt(nullptr, 16))) != nullptr,
                         qPrintable(product));
                ++named;
            }
        }
        QCOMPARE(named, spacemouse::models().size());
    }

    void ratesHaveADeadZoneAnEndAndATimeOut()
    {
        spacemouse::RateSettings settings;
        settings.speed_mm_per_s = 100.0;
        settings.deadZone = 0.1;
        settings.reach_mm = 50.0;
        spacemouse::RateHand hand(settings);
        spacemouse::Held held;
        std::int64_t now_ns = kMs;
        const auto run = [&](double way, int ms, bool isHeard) {
            held.shift.x() = way;
            const std::int64_t heard_ns = now_ns;
            device::DeviceState state;
            for (int i = 0; i < ms; ++i) {
                now_ns += kMs;
                state = hand.advance(held, isHeard ? now_ns : heard_ns, now_ns);
            }
            return state.p_D.x();
        };
        (void)hand.advance(held, now_ns, now_ns);
        QCOMPARE(run(0.1, 100, true), 0.0);
        QVERIFY(std::abs(run(0.55, 100, true) - 5.0) < 1e-9); // half of the range beyond the dead zone
        const double before = run(0.0, 1, true);
        const double stale = run(1.0, 1000, false); // valid for 100 ms
        QVERIFY(std::abs(stale - before - 10.0) < 0.2);
        QVERIFY(std::abs(run(1.0, 2000, true) - 50.0) < 1e-9);
        QVERIFY(std::abs(run(-1.0, 100, true) - 40.0) < 1e-9);
    }
};

PALPATE_TEST(Puck)
#include "tst_Puck.moc"
