// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal/CoulombFriction.h"
#include "nearby/NearPoint.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics::internal {

/// Moves a god-object over the surface towards the HIP, from facet to facet: along one facet, or along the common edge
/// of two (a crease), and across edges as long as the HIP is behind the next facet, too, and the surface turns by at
/// most 60 degrees there. A walk ends well inside a facet, or in a crease between the ends of the edge. At anything
/// else (a corner, a rim, another surface in the way) the general method continues from the position reached.
/// resources/docs/clear-facets.md proves why a walk over clear facets needs no collision tests.
/// @par Real-time Wait-free; bounded by the work of the tick that `near` has begun.
class Walk
{
  public:
    /// References to the god-object's position and contacts, which the walk updates.
    struct Place
    {
        Vec3& god;     ///< god-object position [mm]
        Facet& facet;  ///< touched facet
        Facet& beyond; ///< second touched facet, adjacent to the first; only valid in a crease
        int side;      ///< side of the facets that the god-object is on: +1 front, -1 back
    };

    enum class Start : std::uint8_t
    {
        OnFacet,
        WellInside, ///< where the last walk ended, one skin above the facet
        InCrease,   ///< of two facets
    };

    enum class Ended : std::uint8_t
    {
        OnFacet,     ///< nearest to the HIP (or as near as friction permits), well inside the facet
        InCrease,    ///< the same, held by two facets between the ends of their edge
        AtCreaseEnd, ///< held by two facets; not finished
        Unfinished,  ///< on the facet; not finished
    };
    [[nodiscard]] static bool hasArrived(Ended e) noexcept { return e == Ended::OnFacet || e == Ended::InCrease; }
    [[nodiscard]] static bool isHeldByTwo(Ended e) noexcept { return e == Ended::InCrease || e == Ended::AtCreaseEnd; }

    /// @param friction  friction of the layer in this tick; null: frictionless
    Walk(const Vec3& hip, const HapticLayer& layer, NearPoint& near, CoulombFriction* friction,
         const Place& place) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_near(near)
        , m_friction(friction)
        , m_surface(layer.surface(place.facet.structure))
        , m_god(place.god)
        , m_facet(place.facet)
        , m_beyond(place.beyond)
        , m_side(place.side)
        , m_margin_mm(kTouchRadius * place.facet.skin_mm)
        , m_here(&place.facet)
    {
    }

    /// Walks by moves that no facet blocks.
    /// @param start  current contact
    /// @param most  maximum number of moves
    Ended run(Start start, std::uint32_t most) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] std::uint32_t moves() const noexcept { return m_moves; }
    /// Returns true if the whole walk led over clear facets, so that no collision test was needed.
    [[nodiscard]] bool isClear() const noexcept { return m_isClear; }

  private:
    /// What to do after a step.
    enum class Next : std::uint8_t
    {
        Step,
        Stop, ///< the general method continues from here
        Over, ///< the walk is complete
    };
    struct Exit;
    struct Crease;

    [[nodiscard]] bool isClearAt(const Facet& facet, const Vec3& p) noexcept;
    void begin(Start start) noexcept;
    [[nodiscard]] Next startFromCrease() noexcept;
    [[nodiscard]] Next step() noexcept;
    [[nodiscard]] Next arrive(const Vec3& target) noexcept;
    [[nodiscard]] Next enterCrease(const Vec3& from) noexcept;
    [[nodiscard]] Next cross(const Exit& exit, const Vec3& target) noexcept;
    [[nodiscard]] Exit exitFrom(const Vec3& from, const Vec3& to) const noexcept;
    [[nodiscard]] Crease creaseAt(const Facet& facet, int edge, const Vec3& g) noexcept;
    [[nodiscard]] bool liftOver(const Facet& next, const Vec3& target, double share, Vec3& to) const noexcept;
    [[nodiscard]] Vec3 slowed(const Vec3& target, double rise) noexcept;
    [[nodiscard]] bool isFar(const Vec3& target) const noexcept;
    void addToPath(const Vec3& p) noexcept;
    [[nodiscard]] bool commitPath() noexcept;
    [[nodiscard]] bool makeLastMove(const Vec3& target) noexcept;
    void stand() noexcept;
    [[nodiscard]] const Vec3& last() const noexcept { return m_path[m_points - 1]; }

    const Vec3& m_hip;
    const HapticLayer& m_layer;
    NearPoint& m_near;
    CoulombFriction* m_friction;
    const geometry::SurfaceIndex& m_surface;
    Vec3& m_god;
    Facet& m_facet;
    Facet& m_beyond;
    int m_side;
    double m_margin_mm; ///< minimum distance from the facet's edges of a position well inside

    Facet* m_here;               ///< facet at the end of the path
    int m_entered = -1;          ///< edge of m_here over which the path entered; -1: none
    std::array<Facet, 2> m_met;  ///< facets on the path, used alternately
    std::size_t m_crossings = 0; ///< number of edges crossed
    std::uint32_t m_moves = 0;
    bool m_isClear = false;
    Ended m_ended = Ended::Unfinished;

    std::array<Vec3, NearPoint::kMaxPoints> m_path; ///< moves not yet tested
    /// Facet below each point of the path; entry 0 is the facet before the first point.
    std::array<FacetNumber, NearPoint::kMaxPoints + 1> m_over;
    std::array<CoulombFriction::State, NearPoint::kMaxPoints>
        m_frictionAt; ///< friction state at each point but the first
    std::size_t m_points = 1;
    std::size_t m_crossed = 0; ///< number of edges that the path crosses
};

} // namespace palpate::haptics::internal
