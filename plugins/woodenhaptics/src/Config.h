// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace palpate::woodenhaptics {

/// Parameters of a unit as in its owner's woodenhaptics.json; defaults are the kit's values. Names, meanings and
/// units are those of the file (metres, amperes); index 0, 1, 2 is a, b, c.
/// @par Source The makers' default configuration.
struct Config
{
    int variant = 0; ///< 0: WoodenHaptics; 1: the rebuilt PHANToM
    std::array<double, 3> capstanDiameter_m{0.010, 0.010, 0.010};
    std::array<double, 3> bodyDiameter_m{0.160, 0.120, 0.120};
    std::array<double, 3> linkLength_m{0.080, 0.205, 0.245};
    std::array<double, 3> origin_m{0.220, 0.0, 0.080}; ///< origin of the workspace, relative to the foot
    double workspaceRadius_m = 0.100;
    std::array<double, 3> torqueConstant_Nm_per_A{0.0259, 0.0259, 0.0259};
    double fullScale_A = 3.0;
    std::array<double, 3> countsPerTurn{2000.0, 2000.0, 2000.0}; ///< per motor turn, after quadrature
    double maxForce_N = 5.0;
    double maxStiffness_N_per_m = 1000.0;
    double maxDamping_Ns_per_m = 8.0;
    double massB_kg = 0.170;
    double massC_kg = 0.110;
    double centreB_m = 0.051; ///< centre of mass, distance from the link's joint
    double centreC_m = 0.091;
    double gravity_m_per_s2 = 0.0;             ///< 0: the arm is balanced and needs no compensation
    std::array<double, 6> calibrationCounts{}; ///< counter values in the calibration pose
};

/// Parses a configuration; missing fields get the kit's values. A trailing comma before the closing brace is
/// accepted, because files shipped by the makers have one.
/// @param name  file name for error messages
[[nodiscard]] core::Result<Config> parseConfig(std::string_view text, const std::string& name);
[[nodiscard]] core::Result<Config> readConfig(const std::filesystem::path& file);

} // namespace palpate::woodenhaptics
