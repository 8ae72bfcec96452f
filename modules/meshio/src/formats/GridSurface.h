// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// Takes the triangles, quadrilaterals, polygons and strips of an unstructured grid. Several programs store surfaces as
/// such grids; a grid of volume cells is refused.
class GridSurface
{
  public:
    /// @param type     VTK's number of the cell type (vtkCellType.h)
    /// @param corners  indices of points, checked
    /// @return why the cell is not part of a surface; empty if it is, or is left out
    [[nodiscard]] core::Message add(std::int64_t type, std::span<const std::int32_t> corners);
    /// @return what was expected instead, for the error
    [[nodiscard]] static core::Message expected();
    /// Appends the cells as sections of a binary legacy VTK file, and stores the number of cells and notes in `scan`.
    void write(std::string& plain, PreScan& scan) const;

  private:
    /// Cells as in a legacy VTK file: the number of corners, then the corners.
    struct List
    {
        std::uint64_t cells = 0;
        std::vector<std::int32_t> numbers;

        void add(std::span<const std::int32_t> corners);
        void write(std::string_view keyword, std::string& plain) const;
    };
    List m_polygons, m_strips;
    std::uint64_t m_thin = 0; ///< vertices and lines
};

} // namespace palpate::meshio::internal
