// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/ProductSolver.h"

namespace palpate::evaluation {

ProductSolver::ProductSolver(std::shared_ptr<const haptics::HapticScene> scene, std::string name,
                             std::uint32_t iterations, std::size_t layer)
    : m_scene(std::move(scene))
    , m_name(std::move(name))
    , m_layer(layer)
{
    if (iterations > 0) {
        m_limits.iterations = iterations;
    }
}

void ProductSolver::start(const Vec3& p_WH)
{
    m_god.restore({});
    (void)step(p_WH);
}

SolverStep ProductSolver::step(const Vec3& p_WH)
{
    SolverStep result;
    if (m_layer >= m_scene->layerCount()) {
        result.p_WG = p_WH;
        return result;
    }
    const haptics::GodObjectStep step = m_god.step(p_WH, *m_scene, m_layer, m_limits);
    result.p_WG = step.p_WG;
    result.constraints = step.constraints;
    result.iterations = step.iterations;
    result.isConverged = step.status == haptics::TickStatus::Converged;
    if (step.constraints > 0) { // as in Palpator: no surface, no force
        result.spring_mm = step.p_WG - p_WH;
    }
    return result;
}

std::shared_ptr<const haptics::HapticScene> sceneOf(const geometry::RepairedMesh& mesh, double fingertip_mm)
{
    haptics::HapticStructure structure;
    structure.name = "surface";
    structure.surface = std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
    std::vector<haptics::HapticStructure> structures;
    structures.push_back(std::move(structure));
    return std::make_shared<haptics::HapticScene>(std::move(structures), fingertip_mm);
}

} // namespace palpate::evaluation
