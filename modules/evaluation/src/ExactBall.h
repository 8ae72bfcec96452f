// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Orientation.h"
#include "palpate/evaluation/Surface.h"

#include <vector>

namespace palpate::evaluation {

/// Brings the centre of a ball to a local minimum of its distance to the HIP by straight moves on which the ball comes
/// no nearer than its radius to any triangle that faces the centre; see ExactSolver.
///
/// Nothing but the distance from a triangle is computed. It is convex along a line, so that Newton's steps towards the
/// first touch never pass it; and moves at a right angle to a contact's normal, or away from it, never come nearer.
class ExactBall
{
  public:
    ExactBall(const Surface& surface, double radius_mm);

    /// @param g    where the centre starts, then where it ended [mm]
    /// @return moves made; `kMostMoves` when that was not enough
    std::uint32_t converge(Long3& g, const Long3& hip);
    /// Contacts that hold the ball after `converge`, at most 3.
    [[nodiscard]] int constraints() const noexcept { return m_constraints; }
    /// Distance from `p` to the nearest triangle that faces it, or `most_mm` when none is that near. [mm]
    [[nodiscard]] double clearance_mm(const Vec3& p, double most_mm);

    static constexpr std::uint32_t kMostMoves = 5000;

  private:
    struct Candidate
    {
        Long3 a, b, c, n;        ///< corners and unit normal [mm]
        long double normalError; ///< bound on the error of `n` times a length, per length
        Vec3 middle;             ///< of a ball around it [mm]
        double reach_mm;         ///< its radius
        bool isTwoSided;
    };

    void gather(const Vec3& centre, double reach_mm);
    [[nodiscard]] static bool faces(const Candidate& t, const Long3& p);
    /// Share of the move at which the triangle is first as near as `kept_mm`; more than `limit` when not before that.
    [[nodiscard]] long double firstTouch(const Candidate& t, const Long3& from, const Long3& way, long double kept_mm,
                                         long double limit) const;
    /// @return where the move from → to ends: at `to`, or a skin before the ball touches
    [[nodiscard]] Long3 sweep(const Long3& from, const Long3& to) const;
    void findNormals(const Long3& g);
    /// The part of `wanted` that no contact stands against: its projection onto the cone of free directions.
    [[nodiscard]] Long3 free(const Long3& wanted);
    [[nodiscard]] long double drawnOut(const Long3& way, const Long3& before) const;
    /// Moves along `way`, as long as it is or `share` times that, whichever serves better, and on towards the HIP.
    /// @return how much nearer to the HIP it ends [mm²]
    [[nodiscard]] long double advance(Long3& g, const Long3& way, long double share, const Long3& hip) const;
    [[nodiscard]] bool topples(Long3& g, const Long3& hip) const;
    [[nodiscard]] long double leastGain(const Long3& wanted) const; ///< [mm²]

    const Surface& m_surface;
    long double m_radius_mm, m_skin_mm;
    Box m_gathered;
    std::vector<std::uint32_t> m_near;
    std::vector<Candidate> m_candidates;
    std::vector<Long3> m_normals; ///< of the contacts, towards the centre; no two the same
    int m_constraints = 0;
};

} // namespace palpate::evaluation
