// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomMotion.h"

#include <optional>

namespace palpate::adversary {

/// Structures that share a motion and a god-object.
struct MovingGroup
{
    std::uint32_t number = 0; ///< layer number that the engine is given; groups may share one
    std::optional<RandomMotion> motion;
};

/// A random scene in which some groups of structures move. The layers of `rest` are the groups, in the order of the
/// engine's layers.
struct MovingScene
{
    RandomScene rest;
    std::vector<MovingGroup> groups;

    explicit MovingScene(Chance& chance);
    /// @param shown  one bit per group
    [[nodiscard]] std::unique_ptr<haptics::HapticScene> build(std::uint32_t shown) const;
    [[nodiscard]] std::string name() const;
};

} // namespace palpate::adversary
