// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace palpate::woodenhaptics {

/// What a unit is like, as its owner's woodenhaptics.json says it; defaults are the kit's. Names, meanings and units
/// are the file's (metres, amperes); an index 0, 1, 2 is a, b, c.
/// @par Source The makers' default configuration.
struct Config
{
    int variant = 0; ///< 0: WoodenHaptics; 1: the rebuilt PHANToM
    std::array<double, 3> capstanDiameter_m{0.010, 0.010, 0.010};
    std::array<double, 3> bodyDiameter_m{0.160, 0.120, 0.120};
    std::array<double, 3> linkLength_m{0.080, 0.205, 0.245};
    std::array<double, 3> origin_m{0.220, 0.0, 0.080}; ///< of the workspace, from the foot
    double workspaceRadius_m = 0.100;
    std::array<double, 3> torqueConstant_Nm_per_A{0.0259, 0.0259, 0.0259};
    double fullScale_A = 3.0;
    std::array<double, 3> countsPerTurn{2000.0, 2000.0, 2000.0}; ///< of the motor, after quadrature
    double maxForce_N = 5.0;
    double maxStiffness_N_per_m = 1000.0;
    double maxDamping_Ns_per_m = 8.0;
    double massB_kg = 0.170;
    double massC_kg = 0.110;
    double centreB_m = 0.051; ///< of mass, from the link's joint
    double centreC_m = 0.091;
    double gravity_m_per_s2 = 0.0;             ///< 0: the arm is balanced, nothing to make up for
    std::array<double, 6> calibrationCounts{}; ///< of the counters in the calibration pose
};

/// Reads a configuration; fields that it does not have are the kit's. A comma too many before the closing brace is
/// taken, as in files that the makers ship.
/// @param name  of the file, for messages
[[nodiscard]] core::Result<Config> parseConfig(std::string_view text, const std::string& name);
[[nodiscard]] core::Result<Config> readConfig(const std::filesystem::path& file);

} // namespace palpate::woodenhaptics
