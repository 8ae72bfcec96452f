// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/PressedPairs.h"

#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/ForceTable.h>

#include <utility>
#include <vector>

namespace palpate::study {

PressedPairs::PressedPairs(std::uint32_t seed, std::size_t trials)
    : m_series(ThresholdSeries::create({trials, 2, 80.0}).value())
    , m_random(seed)
{
    next();
}

double PressedPairs::ratio() const noexcept
{
    const bool isStiffer = m_isSecondStiffer ? m_stage == Stage::Second : m_stage == Stage::First;
    return isStiffer ? 1.0 + 0.01 * m_series.percent() : 1.0;
}

bool PressedPairs::takeForce(double force_N)
{
    if (m_stage != Stage::First && m_stage != Stage::Second) {
        return false;
    }
    if (force_N > 0.0) {
        m_isPressed = m_isPressed || force_N >= kPress_N;
        return false;
    }
    if (!std::exchange(m_isPressed, false)) {
        return false;
    }
    m_stage = m_stage == Stage::First ? Stage::Second : Stage::Answer;
    return true;
}

void PressedPairs::answer(bool wasSecondStiffer)
{
    if (m_stage != Stage::Answer) {
        return;
    }
    m_series.answer(wasSecondStiffer == m_isSecondStiffer);
    m_stage = m_series.isDone() ? Stage::Done : Stage::First;
    next();
}

/// Decides the press with the stiffer wall; distributions of the standard library differ between systems.
void PressedPairs::next()
{
    m_isSecondStiffer = (m_random() >> 31U) != 0U;
    m_isPressed = false;
}

std::shared_ptr<const haptics::HapticScene> wallScene(const core::Vec3& p_W, const core::Vec3& n_W, double size_mm,
                                                      double stiffness_N_per_mm)
{
    const core::Vec3 u_W = size_mm * n_W.unitOrthogonal(), v_W = n_W.cross(u_W);
    geometry::TriangleMesh mesh;
    mesh.vertices = {p_W - u_W - v_W, p_W + u_W - v_W, p_W + u_W + v_W, p_W - u_W + v_W};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    haptics::HapticStructure wall;
    wall.name = "wall";
    wall.surface = std::make_shared<const geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(std::move(mesh))));
    wall.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    wall.law = haptics::ForceTable::build(wall.tissue);
    std::vector<haptics::HapticStructure> structures;
    structures.push_back(std::move(wall));
    return std::make_shared<const haptics::HapticScene>(std::move(structures));
}

} // namespace palpate::study
