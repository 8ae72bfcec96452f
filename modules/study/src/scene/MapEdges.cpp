// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/MapEdges.h"

#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/FeltPress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace palpate::study {

namespace {

using core::Vec3;
using geometry::SurfaceIndex;
using haptics::FeltPress;

constexpr std::size_t kMaps = 1 + FeltPress::kCount; // stiffness map, then the maps of buried lumps
using PerMap = std::array<double, kMaps>;

/// Maps of a structure that cause a tangential force.
class PushingMaps
{
  public:
    explicit PushingMaps(const haptics::HapticStructure& one)
        : m_one(one)
    {
        if (!one.maps.stiffness.isEmpty()) {
            m_maps[0] = &one.maps.stiffness;
        }
        for (std::size_t j = 0; one.maps.hasFelt() && j < FeltPress::kCount; ++j) {
            m_maps[1 + j] = &one.maps.felt[j];
        }
    }
    [[nodiscard]] bool isAny() const { return m_maps[0] != nullptr || m_maps[1] != nullptr; }
    /// Returns the map value at a corner of a triangle; 1 without a map.
    [[nodiscard]] double at(std::size_t map, std::uint32_t triangle, std::size_t corner) const
    {
        return m_maps[map] == nullptr ? 1.0 : m_maps[map]->factor * double{(*m_maps[map]->corners)[triangle][corner]};
    }
    [[nodiscard]] bool isThere(std::size_t map) const { return m_maps[map] != nullptr; }
    [[nodiscard]] bool varies(std::uint32_t triangle) const
    {
        return std::any_of(m_maps.begin(), m_maps.end(), [triangle](const haptics::TissueMap* map) {
            return map != nullptr && ((*map->corners)[triangle][1] != (*map->corners)[triangle][0] ||
                                      (*map->corners)[triangle][2] != (*map->corners)[triangle][0]);
        });
    }
    /// Returns a lower bound of the combined map values, from the minimum of each map.
    [[nodiscard]] double least() const
    {
        PerMap each;
        each.fill(1.0);
        for (std::size_t map = 0; map < kMaps; ++map) {
            if (m_maps[map] != nullptr) {
                each[map] = m_maps[map]->greatest();
                for (std::uint32_t i = 0; i < m_one.surface->triangleCount(); ++i) {
                    each[map] = std::min({each[map], at(map, i, 0), at(map, i, 1), at(map, i, 2)});
                }
            }
        }
        return each[0] * (m_maps[1] == nullptr ? 1.0 : *std::min_element(each.begin() + 1, each.end()));
    }

  private:
    const haptics::HapticStructure& m_one;
    std::array<const haptics::TissueMap*, kMaps> m_maps{};
};

/// Returns the outward slopes of the maps across an edge of a triangle [1/mm].
PerMap outwardSlopes(const SurfaceIndex& surface, const PushingMaps& maps, std::uint32_t triangle, std::uint32_t edge)
{
    const geometry::Triangle t = surface.triangle(triangle);
    const Vec3 a = surface.vertex(t[0]), e1 = surface.vertex(t[1]) - a, e2 = surface.vertex(t[2]) - a;
    const Vec3 across = e1.cross(e2);
    const Vec3 along = surface.vertex(t[(edge + 1) % 3]) - surface.vertex(t[edge]);
    const Vec3 out = along.cross(across).normalized();
    const double toSecond = e2.cross(across).dot(out) / across.squaredNorm();
    const double toThird = across.cross(e1).dot(out) / across.squaredNorm();
    PerMap rises{};
    for (std::size_t map = 0; map < kMaps; ++map) {
        if (maps.isThere(map)) {
            const double first = maps.at(map, triangle, 0);
            rises[map] = (maps.at(map, triangle, 1) - first) * toSecond + (maps.at(map, triangle, 2) - first) * toThird;
        }
    }
    return rises;
}

/// Equilibrium of a hand with one grip that rests on a structure.
class Resting
{
  public:
    Resting(const Grip& grip, const HeldDevice& device, const haptics::HapticStructure& one, bool hasFelt)
        : m_push_N(device.push_N)
        , m_hand_N_per_mm(grip.stiffness_N_per_mm / device.scale) // in scene units
        , m_one(one)
        , m_hasFelt(hasFelt)
    {
    }

