// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Damper.h"
#include "law/Spring.h"

namespace palpate::haptics::law {

/// Sum of the force terms of a tissue. An absent term costs a branch; a term whose force is not finite (a damper after
/// too short a time step) is omitted.
template<class... Terms>
struct Sum
{
    /// @param touch  a Touch, or a MappedTouch if a term needs the foot
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

// Force laws by the features of a tissue: most tissues have no maps and do not pay for them. To add a term, add a file
// to this folder and a name to these lists.

/// No friction, nonlinear law or maps: most scenes.
using LinearLaw = Sum<LinearSpring, LinearDamper>;
/// No maps that affect the force.
using UnmappedLaw = Sum<LawSpring, LinearDamper>;
/// Maps that affect the force. Without springs: the other terms, for SharedContact, which evaluates the springs itself.
template<class... Springs>
using WithMaps = Sum<Springs..., MapDamper>;
/// No buried lumps.
using MappedLaw = WithMaps<MapSpring>;
using FeltLaw = WithMaps<TransmissionSpring>;

} // namespace palpate::haptics::law
