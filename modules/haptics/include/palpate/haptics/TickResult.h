// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/Contact.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics {

/// A triangle's plane that limits the god-object: `n . (x - a) >= 0` with n the unit normal on the god-object's side.
struct ActiveConstraint
{
    std::uint32_t structure; ///< number in the scene
    std::uint32_t triangle;  ///< position in the structure's SurfaceIndex
    Vec3 n_W;                ///< unit, towards the god-object
};

/// How a tick of one god-object ended.
enum class TickStatus : std::uint8_t
{
    Converged, ///< at a local minimum of the distance to the HIP
    /// Stopped at a bound of work (GodObjectLimits) before it was at rest: nothing was passed, the force is that of
    /// where the god-object is, and the next tick goes on from there. Points seldom end so; of ticks with a ball that
    /// is large for its facets some do (0.6 % with 8 and 20 mm on voxels of 1 mm), and a resting hand then feels its
    /// force change for some ticks.
    IterationLimit,
    InvalidInput, ///< the HIP was not finite or too far away (HapticScene::reaches); nothing moved
};

/// Layers of a scene beyond this many are merged into the last one.
inline constexpr std::size_t kMaxLayers = 4;

/// Contacts of a tick: in each layer up to three structures can hold the god-object.
inline constexpr std::size_t kMaxContacts = 3 * kMaxLayers;

/// What one servo tick gives.
struct TickResult
{
    Vec3 p_WG = Vec3::Zero();    ///< god-object of the layer that is reported (see `structure`); in free space the
                                 ///< outermost's [mm]
    Vec3 f_W = Vec3::Zero();     ///< force on the hand, summed over the layers, unbounded [N]
    Vec3 n_W = Vec3::Zero();     ///< unit normal of the contact, from surface to free space; zero in free space
    std::int32_t structure = -1; ///< number of the touched structure in the scene, -1 in free space; with several
                                 ///< layers in contact that of the outermost one, and where several structures hold
                                 ///< its god-object the one that pushes most
    std::uint32_t triangle = 0;  ///< touched triangle, index in the structure's mesh as given to `repair`
    std::array<ActiveConstraint, 3> active;    ///< planes that hold the god-object of the reported layer
    std::uint8_t constraints = 0;              ///< active constraints of the reported layer, 0 to 3
    TickStatus status = TickStatus::Converged; ///< worst over the layers
    std::uint32_t iterations = 0;              ///< summed over the layers
    /// Of each structure that pushes: the outermost layer first, in a layer the largest force first. Set up to
    /// `contactCount`.
    std::array<Contact, kMaxContacts> contacts;
    std::uint8_t contactCount = 0; ///< how many of `contacts` are valid

    /// What friction does to the layer that is reported.
    [[nodiscard]] Friction friction() const noexcept
    {
        return contactCount == 0 ? Friction::None : contacts[0].friction;
    }
};

} // namespace palpate::haptics