    /// Returns an upper bound for the energy stored in the force law, for map values of at least `least` [mJ].
    [[nodiscard]] double most_mJ(double least) const
    {
        return m_one.lawAt(restsAt([&](double d) { return least * m_one.lawAt(d).force_N; })).energy_mJ;
    }
    struct Jump
    {
        double force_N, ofLumps_N;
    };
    /// Returns the jump of the tangential force across an edge. @param s  map values there; @param bends  their changes
    /// of slope [1/mm]
    [[nodiscard]] Jump jumpAt(const PerMap& s, const PerMap& bends) const
    {
        if (!m_hasFelt) {
            return {bends[0] * most_mJ(s[0]), 0.0};
        }
        const double d = restsAt([&](double depth_mm) {
            const haptics::ForceTable::Value law = m_one.lawAt(depth_mm);
            return s[0] * scaleOf(FeltPress::at(m_one, depth_mm, law), s) * law.force_N;
        });
        const FeltPress press = FeltPress::at(m_one, d, m_one.lawAt(d));
        double energy_mJ = 0.0, ofLumps = 0.0;
        for (std::size_t j = 0; j < FeltPress::kCount; ++j) {
            energy_mJ += press.energies[j] * s[1 + j];
            ofLumps += press.energies[j] * bends[1 + j];
        }
        return {s[0] * ofLumps + energy_mJ * bends[0], s[0] * ofLumps};
    }

  private:
    static double scaleOf(const FeltPress& press, const PerMap& s)
    {
        double scale = 0.0;
        for (std::size_t j = 0; j < FeltPress::kCount; ++j) {
            scale += press.weights[j] * s[1 + j];
        }
        return scale;
    }
    /// Returns the depth at which tissue and hand spring together balance the push [mm].
    template<class Force>
    [[nodiscard]] double restsAt(const Force& force) const
    {
        double out = 0.0, in = m_push_N / m_hand_N_per_mm; // depth at which the hand spring alone takes the push
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (out + in);
            (force(middle) < m_push_N - m_hand_N_per_mm * middle ? out : in) = middle;
        }
        return out;
    }

    double m_push_N, m_hand_N_per_mm;
    const haptics::HapticStructure& m_one;
    bool m_hasFelt;
};

/// Returns the peak-to-peak oscillation of the tip where a tangential force jumps by `jump_N` towards that place [mm].
///
/// A relay of +-jump/2 with the delay `delay` adds the energy 2 jump w A delay per cycle at amplitude A and angular
/// frequency w; a damper takes pi b w A^2, Coulomb friction 4 A friction. The relay's describing function 2 jump / (pi
/// A) divided by the mass is w^2. Balance: `pi b A + 4 friction sqrt(pi m A / (2 jump)) = 2 jump delay`, a quadratic
/// equation in sqrt(A).
double swing_mm(double jump_N, const Grip& grip, const HeldDevice& device)
{
    if (!(jump_N > 0.0)) {
        return 0.0;
    }
    constexpr double kPerTonne = 1e-3; // N·s^2/mm per kg
    const double mass = kPerTonne * (device.mechanics.mass_kg + grip.mass_kg);
    const double b =
        std::numbers::pi * (device.mechanics.damping_Ns_per_mm + grip.damping_Ns_per_mm + device.added_Ns_per_mm);
    const double c = 4.0 * device.mechanics.friction_N * std::sqrt(std::numbers::pi * mass / (2.0 * jump_N));
    const double e = 2.0 * jump_N * device.delay_s;
    const double root = 2.0 * e / (c + std::sqrt(c * c + 4.0 * b * e));
    return 2.0 * root * root;
}

