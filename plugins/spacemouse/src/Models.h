// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace palpate::spacemouse {

struct Model
{
    std::uint16_t vendor;
    std::uint16_t product;
    const char* name;
};

/// 3Dconnexion's 6-axis devices, and no other: the same vendor's flat mice and keypads are not among them.
/// @par Source Tables of spacenavd (src/dev.c) and PySpaceMouse (pyspacemouse/devices.toml).
[[nodiscard]] std::span<const Model> models() noexcept;
/// @return the model, or null
[[nodiscard]] const Model* findModel(std::uint16_t vendor, std::uint16_t product) noexcept;

} // namespace palpate::spacemouse
