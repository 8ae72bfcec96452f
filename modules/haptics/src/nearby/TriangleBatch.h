// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/DistanceLanes.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// Buffer of up to eight triangles found by a traversal, to be filtered together.
class TriangleBatch
{
  public:
    [[nodiscard]] bool isEmpty() const noexcept { return m_count == 0; }
    [[nodiscard]] bool isFull() const noexcept { return m_count == kLanes; }
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[static_cast<std::size_t>(i)]; }
    /// Returns the index in the structure's SurfaceIndex.
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[static_cast<std::size_t>(i)]; }
    void clear() noexcept { m_count = 0; }

    /// @pre not full
    void add(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        const auto i = static_cast<std::size_t>(m_count++);
        const geometry::Triangle t = surface.triangle(triangle);
        for (std::size_t c = 0; c < 3; ++c) {
            m_at[c][i] = surface.vertex(t[c]).data();
            core::prefetch(m_at[c][i]); // overlap the memory latency of all eight
        }
        m_isTwoSided[i] = surface.isTwoSided(triangle) ? -1 : 0;
        m_structure[i] = structure;
        m_triangle[i] = triangle;
    }

    /// Computes a group from the triangles, padded to eight with the last one.
    /// @pre not empty
    /// @param origin  origin of the single-precision coordinates; four numbers are read [mm]
    /// @param group  result
    /// @return the largest coordinate [mm]
    float derive(const double* origin, TriangleGroup& group) noexcept PALPATE_NONBLOCKING;

  private:
    int m_count = 0;
    const double* m_at[3][kLanes];     ///< addresses of the corners
    std::int32_t m_isTwoSided[kLanes]; ///< all ones or zero
    std::array<std::uint32_t, kLanes> m_structure;
    std::array<std::uint32_t, kLanes> m_triangle;
};

} // namespace palpate::haptics::internal
