// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

#include "RandomTissue.h"

namespace palpate::adversary {

namespace {

MeshKind kindFor(Family family, Chance& chance)
{
    const bool isOpen = family == Family::Open || (family != Family::Closed && chance.is(0.3));
    return static_cast<MeshKind>(isOpen ? chance.whole(kClosedKinds, kMeshKinds - 1)
                                        : chance.whole(0, kClosedKinds - 1));
}

/// Position and size of a scene.
class Placing
{
  public:
    Placing(double scale, Chance& chance)
        : m_size_mm(scale * chance.between(8.0, 25.0))
    {
        if (chance.is(0.5)) {
            m_turn = core::Quaternion(chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1), 0.3);
            m_turn.normalize();
        }
        if (chance.is(0.3)) {
            m_offset_mm = chance.magnitude(1.0, 1e6) * chance.direction();
        }
    }
    void put(RandomMesh& mesh, const Vec3& middle, double share) const
    {
        for (Vec3& v : mesh.mesh.vertices) {
            v = m_turn * (m_size_mm * (middle + share * v)) + m_offset_mm;
        }
    }

  private:
    double m_size_mm;
    core::Quaternion m_turn = core::Quaternion::Identity();
    Vec3 m_offset_mm = Vec3::Zero();
};

std::shared_ptr<const geometry::SurfaceIndex> indexOf(const TriangleMesh& mesh)
{
    return std::make_shared<geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(mesh, geometry::Facing::AsGiven), 1));
}

} // namespace

const char* nameOf(Family family)
{
    static constexpr std::array<const char*, kFamilies> kNames{"closed", "open",       "layers", "balls",
                                                               "rough",  "roughballs", "moving"};
    return kNames[static_cast<std::size_t>(family)];
}

RandomScene randomScene(Family family, Chance& chance)
{
    if (family == Family::Rough || family == Family::RoughBalls) {
        RandomScene scene =
            randomScene(family == Family::Rough ? static_cast<Family>(chance.below(3)) : Family::Balls, chance);
        makeRough(scene, chance);
        return scene;
    }
    RandomScene scene;
    scene.scale = chance.is(0.25) ? chance.magnitude(1e-3, 1e3) : 1.0;
    if (family == Family::Balls) {
        constexpr std::array kRadii_mm{0.1, 1.0, 4.0, 20.0};
        scene.fingertip_mm = kRadii_mm[chance.below(4)];
        if (scene.fingertip_mm * scene.scale > haptics::HapticScene::kMostFingertip_mm) {
            scene.scale = 1.0;
        }
        scene.fingertip_mm *= scene.scale;
    }
    const bool hasLayers = family == Family::Layers || (family == Family::Balls && chance.is(0.15));
    scene.layers = hasLayers ? static_cast<std::uint32_t>(chance.whole(2, 4)) : 1;
    const std::uint32_t several = chance.is(0.25) ? static_cast<std::uint32_t>(chance.whole(2, 4)) : 1;
    const std::uint32_t count = hasLayers ? scene.layers + static_cast<std::uint32_t>(chance.below(3)) : several;
    const double damping = chance.is(0.2) ? 0.002 : 0.0;
    const Placing placing(scene.scale, chance);
    for (std::uint32_t i = 0; i < count; ++i) {
        RandomStructure one;
        one.mesh = randomMesh(kindFor(family, chance), chance);
        one.layer = i % scene.layers;
        // Layers are nested; structures of one layer are beside each other or intersect.
        const double share = (1.0 - 0.18 * one.layer) * (count > scene.layers ? chance.between(0.4, 1.0) : 1.0);
        placing.put(one.mesh, (count > 1 ? chance.between(0.0, hasLayers ? 0.2 : 1.2) : 0.0) * chance.direction(),
                    share);
        one.surface = indexOf(one.mesh.mesh);
        constexpr std::array kStiffness_N_per_mm{0.5, 0.05, 4.0}; // organs, fat and bone side by side
        one.tissue = {kStiffness_N_per_mm[i % 3], damping * (i % 2)};
        scene.name += (i == 0 ? "" : ", ") + one.mesh.name;
        scene.bounds.extend(one.mesh.mesh.bounds());
        scene.structures.push_back(std::move(one));
    }
    return scene;
}

std::unique_ptr<haptics::HapticScene> RandomScene::build(std::uint32_t shown) const
{
    std::vector<haptics::HapticStructure> all;
    for (const RandomStructure& one : structures) {
        haptics::HapticStructure structure = one.structure();
        if ((shown >> one.layer & 1u) == 0) {
            structure.surface = nullptr;
        }
        all.push_back(std::move(structure));
    }
    return std::make_unique<haptics::HapticScene>(std::move(all), fingertip_mm);
}

} // namespace palpate::adversary
