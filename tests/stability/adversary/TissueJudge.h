// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/Palpator.h>

namespace palpate::adversary {

using core::Vec3;

/// A position on a triangle in barycentric coordinates.
class PlaceOnTriangle
{
  public:
    /// Finds the position nearest to `p`.
    /// @param triangle  index in the surface
    PlaceOnTriangle(const geometry::SurfaceIndex& surface, std::uint32_t triangle, const Vec3& p);
    [[nodiscard]] double valueOf(const haptics::TissueMap& map) const;
    /// Returns the gradient magnitude of a map there [1/mm in units of the map].
    [[nodiscard]] double slopeOf(const haptics::TissueMap& map) const;
    /// Returns whether the position is neither on an edge nor at a corner.
    [[nodiscard]] bool isInside() const { return m_shares.minCoeff() > 1e-6; }

  private:
    std::uint32_t m_triangle;
    Vec3 m_ab, m_ac, m_shares;
};

/// The force of one structure from its law, maps and damping by the formulas alone, for a god-object position on a
/// triangle and the distance of the HIP.
class ForceOfTissue
{
  public:
    /// @param plane  a contact of the tick, on `structure`
    ForceOfTissue(const haptics::HapticStructure& structure, const haptics::ActiveConstraint& plane, const Vec3& god,
                  const Vec3& hip);

    /// Returns whether `f_W` is that force: `s F(d) n - b v`, and without friction at most `W |grad s|` in addition.
    [[nodiscard]] bool is(const Vec3& f_W, const Vec3& v_WH) const;
    /// Returns the largest mu with maps: the friction scale, or the part that covers a stiffness map's sideways force.
    /// Friction depends on the start of the move, so this is the maximum over the triangle.
    [[nodiscard]] double coefficient(double mu, double lambda_mm) const;

  private:
    const haptics::HapticStructure& m_on;
    Vec3 m_spring;
    double m_stiffness = 1.0, m_slope_per_mm = 0.0; ///< s and |grad s|
    double m_rounding = 0.0;                        ///< relative rounding error of |grad s|
    double m_damping, m_dampingSlope = 0.0;
    double m_least = 1.0, m_friction = 1.0; ///< smallest s and largest friction scale on the triangle
};

/// Returns how far outside its friction cone a god-object held by one facet is: |g - g*| - R, with g* and R from the
/// facet's plane [mm]. Negative inside.
/// @pre no structure touched in the tick is damped: otherwise the god-object lags
[[nodiscard]] double outsideCone_mm(const haptics::HapticStructure& structure, const haptics::TickResult& tick,
                                    const Vec3& hip);

} // namespace palpate::adversary
