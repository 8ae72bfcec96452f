// SPDX-License-Identifier: BSD-3-Clause
// palpate-paper-body FILE.stl writes the mesh of data/paper. The test evaluation.References compares both.
#include <palpate/evaluation/PaperBody.h>
#include <palpate/meshio/MeshFile.h>

#include <cstdio>

int main(int argc, char** argv)
{
    using namespace palpate;
    if (argc != 2) {
        std::fprintf(stderr, "usage: palpate-paper-body FILE.stl\n");
        return 2;
    }
    const meshio::MeshStructure structure{"shuttle", evaluation::paperBody(), {}};
    if (const core::Status status = meshio::writeMesh(argv[1], {&structure, 1}); !status.isOk()) {
        std::fprintf(stderr, "%s\n", status.message().c_str());
        return 1;
    }
    return 0;
}
