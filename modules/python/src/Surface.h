// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <memory>
#include <mutex>
#include <utility>

namespace palpate::python {

/// Repaired surface with the spatial index, which is built when first touched and shared by all scenes.
class Surface
{
  public:
    explicit Surface(std::shared_ptr<const geometry::RepairedMesh> mesh)
        : m_mesh(std::move(mesh))
    {
    }
    [[nodiscard]] const std::shared_ptr<const geometry::RepairedMesh>& mesh() const noexcept { return m_mesh; }
    /// @pre the GIL is not held: another thread may be building the index
    [[nodiscard]] std::shared_ptr<const geometry::SurfaceIndex> index();

  private:
    std::shared_ptr<const geometry::RepairedMesh> m_mesh;
    std::mutex m_mutex; ///< of m_index
    std::shared_ptr<const geometry::SurfaceIndex> m_index;
};

} // namespace palpate::python
