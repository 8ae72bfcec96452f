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
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        Vec3 f_W = Vec3::Zero();
        (add<Terms>(touch, f_W), ...);
        return f_W;
    }

  private:
    template<class Term>
    static void add(const Touch& touch, Vec3& f_W) noexcept
    {
        if (Term::isIn(touch.structure)) {
            const Vec3 sum = f_W + Term::force(touch);
            if (sum.allFinite()) {
                f_W = sum;
            }
        }
    }
};

/// What a tissue answers with. A new term is a file here and a name in this list.
using Law = Sum<Spring, Damper>;
/// The same where nothing in a layer has friction, a law of its own or a map: most scenes.
using LinearLaw = Sum<LinearSpring, LinearDamper>;

} // namespace palpate::haptics::law
