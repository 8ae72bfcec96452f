// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Stability.h"

#include "StabilityTrial.h"

#include <palpate/geometry/SurfaceIndex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <numbers>
#include <sstream>

namespace palpate::evaluation::stability {

namespace {

using geometry::SurfaceIndex;

/// A triangle of a map: its corners and the gradient of what the map says there.
struct MappedFacet
{
    std::array<Vec3, 3> corners;
    std::array<double, 3> values;
    Vec3 gradient, normal; ///< [1/mm], unit

    MappedFacet(const SurfaceIndex& surface, const haptics::TissueMap& map, std::uint32_t i)
    {
        const geometry::Triangle t = surface.triangle(i);
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = surface.vertex(t[c]);
            values[c] = map.factor * double{(*map.corners)[i][c]};
        }
        const Vec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], across = e1.cross(e2);
        gradient = ((values[1] - values[0]) * e2.cross(across) + (values[2] - values[0]) * across.cross(e1)) /
                   across.squaredNorm();
        normal = across.normalized();
    }
    /// How the map rises on the way out over an edge [1/mm].
    [[nodiscard]] double riseOver(std::size_t edge) const
    {
        return gradient.dot((corners[(edge + 1) % 3] - corners[edge]).normalized().cross(normal));
    }
};

/// Work that is in a tissue of `s` times its law when a hand of this grip rests on it [mJ].
double storedUnder(const Grip& grip, double push_N, double s, const haptics::HapticStructure& one)
{
    double out = 0.0, in = push_N / grip.stiffness_N_per_mm; // the hand's own spring gives way over the rest
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (out + in);
        (s * one.lawAt(middle).force_N < push_N - grip.stiffness_N_per_mm * middle ? out : in) = middle;
    }
    return one.lawAt(out).energy_mJ;
}

/// How far a tip swings about a place where a force across its way jumps by `jump_N` towards it, peak to peak [mm].
///
/// A relay of +-jump/2 that acts `delay` late puts in 2 jump w A delay a turn at amplitude A and frequency w; a damper
/// takes pi b w A^2, Coulomb friction 4 A friction. The relay's describing function 2 jump / (pi A) over the mass is
/// w^2. They balance where `pi b A + 4 friction sqrt(pi m A / (2 jump)) = 2 jump delay`, a quadratic in sqrt(A).
double swing_mm(double jump_N, double delay_s, double mass_kg, double damping_Ns_per_mm, double friction_N)
{
    if (!(jump_N > 0.0)) {
        return 0.0;
    }
    constexpr double kPerTonne = 1e-3; // N·s^2/mm for a kg
    const double b = std::numbers::pi * damping_Ns_per_mm;
    const double c = 4.0 * friction_N * std::sqrt(std::numbers::pi * kPerTonne * mass_kg / (2.0 * jump_N));
    const double e = 2.0 * jump_N * delay_s;
    const double root = 2.0 * e / (c + std::sqrt(c * c + 4.0 * b * e));
    return 2.0 * root * root;
}

} // namespace

std::optional<MapEdge> worstMapEdge(const haptics::HapticScene& scene, const Setup& setup)
{
    constexpr double kSureDamping_Ns_per_mm = 0.01; // as servo::heldStiffness_N_per_mm
    const device::DeviceMechanics& mechanics = setup.preset.mechanics;
    const double delay_s = (0.5 + setup.delayTicks) / setup.rate_Hz;
    const double added = setup.isControlled ? std::min(setup.preset.maxDamping_Ns_per_mm, kSureDamping_Ns_per_mm) : 0.0;
    std::optional<MapEdge> worst;
    for (std::size_t n = 0; n < scene.structures().size(); ++n) {
        const haptics::HapticStructure& one = scene.structures()[n];
        if (one.surface == nullptr || one.maps.stiffness.isEmpty() || one.tissue.hasFriction()) {
            continue;
        }
        for (const Grip& grip : grips()) {
            const double push = push_N(setup.preset);
            double softest = one.maps.stiffness.greatest();
            for (const std::array<float, 3>& at : *one.maps.stiffness.corners) {
                softest = std::min(softest, one.maps.stiffness.factor * double{std::min({at[0], at[1], at[2]})});
            }
            const double most_mJ = storedUnder(grip, push, softest, one);
            MapEdge edgeHere{n, Vec3::Zero(), 0.0, 0.0};
            for (std::uint32_t i = 0; i < one.surface->triangleCount(); ++i) {
                const MappedFacet here(*one.surface, one.maps.stiffness, i);
                for (std::uint32_t edge = 0; edge < 3; ++edge) {
                    const SurfaceIndex::Neighbour beyond = one.surface->neighbour(i, edge);
                    if (beyond.triangle == SurfaceIndex::kNoNeighbour || beyond.triangle < i) {
                        continue;
                    }
                    const MappedFacet there(*one.surface, one.maps.stiffness, beyond.triangle);
                    const double bend = -here.riseOver(edge) - there.riseOver(beyond.edge);
                    if (!(bend * most_mJ > edgeHere.jump_N)) {
                        continue;
                    }
                    const double s = std::min(here.values[edge], here.values[(edge + 1) % 3]);
                    const double jump = bend * storedUnder(grip, push, s, one);
                    if (jump > edgeHere.jump_N) {
                        edgeHere.jump_N = jump;
                        edgeHere.p_W = 0.5 * (here.corners[edge] + here.corners[(edge + 1) % 3]);
                    }
                }
            }
            edgeHere.swing_mm =
                swing_mm(edgeHere.jump_N, delay_s, mechanics.mass_kg + grip.mass_kg,
                         mechanics.damping_Ns_per_mm + grip.damping_Ns_per_mm + added, mechanics.friction_N);
            if (edgeHere.jump_N > 0.0 && (!worst || edgeHere.swing_mm > worst->swing_mm)) {
                worst = edgeHere;
            }
        }
    }
    return worst;
}

std::vector<std::string> mapWarnings(const haptics::HapticScene& scene, const Options& options)
{
    std::vector<std::string> lines;
    for (const device::DevicePreset& preset : options.presets) {
        Setup setup;
        setup.preset = preset;
        setup.rate_Hz = options.rate_Hz;
        setup.delayTicks = options.delayTicks;
        const auto edge = worstMapEdge(scene, setup);
        if (!edge || edge->swing_mm < kLimitCycle_mm) {
            continue;
        }
        std::ostringstream line;
        line.imbue(std::locale::classic());
        line << scene.structures()[edge->structure].name << ": its map of stiffness bends too sharply for "
             << preset.name << " at (" << std::fixed << std::setprecision(1) << edge->p_W.x() << ", " << edge->p_W.y()
             << ", " << edge->p_W.z() << ") mm: the push aside jumps by " << std::setprecision(2) << edge->jump_N
             << " N there and can keep the tip swinging by " << edge->swing_mm << " mm, expected less than "
             << kLimitCycle_mm
             << "; spread the step over more millimetres, round its ends, or give the tissue friction";
        lines.push_back(line.str());
    }
    return lines;
}

} // namespace palpate::evaluation::stability
