// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Friction.h"
#include "nearby/NearPoint.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics::internal {

/// A god-object's way over a surface towards the HIP: along one facet, or two at their common edge, and on over edges,
/// as long as each next facet is pressed too and the surface turns by at most 60 degrees there. It ends well inside a
/// facet or in a crease, between the ends of the edge. At anything else (a corner, a rim, another surface in the way)
/// the general method goes on from where the walk came to. Why a walk over clear facets asks for nothing:
/// resources/docs/clear-facets.md.
/// @par Real-time Wait-free; bounded by the work of the tick that `near` has begun.
class Walk
{
  public:
    /// Where the god-object is, and how the walk moves it.
    struct Place
    {
        Vec3& god;     ///< [mm]
        Facet& facet;  ///< that it touches
        Facet& beyond; ///< the other, where it touches two: beyond an edge of the first
        int side;      ///< of the facets that it is on: +1 front, -1 behind
    };

    enum class Start : std::uint8_t
    {
        OnFacet,
        WellInside, ///< a facet, where the last walk has ended: a skin above it
        InCrease,   ///< of two facets
    };

    enum class Ended : std::uint8_t
    {
        OnFacet,     ///< nearest to the HIP, or as near as friction lets it, well inside the facet
        InCrease,    ///< the same, held by two facets between the ends of their edge
        AtCreaseEnd, ///< held by two facets: more is to be done
        Unfinished,  ///< on the facet: more is to be done
    };
    [[nodiscard]] static bool hasArrived(Ended e) noexcept { return e == Ended::OnFacet || e == Ended::InCrease; }
    [[nodiscard]] static bool isHeldByTwo(Ended e) noexcept { return e == Ended::InCrease || e == Ended::AtCreaseEnd; }

    /// @param friction  of the layer in this tick; null: none
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
        , m_margin_mm(kTouched * place.facet.skin_mm)
        , m_here(&place.facet)
    {
    }

    /// Walks, by moves that nothing blocks. @param most  moves, at most
    Ended run(Start start, std::uint32_t most) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] std::uint32_t moves() const noexcept { return m_moves; }
    /// @return true when all of it led over clear facets: nothing was asked.
    [[nodiscard]] bool isClear() const noexcept { return m_isClear; }

  private:
    /// What follows a step.
    enum class Next : std::uint8_t
    {
        Step,
        Stop, ///< the general method goes on from here
        Over, ///< the walk has ended
    };
    struct Exit;
    struct Crease;

    [[nodiscard]] bool isClearAt(const Facet& facet, const Vec3& p) noexcept;
    void begin(Start start) noexcept;
    [[nodiscard]] Next leaveCrease() noexcept;
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
    [[nodiscard]] bool makePathMoves() noexcept;
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
    double m_margin_mm; ///< from a facet's edges that is well inside

    Facet* m_here;               ///< the facet that the path has come to
    int m_entered = -1;          ///< its edge that it was entered over
    std::array<Facet, 2> m_met;  ///< facets on the way, by turns
    std::size_t m_crossings = 0; ///< edges gone over
    std::uint32_t m_moves = 0;
    bool m_isClear = false;
    Ended m_ended = Ended::Unfinished;

    std::array<Vec3, NearPoint::kMostPoints> m_path; ///< moves that are still to be asked for
    /// Of each point and, first, of that before them.
    std::array<FacetNumber, NearPoint::kMostPoints + 1> m_over;
    std::array<CoulombFriction::State, NearPoint::kMostPoints> m_frictionAt; ///< of each point but the first
    std::size_t m_points = 1;
    std::size_t m_crossed = 0; ///< edges that the path goes over
};

} // namespace palpate::haptics::internal
