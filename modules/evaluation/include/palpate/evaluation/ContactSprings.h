// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// Contact plane that may constrain a god-object.
struct SpringPlane
{
    Vec3 n; ///< unit normal, out of the tissue
    double stiffness_N_per_mm;
    std::size_t structure; ///< index within the layer
};

/// Force law of the tissue at a contact: each structure acts with its own stiffness, as described in
/// resources/docs/god-object.md, "Several structures in one contact". Limited to linear tissue without friction.
/// Implemented independently of the engine, so that both can be compared.
class ContactSprings
{
  public:
    /// Uses the same stiffness in all directions.
    explicit ContactSprings(double stiffness_N_per_mm = 0.0)
        : m_stiffest_N_per_mm(stiffness_N_per_mm)
    {
    }
    /// Selects the constraining planes among those in contact: at most three, and as few as support the spring force.
    /// @param touched  planes in contact, at least one
    ContactSprings(const std::vector<SpringPlane>& touched, const Vec3& spring_mm);

    /// @param spring_mm  vector from the HIP to the god-object, in or near the contact passed to the constructor
    /// @return force on the hand [N]
    [[nodiscard]] Vec3 force(const Vec3& spring_mm) const;
    [[nodiscard]] double stiffest_N_per_mm() const noexcept { return m_stiffest_N_per_mm; }

  private:
    double m_stiffest_N_per_mm;
    std::vector<SpringPlane> m_planes; ///< empty: one isotropic stiffness
};

} // namespace palpate::evaluation
