// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/TickResult.h>

#include <cstring>

namespace palpate::adversary {

[[nodiscard]] inline bool sameBits(const core::Vec3& a, const core::Vec3& b)
{
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

[[nodiscard]] inline bool sameBits(const haptics::TickResult& a, const haptics::TickResult& b)
{
    bool same = sameBits(a.p_WG, b.p_WG) && sameBits(a.f_W, b.f_W) && sameBits(a.n_W, b.n_W) &&
                a.structure == b.structure && a.triangle == b.triangle && a.constraints == b.constraints &&
                a.status == b.status && a.iterations == b.iterations && a.friction() == b.friction();
    for (std::size_t i = 0; same && i < a.constraints; ++i) {
        same = sameBits(a.active[i].n_W, b.active[i].n_W) && a.active[i].triangle == b.active[i].triangle &&
               a.active[i].structure == b.active[i].structure;
    }
    return same;
}

} // namespace palpate::adversary
