// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <span>

namespace palpate::ui {

/// How high a place sounds: 220 Hz for tissue as it is, a semitone higher for each just noticeable difference of 7 %
/// that it is stiffer, lower where it is softer. Within 55 … 3520 Hz, which people hear well.
/// @param ratio  k/k0 [1]
[[nodiscard]] double pitch_Hz(double ratio) noexcept;
/// How loud a force sounds: in proportion, up to 0.6 of full scale at the limit; 0 in air.
[[nodiscard]] double loudness(double force_N, double limit_N) noexcept;

/// A pure tone that follows what is touched without clicks: by pitch and loudness, not by timbre, which can make the
/// stiff seem soft.
/// @par Threads `set` on one, `fill` on another.
class TouchTone
{
  public:
    static constexpr int kRate_Hz = 44100;

    void set(double pitch_Hz, double loudness) noexcept;
    /// Makes the next samples, -1 … 1.
    void fill(std::span<float> samples) noexcept;

  private:
    std::atomic<double> m_wantedPitch_Hz{220.0}, m_wantedLoudness{0.0};
    double m_pitch_Hz = 220.0, m_loudness = 0.0; ///< on their way to what is wanted
    double m_phase = 0.0;                        ///< in turns, 0 … 1
};

} // namespace palpate::ui
