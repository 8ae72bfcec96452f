// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Friction.h"
#include "nearby/NearBall.h"
#include "nearby/TickWork.h"
#include "solver/ActiveSet.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace palpate::haptics::internal {

/// A facet that the ball touches, as seen from its centre.
struct BallContact
{
    Facet facet;
    int side = 1;
    Vec3 n = Vec3::Zero();    ///< unit, from the contact point to the centre
    double distance_mm = 0.0; ///< of the centre from the facet
    Nearest nearest;          ///< the contact point: on an edge or a corner the ball rolls around it

    [[nodiscard]] const Vec3& normal() const noexcept { return n; }
    void lookFrom(const Vec3& g) noexcept;
};

/// One tick of a ball-shaped god-object: its centre comes as near to the HIP as the ball can, by straight moves that no
/// facet blocks. See resources/docs/fingertip.md.
///
/// At each place the contacts give half-spaces through the contact points, and Zilles & Salisbury's constrained point
/// the next target, as for a point. Round edges and corners those planes turn with the ball, and the steps along them
/// creep. Their direction is that of the projected gradient; a secant through the last two tells how long the next must
/// be to end it. Such a step leads on over any number of facets, so it is judged by where the ball is some moves later,
/// and taken back when that is no nearer to the HIP.
/// @par Source Birgin, Martínez & Raydan, SIAM J. Optim. 10 (2000) 1196, doi:10.1137/S1052623497330963: projected
/// gradient with spectral (secant) step lengths and a non-monotone test. Here along the surface, by moves that are each
/// legal.
/// @par Real-time Wait-free; bounded by `limit` and `work`.
class BallTick
{
  public:
    /// @param friction  of the layer in this tick; null: none
    BallTick(const Vec3& hip, const HapticLayer& layer, NearBall& near, CoulombFriction* friction, TickWork& work,
             const Vec3& god) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_near(near)
        , m_friction(friction)
        , m_work(work)
        , m_god(god)
    {
    }

    void touch(const Facet& facet, int side) noexcept;
    /// @return how many moves were tried; more are needed when that is `limit` or the work is spent.
    std::uint32_t converge(std::uint32_t limit) noexcept;

    [[nodiscard]] const Vec3& god() const noexcept { return m_god; }
    [[nodiscard]] const ActiveSet<BallContact>& contacts() const noexcept { return m_active; }

  private:
    void keepThinnest(double skin_mm) noexcept;
    [[nodiscard]] bool makeMove() noexcept;
    [[nodiscard]] bool moveTo(const Vec3& target, bool isLong) noexcept;
    [[nodiscard]] bool stopAt(const Vec3& u, double step, const BallCrossing& crossing, bool isLong) noexcept;
    [[nodiscard]] bool lookAgain() noexcept;
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
    NearBall& m_near;
    CoulombFriction* m_friction;
    TickWork& m_work;
    Vec3 m_god;
    ActiveSet<BallContact> m_active;
    double m_skin_mm = 0.0;                                       ///< the thinnest of those touched; 0: none was
    BallContact m_known;                                          ///< the contact met last, or held from before
    bool m_isHeld = false;                                        ///< by friction, where it is
    bool m_isKnown = false;                                       ///< there is one
    double m_spring_mm = std::numeric_limits<double>::infinity(); ///< when the last progress was made
    std::uint32_t m_since = 0;                                    ///< moves made since then

    /// Where the ball stood, to be taken back to.
    struct Before
    {
        Vec3 god;
        ActiveSet<BallContact> active;
        double spring_mm;
    };
    void standAgain(const Before& stood) noexcept;

    Before m_before;
    Before m_stood;   ///< where it came to rest before it was moved aside
    int m_nudges = 0; ///< how many sides have been tried from there
    int m_slight = 0; ///< moves aside that led nearer, but not by more than counts
    Vec3 m_aside = Vec3::Zero();
    /// A step as the planes give it.
    struct Step
    {
        Vec3 god = Vec3::Zero(); ///< where from [mm]
        Vec3 u = Vec3::Zero();   ///< [mm]
        std::size_t count = 0;   ///< contacts
        int alike = 0;           ///< how many before it led the same way
    };
    Step m_step;                                                   ///< the present one
    Step m_last;                                                   ///< the last one that nothing blocked
    int m_trialMoves = 0;                                          ///< left to the long step that is being judged
    double m_tried_mm = 0.0;                                       ///< its length
    double m_kept_mm = 0.0;                                        ///< length of the last that led nearer
    double m_longest_mm = std::numeric_limits<double>::infinity(); ///< that is still tried
};

} // namespace palpate::haptics::internal
