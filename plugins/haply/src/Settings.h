// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::haply {

/// Content of haply.json; for limits, 0 means that the file has no such limit.
struct Settings
{
    std::uint16_t port = 10001;     ///< of the simulation channel, on this machine
    std::uint16_t httpPort = 10000; ///< asked for the version if `port` does not answer with one
    std::string deviceId;           ///< device to open, "049D"; empty: the only one
    std::string gripId;             ///< VerseGrip in the hand; empty: the only one
    bool hasFile = false;           ///< the user has written settings, and expects a device
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
};

/// Reads haply.json from the first folder that contains one: an object with any of port, http_port, device_id, grip_id,
/// max_force_N, max_stiffness_N_per_mm, max_damping_Ns_per_mm, workspace_radius_mm.
[[nodiscard]] core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::haply
