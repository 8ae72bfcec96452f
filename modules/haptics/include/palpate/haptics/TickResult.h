// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/Contact.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics {

/// Active constraint of a god-object: the plane of a triangle limits positions x to n . (x - c) >= 0, with c a corner
/// of the triangle and n the unit normal on the side of the god-object. A default-constructed constraint is not
/// initialised.
struct ActiveConstraint
{
    std::uint32_t structure; ///< index in HapticScene::structures
    std::uint32_t triangle;  ///< index in the SurfaceIndex of the structure
    Vec3 n_W;                ///< unit normal towards the god-object
};

/// Outcome of a tick.
enum class TickStatus : std::uint8_t
{
    Converged, ///< every god-object is at a local minimum of its distance to the HIP
    /// A work limit (GodObjectLimits) was reached before the god-object came to rest. No surface was crossed, the force
    /// is valid for the current position of the god-object, and the next tick continues from this position. Rare for
    /// points. With a ball much larger than the facets (8 and 20 mm on voxels of 1 mm) 0.6 % of the ticks end this way,
    /// and the force on a resting hand then changes for some ticks.
    /// Also if the rest position in moving tissue is not exact (SurfaceMotion::Rest::isExact).
    IterationLimit,
    InvalidInput, ///< the HIP is not finite or too far away (HapticScene::reaches); no state changed
};

/// Maximum number of layers. Further layers of a scene are merged into the last one.
inline constexpr std::size_t kMaxLayers = 4;

/// Maximum number of contacts in a tick: up to three structures can constrain the god-object of each layer.
inline constexpr std::size_t kMaxContacts = 3 * kMaxLayers;

/// Result of one servo tick, in scene coordinates.
///
/// Entries of `active` and `contacts` beyond their counts are not initialised: neither read, compare nor record them.
/// Clearing them would cost a tick more than 1,000 bytes of stores.
struct TickResult
{
    Vec3 p_WG = Vec3::Zero();    ///< god-object of the reported layer (see `structure`), in free space of the outermost
                                 ///< layer [mm]
    Vec3 f_W = Vec3::Zero();     ///< force on the hand, sum over all layers, before any limit of the device [N]
    Vec3 n_W = Vec3::Zero();     ///< unit contact normal, from the surface to free space; zero in free space
    std::int32_t structure = -1; ///< index of the touched structure in the scene, -1 in free space. With several layers
                                 ///< in contact, the outermost layer is reported; if several structures constrain its
                                 ///< god-object, the structure with the largest force
    std::uint32_t triangle = 0;  ///< touched triangle, as an index in the mesh before `repair`
    std::array<ActiveConstraint, 3> active;    ///< of the reported layer; valid up to `constraints`
    std::uint8_t constraints = 0;              ///< number of active constraints of the reported layer, 0 to 3
    TickStatus status = TickStatus::Converged; ///< maximum over the layers
    std::uint32_t iterations = 0;              ///< moves tried, sum over the layers
    /// One contact per structure that exerts a force: outermost layer first, within a layer the largest force first.
    /// Valid up to `contactCount`.
    std::array<Contact, kMaxContacts> contacts;
    std::uint8_t contactCount = 0; ///< number of valid entries of `contacts`
    double fingertip_mm = 0.0;     ///< radius of the ball whose centre is the god-object; 0 = a point [mm]

    /// Place at which the probe touches: of a ball the point that is farthest against the contact normal, of a point
    /// the god-object itself. With one active constraint this is the touched place of the surface, except for a ball
    /// without room (docs/fingertip.md), which is farther into the surface. The centre in free space. World frame [mm]
    [[nodiscard]] Vec3 touched_W() const noexcept { return touched_W(p_WG, n_W); }
    /// The same for one of the contacts.
    [[nodiscard]] Vec3 touched_W(const Contact& contact) const noexcept { return touched_W(contact.p_WG, contact.n_W); }

    /// State of friction in the reported layer.
    [[nodiscard]] Friction friction() const noexcept
    {
        return contactCount == 0 ? Friction::None : contacts[0].friction;
    }

  private:
    [[nodiscard]] Vec3 touched_W(const Vec3& god_W, const Vec3& normal_W) const noexcept
    {
        return fingertip_mm > 0.0 ? Vec3(god_W - fingertip_mm * normal_W) : god_W;
    }
};

} // namespace palpate::haptics
