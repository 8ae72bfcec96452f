// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"
#include "guard/TriangleSoup.h"

#include <palpate/geometry/PolygonCutter.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// Collects points and polygons of a format that meshio reads itself, and checks every index.
class PolygonSoup
{
  public:
    explicit PolygonSoup(const ScanContext& context)
        : m_context(context)
    {
    }
    /// Points in the order of the file. Complete before the first polygon.
    [[nodiscard]] std::vector<core::Vec3>& points() noexcept { return m_soup.mesh.vertices; }
    /// Adds a polygon; fewer than three corners are counted and left out.
    /// @return an error for too many corners, or an index out of range
    [[nodiscard]] core::Status add(std::span<const std::int64_t> corners);
    /// Reports progress now and then. @return Cancelled if the user cancels
    [[nodiscard]] core::Status progress(std::uint64_t done, std::uint64_t all);
    /// @param name   of the structure; empty: the name of the file
    /// @param scan   receives notes
    /// @return an error without any polygon
    [[nodiscard]] core::Result<TriangleSoup> finish(PreScan& scan, const std::string& name = {});

  private:
    const ScanContext& m_context;
    TriangleSoup m_soup;
    geometry::PolygonCutter m_cutter;
    std::vector<std::uint32_t> m_corners;
    std::uint64_t m_polygons = 0, m_thin = 0, m_calls = 0;
};

} // namespace palpate::meshio::internal
