// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <memory>

namespace palpate::evaluation {

/// The truth that errors are measured against: the definition of the god-object, written out in long double.
///
/// A move is blocked by a triangle when it goes against the normal, starts in front of it or on it, ends behind it and
/// passes through the closed triangle; each of these is the sign of a volume and decided exactly. From where it is, the
/// god-object tries the straight way to the HIP, the ways along each triangle that it touches and those along each pair
/// of them, and takes the one that brings it closest, until none brings it closer. A tick is cut into smaller ones,
/// towards the HIP, so that no choice of a way depends on how far the hand moved in it.
///
/// With friction a way along triangles ends R = mu times the sum of their multipliers before where it would end
/// without, and one that is no longer than R is not gone at all: resources/docs/friction.md.
///
/// With a radius the god-object is the centre of a ball. A move is blocked by a triangle that faces the centre when the
/// ball would come nearer to it than its radius; distances are those to the nearest point of each triangle.
/// @par Cost Brute force over the triangles whose boxes a move could reach: microseconds to milliseconds a tick.
class ExactSolver : public ReferenceSolver
{
  public:
    /// @param surface   must outlive this
    /// @param subSteps  parts that a tick is cut into, at least 1
    /// @param fingertip_mm  radius of the ball that touches; 0 is a point
    /// @param friction  coefficient of the whole surface, at rest and sliding; a point's alone
    explicit ExactSolver(const Surface& surface, int subSteps = 4, double fingertip_mm = 0.0, double friction = 0.0);
    ~ExactSolver() override;

    [[nodiscard]] std::string name() const override { return "exact"; }
    void start(const Vec3& p_WH) override;
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

    /// Puts the god-object at `p_WG`, with the hand at `p_WH`, as another solver left them.
    void resume(const Vec3& p_WG, const Vec3& p_WH);
    /// By how much less than its radius a ball at `p_WG` is away from what faces it; 0 for a point. [mm]
    [[nodiscard]] double intrusion_mm(const Vec3& p_WG);

  private:
    struct Private;
    std::unique_ptr<Private> m_d;
};

/// How much nearer to the HIP legal moves could still bring a god-object. [mm]
[[nodiscard]] double residual_mm(ExactSolver& exact, const Vec3& p_WG, const Vec3& p_WH);

} // namespace palpate::evaluation
