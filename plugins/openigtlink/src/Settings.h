// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/igtl/Wire.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::openigtlink {

/// Content of openigtlink.json.
struct Settings
{
    bool isFromFile = false;
    std::string host = "localhost"; ///< or a numeric address
    std::uint16_t port = igtl::kDefaultPort;
    std::string tool;  ///< device name of the pose; empty: the first one that arrives
    bool isRas = true; ///< frame of the sender; false: LPS
    std::string force; ///< device name of the transform that carries the force back; empty: none
    double maxForce_N = 2.0;
    /// A force that lags by 100 ms, as at 20 Hz, needs a soft tissue: a hand with 0.01 N·s/mm of damping holds
    /// 0.7 · 0.01 / 0.1 = 0.07 N/mm steadily (servo::stableStiffness_N_per_mm).
    double maxStiffness_N_per_mm = 0.05;
    double workspaceRadius_mm = 0.0;   ///< 0: the positions are those of the scene
    double staleAfter_s = 0.2;         ///< without a newer pose, there is no hand
    std::uint32_t requestEvery_ms = 0; ///< interval in a request for tracking data; 0: the server sends by itself
};

/// Reads openigtlink.json from the first folder that contains one; see resources/docs/openigtlink.md.
[[nodiscard]] core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::openigtlink
