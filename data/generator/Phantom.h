// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <string>
#include <vector>

namespace palpate::phantom {

/// Structure of the phantom: surface, appearance and stiffness.
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

/// Stiffness of the lumps relative to the organ.
inline constexpr double kLumpRatio = 3.0;

/// Two lumps: 20 mm in diameter below the front of the right lobe, 12 mm below the front of the left lobe.
[[nodiscard]] std::array<Lump, 2> lumps();

/// Makes organ, lumps, portal vein and hepatic veins in LPS and mm. Deterministic.
[[nodiscard]] std::vector<PhantomStructure> makePhantom();

} // namespace palpate::phantom
