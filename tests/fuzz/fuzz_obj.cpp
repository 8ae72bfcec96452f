// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"
#include "formats/ObjMaterials.h"
#include "text/Encoding.h"

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
    out.push_back("# C:\\\nmtllib a.mtl\no a\nv 0 0 0\nv 2.5 0 0\nv 0 1.5 0\nv nan 0 0\ng a\nusemtl b\nf 1 2 3\nf 1 2\n"
                  "v 0 0 1\ng a\nusemtl c\nf 1 2 5 # x\n\x1a");
    out.emplace_back("newmtl a\nKd 0.5 1 0\nd 0.5\nTr 2\nnewmtl \xe4\nKd 2 0\n");
    out.emplace_back("\xff\xfev\0 \0\0\xd8\0\xdc", 10);
    return out;
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kObj, "a.obj");
    for (const auto& [name, material] : meshio::internal::parseMaterials(bytes)) {
        require(!material.colour || ((*material.colour)[0] >= 0.0 && (*material.colour)[2] <= 1.0),
                "a colour is in range");
        require(material.opacity > 0.0 && material.opacity <= 1.0, "an opacity is in range");
        (void)meshio::internal::utf8Of(name);
    }
    if (const auto text = meshio::internal::fromUtf16(bytes)) {
        require(meshio::internal::utf8Of(*text) == *text, "converted text is valid UTF-8");
    }
}

} // namespace obj

extern const Target kObj{"obj", 200, obj::seeds, obj::tryInput};

} // namespace palpate::fuzz
