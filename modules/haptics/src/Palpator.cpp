// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/Palpator.h"

#include <algorithm>

namespace palpate::haptics {

Palpator::Palpator() = default;

void Palpator::setScene(const HapticScene* scene) noexcept
{
    m_scene = scene;
    const std::size_t used = scene == nullptr ? 0 : scene->layerCount();
    for (std::size_t i = 0; i < m_layers.size(); ++i) {
        m_layers[i].forgetContacts();
        if (i >= used) {
            m_layers[i].restore({});
        }
    }
}

void Palpator::reset() noexcept
{
    for (GodObject& layer : m_layers) {
        layer.restore({});
    }
    m_started = false;
}

TickResult Palpator::step(const Vec3& p_WH, double dt_s) noexcept
{
    TickResult result;
    if (!p_WH.allFinite()) {
        result.p_WG = m_layers[0].state().p_WG;
        result.status = TickStatus::InvalidInput;
        return result;
    }
    const Vec3 v_WH = m_started && dt_s > 0.0 ? Vec3((p_WH - m_p_WH) / dt_s) : Vec3::Zero();
    m_p_WH = p_WH;
    m_started = true;
    result.p_WG = p_WH;
    const std::size_t layers = m_scene == nullptr ? 0 : m_scene->layerCount();
    for (std::size_t i = 0; i < layers; ++i) {
        const GodObjectStep step = m_layers[i].step(p_WH, *m_scene, i);
        result.iterations += step.iterations;
        result.status = std::max(result.status, step.status);
        if (i == 0) {
            result.p_WG = step.p_WG;
        }
        if (step.constraints == 0) {
            // Free, or stopped at the iteration bound on the way: no surface, no force.
            continue;
        }
        // With several structures in one contact the stiffest gives the force: the hand cannot pass it.
        std::size_t touched = 0;
        const auto stiffness = [&](std::size_t k) {
            return m_scene->structures()[step.active[k].structure].tissue.stiffness_N_per_mm;
        };
        for (std::size_t k = 1; k < step.constraints; ++k) {
            if (stiffness(k) > stiffness(touched)) {
                touched = k;
            }
        }
        const HapticStructure& structure = m_scene->structures()[step.active[touched].structure];
        const Vec3 f_W = springDamperForce(structure.tissue, step.p_WG, p_WH, v_WH);
        result.f_W += f_W;
        if (result.structure < 0) {
            result.p_WG = step.p_WG;
            result.active = step.active;
            result.constraints = step.constraints;
            result.structure = static_cast<std::int32_t>(step.active[touched].structure);
            result.triangle = structure.surface->sourceTriangle(step.active[touched].triangle);
            const Vec3 push = step.p_WG - p_WH;
            const double depth = push.norm();
            result.n_W = depth > 0.0 ? Vec3(push / depth) : step.active[touched].n_W;
        }
    }
    return result;
}

PalpatorState Palpator::state() const noexcept
{
    PalpatorState state;
    for (std::size_t i = 0; i < m_layers.size(); ++i) {
        state.layers[i] = m_layers[i].state();
    }
    state.p_WH = m_p_WH;
    state.started = m_started ? 1 : 0;
    return state;
}

void Palpator::restore(const PalpatorState& state) noexcept
{
    for (std::size_t i = 0; i < m_layers.size(); ++i) {
        m_layers[i].restore(state.layers[i]);
    }
    m_p_WH = state.p_WH;
    m_started = state.started != 0;
}

} // namespace palpate::haptics
