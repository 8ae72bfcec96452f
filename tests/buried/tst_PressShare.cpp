// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/buried/Stiffening.h>

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palpate::buried;

class PressShare : public QObject
{
    Q_OBJECT

    static constexpr double kRadius_mm = 5.0;

    /// Returns the integral of w over the volume deeper than `top`: r = t h with h = z + c, and z = s / (1 - s), by
    /// Simpson's rule in both.
    static double integral(double top_mm)
    {
        constexpr int kSteps = 2000;
        const auto simpson = [](double from, double to, const auto& f) {
            const double step = (to - from) / kSteps;
            double sum = f(from) + f(to);
            for (int i = 1; i < kSteps; ++i) {
                sum += (i % 2 == 1 ? 4.0 : 2.0) * f(from + i * step);
            }
            return sum * step / 3.0;
        };
        const double c = pressureScale(kRadius_mm);
        return simpson(top_mm / (top_mm + c), 1.0 - 1e-12, [&](double s) {
            const double z = c * s / (1.0 - s), h = z + c;
            const double disc = simpson(0.0, std::numbers::pi / 2.0 - 1e-9, [&](double angle) {
                const double r = h * std::tan(angle), cosine = std::cos(angle);
                return 2.0 * std::numbers::pi * r * pressDensity(r, z, kRadius_mm) * h / (cosine * cosine);
            });
            return disc * c / ((1.0 - s) * (1.0 - s));
        });
    }

  private Q_SLOTS:
    void theEnergyOfAPressIsAllThere()
    {
        QVERIFY2(std::abs(integral(0.0) - 1.0) < 1e-9, std::to_string(integral(0.0) - 1.0).c_str());
    }

    void aLayerHoldsWhatTheFormulaSays()
    {
        for (const double depth : {0.3, 1.0, 2.5, 5.0, 20.0}) {
            QVERIFY(std::abs(integral(depth) - shareBelow(depth, kRadius_mm)) < 1e-8);
        }
        // As in the table of resources/docs/felt.md.
        const std::array<std::array<double, 2>, 5> known{
            {{0.5, 0.772}, {1.0, 0.564}, {2.0, 0.358}, {4.0, 0.205}, {6.0, 0.144}}};
        for (const auto& [depth, share] : known) {
            QVERIFY(std::abs(shareBelow(depth * kRadius_mm, kRadius_mm) - share) < 6e-4);
        }
    }

    void aSphereFarBelowHoldsItsVolumeTimesTheDensity()
    {
        const double b = 10.0, depth = 200.0 * b;
        const double far = 8.0 * kRadius_mm * b * b * b / (std::numbers::pi * std::pow(depth, 4));
        QVERIFY(std::abs(shareOfSphere(b, depth, kRadius_mm) / far - 1.0) < 0.01);
        const double local = 4.0 / 3.0 * std::numbers::pi * b * b * b * pressDensity(0.0, depth, kRadius_mm);
        QVERIFY(std::abs(shareOfSphere(b, depth, kRadius_mm) / local - 1.0) < 1e-3);
        QVERIFY(std::abs(shareOfSphere(5.0, 10.0, kRadius_mm) - 0.0721) < 5e-5); // volume integral, felt.md
    }

    void boundsAreInOrder()
    {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int i = 0; i < 100000; ++i) {
            const double share = unit(random), ratio = std::pow(10.0, 8.0 * unit(random) - 4.0);
            const auto k = stiffening(share, ratio);
            const double rounding = 1e-12 * k.high;
            QVERIFY(k.low > 0.0 && k.low <= k.estimate + rounding && k.estimate <= k.high + rounding);
            QVERIFY(ratio >= 1.0 ? k.low >= 1.0 : k.high <= 1.0);
        }
    }

    void theEndsOfTheRangeAreKnown()
    {
        const auto none = stiffening(0.0, 4.4), same = stiffening(0.4, 1.0), all = stiffening(1.0, 4.4);
        QCOMPARE(none.low, 1.0);
        QCOMPARE(none.high, 1.0);
        QCOMPARE(same.estimate, 1.0);
        QVERIFY(std::abs(all.low - 4.4) < 1e-12 && std::abs(all.estimate - 4.4) < 1e-12 &&
                std::abs(all.high - 4.4) < 1e-12);
        const auto rigid = stiffening(0.1, std::numeric_limits<double>::infinity());
        QVERIFY(std::abs(rigid.low - 1.0 / 0.9) < 1e-12 && std::isinf(rigid.high));
        QVERIFY(std::abs(rigid.estimate - (1.0 + 0.1 / (kBeta * 1.1 * 0.9))) < 1e-12);
        // A small, deep, rigid sphere: Eshelby's 5/2.
        QVERIFY(std::abs((stiffening(1e-6, 1e12).estimate - 1.0) / 1e-6 - 2.5) < 1e-4);
    }

    void partsOfALumpFeelAsTheWhole()
    {
        const std::array<LumpShare, 2> parts{{{0.1, 3.0}, {0.25, 3.0}}};
        const auto together = stiffening(parts), whole = stiffening(0.35, 3.0);
        QVERIFY(std::abs(together.low - whole.low) < 1e-12);
        QVERIFY(std::abs(together.estimate - whole.estimate) < 1e-12);
        QVERIFY(std::abs(together.high - whole.high) < 1e-12);
    }

    void aHardPressComesNearer()
    {
        // On the axis, 8 mm below: the estimates of resources/docs/felt.md.
        const std::array<std::array<double, 2>, 4> known{{{0.0, 9.77}, {2.0, 13.34}, {4.0, 18.76}, {6.0, 27.39}}};
        for (const auto& [press, percent] : known) {
            const double share = shareOfSphere(10.0, 18.0 - approach(8.0, press, kRadius_mm), kRadius_mm);
            QVERIFY(std::abs(100.0 * (stiffening(share, 3.0).estimate - 1.0) - percent) < 0.1);
        }
        QCOMPARE(approach(0.0, 4.0, kRadius_mm), 0.0);
        QCOMPARE(approach(-1.0, 4.0, kRadius_mm), 0.0);
    }
};

PALPATE_TEST(PressShare)
#include "tst_PressShare.moc"
