// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <future>
#include <utility>
#include <vector>

namespace palpate::view {

/// Makes a picture with fewer triangles, for frames while the view turns: the points in each cell of a grid whose
/// normals are in the same octant become one point with the mean position and normal. Its colours and arrays are left
/// out.
/// @param surface  from `makeSurface`
/// @param divisor  about one of so many triangles stays; more than 1, typically 2 to 12
/// @par Cost 0.1 s per million triangles. Any thread, while nobody changes the arrays of the surface.
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData& surface, double divisor);

/// Makes coarse pictures of many surfaces on another thread.
class PALPATE_EXPORT CoarseSurfaces
{
  public:
    /// Number of triangles from which on a coarse picture pays.
    static constexpr vtkIdType kLeastTriangles = 1000;
    /// Number of triangles in all coarse pictures of a scene: what two processor cores draw ten times a second without
    /// a graphics card (bench_turning).
    static constexpr double kTriangles = 100'000.0;
    /// A surface and its coarse picture.
    using Pair = std::pair<vtkSmartPointer<vtkPolyData>, vtkSmartPointer<vtkPolyData>>;

    /// Starts with these surfaces, unless it is busy. Surfaces with fewer than `kLeastTriangles` are left out.
    /// @param divisor  as for `coarseSurface`
    void start(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces, double divisor);
    [[nodiscard]] bool isBusy() const { return m_made.valid(); }
    /// Returns the result once, as soon as it is there; else nothing.
    [[nodiscard]] std::vector<Pair> take();

  private:
    std::future<std::vector<Pair>> m_made;
};

} // namespace palpate::view
