// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/ThresholdSeries.h"

#include <palpate/core/Export.h>
#include <palpate/haptics/HapticScene.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>

namespace palpate::study {

/// Trials for the smallest increase of stiffness that a hand detects: in each trial the hand presses a wall twice, the
/// wall is stiffer in one of the presses, and the examinee tells in which. The levels are those of a ThresholdSeries
/// with two choices.
///
/// @par Thread A value; one thread at a time.
class PALPATE_EXPORT PressedPairs
{
  public:
    enum class Stage : std::uint8_t
    {
        First,  ///< waits for the first press
        Second, ///< waits for the second press
        Answer, ///< waits for the answer
        Done
    };
    static constexpr std::size_t kTrials = 60;
    /// Force from which contact counts as a press. [N]
    static constexpr double kPress_N = 0.8;

    /// @param seed  decides in which press of each trial the wall is stiffer
    explicit PressedPairs(std::uint32_t seed, std::size_t trials = kTrials);

    [[nodiscard]] Stage stage() const noexcept { return m_stage; }
    /// Stiffness of the wall in the press that is awaited, relative to the softer wall [1].
    [[nodiscard]] double ratio() const noexcept;
    /// Takes the force of the hand on the wall, 0 without contact. A press ends when the hand leaves the wall after
    /// kPress_N. @return true if the stage changed, and with it `ratio`
    bool takeForce(double force_N);
    /// Takes an answer in the stage Answer; no effect in others.
    void answer(bool wasSecondStiffer);
    [[nodiscard]] const ThresholdSeries& series() const noexcept { return m_series; }
    /// Right answer of the current trial, for simulated observers.
    [[nodiscard]] bool isSecondStiffer() const noexcept { return m_isSecondStiffer; }

  private:
    void next();

    ThresholdSeries m_series;
    std::mt19937 m_random;
    Stage m_stage = Stage::First;
    bool m_isSecondStiffer = false;
    bool m_isPressed = false;
};

/// Makes a flat wall as a haptic scene of one structure.
/// @param p_W  a point of the wall [mm]
/// @param n_W  unit normal, towards the hand
/// @param size_mm  half of the width, > 0
/// @param stiffness_N_per_mm  > 0
[[nodiscard]] PALPATE_EXPORT std::shared_ptr<const haptics::HapticScene>
wallScene(const core::Vec3& p_W, const core::Vec3& n_W, double size_mm, double stiffness_N_per_mm);

} // namespace palpate::study
