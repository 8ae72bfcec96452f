// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/StateOf.h"

#include <cstddef>

namespace palpate::view {

TouchState stateOf(const servo::TickRecord& tick, double fingertip_mm, std::span<const Colour> colours)
{
    const haptics::TickResult& felt = tick.felt;
    TouchState state;
    state.p_WH = tick.p_WH;
    state.p_WG = felt.p_WG;
    state.n_W = felt.n_W;
    state.f_W = felt.f_W;
    state.fingertip_mm = fingertip_mm;
    state.isInContact = felt.structure >= 0;
    state.isPresent = (tick.flags & servo::kNoHand) == 0;
    for (std::size_t i = 1; state.isInContact && i < felt.contactCount; ++i) {
        const haptics::Contact& contact = felt.contacts[i];
        if (contact.layer == felt.contacts[i - 1].layer) {
            continue; // another structure that constrains the same god-object
        }
        const Colour colour = contact.structure < colours.size() ? colours[contact.structure] : Colour{1.0, 1.0, 1.0};
        state.inner[state.innerCount++] = {contact.p_WG, colour, contact.depth_mm};
    }
    return state;
}

} // namespace palpate::view
