// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Surface.h"
#include "reference/Orientation.h"

#include <vector>

namespace palpate::evaluation {

/// Moves the centre of a sphere to a local minimum of its distance to the HIP by straight moves during which the
/// sphere never comes closer than its radius to a triangle that faces the centre; see ExactSolver.
///
/// Uses only the distance to a triangle. This distance is convex along a line, so Newton steps towards the first
/// contact never overshoot, and moves perpendicular to a contact normal or away from the contact never reduce the
/// distance.
class ExactBall
{
  public:
    ExactBall(const Surface& surface, double radius_mm);

    /// @param g    start position of the centre; receives the end position [mm]
    /// @return number of moves; `kMostMoves` if the limit was reached
    std::uint32_t converge(Long3& g, const Long3& hip);
    /// Number of contacts that constrain the sphere after `converge`, at most 3.
    [[nodiscard]] int constraints() const noexcept { return m_constraints; }
    /// Distance from `p` to the nearest triangle that faces `p`, at most `most_mm`. [mm]
    [[nodiscard]] double clearance_mm(const Vec3& p, double most_mm);

    static constexpr std::uint32_t kMostMoves = 5000;

  private:
    struct Candidate
    {
        Long3 a, b, c, n;        ///< corners and unit normal [mm]
        long double normalError; ///< bound on the error of `n` times a length, relative to the length
        Vec3 middle;             ///< centre of the bounding sphere [mm]
        double reach_mm;         ///< radius of the bounding sphere
        bool isTwoSided;
    };

    void gather(const Vec3& centre, double reach_mm);
    [[nodiscard]] static bool faces(const Candidate& t, const Long3& p);
    /// Fraction of the move at which the distance to the triangle first equals `kept_mm`; greater than `limit` if
    /// later.
    [[nodiscard]] long double firstTouch(const Candidate& t, const Long3& from, const Long3& way, long double kept_mm,
                                         long double limit) const;
    /// @return end of the move from → to: `to`, or one skin before the first contact
    [[nodiscard]] Long3 sweep(const Long3& from, const Long3& to) const;
    void findNormals(const Long3& g);
    /// Projects `wanted` onto the cone of unconstrained directions.
    [[nodiscard]] Long3 free(const Long3& wanted);
    [[nodiscard]] long double extrapolatedLength(const Long3& way, const Long3& before) const;
    /// Moves along `way` by its length or by `share` times its length, whichever is better, and then towards the HIP.
    /// @return decrease of the squared distance to the HIP [mm²]
    [[nodiscard]] long double advance(Long3& g, const Long3& way, long double share, const Long3& hip) const;
    [[nodiscard]] bool leaveUnstableEquilibrium(Long3& g, const Long3& hip) const;
    [[nodiscard]] long double leastGain(const Long3& wanted) const; ///< [mm²]

    const Surface& m_surface;
    long double m_radius_mm, m_skin_mm;
    Box m_gathered;
    std::vector<std::uint32_t> m_near;
    std::vector<Candidate> m_candidates;
    std::vector<Long3> m_normals; ///< contact normals towards the centre, without duplicates
    int m_constraints = 0;
};

} // namespace palpate::evaluation
