// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/MotionComparison.h"

#include "palpate/evaluation/Shapes.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/Repair.h>
#include <palpate/haptics/Palpator.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

namespace palpate::evaluation {

namespace {

using core::Vec3;
using geometry::SurfaceMotion;
using haptics::HapticScene;
using haptics::Palpator;
using Motion = std::shared_ptr<const SurfaceMotion>;

constexpr double kPeriod_s = 1e-3;

struct MovingCase
{
    std::string name;
    geometry::TriangleMesh rest;
    Motion motion;
    bool isClosed = true;
    std::size_t ticks = 1000;
    Vec3 (*hand)(double t_s) = nullptr; ///< starts in front of the surface
};

haptics::HapticStructure structureOf(const geometry::TriangleMesh& mesh)
{
    haptics::HapticStructure structure;
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(mesh, geometry::Facing::AsGiven)));
    structure.tissue.stiffness_N_per_mm = 0.5;
    return structure;
}

/// Follows a case and counts where the god-object is.
/// @param step  does a tick and returns the god-object's rest position as well: a surface is touched more closely than
/// a position can be taken back from the world
template<class Step>
MotionRow followed(const MovingCase& one, const char* way, Step step)
{
    const auto index = structureOf(one.rest).surface;
    MotionRow row{one.name, way, one.ticks, 0, 0, 0.0};
    bool wasBehind = false;
    std::size_t behind = 0;
    for (std::size_t i = 0; i < one.ticks; ++i) {
        const double t_s = static_cast<double>(i) * kPeriod_s;
        const auto [tick, rest] = step(one.hand(t_s), t_s);
        const bool isBehind = one.isClosed ? isInside(*index, rest) : rest.z() < 0.0;
        row.touched += tick.contactCount > 0 ? 1 : 0;
        row.passes += isBehind && !wasBehind ? 1 : 0;
        behind += isBehind ? 1 : 0;
        wasBehind = isBehind;
    }
    row.share = static_cast<double>(behind) / static_cast<double>(one.ticks);
    return row;
}

MotionRow nodesMoved(const MovingCase& one)
{
    Palpator palpator;
    return followed(one, "nodes moved between ticks", [&](const Vec3& hand, double t_s) {
        geometry::TriangleMesh mesh = one.rest;
        mesh.vertices = one.motion->placesAt(t_s, one.rest.vertices);
        std::vector<haptics::HapticStructure> structures{structureOf(mesh)};
        palpator.setScene(std::make_shared<const HapticScene>(std::move(structures)), haptics::Continuity::Places);
        const haptics::TickResult tick = palpator.step(hand, kPeriod_s);
        return std::pair(tick, one.motion->toRest(one.motion->at(t_s), tick.p_WG, tick.p_WG).X);
    });
}

MotionRow pulledBack(const MovingCase& one)
{
    haptics::HapticStructure structure = structureOf(one.rest);
    structure.motion = one.motion;
    const HapticScene scene({structure});
    Palpator palpator;
    palpator.borrowScene(&scene);
    return followed(one, "hand pulled back to the rest shape", [&](const Vec3& hand, double t_s) {
        const haptics::TickResult tick = palpator.step(hand, kPeriod_s, nullptr, t_s);
        return std::pair(tick, Vec3(palpator.state().layers[0].p_WG));
    });
}

Motion glide(const Vec3& from, const Vec3& v, double duration_s)
{
    std::vector<geometry::PoseKey> keys(2);
    keys[1].time_s = duration_s;
    keys[0].X_WR.translation() = from;
    keys[1].X_WR.translation() = from + duration_s * v;
    return SurfaceMotion::poses(keys).value();
}

Motion oscillation(double frequency_Hz)
{
    constexpr int kKeys = 64;
    constexpr double kAmplitude_mm = 20.0;
    std::vector<geometry::PoseKey> keys(kKeys + 1);
    for (int i = 0; i < kKeys; ++i) {
        const double turn = static_cast<double>(i) / kKeys;
        keys[static_cast<std::size_t>(i)].time_s = turn / frequency_Hz;
        keys[static_cast<std::size_t>(i)].X_WR.translation().z() =
            kAmplitude_mm * std::sin(2.0 * std::numbers::pi * turn);
    }
    keys.back().time_s = 1.0 / frequency_Hz;
    return SurfaceMotion::poses(keys, true).value();
}

Motion randomFrames()
{
    const core::Box box(Vec3::Constant(-50.0), Vec3::Constant(50.0));
    const auto lattice = geometry::MotionLattice::around(box, 20.0);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> of(-1.0, 1.0);
    std::vector<std::vector<Vec3>> frames(8);
    double scale = 1e-3; // first to learn the strain, then to have 30 %
    for (auto& frame : frames) {
        for (std::size_t i = 0; i < lattice.controlCount(); ++i) {
            frame.push_back(scale * Vec3(of(random), of(random), of(random)));
        }
    }
    scale = 0.999 * SurfaceMotion::kMaxStrain / SurfaceMotion::frames(1.0, lattice, frames).value()->strain();
    for (auto& frame : frames) {
        for (Vec3& u : frame) {
            u *= scale;
        }
    }
    return SurfaceMotion::frames(1.0, lattice, frames).value();
}

std::vector<MovingCase> cases()
{
    const geometry::TriangleMesh sphere = shapes::bumpySphere(4, 30.0, 0.0);
    const auto still = [](double) { return Vec3(1.0, 2.0, 35.0); };
    return {
        {"plate of 0 mm at 2 m/s", shapes::sheet(50.0, 4), glide(Vec3(0, 0, -31), Vec3(0, 0, 2000), 0.05), false, 50,
         [](double) { return Vec3(0.3, 0.2, 0.0); }},
        {"sphere by ±20 mm at 0.25 Hz", sphere, oscillation(0.25), true, 4000, still},
        {"sphere by ±20 mm at 50 Hz", sphere, oscillation(50.0), true, 1000, still},
        {"sphere in random frames of 30 % strain", sphere, randomFrames(), true, 3000,
         [](double t) {
             return Vec3(8.0 * std::sin(2.0 * t), 8.0 * std::cos(3.0 * t), 31.0 + 4.0 * std::cos(9.0 * t));
         }},
    };
}

} // namespace

std::vector<MotionRow> compareMotions()
{
    std::vector<MotionRow> rows;
    for (const MovingCase& one : cases()) {
        rows.push_back(nodesMoved(one));
        rows.push_back(pulledBack(one));
    }
    return rows;
}

} // namespace palpate::evaluation
