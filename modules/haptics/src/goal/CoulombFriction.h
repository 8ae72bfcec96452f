// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "probe/PointProbe.h"

#include <array>
#include <cstddef>
#include <span>

namespace palpate::haptics::internal {

/// Coulomb friction of one god-object in one tick. Let g* be the rest position without friction. The god-object g
/// sticks while r = |g - g*| is at most R; otherwise it is dragged behind g* at the distance R. R is the sum over the
/// contacts of mu lambda, where lambda are the multipliers [mm] of the frictionless rest position. Hence no groove can
/// hold a god-object by wedging it, and R vanishes with the depth. See resources/docs/friction.md for the derivation.
///
/// The choice between the two coefficients is a state that persists between ticks: static friction until overcome, then
/// kinetic friction until r falls below kCaught R.
/// @par Real-time Wait-free.
/// @par Source Moreau's catching-up algorithm, x' = projection of x on a moving set (arXiv:2501.04781), for the set |g
/// - g*| <= R; drag by the implicit Euler step.
///
/// If structures share a contact, each lambda is weighted by its stiffness k = F(lambda)/lambda: R is then `sum lambda
/// (sum mu k lambda) / (sum k lambda)`, so that the friction force is the sum of mu times the normal force of each
/// structure.
class CoulombFriction
{
  public:
    /// Fraction of R below which a sliding god-object is caught. Without this hysteresis, a slow hand with a coarse
    /// encoder would stick at each encoder count.
    static constexpr double kCaught = 0.6;

    /// @param layer  a layer with friction
    /// @param dt_s  time since the last tick [s]; <= 0: no drag
    /// @param slides  final state of the previous tick
    CoulombFriction(const HapticLayer& layer, double dt_s, bool slides) noexcept
        : m_layer(layer)
        , m_dt_s(dt_s)
    {
        m_now.slides = slides;
    }

    /// Friction state within a tick.
    struct State
    {
        bool slides;
        bool lastSlid;     ///< the last call of `remainingFraction` allowed sliding
        bool isBehind;     ///< `behind_mm` is valid
        double still_mm;   ///< R with static friction
        double sliding_mm; ///< R with kinetic friction
        double drag;       ///< maximum drag of the contacts [N s/mm]
        double stiffest;   ///< maximum stiffness of the contacts [N/mm]
        double behind_mm;  ///< additional lag beyond R that drag permits in this tick
    };
    [[nodiscard]] const State& state() const noexcept { return m_now; }
    /// Restores an earlier state of the tick.
    void restore(const State& state) noexcept { m_now = state; }

    [[nodiscard]] bool slides() const noexcept { return m_now.slides; }
    [[nodiscard]] bool lastSlid() const noexcept { return m_now.lastSlid; }

    /// Removes all contacts, to evaluate other contacts or another position.
    void lift() noexcept
    {
        m_now.still_mm = m_now.sliding_mm = m_now.stiffest = m_now.drag = 0.0;
        m_pressedCount = 0;
    }
    /// Adds a contact.
    /// @param facet  must stay valid until `lift` if the layer has several structures
    /// @param foot  foot of the god-object on the facet [mm]
    /// @param lambda_mm  multiplier of the facet's plane
    void press(const Facet& facet, const Vec3& foot, double lambda_mm) noexcept;
    /// Applies friction to a move towards g*.
    /// @param r_mm  distance from the god-object to g*
    /// @param rounding_mm  differences up to this length are ignored
    /// @return the fraction of the distance to g* that remains after the move; 1 if static friction holds
    [[nodiscard]] double remainingFraction(double r_mm, double rounding_mm) noexcept;
    /// Returns true if friction alone holds the god-object against a pull.
    /// @param pull_mm  length of the spring along the direction of motion
    [[nodiscard]] bool holdsAgainst(double pull_mm) const noexcept
    {
        // A sliding god-object is exactly on the boundary of the friction cone, up to rounding.
        constexpr double kRim = 1.0 + 1e-9;
        const double behind_mm = m_now.drag > 0.0 && m_now.isBehind ? m_now.behind_mm : 0.0;
        return pull_mm <= kRim * (m_now.slides ? m_now.sliding_mm + behind_mm : m_now.still_mm);
    }

  private:
    void share(const Facet& facet, const Vec3& foot, double lambda_mm, double atRest, double sliding) noexcept;

    /// A contact and its friction coefficients.
    struct Pressed
    {
        const Facet* facet;
        Vec3 foot;
        double lambda_mm, atRest, sliding;
        double force_N; ///< normal force; < 0: not computed
    };

    const HapticLayer& m_layer;
    double m_dt_s;
    State m_now{};
    std::array<Pressed, 4> m_pressed; ///< contacts since `lift`; only used if the layer has several structures
    std::size_t m_pressedCount = 0;
};

} // namespace palpate::haptics::internal
