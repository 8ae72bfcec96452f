// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal/CoulombFriction.h"
#include "nearby/NearBall.h"
#include "nearby/TickWork.h"
#include "solver/ActiveSet.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace palpate::haptics::internal {

/// A facet in contact with the ball, as seen from the ball's centre.
struct BallContact
{
    Facet facet;
    int side = 1;
    Vec3 n = Vec3::Zero();    ///< unit contact normal, from the contact point to the centre
    double radius_mm = 0.0;   ///< distance that the centre keeps: the fingertip's radius, or less, see TightRoom
    double distance_mm = 0.0; ///< distance of the centre from the facet
    Nearest nearest;          ///< contact point: on an edge or a corner the ball rolls around it

    [[nodiscard]] const Vec3& normal() const noexcept { return n; }
    void updateFrom(const Vec3& g) noexcept;
};

/// One tick of a ball-shaped god-object: moves the centre as near to the HIP as possible by straight moves that no
/// facet blocks. See resources/docs/fingertip.md.
///
/// At each position the contacts define half-spaces through the contact points, and Zilles & Salisbury's constrained
/// point is the next target, as for a point. Around edges and corners these planes turn with the ball, so that plain
/// steps converge slowly (creep). Step directions are those of the projected gradient; a secant through the last two
/// steps estimates the step length that ends the creeping. A long step may cross any number of facets, so the result is
/// judged a few moves later, and the step is taken back if the ball is no nearer to the HIP.
/// @par Source Birgin, Martínez & Raydan, SIAM J. Optim. 10 (2000) 1196, doi:10.1137/S1052623497330963: projected
/// gradient with spectral (secant) step lengths and a non-monotone test. Applied here along the surface, with each move
/// legal by itself.
/// @par Real-time Wait-free; bounded by `limit` and `work`.
class BallTick
{
  public:
    /// @param room  distances that the ball keeps where it was placed too near; null: its radius everywhere
    /// @param friction  friction of the layer in this tick; null: frictionless
    BallTick(const Vec3& hip, const HapticLayer& layer, const TightRoom* room, NearBall& near,
             CoulombFriction* friction, TickWork& work, const Vec3& god) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_room(room)
        , m_near(near)
        , m_friction(friction)
        , m_work(work)
        , m_god(god)
    {
    }

    void touch(const Facet& facet, int side) noexcept;
    /// Moves the ball until rest, `limit` or the end of the work budget.
    /// @return the number of moves tried; if equal to `limit`, or if the budget is spent, the tick is incomplete
    std::uint32_t converge(std::uint32_t limit) noexcept;

    [[nodiscard]] const Vec3& god() const noexcept { return m_god; }
    [[nodiscard]] const ActiveSet<BallContact>& contacts() const noexcept { return m_active; }

  private:
    void keepThinnest(double skin_mm) noexcept;
    [[nodiscard]] bool makeMove() noexcept;
    [[nodiscard]] bool moveTo(const Vec3& target, bool isLong) noexcept;
    [[nodiscard]] bool stopAt(const Vec3& u, double step, const BallCrossing& crossing, bool isLong) noexcept;
    [[nodiscard]] bool updateContacts() noexcept;
    [[nodiscard]] bool rollOn(BallContact& contact) const noexcept;
    [[nodiscard]] Vec3 nextMove() noexcept;
    [[nodiscard]] Vec3 slowed(const Vec3& u) noexcept;
    [[nodiscard]] Vec3 brink(const BallContact& contact) const noexcept;
    [[nodiscard]] Vec3 slope() const noexcept;
    [[nodiscard]] bool tryAside() noexcept;
    [[nodiscard]] Vec3 lengthened(const Vec3& u) noexcept;
    [[nodiscard]] bool judgeLongStep(bool isOver) noexcept;
    void dropUntouched() noexcept;
    [[nodiscard]] bool touchesHip(double spring_mm) const noexcept;
    [[nodiscard]] bool isNearest(double spring_mm) const noexcept;
    [[nodiscard]] double slight(double spring_mm) const noexcept;
    [[nodiscard]] bool isTouched(const BallContact& contact) const noexcept;
    [[nodiscard]] bool isDeep() const noexcept;
    [[nodiscard]] bool isFlat() const noexcept;
    [[nodiscard]] bool staysFlat(const Vec3& u) const noexcept;

    const Vec3& m_hip;
    const HapticLayer& m_layer;
    const TightRoom* m_room;
    NearBall& m_near;
    CoulombFriction* m_friction;
    TickWork& m_work;
    Vec3 m_god;
    ActiveSet<BallContact> m_active;
    double m_skin_mm = 0.0; ///< smallest skin of the facets touched in this tick; 0: none touched yet
    BallContact m_known;    ///< last contact met, or contact carried over from the previous tick
    bool m_isHeld = false;  ///< held in place by friction
    bool m_isKnown = false; ///< m_known is valid
    double m_spring_mm = std::numeric_limits<double>::infinity(); ///< distance to the HIP at the last progress
    std::uint32_t m_since = 0;                                    ///< moves made since the last progress

    /// Snapshot of a position that the ball may be returned to.
    struct Before
    {
        Vec3 god;
        ActiveSet<BallContact> active;
        double spring_mm;
    };
    void restoreSnapshot(const Before& stood) noexcept;

    Before m_before;
    Before m_restSnapshot;        ///< rest position before the sideways moves
    int m_nudges = 0;             ///< number of sides tried from the rest position
    int m_insignificantMoves = 0; ///< sideways moves that gained less than the significant distance
    Vec3 m_aside = Vec3::Zero();
    /// A step as given by the constrained point.
    struct Step
    {
        Vec3 god = Vec3::Zero(); ///< start position [mm]
        Vec3 u = Vec3::Zero();   ///< displacement [mm]
        std::size_t count = 0;   ///< number of contacts
        int alike = 0;           ///< number of preceding steps in the same direction
    };
    Step m_step;             ///< current step
    Step m_last;             ///< last step that was not blocked
    int m_trialMoves = 0;    ///< remaining moves before the current long step is judged
    double m_tried_mm = 0.0; ///< length of the long step under trial
    double m_kept_mm = 0.0;  ///< length of the last accepted long step
    double m_longest_mm = std::numeric_limits<double>::infinity(); ///< upper limit of trial step lengths
};

} // namespace palpate::haptics::internal
