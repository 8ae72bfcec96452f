// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Subject.h"

#include "reference/ClosestPoint.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/study/HapticCopy.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace palpate::evaluation {

namespace {

// Contact tolerance: a god-object keeps a gap of one skin or, with the ray solvers, 1e-6 of the scene to the surface.
constexpr double kTouch_mm = 1e-3, kTouchShare = 4e-6;

/// Structure with its mesh, before the layers are merged.
struct Part
{
    const geometry::RepairedMesh* mesh;
    meshio::SceneStructure description;
};

/// Renumbers the layers without gaps in the same order; excess layers are merged, as in HapticScene.
void numberLayers(std::vector<Part>& parts)
{
    std::set<std::uint32_t> used;
    for (const Part& part : parts) {
        used.insert(part.description.layer);
    }
    for (Part& part : parts) {
        const auto rank = static_cast<std::size_t>(std::distance(used.begin(), used.find(part.description.layer)));
        part.description.layer = static_cast<std::uint32_t>(std::min(rank, haptics::HapticScene::kMaxLayers - 1));
    }
}

std::shared_ptr<const Subject> make(std::string name, std::vector<Part> parts)
{
    if (parts.empty()) {
        return nullptr;
    }
    numberLayers(parts);
    auto subject = std::make_shared<Subject>();
    subject->name = std::move(name);
    const auto started = std::chrono::steady_clock::now();
    std::vector<haptics::HapticStructure> structures;
    for (const Part& part : parts) {
        structures.push_back(study::hapticStructure(part.description, study::indexed(*part.mesh)));
    }
    subject->scene = std::make_shared<const haptics::HapticScene>(std::move(structures));
    subject->build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();

    std::vector<const geometry::RepairedMesh*> meshes;
    for (std::uint32_t layer = 0; layer < subject->scene->layerCount(); ++layer) {
        std::vector<const geometry::RepairedMesh*> members;
        std::vector<SubjectStructure> described;
        std::size_t triangles = 0;
        for (const Part& part : parts) {
            if (part.description.layer == layer) {
                described.push_back({part.description.name, part.description.tissue.stiffness_N_per_mm, layer,
                                     static_cast<std::uint32_t>(triangles)});
                members.push_back(part.mesh);
                triangles += part.mesh->mesh.triangles.size();
            }
        }
        meshes.insert(meshes.end(), members.begin(), members.end());
        subject->layers.push_back({Surface(merged(members)), std::move(described)});
    }
    subject->hash = session::geometryHash(subject->layers.size() == 1 ? subject->layers[0].surface.repaired().mesh
                                                                      : merged(meshes).mesh);
    return subject;
}

} // namespace

ContactSprings SubjectLayer::springsAt(const Vec3& p_WG, const Vec3& spring_mm, double fingertip_mm) const
{
    const auto softer = [](const SubjectStructure& a, const SubjectStructure& b) {
        return a.stiffness_N_per_mm < b.stiffness_N_per_mm;
    };
    const auto [softest, stiffest] = std::minmax_element(structures.begin(), structures.end(), softer);
    if (spring_mm.isZero(0.0) || !softer(*softest, *stiffest)) {
        return ContactSprings(stiffest->stiffness_N_per_mm);
    }
    const double reach = fingertip_mm + std::min(kTouch_mm, kTouchShare * surface.bounds().sizes().maxCoeff());
    std::vector<std::uint32_t> near;
    surface.appendNear(Box(p_WG.array() - reach, p_WG.array() + reach), near);
    std::vector<SpringPlane> touched;
    for (const std::uint32_t t : near) {
        const Vec3 &a = surface.corner(t, 0), &b = surface.corner(t, 1), &c = surface.corner(t, 2);
        const Vec3 away = p_WG - closestPoint<double>(a, b, c, p_WG);
        if (away.norm() > reach) {
            continue;
        }
        const auto after = std::upper_bound(structures.begin(), structures.end(), t,
                                            [](auto i, const auto& s) { return i < s.firstTriangle; });
        const SubjectStructure& of = *std::prev(after);
        Vec3 n = fingertip_mm > 0.0 ? away.normalized() : (b - a).cross(c - a).normalized();
        if (surface.isTwoSided(t) && n.dot(spring_mm) < 0.0) {
            n = -n;
        }
        touched.push_back({n, of.stiffness_N_per_mm, static_cast<std::size_t>(&of - structures.data())});
    }
    return touched.empty() ? ContactSprings(stiffest->stiffness_N_per_mm) : ContactSprings(touched, spring_mm);
}

std::size_t Subject::triangleCount() const
{
    std::size_t count = 0;
    for (const SubjectLayer& layer : layers) {
        count += layer.surface.triangleCount();
    }
    return count;
}

Box Subject::bounds() const
{
    Box box;
    for (const SubjectLayer& layer : layers) {
        box.extend(layer.surface.bounds());
    }
    return box;
}

std::shared_ptr<const Subject> subjectOf(std::string name, const meshio::LoadedScene& scene)
{
    std::vector<Part> parts;
    for (const meshio::LoadedStructure& structure : scene.structures) {
        const meshio::SceneStructure& d = structure.description;
        if (study::canBeFelt(d) && structure.surface != nullptr && !structure.surface->mesh.triangles.empty()) {
            parts.push_back({structure.surface.get(), d});
        }
    }
    return make(std::move(name), std::move(parts));
}

std::shared_ptr<const Subject> subjectOf(std::string name, const geometry::TriangleMesh& mesh)
{
    const geometry::RepairedMesh repaired = geometry::repair(mesh, geometry::Facing::AsGiven);
    meshio::SceneStructure description; // default tissue of a new structure, layer 0
    description.name = name;
    return repaired.mesh.triangles.empty() ? nullptr : make(name, {{&repaired, description}});
}

} // namespace palpate::evaluation
