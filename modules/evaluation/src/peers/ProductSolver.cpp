// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/ProductSolver.h"

#include <algorithm>

namespace palpate::evaluation {

namespace {

/// Returns the scene with only the given layer.
std::shared_ptr<const haptics::HapticScene> layerOf(const haptics::HapticScene& scene, std::size_t layer)
{
    std::vector<haptics::HapticStructure> structures = scene.structures();
    for (std::uint32_t i = 0; i < structures.size(); ++i) {
        const auto isIn = [i](const haptics::HapticLayer& of) {
            return std::find(of.structures.begin(), of.structures.end(), i) != of.structures.end();
        };
        if (layer >= scene.layerCount() || !isIn(scene.layer(layer))) {
            structures[i].surface = nullptr; // keeps its index
        }
    }
    return std::make_shared<haptics::HapticScene>(std::move(structures), scene.fingertip_mm());
}

haptics::GodObjectLimits limitsOf(std::uint32_t iterations)
{
    haptics::GodObjectLimits limits;
    if (iterations > 0) {
        limits.iterations = iterations;
    }
    return limits;
}

} // namespace

ProductSolver::ProductSolver(std::shared_ptr<const haptics::HapticScene> scene, std::string name,
                             std::uint32_t iterations, std::size_t layer)
    : m_scene(scene->layerCount() > 1 || layer > 0 ? layerOf(*scene, layer) : std::move(scene))
    , m_name(std::move(name))
    , m_palpator(m_scene->fingertip_mm() > 0.0 ? haptics::Fingertips::Any : haptics::Fingertips::Points,
                 limitsOf(iterations))
{
    m_palpator.borrowScene(m_scene.get());
}

void ProductSolver::start(const Vec3& p_WH)
{
    m_palpator.reset();
    (void)step(p_WH);
}

SolverStep ProductSolver::step(const Vec3& p_WH)
{
    const haptics::TickResult tick = m_palpator.step(p_WH, 1e-3);
    SolverStep result;
    result.p_WG = tick.p_WG;
    result.constraints = tick.constraints;
    result.iterations = tick.iterations;
    result.isConverged = tick.status == haptics::TickStatus::Converged;
    if (tick.constraints > 0) { // no contact, no force
        result.spring_mm = tick.p_WG - p_WH;
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
