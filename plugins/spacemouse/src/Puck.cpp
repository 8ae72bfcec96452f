// SPDX-License-Identifier: BSD-3-Clause
#include "Puck.h"

#include <algorithm>

namespace palpate::spacemouse {

namespace {

constexpr double kFullWay = 350.0;
constexpr std::size_t kThree = 7; // bytes of a 3-axis report
constexpr std::size_t kSix = 13;

core::Vec3 axesAt(std::span<const std::uint8_t> report, std::size_t first) noexcept
{
    core::Vec3 axes;
    for (int i = 0; i < 3; ++i) {
        const std::size_t at = first + 2 * static_cast<std::size_t>(i);
        const auto value = static_cast<std::int16_t>(report[at] | report[at + 1] << 8);
        axes[i] = std::clamp(value / kFullWay, -1.0, 1.0);
    }
    return {axes[0], -axes[1], -axes[2]};
}

} // namespace

bool Puck::take(std::span<const std::uint8_t> report) noexcept
{
    if (report.size() < 2) {
        return false;
    }
    switch (report[0]) {
    case 1:
        if (report.size() != kThree && report.size() != kSix) {
            return false;
        }
        m_held.shift = axesAt(report, 1);
        if (report.size() == kSix) {
            m_held.turn = axesAt(report, 7);
        }
        return true;
    case 2:
        if (report.size() != kThree) {
            return false;
        }
        m_held.turn = axesAt(report, 1);
        return true;
    case 3: {
        std::uint32_t buttons = 0;
        for (std::size_t i = 1; i < std::min<std::size_t>(report.size(), 5); ++i) {
            buttons |= static_cast<std::uint32_t>(report[i]) << (8 * (i - 1));
        }
        m_held.buttons = buttons;
        return true;
    }
    default:
        return false;
    }
}

} // namespace palpate::spacemouse
