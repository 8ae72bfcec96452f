// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Subject.h"

#include <palpate/session/GeometryHash.h>

#include <chrono>

namespace palpate::evaluation {

namespace {

std::shared_ptr<const Subject> make(std::string name, const std::vector<const geometry::RepairedMesh*>& meshes)
{
    const auto started = std::chrono::steady_clock::now();
    std::vector<haptics::HapticStructure> structures;
    for (const geometry::RepairedMesh* mesh : meshes) {
        haptics::HapticStructure structure;
        structure.name = "structure " + std::to_string(structures.size() + 1);
        structure.surface = std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*mesh));
        structures.push_back(std::move(structure));
    }
    auto scene = std::make_shared<const haptics::HapticScene>(std::move(structures));
    const double build_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();
    geometry::RepairedMesh all = merged(meshes);
    std::string hash = session::geometryHash(all.mesh);
    return std::make_shared<const Subject>(
        Subject{std::move(name), std::move(hash), Surface(std::move(all)), std::move(scene), build_ms});
}

} // namespace

std::shared_ptr<const Subject> subjectOf(std::string name, const meshio::LoadedScene& scene)
{
    std::vector<const geometry::RepairedMesh*> meshes;
    for (const meshio::LoadedStructure& structure : scene.structures) {
        if (structure.description.palpable && structure.surface != nullptr &&
            !structure.surface->mesh.triangles.empty()) {
            meshes.push_back(structure.surface.get());
        }
    }
    return meshes.empty() ? nullptr : make(std::move(name), meshes);
}

std::shared_ptr<const Subject> subjectOf(std::string name, const geometry::TriangleMesh& mesh)
{
    const geometry::RepairedMesh repaired = geometry::repair(mesh);
    return repaired.mesh.triangles.empty() ? nullptr : make(std::move(name), {&repaired});
}

} // namespace palpate::evaluation
