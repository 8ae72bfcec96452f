// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"

#include <palpate/haptics/Palpator.h>

#include <memory>

namespace palpate::evaluation {

/// One layer of the product behind the interface of the references.
class ProductSolver : public ReferenceSolver
{
  public:
    /// @param layer  of the scene: each has a god-object of its own
    /// @param iterations  bound on the moves of a tick; 1 is one pass a tick, as in the paper; 0 is the product's own
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

/// A scene of one structure, made as the program makes it.
/// @param fingertip_mm  radius of the ball that touches; 0 is a point
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> sceneOf(const geometry::RepairedMesh& mesh,
                                                                  double fingertip_mm = 0.0);

} // namespace palpate::evaluation
