// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/Palpator.h"

#include <algorithm>
#include <utility>

namespace palpate::haptics {

namespace {

/// A damper that no number can hold, after a time too short to divide by, is left out; and so is a spring.
Vec3 finiteForce(const Tissue& tissue, const Vec3& p_WG, const Vec3& p_WH, const Vec3& v_WH) noexcept
{
    Vec3 f_W = springDamperForce(tissue, p_WG, p_WH, v_WH);
    if (!f_W.allFinite()) {
        f_W = tissue.stiffness_N_per_mm * (p_WG - p_WH);
    }
    return f_W.allFinite() ? f_W : Vec3::Zero();
}

} // namespace

Palpator::Palpator() = default;

void Palpator::setScene(const HapticScene* scene) noexcept
{
    m_scene = scene;
    const PalpatorState before = state();
    const std::array<Numbers, HapticScene::kMaxLayers> numbers = std::exchange(m_numbers, {});
    for (std::size_t i = 0; i < m_layers.size(); ++i) {
        GodObjectState kept;
        if (scene != nullptr && i < scene->layerCount()) {
            const HapticLayer& layer = scene->layer(i);
            m_numbers[i] = {layer.number, layer.lastNumber};
            for (std::size_t j = 0; j < numbers.size(); ++j) {
                if (numbers[j].first <= layer.number && layer.number <= numbers[j].last) {
                    kept = before.layers[j];
                }
            }
        }
        m_layers[i].restore(kept);
        m_layers[i].forgetContacts();
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
    if (m_scene != nullptr ? !m_scene->reaches(p_WH) : !p_WH.allFinite()) {
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
        result.f_W += finiteForce(structure.tissue, step.p_WG, p_WH, v_WH);
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
