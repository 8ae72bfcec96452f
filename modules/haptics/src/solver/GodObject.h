// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal/CoulombFriction.h"
#include "nearby/NearBall.h"
#include "nearby/NearPoint.h"
#include "palpate/haptics/Palpator.h"
#include "probe/ConstrainedPoint.h"

#include <array>
#include <cstdint>
#include <span>

namespace palpate::haptics::internal {

/// How one step of a god-object ended. Its position and contacts stay in the GodObject, which is read in place.
struct GodObjectStep
{
    std::uint32_t iterations = 0; ///< moves tried
    std::uint32_t work = 0;       ///< spent, in units of TickWork
    TickStatus status = TickStatus::Converged;
};

/// God-object of one layer: the point constrained to the outside of the surfaces, where the HIP would be if device and
/// tissue were infinitely stiff. Methods: resources/docs/god-object.md for a point, resources/docs/fingertip.md for a
/// ball.
class GodObject
{
  public:
    /// Moves towards the HIP by moves that no triangle of `layer` blocks, until no further move reduces the distance.
    ///
    /// Minimises 0.5 |x - p_WH|^2 subject to n_i . (x - a_i) >= skin for the k <= 3 active constraints, which are found
    /// by sweeping the god-object against the surfaces: k = 0 free space, 1 face, 2 edge, 3 corner.
    ///
    /// With friction each move is shortened as goal/CoulombFriction.h describes.
    /// @param p_WH  HIP [mm], within HapticScene::reaches
    /// @param dt_s  time since the previous tick [s], > 0; used by the drag of friction
    /// @param layer  surfaces of the layer; only read
    /// @param ball  caches for a ball-shaped probe; may be null for a point
    /// @par Real-time Wait-free, no allocation. Servo thread, or any one thread at a time.
    /// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876. Differs: converges within the tick.
    [[nodiscard]] GodObjectStep step(const Vec3& p_WH, double dt_s, const HapticLayer& layer,
                                     const GodObjectLimits& limits, NearBall* ball) noexcept PALPATE_NONBLOCKING;

    /// Discards the contacts but keeps the position. Needed after a scene change, which makes triangle indices invalid.
    void forgetContacts() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const GodObjectState& state() const noexcept { return m_state; }
    void restore(const GodObjectState& state) noexcept;
    /// Active constraints of the last step, 0 to 3. Valid until the next step, `restore` or `forgetContacts`.
    [[nodiscard]] std::span<const ActiveConstraint> active() const noexcept
    {
        return std::span(m_active).first(m_state.constraints);
    }
    /// Facets of `active()`, in the same order.
    [[nodiscard]] const std::array<Facet, 3>& facets() const noexcept { return m_facets; }
    /// Sum of the multipliers times the normals of the last step [mm]. Valid only in a layer with friction and with two
    /// or more active constraints.
    [[nodiscard]] const Vec3& push_W() const noexcept { return m_push_W; }

  private:
    [[nodiscard]] GodObjectStep stepTight(const Vec3& p_WH, double dt_s, const HapticLayer& layer,
                                          const GodObjectLimits& limits, NearBall* ball) noexcept;
    void recallFacets(const HapticLayer& layer) noexcept;
    void stepBall(const Vec3& p_WH, const HapticLayer& layer, const GodObjectLimits& limits, NearBall& ball,
                  CoulombFriction* friction, GodObjectStep& result) noexcept;
    void stepPoint(const Vec3& p_WH, const HapticLayer& layer, const GodObjectLimits& limits, CoulombFriction* friction,
                   bool mayWalk, GodObjectStep& result) noexcept;
    void stepWithFriction(const Vec3& p_WH, double dt_s, const HapticLayer& layer, const GodObjectLimits& limits,
                          NearBall* ball, GodObjectStep& result) noexcept;
    [[nodiscard]] ConstrainedPoint withoutFriction(const Vec3& p_WH, const HapticLayer& layer,
                                                   std::array<HalfSpace, 3>& planes) const noexcept;
    [[nodiscard]] bool supports(std::size_t contact, const HapticLayer& layer) const noexcept;
    [[nodiscard]] bool tryHold(const ConstrainedPoint& point, const std::array<HalfSpace, 3>& planes,
                               const HapticLayer& layer, CoulombFriction& friction) const noexcept;
    struct Before;
    void keepHeld(const Vec3& p_WH, const HapticLayer& layer, const Before& before) noexcept;
    void lookAhead(const HapticLayer& layer, bool hasWalkedClear) noexcept;
    template<class Contacts>
    void keep(const Contacts& contacts) noexcept;
    void publish() noexcept;

    GodObjectState m_state;
    // Caches of the layer around the god-object; they never change a result.
    NearPoint m_near;
    std::array<Facet, 3> m_facets;            ///< facets of the constraints in m_state
    std::array<ActiveConstraint, 3> m_active; ///< these constraints as planes; set by step()
    Vec3 m_push_W;                            ///< see push_W()
    const TightRoom* m_room = nullptr;        ///< set during a step in the state kTight
    bool m_hasFacets = false;
    bool m_hasWalked = false; ///< the last tick ended by a walk, well inside m_facets[0]
};

} // namespace palpate::haptics::internal
