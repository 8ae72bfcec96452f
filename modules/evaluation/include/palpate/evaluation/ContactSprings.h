// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// A plane that may hold a god-object.
struct SpringPlane
{
    Vec3 n; ///< unit, out of the tissue
    double stiffness_N_per_mm;
    std::size_t structure; ///< number in the layer
};

/// What the tissue at a place answers a spring with: each structure with its own stiffness, as
/// resources/docs/god-object.md says in "Several structures in one contact", written for linear tissue without
/// friction. Written apart from the engine's own, as all that judges it is.
class ContactSprings
{
  public:
    /// One stiffness in all directions.
    explicit ContactSprings(double stiffness_N_per_mm = 0.0)
        : m_stiffest_N_per_mm(stiffness_N_per_mm)
    {
    }
    /// Of the planes that a god-object touches those that hold it: at most three, as few as resolve the spring.
    /// @param touched  at least one
    ContactSprings(const std::vector<SpringPlane>& touched, const Vec3& spring_mm);

    /// @param spring_mm  god-object - HIP: that of the contact, or one near it
    /// @return force on the hand [N]
    [[nodiscard]] Vec3 force(const Vec3& spring_mm) const;
    [[nodiscard]] double stiffest_N_per_mm() const noexcept { return m_stiffest_N_per_mm; }

  private:
    double m_stiffest_N_per_mm;
    std::vector<SpringPlane> m_planes; ///< empty: one stiffness
};

} // namespace palpate::evaluation
