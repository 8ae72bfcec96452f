// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/HardCases.h"
#include "palpate/evaluation/Surface.h"

#include <palpate/haptics/Palpator.h>

#include <memory>

namespace palpate::evaluation {

/// Result of one tick of the product, with checks that do not need the exact solver.
struct CheckedTick
{
    haptics::TickResult tick;
    bool lacksForce = false; ///< no force although the god-object is not at the HIP
    double forceError = 0.0; ///< |f - k (g - p)| relative to k |g - p|; for two structures, the distance of f from the
                             ///< range between the forces of either alone
    bool differsAfterRestore = false; ///< different bits after restoring a recorded state
    double outsideCone_mm =
        0.0; ///< for one constraining facet: |g - g*| - mu lambda, the definition in goal/CoulombFriction.h
    double layersError_N = 0.0; ///< force of both layers minus the sum of the forces of each alone
};

/// Runs the product on a hard case like the servo thread does, with a second instance that is restored from its state
/// at intervals and, for cases with one, with a surrounding layer that is shown and hidden.
class JudgedProduct
{
  public:
    /// @param beside  second structure of the case, or null
    JudgedProduct(const HardCase& hardCase, const geometry::RepairedMesh& mesh, const geometry::RepairedMesh* beside);
    JudgedProduct(const JudgedProduct&) = delete;
    JudgedProduct& operator=(const JudgedProduct&) = delete;

    void start(const Vec3& hip);
    [[nodiscard]] CheckedTick step(const Vec3& hip);

  private:
    void switchOther();
    void judgeForce(CheckedTick& result, const Vec3& hip) const;
    void checkSharedForce(CheckedTick& result, const Vec3& spring) const;
    void judgeFriction(CheckedTick& result, const Vec3& hip) const;

    std::int64_t m_otherEvery, m_tick = 0;
    double m_magnitude_mm = 0.0; ///< largest absolute coordinate
    std::unique_ptr<haptics::HapticScene> m_scene, m_otherScene, m_bothScene, m_hiddenScene;
    haptics::Palpator m_alone, m_restored, m_other, m_both;
};

} // namespace palpate::evaluation
