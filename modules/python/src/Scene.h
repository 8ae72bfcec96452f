// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/Replay.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace palpate::python {

/// Structure of a scene: description and surface.
struct Structure
{
    meshio::LoadedStructure loaded;
    std::shared_ptr<Surface> surface; ///< with the mesh of `loaded.surface`
};

/// Immutable scene. The haptic copy is made when first touched.
class Scene
{
  public:
    /// @param surfaces  one for each structure; empty: new ones
    Scene(meshio::LoadedScene loaded, double fingertip_mm, std::vector<std::shared_ptr<Surface>> surfaces = {});
    /// Copy with another fingertip or another tissue of all structures.
    Scene(const Scene& from, double fingertip_mm, const session::TissueOverride& tissue);

    [[nodiscard]] const meshio::LoadedScene& loaded() const noexcept { return *m_loaded; }
    [[nodiscard]] double fingertip_mm() const noexcept { return m_fingertip_mm; }
    [[nodiscard]] const session::TissueOverride& tissue() const noexcept { return m_tissue; }
    [[nodiscard]] Structure structure(std::size_t number) const;
    /// Returns the scene for the palpator.
    /// @throws py::value_error if nothing is palpable
    /// @pre the GIL is not held: another thread may be building the same copy
    [[nodiscard]] std::shared_ptr<const haptics::HapticScene> haptic() const;

  private:
    std::shared_ptr<const meshio::LoadedScene> m_loaded;
    std::vector<std::shared_ptr<Surface>> m_surfaces;
    double m_fingertip_mm;
    session::TissueOverride m_tissue;
    mutable std::mutex m_mutex; ///< of m_haptic
    mutable std::shared_ptr<const haptics::HapticScene> m_haptic;
};

} // namespace palpate::python
