// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace palpate::test {

/// A mesh file that a reader must decide about, in the classes of shared/hostile.
struct HostileMesh
{
    std::string name;
    std::string bytes;
    std::string complaint; ///< start of the message after the file name; empty for a readable file
};

/// OBJ and PLY files with one defect each.
std::vector<HostileMesh> hostileMeshes();

} // namespace palpate::test
