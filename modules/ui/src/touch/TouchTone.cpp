// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchTone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::ui {

namespace {

constexpr double kPlain_Hz = 220.0, kLowest_Hz = 55.0, kHighest_Hz = 3520.0;
constexpr double kJustNoticeableRatio = 1.07; ///< k/k0 per semitone: half of the 14 % that a trained hand detects
constexpr double kSemitones = 12.0;
constexpr double kLoudest = 0.6;
constexpr double kFollows_s = 0.015; ///< time constant of pitch and loudness: slow enough to avoid clicks, fast enough
                                     ///< not to be perceived as a lag

} // namespace

double pitch_Hz(double ratio) noexcept
{
    if (!(ratio > 0.0)) {
        return kLowest_Hz;
    }
    return std::clamp(kPlain_Hz * std::exp2(std::log(ratio) / std::log(kJustNoticeableRatio) / kSemitones), kLowest_Hz,
                      kHighest_Hz);
}

double loudness(double force_N, double limit_N) noexcept
{
    return force_N > 0.0 && limit_N > 0.0 ? kLoudest * std::min(1.0, force_N / limit_N) : 0.0;
}

void TouchTone::set(double pitch_Hz, double loudness) noexcept
{
    m_wantedPitch_Hz.store(pitch_Hz, std::memory_order_relaxed);
    m_wantedLoudness.store(loudness, std::memory_order_relaxed);
}

void TouchTone::fill(std::span<float> samples) noexcept
{
    const double wantedPitch_Hz = m_wantedPitch_Hz.load(std::memory_order_relaxed);
    const double wantedLoudness = m_wantedLoudness.load(std::memory_order_relaxed);
    const double step = 1.0 - std::exp(-1.0 / (kFollows_s * kRate_Hz));
    // First-order low pass per sample; the phase is continuous, so that changes cause no clicks.
    for (float& sample : samples) {
        m_pitch_Hz += step * (wantedPitch_Hz - m_pitch_Hz);
        m_loudness += step * (wantedLoudness - m_loudness);
        m_phase += m_pitch_Hz / kRate_Hz;
        m_phase -= std::floor(m_phase);
        sample = static_cast<float>(m_loudness * std::sin(2.0 * std::numbers::pi * m_phase));
    }
}

} // namespace palpate::ui
