// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "probe/PointProbe.h"

#include <array>
#include <cstddef>
#include <span>

namespace palpate::haptics::internal {

/// Coulomb friction of one god-object in one tick, on the way to where it would stand without friction, g*: it holds
/// the god-object g while r = |g - g*| is at most R, and drags behind it at that distance else. R is the sum over the
/// contacts of mu lambda, with lambda the multipliers [mm] that hold g*: those without friction, so that no groove can
/// hold what squeezes itself in, and R vanishes with the depth. resources/docs/friction.md has the argument.
///
/// Which of the two coefficients counts is a state between ticks: friction at rest until that is overcome, friction of
/// sliding until r falls below kCaught R.
/// @par Real-time Wait-free.
/// @par Source Moreau's catching-up algorithm, x' = projection of x on a moving set (arXiv:2501.04781), for the set
/// |g - g*| <= R; drag by the implicit Euler step.
///
/// Where structures share a contact each lambda counts by its stiffness k = F(lambda)/lambda: R is then
/// `sum lambda (sum mu k lambda) / (sum k lambda)`, so that the drag is the sum of mu times each one's own force.
class CoulombFriction
{
  public:
    /// Share of R below which what slides is caught: a slow hand with a coarse encoder would stick at each count if it
    /// were caught at the rim.
    static constexpr double kCaught = 0.6;

    /// @param layer  where something has friction
    /// @param dt_s  time since the last tick [s]; <= 0: no drag
    /// @param slides  as the last tick left it
    CoulombFriction(const HapticLayer& layer, double dt_s, bool slides) noexcept
        : m_layer(layer)
        , m_dt_s(dt_s)
    {
        m_now.slides = slides;
    }

    /// What it has come to in this tick.
    struct State
    {
        bool slides;
        bool lastSlid;     ///< the last `remainingShare` let it go on
        bool isBehind;     ///< `behind_mm` is known
        double still_mm;   ///< R with the coefficients at rest
        double sliding_mm; ///< R with those of sliding
        double drag;       ///< of what is pressed, the greatest [N s/mm]
        double stiffest;   ///< of what is pressed [N/mm]
        double behind_mm;  ///< how far drag lets it fall behind R in this tick
    };
    [[nodiscard]] const State& state() const noexcept { return m_now; }
    /// Takes back what came after.
    void restore(const State& state) noexcept { m_now = state; }

    [[nodiscard]] bool slides() const noexcept { return m_now.slides; }
    [[nodiscard]] bool lastSlid() const noexcept { return m_now.lastSlid; }

    /// Begins with another set of contacts, or another place on them.
    void lift() noexcept
    {
        m_now.still_mm = m_now.sliding_mm = m_now.stiffest = m_now.drag = 0.0;
        m_pressedCount = 0;
    }
    /// Adds a contact. @param facet  kept until `lift`, where structures share the layer
    /// @param foot  of the god-object on the facet [mm]; @param lambda_mm  its multiplier
    void press(const Facet& facet, const Vec3& foot, double lambda_mm) noexcept;
    /// @param r_mm  from the god-object to g*; @param rounding_mm  no difference
    /// @return the share of the way to g* that is left when friction has let it go on: 1 where that holds
    [[nodiscard]] double remainingShare(double r_mm, double rounding_mm) noexcept;
    /// @return true when friction alone holds it against a pull, measured as the spring's length along the way.
    [[nodiscard]] bool holdsAgainst(double pull_mm) const noexcept
    {
        constexpr double kRim = 1.0 + 1e-9; // what slides stands at the rim itself, to rounding
        const double behind_mm = m_now.drag > 0.0 && m_now.isBehind ? m_now.behind_mm : 0.0;
        return pull_mm <= kRim * (m_now.slides ? m_now.sliding_mm + behind_mm : m_now.still_mm);
    }

  private:
    void raise(const HapticStructure& on, const Facet& facet, const Vec3& foot, double lambda_mm, double& atRest,
               double& sliding) const noexcept;
    void share(const Facet& facet, const Vec3& foot, double lambda_mm, double atRest, double sliding) noexcept;

    /// A contact with its coefficients.
    struct Pressed
    {
        const Facet* facet;
        Vec3 foot;
        double lambda_mm, atRest, sliding;
    };

    const HapticLayer& m_layer;
    double m_dt_s;
    State m_now{};
    std::array<Pressed, 4> m_pressed; ///< since `lift`, where a layer has several structures
    std::size_t m_pressedCount = 0;
};

} // namespace palpate::haptics::internal