/// Returns the edge of a structure with the largest oscillation for a grip. `jump_N` is 0 if no tangential force jumps.
MapEdge worstEdge(const haptics::HapticStructure& one, const PushingMaps& maps, const Grip& grip,
                  const HeldDevice& device)
{
    const SurfaceIndex& surface = *one.surface;
    const bool hasFelt = maps.isThere(1);
    const Resting hand(grip, device, one, hasFelt);
    const double most_mJ = hand.most_mJ(maps.least());
    MapEdge worst;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const SurfaceIndex::Neighbour beyond = surface.neighbour(i, edge);
            if (beyond.triangle == SurfaceIndex::kNoNeighbour || beyond.triangle < i ||
                !(maps.varies(i) || maps.varies(beyond.triangle))) {
                continue;
            }
            PerMap bends = outwardSlopes(surface, maps, i, edge);
            const PerMap there = outwardSlopes(surface, maps, beyond.triangle, beyond.edge);
            double ofLumps = 0.0; // largest bend of the lump maps
            for (std::size_t map = 0; map < kMaps; ++map) {
                bends[map] = -bends[map] - there[map];
                ofLumps = map > 0 ? std::max(ofLumps, bends[map]) : 0.0;
            }
            std::array<PerMap, 2> ends;
            double felt = 1.0, own = 0.0; // maximum of both ends
            for (std::size_t end = 0; end < 2; ++end) {
                for (std::size_t map = 0; map < kMaps; ++map) {
                    ends[end][map] = maps.at(map, i, (edge + end) % 3);
                    felt = map > 0 ? std::max(felt, ends[end][map]) : felt;
                }
                own = std::max(own, ends[end][0]);
            }
            if (!((own * ofLumps + felt * std::max(0.0, bends[0])) * most_mJ > worst.jump_N)) {
                continue; // below the current worst edge even for the maximum stored energy
            }
            for (const PerMap& s : ends) {
                const Resting::Jump jump = hand.jumpAt(s, bends);
                if (jump.force_N > worst.jump_N) {
                    const geometry::Triangle t = surface.triangle(i);
                    worst.jump_N = jump.force_N;
                    worst.isOfLumps = 2.0 * jump.ofLumps_N > jump.force_N;
                    worst.p_W = 0.5 * (surface.vertex(t[edge]) + surface.vertex(t[(edge + 1) % 3]));
                }
            }
        }
    }
    worst.swing_mm = swing_mm(worst.jump_N, grip, device);
    return worst;
}

} // namespace

const std::vector<Grip>& grips()
{
    static const std::vector<Grip> kGrips{{"light", 0.02, 0.15, 0.001}, {"fingertip", 0.006, 0.75, 0.0057}};
    return kGrips;
}

double restingPush_N(double maxForce_N) noexcept
{
    return std::min(3.0, 0.4 * maxForce_N);
}

HeldDevice heldDevice(const device::DevicePreset& preset, double rate_Hz, int delayTicks)
{
    constexpr double kSureDamping_Ns_per_mm = 0.01; // same value as in servo::heldStiffness_N_per_mm
    HeldDevice held;
    held.mechanics = preset.mechanics;
    held.added_Ns_per_mm = std::min(preset.maxDamping_Ns_per_mm, kSureDamping_Ns_per_mm);
    held.delay_s = (0.5 + delayTicks) / rate_Hz;
    held.push_N = restingPush_N(preset.maxForce_N);
    return held;
}

std::optional<HeldDevice> heldDevice(const device::DeviceInfo& info, double rate_Hz, int delayTicks, double scale)
{
    if (info.actuatedAxes == 0 || !(rate_Hz > 0.0) || !(scale > 0.0)) {
        return std::nullopt;
    }
    device::DevicePreset preset;
    const device::DevicePreset* known = device::findDevicePreset(info.id);
    if (known != nullptr) {
        preset.mechanics = known->mechanics;
    } else {
        preset.mechanics.damping_Ns_per_mm = std::max(0.0, info.ownDamping_Ns_per_mm);
    }
    preset.maxDamping_Ns_per_mm = info.maxDamping_Ns_per_mm;
    preset.maxForce_N = info.maxForce_N;
    HeldDevice held = heldDevice(preset, rate_Hz, delayTicks);
    held.scale = scale;
    return held;
}

std::vector<MapEdge> mapEdges(const haptics::HapticScene& scene, const HeldDevice& device)
{
    std::vector<MapEdge> edges;
    for (std::size_t n = 0; n < scene.structures().size(); ++n) {
        const haptics::HapticStructure& one = scene.structures()[n];
        const PushingMaps maps(one);
        if (one.surface == nullptr || !maps.isAny() || one.tissue.hasFriction()) {
            continue;
        }
        MapEdge worst;
        for (const Grip& grip : grips()) {
            const MapEdge edge = worstEdge(one, maps, grip, device);
            if (edge.swing_mm > worst.swing_mm) {
                worst = edge;
            }
        }
        if (worst.jump_N > 0.0) {
            worst.structure = n;
            edges.push_back(worst);
        }
    }
    return edges;
}

} // namespace palpate::study
