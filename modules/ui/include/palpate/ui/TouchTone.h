// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <atomic>
#include <span>

namespace palpate::ui {

/// Pitch of a stiffness ratio: 220 Hz for the unmodified tissue, one semitone up per just noticeable difference of 7 %
/// in stiffness, down for softer places. Clamped to 55 … 3520 Hz, a well audible range.
/// @param ratio  k/k0 [1]
[[nodiscard]] PALPATE_EXPORT double pitch_Hz(double ratio) noexcept;
/// Loudness of a force, proportional up to 0.6 of full scale at the limit; 0 in free space.
[[nodiscard]] PALPATE_EXPORT double loudness(double force_N, double limit_N) noexcept;

/// Sine generator with click-free changes of pitch and loudness. The timbre is constant, because a change of timbre can
/// make stiff places seem soft.
///
/// @par Thread `set` on one thread, `fill` on another.
///
/// @par Example
/// @code
/// TouchTone tone;
/// tone.set(pitch_Hz(1.07), loudness(2.0, 8.0)); // 7 % stiffer, 2 N of 8 N
/// std::array<float, 441> samples{};
/// tone.fill(samples); // 10 ms
/// @endcode
class PALPATE_EXPORT TouchTone
{
  public:
    static constexpr int kRate_Hz = 44100;

    void set(double pitch_Hz, double loudness) noexcept;
    /// Generates the next samples, -1 to 1.
    void fill(std::span<float> samples) noexcept;

  private:
    std::atomic<double> m_wantedPitch_Hz{220.0}, m_wantedLoudness{0.0};
    double m_pitch_Hz = 220.0, m_loudness = 0.0; ///< approach the requested values
    double m_phase = 0.0;                        ///< in turns, 0 to 1
};

} // namespace palpate::ui
