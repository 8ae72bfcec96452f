// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/TouchTone.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace palpate;

/// Tests the samples of the touch sound.
class TouchTone : public QObject
{
    Q_OBJECT

    static std::vector<float> second(ui::TouchTone& tone)
    {
        std::vector<float> samples(ui::TouchTone::kRate_Hz);
        tone.fill(samples);
        return samples;
    }

  private Q_SLOTS:
    void aJustNoticeableDifferenceIsASemitone()
    {
        const double semitone = std::exp2(1.0 / 12.0);
        double pitch = 220.0, ratio = 1.0;
        for (int i = 0; i <= 24; ++i) {
            QVERIFY(std::abs(ui::pitch_Hz(ratio) / pitch - 1.0) < 1e-12);
            QVERIFY(i > 12 || std::abs(ui::pitch_Hz(1.0 / ratio) * pitch / (220.0 * 220.0) - 1.0) < 1e-12);
            ratio *= 1.07;
            pitch *= semitone;
        }
        QCOMPARE(ui::pitch_Hz(1e300), 3520.0);
        for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
            QCOMPARE(ui::pitch_Hz(none), 55.0);
        }
    }
    void loudAsTheForceAndNeverTooLoud()
    {
        QCOMPARE(ui::loudness(0.0, 8.0), 0.0);
        QCOMPARE(ui::loudness(2.0, 8.0), 0.15);
        QCOMPARE(ui::loudness(80.0, 8.0), 0.6);
        for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
            QCOMPARE(ui::loudness(none, 8.0), 0.0);
            QCOMPARE(ui::loudness(1.0, none), 0.0);
        }
    }
    void theToneIsWhatWasSet()
    {
        ui::TouchTone tone;
        const std::vector<float> silence = second(tone);
        QVERIFY(std::all_of(silence.begin(), silence.end(), [](float s) { return s == 0.0f; }));
        tone.set(440.0, 0.5);
        second(tone);
        const std::vector<float> samples = second(tone);
        int rises = 0;
        for (std::size_t i = 1; i < samples.size(); ++i) {
            rises += samples[i - 1] < 0.0f && samples[i] >= 0.0f ? 1 : 0;
        }
        QVERIFY2(std::abs(rises - 440) <= 1, qPrintable(QString::number(rises)));
        const float most = *std::max_element(samples.begin(), samples.end());
        QVERIFY(std::abs(most - 0.5f) < 1e-3f);
    }
    /// On a change of tone or to silence, no step is larger than within the two tones.
    void changesDoNotClick()
    {
        ui::TouchTone tone;
        float before = 0.0f;
        double pitchBefore = 220.0;
        for (const auto& [pitch, loud] : {std::pair(880.0, 0.6), std::pair(110.0, 0.6), std::pair(3520.0, 0.0),
                                          std::pair(220.0, 0.3), std::pair(220.0, 0.0)}) {
            tone.set(pitch, loud);
            const double turns = std::max(pitch, pitchBefore) / ui::TouchTone::kRate_Hz;
            for (const float sample : second(tone)) {
                QVERIFY(std::abs(sample - before) < 0.6 * (2.0 * std::numbers::pi * turns + 0.002));
                before = sample;
            }
            pitchBefore = pitch;
        }
        QVERIFY(std::abs(before) < 1e-6f);
    }
};

PALPATE_TEST(TouchTone)
#include "tst_TouchTone.moc"
