// SPDX-License-Identifier: BSD-3-Clause
#include "formats/GridSurface.h"

#include "text/Fault.h"

#include <vtkCellType.h>

#include <array>

namespace palpate::meshio::internal {

void GridSurface::List::add(std::span<const std::int32_t> corners)
{
    ++cells;
    numbers.push_back(static_cast<std::int32_t>(corners.size()));
    numbers.insert(numbers.end(), corners.begin(), corners.end());
}

void GridSurface::List::write(std::string_view keyword, std::string& plain) const
{
    if (cells == 0) {
        return;
    }
    plain.append("\n").append(keyword).append(" ").append(std::to_string(cells)).append(" ");
    plain.append(std::to_string(numbers.size())).append("\n");
    for (const std::int32_t number : numbers) {
        const auto bits = static_cast<std::uint32_t>(number);
        for (const unsigned shift : {24U, 16U, 8U, 0U}) {
            plain += static_cast<char>(bits >> shift & 0xffU);
        }
    }
}

core::Message GridSurface::add(std::int64_t type, std::span<const std::int32_t> corners)
{
    switch (type) {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
        ++m_thin;
        return {};
    case VTK_TRIANGLE_STRIP:
        m_strips.add(corners);
        return {};
    case VTK_PIXEL:
        if (corners.size() == 4) { // in the order of an image
            m_polygons.add(std::array{corners[0], corners[1], corners[3], corners[2]});
            return {};
        }
        break;
    case VTK_TRIANGLE:
    case VTK_QUAD:
        if (corners.size() == (type == VTK_TRIANGLE ? 3U : 4U)) {
            m_polygons.add(corners);
            return {};
        }
        break;
    case VTK_POLYGON:
        m_polygons.add(corners);
        return {};
    default:
        return {PALPATE_TEXT("a cell of VTK's type %1: not a surface, but a volume mesh or curved cells"), type};
    }
    return {PALPATE_TEXT("number of corners of a cell of VTK's type %1: %2"), type, corners.size()};
}

core::Message GridSurface::expected()
{
    return {PALPATE_TEXT("triangles and quadrilaterals: extract the surface first (ParaView: Extract Surface)")};
}

void GridSurface::write(std::string& plain, PreScan& scan) const
{
    m_polygons.write("POLYGONS", plain);
    m_strips.write("TRIANGLE_STRIPS", plain);
    scan.cells = m_polygons.cells + m_strips.cells;
    if (m_thin > 0) {
        scan.note({PALPATE_TEXT("vertices and lines left out: %1"), Count(m_thin)});
    }
}

} // namespace palpate::meshio::internal
