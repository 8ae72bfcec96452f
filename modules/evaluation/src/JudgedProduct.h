// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/HardCases.h"
#include "palpate/evaluation/Surface.h"

#include <palpate/haptics/Palpator.h>

#include <memory>

namespace palpate::evaluation {

/// What a tick of the product must be by itself, whatever the exact solver says.
struct JudgedTick
{
    haptics::TickResult tick;
    bool isForceless = false;     ///< no force, though the god-object is not at the HIP
    double forceError = 0.0;      ///< |f - k (g - p)|, as a share of k |g - p|; of two structures, by how much f is
                                  ///< outside what either would answer alone
    bool isRestoredApart = false; ///< restored from a recorded state it gives other bits
    double outsideCone_mm = 0.0;  ///< one facet holds it: |g - g*| - mu lambda, the definition of law/Friction.h
    double layersError_N = 0.0;   ///< force of both layers, less those of each alone
};

/// The product on a hard case, as the servo thread runs it: with a second one that is restored from its state now and
/// then, and with a layer around it that comes and goes, where the case has one.
class JudgedProduct
{
  public:
    /// @param beside  of the case, or null
    JudgedProduct(const HardCase& hardCase, const geometry::RepairedMesh& mesh, const geometry::RepairedMesh* beside);
    JudgedProduct(const JudgedProduct&) = delete;
    JudgedProduct& operator=(const JudgedProduct&) = delete;

    void start(const Vec3& hip);
    [[nodiscard]] JudgedTick step(const Vec3& hip);

  private:
    void switchOther();
    void judgeForce(JudgedTick& result, const Vec3& hip) const;
    void judgeShared(JudgedTick& result, const Vec3& spring) const;
    void judgeFriction(JudgedTick& result, const Vec3& hip) const;

    std::int64_t m_otherEvery, m_tick = 0;
    double m_magnitude_mm = 0.0; ///< largest coordinate
    std::unique_ptr<haptics::HapticScene> m_scene, m_otherScene, m_bothScene, m_hiddenScene;
    haptics::Palpator m_alone, m_restored, m_other, m_both;
};

} // namespace palpate::evaluation
