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
    std::string complaint; ///< begin of what is said after the file's name; empty for a file that can be read
};

/// OBJ and PLY files, made here so that each says what is wrong with it.
std::vector<HostileMesh> hostileMeshes();

} // namespace palpate::test
