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
    out.push_back(test::stripsPly());
    out.push_back(test::asciiPly("0 0 0 7\n2.5 0 0\n0 1.5 0\nnan 0 0\n", "3 0 1 2 0.5\n2 0 1\n", 4, 2));
    out.push_back(test::asciiPly("0 0 0\n2.5 0 0\n0 1.5 0\n1 1 1\n", "3 0 1 2 2\n3 0 3 1 2\n", 4, 2));
    return out;
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kPly, "a.ply");
}

} // namespace ply

extern const Target kPly{"ply", 200, ply::seeds, ply::tryInput};

} // namespace palpate::fuzz
