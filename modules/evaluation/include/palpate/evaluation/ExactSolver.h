// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <memory>

namespace palpate::evaluation {

/// Ground truth for all errors: the definition of the god-object, evaluated in long double.
///
/// A triangle blocks a move that goes against the normal, starts in front of or on the triangle, ends behind it and
/// passes through the closed triangle. Each condition is the sign of a volume and is decided exactly. From the current
/// position, the god-object tries the straight line to the HIP, the directions along each contact triangle and those
/// along each pair of them, and takes the one that ends closest to the HIP, until no move reduces the distance. A tick
/// is divided into sub-steps towards the HIP, so that the choice of direction does not depend on the hand's
/// displacement per tick.
///
/// With friction, a move along triangles stops R = mu times the sum of their multipliers before the frictionless end
/// point; a move no longer than R is not made. See resources/docs/friction.md.
///
/// With a radius, the god-object is the centre of a sphere. A triangle that faces the centre blocks a move that would
/// bring the sphere closer than its radius, measured to the nearest point of the triangle.
/// @par Cost Brute force over the triangles whose boxes a move can reach: microseconds to milliseconds per tick.
class ExactSolver : public ReferenceSolver
{
  public:
    /// @param surface   must outlive this
    /// @param subSteps  number of sub-steps per tick, at least 1
    /// @param fingertip_mm  fingertip radius; 0: point contact
    /// @param friction  static and dynamic friction coefficient of the whole surface; point contact only
    explicit ExactSolver(const Surface& surface, int subSteps = 4, double fingertip_mm = 0.0, double friction = 0.0);
    ~ExactSolver() override;

    [[nodiscard]] std::string name() const override { return "exact"; }
    void start(const Vec3& p_WH) override;
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

    /// Sets the state left by another solver: god-object `p_WG` and HIP `p_WH`.
    void resume(const Vec3& p_WG, const Vec3& p_WH);
    /// Penetration of a sphere at `p_WG` into the facets that face its centre; 0 for point contact. [mm]
    [[nodiscard]] double intrusion_mm(const Vec3& p_WG);

  private:
    struct Private;
    std::unique_ptr<Private> m_d;
};

/// Distance by which legal moves can still bring the god-object closer to the HIP. [mm]
[[nodiscard]] double residual_mm(ExactSolver& exact, const Vec3& p_WG, const Vec3& p_WH);

} // namespace palpate::evaluation
