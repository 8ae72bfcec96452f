// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace obj {

std::vector<std::string> seeds()
{
    std::vector<std::string> out;
    for (const test::HostileMesh& mesh : test::hostileMeshes()) {
        if (mesh.name.ends_with(".obj") && mesh.bytes.size() < 4096) {
            out.push_back(mesh.bytes);
        }
    }
    return out;
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kObj, "a.obj");
}

} // namespace obj

extern const Target kObj{"obj", 200, obj::seeds, obj::tryInput};

} // namespace palpate::fuzz
