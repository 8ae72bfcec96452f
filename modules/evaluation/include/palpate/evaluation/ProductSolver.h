// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"

#include <palpate/haptics/Palpator.h>

#include <memory>

namespace palpate::evaluation {

/// Adapts one layer of the product to the ReferenceSolver interface.
class ProductSolver : public ReferenceSolver
{
  public:
    /// @param layer  index of the layer in the scene; each layer has a separate god-object
    /// @param iterations  maximum number of moves per tick; 1: one pass per tick, as in the paper; 0: default of the
    /// product
    ProductSolver(std::shared_ptr<const haptics::HapticScene> scene, std::string name, std::uint32_t iterations = 0,
                  std::size_t layer = 0);

    [[nodiscard]] std::string name() const override { return m_name; }
    void start(const Vec3& p_WH) override;
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

  private:
    std::shared_ptr<const haptics::HapticScene> m_scene;
    std::string m_name;
    haptics::Palpator m_palpator;
};

/// Returns a scene with one structure, built like in the program.
/// @param fingertip_mm  fingertip radius; 0: point contact
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> sceneOf(const geometry::RepairedMesh& mesh,
                                                                  double fingertip_mm = 0.0);

} // namespace palpate::evaluation
