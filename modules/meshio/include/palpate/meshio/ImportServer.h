// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>

namespace palpate::meshio {

/// Resource limits for reading one file; a file that needs more is refused. Limits grow with the file size.
struct ImportLimits
{
    std::uint64_t memory_bytes = std::uint64_t{1} << 30; ///< address space of the child, including the program
    double memoryPerByte = 24.0;                         ///< additional memory per byte of the file [bytes]
    double cpu_s = 8.0;                                  ///< processor time [s]
    double wall_s = 10.0;                                ///< wall-clock time [s]
    double perMegabyte_s = 1.0; ///< additional time per 1e6 bytes of the file, for both times [s]
    /// Additional memory and time for a label map, whose compressed size says little: its voxels are limited to 1,100
    /// for each byte of the file.
    std::uint64_t labelMemory_bytes = std::uint64_t{1} << 32;
    double label_s = 60.0;
    unsigned files = 24; ///< open file descriptors
};

/// Starts the server for sandboxed import. From then on each file is read in a child process under the limits: a file
/// that makes the reader crash, hang or run out of memory is an error of `readMesh`, and the program continues.
///
/// Forks a server that forks one child per file: a child starts with the program already loaded, which saves 30 ms.
/// Call once, first in main, while the program has one thread and no open files. The server ends with its parent. A
/// program without this call (a library does not control main) reads in its own process, with the same checks.
/// @return the reason when the server cannot start; files are then read in this process
PALPATE_EXPORT core::Status startImportServer(const ImportLimits& limits = {});

} // namespace palpate::meshio
