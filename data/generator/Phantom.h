// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <string>
#include <vector>

namespace palpate::phantom {

/// A structure of the phantom: its surface, how it is drawn and how it feels.
struct PhantomStructure
{
    std::string name;
    geometry::TriangleMesh mesh;
    std::array<double, 3> colour;
    double opacity;
    bool palpable;
    double stiffness_N_per_mm;
    std::uint32_t layer;
};

/// How many times as stiff as the organ the lumps are.
inline constexpr double kLumpRatio = 3.0;

/// The two lumps: 20 mm across under the front of the right lobe, 12 mm across under the front of the left.
[[nodiscard]] std::array<Lump, 2> lumps();

/// Organ, lumps, portal vein and hepatic veins, in LPS and mm, the same on every run.
[[nodiscard]] std::vector<PhantomStructure> makePhantom();

} // namespace palpate::phantom
