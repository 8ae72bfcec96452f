// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomScene.h"

namespace palpate::adversary {

/// A hand that performs a sequence of motions that are difficult for god-objects. One HIP per tick.
class RandomHand
{
  public:
    /// @param isExact  some HIPs are exactly on vertices, edges and planes; otherwise each HIP is offset by a millionth
    /// of the scene
    RandomHand(const RandomScene& scene, bool isExact, std::uint64_t seed);
    [[nodiscard]] Vec3 next();

  private:
    enum class Motion
    {
        WhiteNoise,
        Walk,     ///< at random
        Teleport, ///< anywhere around the scene
        Strike,   ///< straight through the scene, fast
        Slide,    ///< slightly below the surface, along a facet and beyond
        OnFeatures,
        AlongEdge,
        ThroughVertex,
        AroundVertex,
        InPlane,
        Rest,
        Creep,
        Far, ///< far away and back
    };
    static constexpr int kMotions = 13;

    void begin();
    [[nodiscard]] Vec3 moved();
    [[nodiscard]] Vec3 onFeature();

    const RandomScene& m_scene;
    Chance m_chance;
    bool m_isExact;
    double m_size_mm;
    Vec3 m_middle, m_hip;
    Motion m_motion = Motion::Rest;
    int m_left = 0, m_tick = 0;
    std::array<Vec3, 3> m_facet;
    Vec3 m_normal = Vec3::UnitZ(), m_step = Vec3::Zero(), m_place = Vec3::Zero();
    double m_amount_mm = 0.0, m_depth_mm = 0.0;
};

} // namespace palpate::adversary
