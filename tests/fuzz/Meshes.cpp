// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"

#include "read/ReadMesh.h"

namespace palpate::fuzz {

namespace {

void check(const meshio::MeshFile& file)
{
    require(!file.structures.empty(), "a mesh has structures");
    for (const meshio::MeshStructure& structure : file.structures) {
        require(!structure.mesh.triangles.empty(), "a structure has triangles");
        for (const core::Vec3& p : structure.mesh.vertices) {
            require(p.allFinite() && p.cwiseAbs().maxCoeff() <= 1e7, "coordinates are finite and within 10 km");
        }
        for (const geometry::Triangle& triangle : structure.mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                require(corner < structure.mesh.vertices.size(), "indices are in range");
            }
        }
    }
}

} // namespace

void tryMesh(std::string_view bytes, const meshio::internal::MeshFormat& format, const char* name)
{
    using meshio::internal::FileImage;
    for (const bool isPartial : {false, true}) {
        auto image = FileImage::copy(bytes, name);
        require(image.isOk(), "there is memory for a small input");
        meshio::internal::ScanContext context;
        context.file = name;
        context.isPartial = isPartial;
        if (format.guard != nullptr) {
            if (const auto scanned = format.guard(image.value(), context); !scanned.isOk()) {
                requireOneLine(scanned.status(), name);
                continue;
            }
        }
        auto whole = FileImage::copy(bytes, name);
        require(whole.isOk(), "there is memory for a small input");
        meshio::ReadOptions options;
        options.isPartial = isPartial;
        const auto file = meshio::internal::decodeMesh(std::move(whole).value(), name, options);
        if (file.isOk()) {
            check(file.value());
        } else {
            requireOneLine(file.status(), name);
        }
    }
}

} // namespace palpate::fuzz
