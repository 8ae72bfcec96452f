// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomMesh.h"

#include <palpate/haptics/HapticScene.h>

#include <array>
#include <memory>

namespace palpate::adversary {

/// Families of random scenes: each is a row of the test.
enum class Family
{
    Closed, ///< a point on bodies that enclose a volume
    Open,   ///< a point on sheets, fins and loose triangles
    Layers, ///< a point and two to four layers
    Balls,  ///< balls of 0.1 to 20 mm in the scenes above
    Rough,  ///< a point in the scenes above, with friction, laws and maps
    RoughBalls,
    Moving, ///< all of the above, with structures that move, see MovingScene
};
constexpr int kFamilies = 7;
[[nodiscard]] const char* nameOf(Family family);

struct RandomStructure
{
    RandomMesh mesh; ///< in world position [mm]
    std::shared_ptr<const geometry::SurfaceIndex> surface;
    haptics::Tissue tissue;
    std::uint32_t layer = 0; ///< 0, 1, … without gaps
    haptics::TissueMaps maps{};
    std::shared_ptr<const haptics::ForceTable> law{};

    [[nodiscard]] haptics::HapticStructure structure() const { return {mesh.name, surface, tissue, layer, maps, law}; }
};

struct RandomScene
{
    std::string name;
    double fingertip_mm = 0.0;
    double scale = 1.0; ///< 1 for a scene of some 20 to 50 mm
    std::uint32_t layers = 1;
    std::vector<RandomStructure> structures;
    core::Box bounds; ///< [mm]

    [[nodiscard]] double size_mm() const { return bounds.diagonal().norm(); }
    /// @param shown  one bit per layer; structures of hidden layers have no surface
    [[nodiscard]] std::unique_ptr<haptics::HapticScene> build(std::uint32_t shown) const;
};

[[nodiscard]] RandomScene randomScene(Family family, Chance& chance);

} // namespace palpate::adversary
