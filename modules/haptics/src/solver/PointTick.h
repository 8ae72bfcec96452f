// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal/CoulombFriction.h"
#include "nearby/NearPoint.h"
#include "solver/PointContact.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace palpate::haptics::internal {

/// One tick of a point-shaped god-object, by the general method: straight moves to the constrained point of the active
/// set, each up to the first facet in the way, whose plane becomes a constraint.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876. Differs: converges within the tick.
/// @par Real-time Wait-free; bounded by `limit` and the work that `near` has begun.
class PointTick
{
  public:
    /// @param friction  friction of the layer in this tick; null: frictionless
    /// @param walked  number of moves already made in this tick
    PointTick(const Vec3& hip, const HapticLayer& layer, NearPoint& near, CoulombFriction* friction, const Vec3& god,
              std::uint32_t walked) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_near(near)
        , m_friction(friction)
        , m_god(god)
        , m_walked(walked)
    {
    }

    /// Adds a contact of the previous tick.
    void touch(const Facet& facet, int side) noexcept { touch({facet, side}); }

    /// Moves the god-object until rest or `limit`.
    /// @return the number of moves tried; `limit` if the tick is incomplete
    [[nodiscard]] std::uint32_t converge(std::uint32_t limit) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const Vec3& god() const noexcept { return m_god; }
    [[nodiscard]] const PointContacts& contacts() const noexcept { return m_active; }

  private:
    void touch(const PointContact& contact) noexcept;
    [[nodiscard]] std::uint32_t moveUntilDone(std::uint32_t limit) noexcept;
    [[nodiscard]] bool walkToRest(std::uint32_t most) noexcept;
    [[nodiscard]] bool detectCycle() noexcept;
    void recordBlocking(const PointContact& contact) noexcept;
    void addBlockingContacts() noexcept;
    [[nodiscard]] Vec3 nextTarget() noexcept;
    [[nodiscard]] Vec3 slowed(const Vec3& u) noexcept;
    [[nodiscard]] bool stopAt(const Vec3& target, const Crossing& crossing) noexcept;
    bool moveTo(const Vec3& p) noexcept;
    void keepSupporting() noexcept;
    [[nodiscard]] bool isCertain() const noexcept;
    [[nodiscard]] bool isConcaveEdge() const noexcept;
    [[nodiscard]] bool takeEscape() noexcept;

    const Vec3& m_hip;
    const HapticLayer& m_layer;
    NearPoint& m_near;
    CoulombFriction* m_friction;
    Vec3 m_god;
    PointContacts m_active;
    bool m_isHeld = false;  ///< held in place by friction
    bool m_mayWalk = false; ///< walking from the single contact is possible
    std::uint32_t m_walked; ///< moves made by walking
    double m_skin_mm = 0.0; ///< maximum skin of the touched facets
    /// Distance to the HIP when the last contact was released.
    double m_letGo_mm = std::numeric_limits<double>::infinity();
    int m_rounds = 0; ///< number of releases that gained less than a skin
    /// A facet that blocked a move or was reached by a walk, and the side of contact.
    struct Met
    {
        FacetNumber number;
        int side;
    };
    std::array<Met, 3> m_recentBlocking;   ///< most recent facets since the last release
    std::size_t m_turn = 0;                ///< number of facets since the last release
    std::optional<PointContact> m_lastMet; ///< last facet that blocked a move
};

} // namespace palpate::haptics::internal
