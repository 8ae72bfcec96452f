// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/study/PressedPairs.h>
#include <palpate/study/ThresholdSeries.h>

#include <QTest>

#include <cmath>
#include <random>
#include <string>

using namespace palpate;

/// Tests the adaptive series on simulated observers with a known threshold.
class ThresholdSeries : public QObject
{
    Q_OBJECT

    static constexpr int kSeeds = test::trials(100);

    struct Recovered
    {
        int within = 0;     ///< series within ±3 percentage points of the threshold
        int inInterval = 0; ///< series with the threshold in the credible interval
        double bias = 0.0;  ///< mean error
    };
    static Recovered recover(double threshold_percent, double slope)
    {
        Recovered out;
        for (unsigned seed = 0; seed < kSeeds; ++seed) {
            std::mt19937 random(seed);
            auto series = study::ThresholdSeries::create().value();
            while (!series.isDone()) {
                const double u = (static_cast<double>(random()) + 0.5) / 4294967296.0;
                series.answer(u < study::rightAnswers(series.percent(), threshold_percent, slope, 4));
            }
            const study::HandThreshold is = series.estimate();
            const double error = is.percent - threshold_percent;
            out.within += std::abs(error) <= 3.0 ? 1 : 0;
            out.inInterval += is.low_percent <= threshold_percent && threshold_percent <= is.high_percent ? 1 : 0;
            out.bias += error / kSeeds;
        }
        return out;
    }

  private Q_SLOTS:
    void twoRightAnswersMakeItHarderOneWrongEasier()
    {
        auto series = study::ThresholdSeries::create({7, 4, 80.0}).value();
        const auto answers = [&series](std::initializer_list<bool> all) {
            for (const bool isRight : all) {
                series.answer(isRight);
            }
        };
        answers({true});
        QCOMPARE(series.percent(), 80.0);
        answers({true});
        QCOMPARE(series.percent(), 80.0 / 1.6);
        answers({false}); // first reversal
        QCOMPARE(series.percent(), 80.0);
        QCOMPARE(series.reversals(), std::size_t{1});
        answers({true, false}); // the right answer before no longer counts; the second wrong one in the same direction
        QVERIFY(std::abs(series.percent() - 128.0) < 1e-12);
        QCOMPARE(series.reversals(), std::size_t{1});
        answers({true, true}); // second reversal: smaller steps
        QVERIFY(std::abs(series.percent() - 128.0 / 1.25) < 1e-12);
        QVERIFY(series.isDone());
        answers({false});
        QCOMPARE(series.trials().size(), std::size_t{7});
        QVERIFY(series.trials()[2].percent == 80.0 / 1.6 && !series.trials()[2].isRight);
    }

    void oneOfTwoPressesIsStiffer()
    {
        study::PressedPairs pairs(7, 3);
        int second = 0;
        for (int trial = 0; trial < 3; ++trial) {
            const double first = pairs.ratio();
            QVERIFY(!pairs.takeForce(0.5) && !pairs.takeForce(0.0)); // touched, not pressed
            QVERIFY(!pairs.takeForce(2.0) && pairs.takeForce(0.0));
            QVERIFY(pairs.stage() == study::PressedPairs::Stage::Second);
            QVERIFY((first == 1.0) != (pairs.ratio() == 1.0));
            QVERIFY((pairs.ratio() > first) == pairs.isSecondStiffer());
            second += pairs.isSecondStiffer() ? 1 : 0;
            pairs.answer(true); // too early
            QVERIFY(!pairs.takeForce(2.0) && pairs.takeForce(0.0));
            pairs.answer(pairs.isSecondStiffer());
        }
        QVERIFY(pairs.stage() == study::PressedPairs::Stage::Done && pairs.series().isDone());
        QVERIFY(pairs.series().trials()[2].isRight && second > 0 && second < 3);
        const auto wall = study::wallScene({1, 2, 3}, core::Vec3(0, 0, 1), 50.0, 0.3);
        QCOMPARE(wall->structures()[0].tissue.stiffness_N_per_mm, 0.3);
        QCOMPARE(wall->structures()[0].surface->triangleCount(), std::size_t{2});
    }

    void levelsStayInTheirRange()
    {
        auto hard = study::ThresholdSeries::create().value(), easy = hard;
        while (!hard.isDone()) {
            hard.answer(true);
            easy.answer(false);
        }
        QCOMPARE(hard.percent(), 1.0);
        QCOMPARE(easy.percent(), 200.0);
        QVERIFY(hard.estimate().percent < 5.0 && easy.estimate().percent > 100.0);
    }

    void rightAnswersHaveTheirThreshold()
    {
        for (const std::size_t choices : {2U, 4U, 16U}) {
            QVERIFY(std::abs(study::rightAnswers(20.0, 20.0, 3.5, choices) - std::sqrt(0.5)) < 1e-12);
            QVERIFY(std::abs(study::rightAnswers(0.0, 20.0, 3.5, choices) - 1.0 / static_cast<double>(choices)) <
                    1e-12);
            QVERIFY(std::abs(study::rightAnswers(1e4, 20.0, 3.5, choices) - 1.0) < 1e-12);
        }
    }

    /// The bounds are the shares in docs/exercise.md less three standard errors, 90 % of intervals that should hold the
    /// threshold in 95 %, and a mean error of half the 3 points.
    void simulatedObserversAreRecovered_data()
    {
        QTest::addColumn<double>("threshold");
        QTest::addColumn<double>("share");
        QTest::newRow("10 %") << 10.0 << 0.99;
        QTest::newRow("20 %") << 20.0 << 0.93;
        QTest::newRow("30 %") << 30.0 << 0.78;
        QTest::newRow("40 %") << 40.0 << 0.70;
    }
    void simulatedObserversAreRecovered()
    {
        QFETCH(double, threshold);
        QFETCH(double, share);
        const Recovered is = recover(threshold, 3.5);
        const std::string seen = std::to_string(is.within) + " of " + std::to_string(kSeeds) + " within 3 points, " +
                                 std::to_string(is.inInterval) + " in the interval, bias " + std::to_string(is.bias);
        qInfo("%s", seen.c_str());
        const double error = std::sqrt(share * (1.0 - share) / kSeeds);
        QVERIFY2(is.within >= kSeeds * (share - 3.0 * error), seen.c_str());
        QVERIFY2(is.inInterval >= 0.9 * kSeeds, seen.c_str());
        QVERIFY2(std::abs(is.bias) < 1.5, seen.c_str());
    }

    void optionsOutOfRangeAreRefused()
    {
        QCOMPARE(study::ThresholdSeries::create({0, 4, 80.0}).status().message(),
                 std::string("trials: found 0, expected 1 to 10000"));
        QCOMPARE(study::ThresholdSeries::create({60, 1, 80.0}).status().message(),
                 std::string("places: found 1, expected 2 to 16"));
        QVERIFY(!study::ThresholdSeries::create({60, 4, 0.0}).isOk());
        QVERIFY(!study::ThresholdSeries::create({60, 4, std::nan("")}).isOk());
    }
};

PALPATE_TEST(ThresholdSeries)
#include "tst_ThresholdSeries.moc"
