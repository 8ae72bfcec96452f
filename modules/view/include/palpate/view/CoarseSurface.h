// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <future>
#include <utility>
#include <vector>

namespace palpate::view {

/// Makes a picture with about a fifth of the triangles, for frames while the view turns: the points in each cell of
/// a grid become one point with the mean position and normal. Its colours and arrays are left out.
/// @param surface  from `makeSurface`
/// @par Cost 0.1 s per million triangles. Any thread, while nobody changes the arrays of the surface.
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData& surface);

/// Makes coarse pictures of many surfaces on another thread.
class PALPATE_EXPORT CoarseSurfaces
{
  public:
    /// Number of triangles from which on a coarse picture pays.
    static constexpr vtkIdType kLeastTriangles = 1000;
    /// A surface and its coarse picture.
    using Pair = std::pair<vtkSmartPointer<vtkPolyData>, vtkSmartPointer<vtkPolyData>>;

    /// Starts with these surfaces, unless it is busy. Surfaces with fewer than `kLeastTriangles` are left out.
    void start(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces);
    [[nodiscard]] bool isBusy() const { return m_made.valid(); }
    /// Returns the result once, as soon as it is there; else nothing.
    [[nodiscard]] std::vector<Pair> take();

  private:
    std::future<std::vector<Pair>> m_made;
};

} // namespace palpate::view
