// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/internal/BallTick.h"
#include "palpate/haptics/internal/Neighbourhood.h"
#include "palpate/haptics/internal/TickWork.h"

#include <array>
#include <cstdint>

namespace palpate::haptics {

/// A triangle's plane that limits the god-object: `n . (x - a) >= 0` with n the unit normal on the god-object's side.
struct ActiveConstraint
{
    std::uint32_t structure = 0; ///< number in the scene
    std::uint32_t triangle = 0;  ///< position in the structure's SurfaceIndex
    Vec3 n_W = Vec3::Zero();     ///< unit, towards the god-object
};

/// How a tick of one god-object ended.
enum class TickStatus : std::uint8_t
{
    Converged,      ///< at a local minimum of the distance to the HIP
    IterationLimit, ///< stopped at the bound; the god-object is legal but could still come closer
    InvalidInput,   ///< the HIP was not finite or too far away (HapticScene::reaches); nothing moved
};

/// A god-object between ticks: its position and what it touches.
struct GodObjectState
{
    Vec3 p_WG = Vec3::Zero(); ///< [mm]
    std::array<std::uint32_t, 3> structure{};
    std::array<std::uint32_t, 3> triangle{};
    std::array<std::int8_t, 3> side{}; ///< +1: on the front of the triangle, -1: behind it
    std::uint8_t constraints = 0;      ///< how many of the three are valid
    std::uint8_t placed = 0;           ///< 0: the next step starts at its HIP
    std::uint8_t pad[3]{};
};

/// Bounds on the work of one tick of one layer, in counts and never in time, so that a replay is exact. Each layer has
/// its own: what one is given must not depend on which others there are.
struct GodObjectLimits
{
    std::uint32_t iterations = 512; ///< moves tried in a tick; reaching it is reported
    std::uint32_t work = 20000;     ///< units of internal::TickWork; reaching it is reported, too
};

/// What one step of a god-object gives.
struct GodObjectStep
{
    Vec3 p_WG = Vec3::Zero(); ///< [mm]
    std::array<ActiveConstraint, 3> active{};
    std::uint8_t constraints = 0; ///< how many of `active` are valid
    TickStatus status = TickStatus::Converged;
    std::uint32_t iterations = 0;
};

/// The god-object of one layer: the point that stays on the surface, where the HIP would be if device and tissue were
/// infinitely stiff. See resources/docs/god-object.md for the method.
class GodObject
{
  public:
    /// Moves towards the HIP by moves that no triangle of `layer` blocks, until no further move brings it closer.
    ///
    /// Minimises 0.5 |x - p_WH|^2 subject to n_i . (x - a_i) >= skin for the k <= 3 active constraints, found by
    /// sweeping the god-object against the surfaces: k = 0 free space, 1 face, 2 edge, 3 corner.
    /// @param p_WH  HIP [mm], within the scene's reach
    /// @param scene,layer  what to touch; only read
    /// @par Real-time Wait-free, no allocation. Servo thread, or any one thread at a time.
    /// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876. Differs: converges within the tick.
    [[nodiscard]] GodObjectStep step(const Vec3& p_WH, const HapticScene& scene, std::size_t layer,
                                     const GodObjectLimits& limits = {}) noexcept PALPATE_NONBLOCKING;

    /// Forgets the contacts but not the position: triangle numbers of another scene mean nothing.
    void forgetContacts() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const GodObjectState& state() const noexcept { return m_state; }
    void restore(const GodObjectState& state) noexcept;

  private:
    template<class AnyTick>
    void run(AnyTick tick, const GodObjectLimits& limits, GodObjectStep& result) noexcept;
    void clearCaches() noexcept;

    GodObjectState m_state;
    // Caches: they never change a result.
    internal::Neighbourhood m_neighbourhood;
    internal::BallNeighbourhood m_ballNeighbourhood;
    std::array<internal::Facet, 3> m_facets; ///< of the state's constraints
    bool m_hasFacets = false;
    bool m_hasWalked = false; ///< the last tick ended by walking: on the first of them, well inside
};

} // namespace palpate::haptics
