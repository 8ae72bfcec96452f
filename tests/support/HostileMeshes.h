// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace palpate::test {

/// A mesh file that a reader must accept or reject, in the classes of shared/hostile.
struct HostileMesh
{
    std::string name;
    std::string bytes;
    std::string complaint; ///< start of the message after the file's name; empty for a valid file
};

/// Returns generated OBJ and PLY files with a known fault each.
std::vector<HostileMesh> hostileMeshes();

} // namespace palpate::test
