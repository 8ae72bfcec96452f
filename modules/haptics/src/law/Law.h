// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Damper.h"
#include "law/Spring.h"

namespace palpate::haptics::law {

/// The sum of the terms that a tissue has. One that it lacks costs a branch; one whose force no number can hold (a
/// damper after a time too short to divide by) is left out.
template<class... Terms>
struct Sum
{
    /// @param touch  a Touch, or a MappedTouch where a term asks for the foot
    template<class TouchOfTerms>
    [[nodiscard]] PALPATE_ALWAYS_INLINE static Vec3 force(const TouchOfTerms& touch) noexcept
    {
        Vec3 f_W = Vec3::Zero();
        (add<Terms>(touch, f_W), ...);
        return f_W;
    }

  private:
    template<class Term, class TouchOfTerms>
    PALPATE_ALWAYS_INLINE static void add(const TouchOfTerms& touch, Vec3& f_W) noexcept
    {
        if (Term::isIn(touch.structure)) {
            const Vec3 sum = f_W + Term::force(touch);
            if (sum.allFinite()) {
                f_W = sum;
            }
        }
    }
};

// What a tissue answers with, by what it has: most have no map, and pay for none. A new term is a file here and a name
// in these lists.

/// Neither friction, a law of its own nor a map: most scenes.
using LinearLaw = Sum<LinearSpring, LinearDamper>;
/// No map of the force.
using UnmappedLaw = Sum<LawSpring, LinearDamper>;
/// No lumps felt below.
using MappedLaw = Sum<MapSpring, MapDamper>;
using FeltLaw = Sum<FeltSpring, MapDamper>;

} // namespace palpate::haptics::law
