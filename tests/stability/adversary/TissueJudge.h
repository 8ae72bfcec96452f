// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/Palpator.h>

namespace palpate::adversary {

using core::Vec3;

/// A place on a triangle, by the shares of its corners.
class PlaceOnTriangle
{
  public:
    /// The nearest to `p`. @param triangle  position in the surface
    PlaceOnTriangle(const geometry::SurfaceIndex& surface, std::uint32_t triangle, const Vec3& p);
    [[nodiscard]] double valueOf(const haptics::TissueMap& map) const;
    /// How steep a map is there. [1/mm of its unit]
    [[nodiscard]] double slopeOf(const haptics::TissueMap& map) const;
    /// Neither on an edge nor at a corner.
    [[nodiscard]] bool isInside() const { return m_shares.minCoeff() > 1e-6; }

  private:
    std::uint32_t m_triangle;
    Vec3 m_ab, m_ac, m_shares;
};

/// The force of one structure by its law, maps and damping, from the formulas alone: where the god-object stands on a
/// triangle, and how far the HIP is.
class ForceOfTissue
{
  public:
    /// @param plane  a contact of the tick, on `structure`
    ForceOfTissue(const haptics::HapticStructure& structure, const haptics::ActiveConstraint& plane, const Vec3& god,
                  const Vec3& hip);

    /// True when `f_W` is that force: `s F(d) n - b v`, and without friction no more than `W |grad s|` beside it.
    [[nodiscard]] bool is(const Vec3& f_W, const Vec3& v_WH) const;
    /// The most that a map makes of mu: the scale of friction, or what takes up a map of stiffness. Friction goes by
    /// the place where a move began, so it is the greatest of the triangle.
    [[nodiscard]] double coefficient(double mu, double lambda_mm) const;

  private:
    const haptics::HapticStructure& m_on;
    Vec3 m_spring;
    double m_stiffness = 1.0, m_slope_per_mm = 0.0; ///< s and |grad s|
    double m_rounding = 0.0;                        ///< of the latter, as a share of it
    double m_damping, m_dampingSlope = 0.0;
    double m_least = 1.0, m_friction = 1.0; ///< least s and greatest scale of friction, anywhere on the triangle
};

/// How far outside its cone friction leaves a god-object that one facet holds: |g - g*| - R, with g* and R from that
/// facet's plane. Negative inside. @pre nothing that it has touched in the tick drags: then it lags behind. [mm]
[[nodiscard]] double outsideCone_mm(const haptics::HapticStructure& structure, const haptics::TickResult& tick,
                                    const Vec3& hip);

} // namespace palpate::adversary
