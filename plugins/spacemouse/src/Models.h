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

/// 3Dconnexion's 6-axis devices. Regular mice and keypads of the same vendor are not included.
/// @par Source Tables of spacenavd (src/dev.c) and PySpaceMouse (pyspacemouse/devices.toml).
[[nodiscard]] std::span<const Model> models() noexcept;
/// Finds a model by USB ids. @return null when unknown
[[nodiscard]] const Model* findModel(std::uint16_t vendor, std::uint16_t product) noexcept;

} // namespace palpate::spacemouse
