// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace palpate::haptics::law {

/// Returns true if the active planes belong to more than one structure.
[[nodiscard]] inline bool isShared(std::span<const ActiveConstraint> planes) noexcept
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

/// Lets each structure of a contact push with its own law, maps and damper.
///
/// With g the god-object, p the HIP and lambda_i >= 0 the multipliers of the planes, `g - p = sum lambda_i n_i + t`,
/// where t is what friction holds back. Structure S pushes by `P_S`, the sum of lambda_i n_i over its planes. Its law
/// is taken at D_S, the part of g - p along P_S, where it has the secant stiffness `k_S = F_S(D_S) / D_S`. With the
/// structures sorted by ascending k_S, and Q_j the sum of the pushes from the j-th on,
///
///     f = sum over j of (k_j - k_(j-1)) min(1, (g - p).Q_j / |Q_j|^2) Q_j,    k_0 = 0
///
/// This is continuous where a plane becomes active, at most the greatest k_S times |g - p|, and the law of a structure
/// that is alone. At right angles each structure answers as if it were alone.
///
/// A damper counts by the structure's part of the multipliers, and so does the stiffness along t.
/// @param planes  that hold the god-object, at most three; `facets` are theirs
/// @param push_W  g - p [mm]
/// @par Real-time Wait-free.
/// @par Source resources/docs/god-object.md, "Several structures in one contact": derivation, and the energy that
/// closed paths can gain.
[[nodiscard]] SharedContact sharedContact(const HapticScene& scene, std::span<const ActiveConstraint> planes,
                                          std::span<const internal::Facet> facets, const Vec3& p_WG, const Vec3& push_W,
                                          const Motion& hip) noexcept;

} // namespace palpate::haptics::law
