// SPDX-License-Identifier: BSD-3-Clause
#include "lumps/JudgedProduct.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace palpate::evaluation {

namespace {

constexpr double kTick_s = 1e-3;
constexpr std::int64_t kRestoreEvery = 61; // ticks; not the period of any path

using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::TickResult;

HapticStructure structureOf(const geometry::RepairedMesh& mesh, std::uint32_t layer, double friction)
{
    HapticStructure structure;
    structure.name = layer == 0 ? "around" : "surface";
    structure.surface = std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
    structure.layer = layer;
    structure.tissue.friction_static = structure.tissue.friction_dynamic = friction;
    return structure;
}

bool isSame(const Vec3& a, const Vec3& b)
{
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

} // namespace

JudgedProduct::JudgedProduct(const HardCase& hardCase, const geometry::RepairedMesh& mesh,
                             const geometry::RepairedMesh* beside)
    : m_otherEvery(hardCase.other ? hardCase.otherEvery : 0)
{
    const core::Box bounds = mesh.mesh.bounds();
    m_magnitude_mm = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    const HapticStructure surface = structureOf(mesh, 1, hardCase.friction);
    std::vector structures{surface};
    if (beside != nullptr) {
        structures.push_back(structureOf(*beside, 1, hardCase.friction));
        structures.back().name = "beside";
        structures.back().tissue.stiffness_N_per_mm = hardCase.neighbourStiffness_N_per_mm;
    }
    m_scene = std::make_unique<HapticScene>(std::move(structures), hardCase.fingertip_mm);
    m_alone.borrowScene(m_scene.get());
    m_restored.borrowScene(m_scene.get());
    if (m_otherEvery > 0) {
        const HapticStructure other =
            structureOf(geometry::repair(hardCase.other(), geometry::Facing::AsGiven), 0, 0.0);
        m_otherScene = std::make_unique<HapticScene>(std::vector{other}, hardCase.fingertip_mm);
        m_bothScene = std::make_unique<HapticScene>(std::vector{other, surface}, hardCase.fingertip_mm);
        HapticStructure hidden = other; // keeps its index, like in the program
        hidden.surface = nullptr;
        m_hiddenScene = std::make_unique<HapticScene>(std::vector{hidden, surface}, hardCase.fingertip_mm);
        m_both.borrowScene(m_hiddenScene.get());
    }
}

void JudgedProduct::start(const Vec3& hip)
{
    m_alone.reset();
    (void)m_alone.step(hip, kTick_s);
    m_both.reset();
    (void)m_both.step(hip, kTick_s);
    (void)m_other.step(hip, kTick_s);
}

/// Shows or hides the surrounding layer. All palpators get their scenes again, so that all drop the same contacts.
void JudgedProduct::switchOther()
{
    const bool isShown = m_tick / m_otherEvery % 2 != 0;
    m_alone.borrowScene(m_scene.get());
    m_other.borrowScene(isShown ? m_otherScene.get() : nullptr);
    m_both.borrowScene(isShown ? m_bothScene.get() : m_hiddenScene.get());
}

CheckedTick JudgedProduct::step(const Vec3& hip)
{
    CheckedTick result;
    const bool isSwitched = m_otherEvery > 0 && m_tick > 0 && m_tick % m_otherEvery == 0;
    if (isSwitched) {
        switchOther();
    }
    if (isSwitched || m_tick % kRestoreEvery == 0) {
        m_restored.restore(m_alone.state());
    }
    result.tick = m_alone.step(hip, kTick_s);
    const TickResult restored = m_restored.step(hip, kTick_s);
    result.differsAfterRestore = !isSame(result.tick.p_WG, restored.p_WG) || !isSame(result.tick.f_W, restored.f_W) ||
                                 result.tick.iterations != restored.iterations || result.tick.status != restored.status;
    if (m_otherEvery > 0) {
        result.layersError_N =
            (m_both.step(hip, kTick_s).f_W - result.tick.f_W - m_other.step(hip, kTick_s).f_W).norm();
    }
    if (hip.allFinite()) {
        judgeForce(result, hip);
        judgeFriction(result, hip);
    }
    ++m_tick;
    return result;
}

void JudgedProduct::judgeForce(CheckedTick& result, const Vec3& hip) const
{
    const double stiffness = m_scene->structures()[0].tissue.stiffness_N_per_mm;
    const Vec3 spring = result.tick.p_WG - hip, wanted = stiffness * spring;
    // Free means at the HIP, up to the rounding of the coordinates.
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (m_magnitude_mm + hip.cwiseAbs().maxCoeff());
    result.lacksForce = result.tick.f_W.isZero(0.0) && spring.norm() > rounding;
    if (m_scene->structures().size() > 1) {
        checkSharedForce(result, spring);
    } else if (!result.tick.f_W.isZero(0.0)) {
        result.forceError = (result.tick.f_W - wanted).norm() / wanted.norm();
    }
}

/// Checks that the force is between those of the softest and the stiffest constraining structure, or equal to that of
/// the only one.
void JudgedProduct::checkSharedForce(CheckedTick& result, const Vec3& spring) const
{
    constexpr double kRounding = 1e-9; // share of the spring lost to the skin when resolved into planes
    const TickResult& tick = result.tick;
    if (tick.f_W.isZero(0.0) || tick.constraints == 0) {
        return;
    }
    double softest = std::numeric_limits<double>::infinity(), stiffest = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(tick.constraints); ++i) {
        const double k = m_scene->structures()[tick.active[i].structure].tissue.stiffness_N_per_mm;
        softest = std::min(softest, k);
        stiffest = std::max(stiffest, k);
    }
    const double length = spring.norm(), along = tick.f_W.dot(spring) / (length * length);
    const double more = tick.f_W.norm() / (stiffest * length) - 1.0, less = 1.0 - along / softest;
    result.forceError = std::max(0.0, std::max(more, less) - kRounding);
}

void JudgedProduct::judgeFriction(CheckedTick& result, const Vec3& hip) const
{
    const double mu = m_scene->structures()[0].tissue.friction_static;
    if (mu > 0.0 && result.tick.constraints == 1 && result.tick.status == haptics::TickStatus::Converged) {
        const Vec3 spring = result.tick.p_WG - hip, n = result.tick.active[0].n_W;
        const double lambda = n.dot(spring);
        result.outsideCone_mm = (spring - lambda * n).norm() - (1.0 + 1e-6) * mu * std::max(0.0, lambda);
    }
}

} // namespace palpate::evaluation
