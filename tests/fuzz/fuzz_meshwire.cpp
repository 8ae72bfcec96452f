// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"
#include "read/MeshWire.h"

#include <algorithm>
#include <sys/mman.h>
#include <unistd.h>

namespace palpate::fuzz {

namespace meshwire {

class MemoryFile
{
  public:
    MemoryFile()
        : m_descriptor(::memfd_create("palpate-fuzz", MFD_CLOEXEC))
    {
        require(m_descriptor >= 0, "a memory file can be made");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(m_descriptor); }
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    [[nodiscard]] std::string bytes() const
    {
        std::string out(static_cast<std::size_t>(::lseek(m_descriptor, 0, SEEK_END)), '\0');
        require(::pread(m_descriptor, out.data(), out.size(), 0) == static_cast<ssize_t>(out.size()),
                "a memory file can be read");
        return out;
    }

  private:
    int m_descriptor;
};

meshio::MeshFile sample(std::size_t structures)
{
    meshio::MeshFile file;
    file.format = "NRRD label map";
    file.voxels = geometry::Staircase{};
    file.voxels->voxel_mm = core::Vec3(1, 1, 2);
    file.voxels->axes.setIdentity();
    file.notes = {core::Message(PALPATE_TEXT("%1 and %2"), 1, "two")};
    for (std::size_t i = 0; i < structures; ++i) {
        meshio::MeshStructure& one = file.structures.emplace_back();
        one.name = "label " + std::to_string(i + 1);
        one.colour = {0.1, 0.2, 0.3};
        one.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        one.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        one.mesh.arrays = {{"a", false, {1, 2, 3, 4}}, {"b", true, {5, 6, 7, 8}}};
    }
    return file;
}

std::vector<std::string> seeds()
{
    const MemoryFile whole, early, failed;
    require(meshio::internal::writeOutcome(whole.descriptor(), sample(2)), "an outcome can be handed over");
    meshio::MeshFile first = sample(1);
    require(meshio::internal::writeStructure(early.descriptor(), first) &&
                meshio::internal::writeOutcome(early.descriptor(), sample(3), 1),
            "a structure can be handed over before the others");
    first = sample(1);
    require(meshio::internal::writeStructure(failed.descriptor(), first) &&
                meshio::internal::writeOutcome(
                    failed.descriptor(), core::Status(core::StatusCode::BadFormat, PALPATE_TEXT("found, expected"))),
            "a structure can be handed over before an error");
    return {whole.bytes(), early.bytes(), failed.bytes()};
}

void check(const meshio::MeshStructure& structure)
{
    require(!structure.mesh.triangles.empty(), "a structure has triangles");
    for (const core::Vec3& p : structure.mesh.vertices) {
        require(p.allFinite(), "vertices are finite");
    }
    for (const geometry::Triangle& triangle : structure.mesh.triangles) {
        require(std::ranges::max(triangle) < structure.mesh.vertices.size(), "indices are in range");
    }
    for (const geometry::MeshArray& array : structure.mesh.arrays) {
        require(array.values.size() ==
                    (array.isPerTriangle ? structure.mesh.triangles.size() : structure.mesh.vertices.size()),
                "arrays are complete");
    }
}

/// Parses a possible reply of an import process, structure by structure.
void tryInput(std::string_view bytes)
{
    const MemoryFile handed;
    require(::write(handed.descriptor(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "there is memory for a small input");
    meshio::internal::OutcomeReader reader(handed.descriptor(), "a.nrrd");
    std::size_t structures = 0;
    while (reader.readStructure()) {
        check(reader.file().structures.back());
        ++structures;
    }
    const auto outcome = std::move(reader).finish();
    if (outcome.isOk()) {
        require(outcome.value().structures.size() == structures && structures > 0, "all structures were read");
    } else {
        require(outcome.status().message().find('\n') == std::string::npos, "a refusal is one line");
    }
}

} // namespace meshwire

extern const Target kMeshWire{"meshwire", 200, meshwire::seeds, meshwire::tryInput};

} // namespace palpate::fuzz
