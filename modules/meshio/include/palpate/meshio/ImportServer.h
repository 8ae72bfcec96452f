// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>

namespace palpate::meshio {

/// What reading one file may cost; what needs more is refused. The file's size counts in, as a large mesh takes its
/// time.
struct ImportLimits
{
    std::uint64_t memory_bytes = std::uint64_t{1} << 30; ///< address space of the child, the program's own included
    double memoryPerByte = 24.0;                         ///< and for each byte of the file [bytes]
    double cpu_s = 8.0;                                  ///< processor time [s]
    double wall_s = 10.0;                                ///< [s]
    double perMegabyte_s = 1.0;                          ///< for each 1e6 bytes of the file, on both times [s]
    unsigned files = 24;                                 ///< open file descriptors
};

/// From now on files are read in child processes of this one, each under the limits: a file that crashes, hangs or
/// starves its reader is an error of `readMesh`, and the program goes on.
///
/// Forks a server that forks such a child a file: the children find the program loaded, which starting it anew would
/// take 30 ms for. Call it once, first in main, while there is one thread and nothing is open. It ends with its parent.
/// A program that never calls it (a library cannot know its program's main) reads in its own process, with the same
/// checks.
/// @return why there is no server; files are then read in this process
core::Status startImportServer(const ImportLimits& limits = {});

} // namespace palpate::meshio
