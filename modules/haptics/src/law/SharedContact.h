// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace palpate::haptics::law {

/// Returns true if the active planes belong to more than one structure.
[[nodiscard]] inline bool hasSeveralStructures(std::span<const ActiveConstraint> planes) noexcept
{
    return std::any_of(planes.begin(), planes.end(),
                       [&](const ActiveConstraint& plane) { return plane.structure != planes[0].structure; });
}

/// Response of several structures in one contact.
struct SharedContact
{
    /// One entry per structure that pushes, in ascending order of force. All members but `layer` and `friction` are
    /// set.
    std::array<Contact, 3> contacts;
    std::size_t count = 0;   ///< 0 without a spring
    Vec3 n_W = Vec3::Zero(); ///< unit direction of the sum of all pushes
};

/// Computes the force of several structures in one contact, each with its own law, maps and damper.
///
/// With g the god-object, p the HIP and lambda_i >= 0 the multipliers of the planes, `g - p = sum lambda_i n_i + t`,
/// where t is the part held back by friction. Structure S pushes by `P_S`, the sum of lambda_i n_i over the planes of
/// S. Its law is evaluated at D_S, the component of g - p along P_S, and gives the secant stiffness `k_S = F_S(D_S) /
/// D_S`. With the structures sorted by ascending k_S, and Q_j the sum of the pushes from the j-th structure on,
///
///     f = sum over j of (k_j - k_(j-1)) min(1, (g - p).Q_j / |Q_j|^2) Q_j,    k_0 = 0
///
/// The force is continuous where a plane becomes active, at most max k_S times |g - p|, and equal to the law of a
/// single structure. At right angles each structure responds as if it were alone.
///
/// Dampers are weighted by the structure's fraction of the multipliers, and so is the stiffness along t.
/// @param scene  the structures
/// @param planes  active planes of the god-object, at most three
/// @param facets  facets of `planes`
/// @param p_WG  god-object position [mm]
/// @param push_W  g - p [mm]
/// @param hip  motion of the HIP
/// @par Real-time Wait-free.
/// @par Source resources/docs/god-object.md, "Several structures in one contact": derivation, and the energy that
/// closed paths can gain.
[[nodiscard]] SharedContact sharedContact(const HapticScene& scene, std::span<const ActiveConstraint> planes,
                                          std::span<const internal::Facet> facets, const Vec3& p_WG, const Vec3& push_W,
                                          const Motion& hip) noexcept;

} // namespace palpate::haptics::law
