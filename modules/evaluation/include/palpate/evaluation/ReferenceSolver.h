// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>
#include <string>

namespace palpate::evaluation {

using core::Vec3;

/// What one tick of any solver gives.
struct SolverStep
{
    Vec3 p_WG = Vec3::Zero();      ///< god-object, or for a penalty what the spring is tied to [mm]
    Vec3 spring_mm = Vec3::Zero(); ///< force on the hand for a stiffness of 1 N/mm
    int constraints = 0;           ///< active planes at the end of the tick
    std::uint32_t iterations = 0;  ///< moves tried
    bool isConverged = true;       ///< false: stopped at a bound or on bad input
};

/// A solver under evaluation. Each is written for itself, so that an error in one is not an error in all.
class ReferenceSolver
{
  public:
    virtual ~ReferenceSolver() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// Forgets everything and starts at `p_WH`. [mm]
    virtual void start(const Vec3& p_WH) = 0;
    /// Feels one tick. [mm]
    [[nodiscard]] virtual SolverStep step(const Vec3& p_WH) = 0;
};

} // namespace palpate::evaluation
