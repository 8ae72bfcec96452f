// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace ply {

std::vector<std::string> seeds()
{
    std::vector<std::string> out;
    for (const test::HostileMesh& mesh : test::hostileMeshes()) {
        if (mesh.name.ends_with(".ply") && mesh.bytes.size() < 4096) {
            out.push_back(mesh.bytes);
        }
    }
    return out;
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kPly, "a.ply");
}

} // namespace ply

extern const Target kPly{"ply", 200, ply::seeds, ply::tryInput};

} // namespace palpate::fuzz
