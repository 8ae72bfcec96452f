// SPDX-License-Identifier: BSD-3-Clause
// Tests the statistics of several paths against known quantiles and simulated samples.
#include "TestRunner.h"

#include <palpate/evaluation/Spread.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace palpate::evaluation;

class SpreadOfPaths : public QObject
{
    Q_OBJECT

    static std::vector<double> logNormal(std::mt19937_64& random, std::size_t count, double sigma)
    {
        std::vector<double> values(count);
        for (double& v : values) {
            // Box-Muller from two uniform numbers: std::normal_distribution differs between libraries.
            const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
            const double w = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
            v = std::exp(sigma * std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * w));
        }
        return values;
    }

  private Q_SLOTS:
    void medianHasAnIntervalBetweenValues()
    {
        const Spread one = spreadOf({3.0}, 1e-12);
        QCOMPARE(one.median, 3.0);
        QCOMPARE(one.low, 3.0);
        QCOMPARE(one.high, 3.0);
        QCOMPARE(one.confidence, 0.0);
        const Spread three = spreadOf({3.0, 1.0, 2.0}, 1e-12);
        QCOMPARE(three.median, 2.0);
        QCOMPARE(three.medianLow, 1.0);
        QCOMPARE(three.medianHigh, 3.0);
        QCOMPARE(three.confidence, 0.75); // 1 - 2/2^3
        QCOMPARE(three.values, (std::vector<double>{3.0, 1.0, 2.0}));
        const Spread nine = spreadOf({1, 2, 3, 4, 5, 6, 7, 8, 9}, 1e-12);
        QCOMPARE(nine.medianLow, 2.0); // 1 - 2 (1 + 9)/2^9 = 96.1 %
        QCOMPARE(nine.medianHigh, 8.0);
        QCOMPARE(nine.confidence, 1.0 - 20.0 / 512.0);
        QCOMPARE(spreadOf({1, 2, 3, 4, 5, 6, 7, 8}, 1e-12).medianLow, 1.0); // 2 to 7 would give 93 %
        const Spread sixteen = spreadOf({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, 1e-12);
        QCOMPARE(sixteen.medianLow, 4.0);
        QCOMPARE(sixteen.confidence, 1.0 - 2.0 * (1 + 16 + 120 + 560) * 0x1p-16); // evaluate.md: 98 %
        QVERIFY(spreadOf({}, 1e-12).values.empty());
    }

    void zerosAndBoundsAreKept()
    {
        const Spread spread = spreadOf({0.0, 0.0, 1.0, 1.0}, 1e-12, 5.0);
        QCOMPARE(spread.low, 0.0);
        QCOMPARE(spread.high, 5.0);
        QCOMPARE(spread.median, 0.5);
        const Spread same = spreadOf({2.0, 2.0, 2.0}, 1e-12);
        QVERIFY(std::abs(same.low - 2.0) < 1e-12 && std::abs(same.high - 2.0) < 1e-12);
    }

    /// For log-normal values, 95 % of new values are within the spread, and the median's interval covers the median
    /// with its stated confidence.
    void coversWhatItSays_data()
    {
        QTest::addColumn<int>("paths");
        QTest::newRow("3") << 3;
        QTest::newRow("8") << 8;
        QTest::newRow("20") << 20;
    }
    void coversWhatItSays()
    {
        QFETCH(int, paths);
        constexpr int kTrials = 20000;
        std::mt19937_64 random(5);
        int within = 0, medians = 0;
        double confidence = 0.0;
        for (int i = 0; i < kTrials; ++i) {
            std::vector<double> values = logNormal(random, static_cast<std::size_t>(paths) + 1, 1.3);
            const double another = values.back();
            values.pop_back();
            const Spread spread = spreadOf(values, 1e-12);
            within += another >= spread.low && another <= spread.high ? 1 : 0;
            medians += spread.medianLow <= 1.0 && spread.medianHigh >= 1.0 ? 1 : 0;
            confidence = spread.confidence;
        }
        const double share = static_cast<double>(within) / kTrials, held = static_cast<double>(medians) / kTrials;
        QVERIFY2(share > 0.945 && share < 0.97, qPrintable(QString::number(share))); // at least as wide as the values
        QVERIFY2(std::abs(held - confidence) < 0.01, qPrintable(QString::number(held)));
    }
};

PALPATE_TEST(SpreadOfPaths)
#include "tst_SpreadOfPaths.moc"
