// SPDX-License-Identifier: BSD-3-Clause
#include "Palpation.h"
#include "Phantom.h"

#include <palpate/meshio/LoadScene.h>
#include <palpate/meshio/MeshFile.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>
#include <unistd.h>

namespace {

using namespace palpate;

/// File name of a structure: "lump 20 mm" becomes "lump-20-mm.stl".
std::string stlName(std::string name)
{
    std::replace(name.begin(), name.end(), ' ', '-');
    return name + ".stl";
}

/// Re-simulates a recording on the scene in the same folder.
/// @param isExact  true: all bits must agree; false: differences by rounding between builds are allowed
core::Status verify(const meshio::LoadedScene& scene, const std::filesystem::path& recording, bool isExact)
{
    const auto reader = session::RecordingReader::open(recording);
    if (!reader.isOk()) {
        return reader.status();
    }
    if (core::Status status = reader.value()->verify(); !status.isOk()) {
        return status;
    }
    const auto again = session::resimulate(*reader.value(), study::indexedByHash(study::meshesByHash(scene)));
    if (!again.isOk()) {
        return again.status().at(recording);
    }
    const session::Resimulation& it = again.value();
    if (it.unverified > 0 || !it.isWithinRounding() || (isExact && !it.isSame())) {
        const core::Message why = it.unverified > 0       ? core::Message(PALPATE_TEXT("ticks are missing"))
                                  : it.isWithinRounding() ? it.difference
                                                          : it.beyond;
        return core::Status(core::StatusCode::Mismatch, why).at(recording);
    }
    return {};
}

/// Scene description of the phantom. @param buried  lumps palpated through the liver, or as layers below
meshio::SceneFile describe(const std::vector<phantom::PhantomStructure>& phantom, const std::filesystem::path& folder,
                           meshio::BuriedTouch buried)
{
    meshio::SceneFile scene;
    scene.buried = buried;
    for (const phantom::PhantomStructure& structure : phantom) {
        meshio::SceneStructure& described = scene.structures.emplace_back();
        described.mesh = std::filesystem::absolute(folder / "phantom.vtp");
        described.part = structure.name;
        described.name = structure.name;
        described.colour = structure.colour;
        described.opacity = structure.opacity;
        described.palpable = structure.palpable;
        described.tissue.stiffness_N_per_mm = structure.stiffness_N_per_mm;
        if (structure.layer > 0 && buried == meshio::BuriedTouch::Felt) {
            described.inside = phantom.front().name;
            described.young_ratio = phantom::kLumpRatio;
        } else {
            described.layer = structure.layer;
        }
    }
    meshio::SceneCamera camera;
    camera.position_W = {-70, -430, 110};
    camera.focus_W = {4, 4, 4};
    scene.camera = camera;
    return scene;
}

/// The scene with a liver that moves down on breathing in: its dome by 15 mm, its lower edge not at all.
meshio::SceneFile breathing(meshio::SceneFile scene)
{
    meshio::SceneMotion motion;
    motion.amplitude_mm = {0.0, -3.0, -15.0};
    motion.still_mm = {0.0, 0.0, -56.0};
    motion.full_mm = {0.0, 0.0, 64.0};
    for (meshio::SceneStructure& structure : scene.structures) {
        structure.motion = motion;
    }
    return scene;
}

core::Status write(const std::filesystem::path& folder)
{
    std::vector<phantom::PhantomStructure> phantom = phantom::makePhantom();
    const meshio::SceneFile scene = describe(phantom, folder, meshio::BuriedTouch::Felt);
    const meshio::SceneFile layered = describe(phantom, folder, meshio::BuriedTouch::Layers);
    std::vector<meshio::MeshStructure> meshes;
    for (phantom::PhantomStructure& structure : phantom) {
        meshes.push_back({structure.name, std::move(structure.mesh), structure.colour});
    }
    if (core::Status status = meshio::writeMesh(folder / "phantom.vtp", meshes); !status.isOk()) {
        return status;
    }
    for (const meshio::MeshStructure& mesh : meshes) {
        if (core::Status status = meshio::writeMesh(folder / stlName(mesh.name), {&mesh, 1}); !status.isOk()) {
            return status;
        }
    }
    const std::filesystem::path scenePath = folder / "phantom.palpate.json";
    if (core::Status status = meshio::writeScene(scenePath, scene); !status.isOk()) {
        return status;
    }
    if (core::Status status = meshio::writeScene(folder / "phantom-layers.palpate.json", layered); !status.isOk()) {
        return status;
    }
    if (core::Status status = meshio::writeScene(folder / "phantom-breathing.palpate.json", breathing(scene));
        !status.isOk()) {
        return status;
    }
    // Recorded on the scene as opened from the file, so that a replay on the scene file gives the same bits.
    core::Result<meshio::LoadedScene> loaded = study::openScene(scenePath);
    if (!loaded.isOk()) {
        return loaded.status();
    }
    const std::filesystem::path recording = folder / "palpation.palpate";
    const core::Status recorded = phantom::recordPalpation(loaded.value(), phantom::palpationScript(), recording);
    return recorded.isOk() ? verify(loaded.value(), recording, true) : recorded;
}

/// Compares two files byte by byte. @return one line when they differ
core::Status compareBytes(const std::filesystem::path& kept, const std::filesystem::path& made)
{
    std::ifstream a(kept, std::ios::binary);
    std::ifstream b(made, std::ios::binary);
    using Bytes = std::istreambuf_iterator<char>;
    if (!a || !b || !std::equal(Bytes(a), Bytes(), Bytes(b), Bytes())) {
        return {core::StatusCode::Mismatch, PALPATE_TEXT("%1 is not what the generator makes"), kept};
    }
    return {};
}

/// Compares meshes by content, because compression differs between library versions.
core::Status compareMeshes(const std::filesystem::path& kept, const std::filesystem::path& made)
{
    const core::Result<meshio::MeshFile> a = meshio::readMesh(kept);
    const core::Result<meshio::MeshFile> b = meshio::readMesh(made);
    for (const auto* read : {&a, &b}) {
        if (!read->isOk()) {
            return read->status();
        }
    }
    const auto same = [](const meshio::MeshStructure& x, const meshio::MeshStructure& y) {
        return x.name == y.name && x.mesh.vertices == y.mesh.vertices && x.mesh.triangles == y.mesh.triangles;
    };
    const std::vector<meshio::MeshStructure>& x = a.value().structures;
    const std::vector<meshio::MeshStructure>& y = b.value().structures;
    if (!std::equal(x.begin(), x.end(), y.begin(), y.end(), same)) {
        return {core::StatusCode::Mismatch, PALPATE_TEXT("%1 is not what the generator makes"), kept};
    }
    return {};
}

/// Compares the ticks of two recordings, ignoring dates and solve times. Tolerance for rounding in other builds: a
/// millionth of a mm and of a N.
core::Status compareRecordings(const std::filesystem::path& kept, const std::filesystem::path& made)
{
    std::array<std::vector<servo::TickRecord>, 2> ticks;
    for (int i = 0; i < 2; ++i) {
        const auto reader = session::RecordingReader::open(i == 0 ? kept : made);
        if (!reader.isOk()) {
            return reader.status();
        }
        const session::RecordingExtent& extent = reader.value()->extent();
        const core::Status read =
            reader.value()->forEach(extent.firstTick, extent.lastTick, [&](const servo::TickRecord& tick) {
                ticks[i].push_back(tick);
                return true;
            });
        if (!read.isOk()) {
            return read;
        }
    }
    const auto close = [](const core::Vec3& a, const core::Vec3& b) { return (a - b).norm() <= 1e-6; };
    const auto same = [&close](const servo::TickRecord& a, const servo::TickRecord& b) {
        return a.tick == b.tick && close(a.p_WH, b.p_WH) && close(a.felt.p_WG, b.felt.p_WG) &&
               close(a.felt.f_W, b.felt.f_W) && close(a.fSent_W, b.fSent_W) && a.felt.structure == b.felt.structure &&
               a.flags == b.flags;
    };
    const auto [a, b] = std::mismatch(ticks[0].begin(), ticks[0].end(), ticks[1].begin(), ticks[1].end(), same);
    if (a != ticks[0].end() || b != ticks[1].end()) {
        return {core::StatusCode::Mismatch, PALPATE_TEXT("%1: tick %2 is not what the generator makes"), kept,
                a - ticks[0].begin()};
    }
    return {};
}

core::Status check(const std::filesystem::path& folder)
{
    const std::filesystem::path made =
        std::filesystem::temp_directory_path() / ("palpate-phantom-" + std::to_string(getpid()));
    std::filesystem::create_directory(made);
    core::Status status = write(made);
    for (const auto& entry : std::filesystem::directory_iterator(made)) {
        if (!status.isOk()) {
            break;
        }
        const std::filesystem::path kept = folder / entry.path().filename();
        const std::string extension = entry.path().extension().string();
        status = extension == ".vtp"       ? compareMeshes(kept, entry.path())
                 : extension == ".palpate" ? compareRecordings(kept, entry.path())
                                           : compareBytes(kept, entry.path());
    }
    std::filesystem::remove_all(made);
    if (!status.isOk()) {
        return status;
    }
    const core::Result<meshio::LoadedScene> kept = study::openScene(folder / "phantom.palpate.json");
    return kept.isOk() ? verify(kept.value(), folder / "palpation.palpate", false) : kept.status();
}

} // namespace

/// Usage: palpate-phantom [--check] FOLDER
///
/// Writes the phantom's meshes, scene files and recording into an existing folder. With --check, compares the
/// existing files with the generated ones and verifies the recording by re-simulation.
int main(int argc, char** argv)
{
    const bool isCheck = argc == 3 && std::string_view(argv[1]) == "--check";
    if ((argc != 2 && !isCheck) || !std::filesystem::is_directory(argv[argc - 1])) {
        std::fprintf(stderr, "usage: palpate-phantom [--check] FOLDER (an existing folder)\n");
        return 2;
    }
    const core::Status status = isCheck ? check(argv[2]) : write(argv[1]);
    if (!status.isOk()) {
        std::fprintf(stderr, "palpate-phantom: %s\n", status.message().c_str());
        return 1;
    }
    return 0;
}
