// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Clock.h>
#include <palpate/core/TimingHistogram.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

using Histogram = palpate::core::TimingHistogram;

class TimingHistogram : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void aShortDurationEndsAtItsBounds()
    {
        using palpate::core::shortDuration_ns;
        constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
        QCOMPARE(shortDuration_ns(-1), std::uint32_t{0});
        QCOMPARE(shortDuration_ns(1234), std::uint32_t{1234});
        QCOMPARE(shortDuration_ns(kMost), std::uint32_t{0xffffffff});
        QCOMPARE(shortDuration_ns(kMost + 1), std::uint32_t{0xffffffff});
        QCOMPARE(shortDuration_ns(std::numeric_limits<std::int64_t>::max()), std::uint32_t{0xffffffff});
    }

    void isZeroWithoutValues()
    {
        const auto summary = Histogram().summary();
        QCOMPARE(summary.count, std::uint64_t{0});
        QCOMPARE(summary.p50_ns, std::int64_t{0});
        QCOMPARE(summary.max_ns, std::int64_t{0});
    }

    void isExactForShortTimes()
    {
        Histogram histogram;
        for (int i = 1; i <= 200; ++i) {
            histogram.add(i);
        }
        const auto summary = histogram.summary();
        QCOMPARE(summary.count, std::uint64_t{200});
        QCOMPARE(summary.p50_ns, std::int64_t{100});
        QCOMPARE(summary.p99_ns, std::int64_t{198});
        QCOMPARE(summary.p999_ns, std::int64_t{200});
        QCOMPARE(summary.max_ns, std::int64_t{200});
    }

    void percentilesAreWithinTheirBinOfTheTrueOnes_data()
    {
        QTest::addColumn<double>("meanLog");
        QTest::addColumn<double>("sigma");
        QTest::newRow("microseconds") << std::log(2e3) << 1.0;
        QTest::newRow("about a millisecond") << std::log(1e6) << 0.05;
        QTest::newRow("all over the range") << std::log(1e5) << 3.0;
    }
    void percentilesAreWithinTheirBinOfTheTrueOnes()
    {
        QFETCH(double, meanLog);
        QFETCH(double, sigma);
        std::mt19937 random(5); // NOLINT: a fixed seed
        std::lognormal_distribution<double> distribution(meanLog, sigma);
        Histogram histogram;
        std::vector<std::int64_t> values;
        for (int i = 0; i < 100'000; ++i) {
            values.push_back(std::min(static_cast<std::int64_t>(distribution(random)), std::int64_t{4'000'000'000}));
            histogram.add(values.back());
        }
        std::sort(values.begin(), values.end());
        const auto summary = histogram.summary();
        const auto verify = [&](std::int64_t shown, double share) {
            const std::int64_t exact = values[static_cast<std::size_t>(std::ceil(share * 100'000.0)) - 1];
            return shown >= exact &&
                   static_cast<double>(shown) <= static_cast<double>(exact) * (1.0 + 1.0 / 256.0) + 1.0;
        };
        QVERIFY(verify(summary.p50_ns, 0.5));
        QVERIFY(verify(summary.p99_ns, 0.99));
        QVERIFY(verify(summary.p999_ns, 0.999));
        QCOMPARE(summary.max_ns, values.back());
    }

    void takesAnyNumber()
    {
        Histogram histogram;
        histogram.add(std::numeric_limits<std::int64_t>::min());
        histogram.add(-1);
        QCOMPARE(histogram.summary().p999_ns, std::int64_t{0});
        histogram.add(std::numeric_limits<std::int64_t>::max());
        QCOMPARE(histogram.summary().count, std::uint64_t{3});
        QCOMPARE(histogram.summary().p999_ns, std::int64_t{0xFFFFFFFF});
        QCOMPARE(histogram.summary().max_ns, std::numeric_limits<std::int64_t>::max());
        histogram.clear();
        QCOMPARE(histogram.summary().count, std::uint64_t{0});
    }

    void canBeReadWhileItIsFilled()
    {
        Histogram histogram;
        constexpr int kValues = 300'000;
        std::barrier start(2);
        std::thread servo([&] {
            start.arrive_and_wait();
            for (int i = 0; i < kValues; ++i) {
                histogram.add(i % 1000);
            }
        });
        start.arrive_and_wait();
        std::uint64_t last = 0;
        bool isGrowing = true;
        for (int i = 0; i < 200; ++i) {
            const auto summary = histogram.summary();
            isGrowing = isGrowing && summary.count >= last && summary.max_ns <= 999;
            last = summary.count;
        }
        servo.join();
        QVERIFY(isGrowing);
        QCOMPARE(histogram.summary().count, std::uint64_t{kValues});
    }
};

PALPATE_TEST(TimingHistogram)
#include "tst_TimingHistogram.moc"
