// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>
#include <string>

namespace palpate::evaluation {

using core::Vec3;

/// Result of one tick of any solver.
struct SolverStep
{
    Vec3 p_WG = Vec3::Zero();      ///< god-object, or the anchor of the spring for penalty methods [mm]
    Vec3 spring_mm = Vec3::Zero(); ///< force on the hand at a stiffness of 1 N/mm
    int constraints = 0;           ///< active constraint planes at the end of the tick
    std::uint32_t iterations = 0;  ///< moves tried
    bool isConverged = true;       ///< false: stopped at the iteration limit or on invalid input
};

/// Interface of the solvers under evaluation. They share no code, so that an error in one does not affect the others.
class ReferenceSolver
{
  public:
    virtual ~ReferenceSolver() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// Resets the state and starts at `p_WH`. [mm]
    virtual void start(const Vec3& p_WH) = 0;
    /// Computes one tick for HIP `p_WH`. [mm]
    [[nodiscard]] virtual SolverStep step(const Vec3& p_WH) = 0;
};

} // namespace palpate::evaluation
