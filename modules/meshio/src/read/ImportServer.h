// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/OpenFile.h"
#include "read/FieldFile.h"
#include "read/VolumeFile.h"

#include "palpate/meshio/ImportServer.h"
#include "palpate/meshio/MeshFile.h"

#include <array>
#include <cstdint>

namespace palpate::meshio::internal {

// Three processes: the client asks the server over a socket; the server forks a keeper, which forks the reader,
// reports the exit status of the reader to the client, and kills the reader when the client hangs up.

/// Type of file to read.
enum class ImportKind : std::uint8_t
{
    Mesh,
    Volume, ///< by path: some formats store the numbers in a separate file
    Field,  ///< a displacement field, by path
};

/// Task for the reader; sent with the descriptors below and followed by the path.
struct ImportTask
{
    std::uint64_t memory_bytes = 0;
    std::uint64_t cpu_s = 0;
    std::uint64_t files = 0;
    double unit_mm = 1.0;
    FileFrame frame = FileFrame::Untagged;
    bool isPartial = false;
    bool readsScale = true;
    ImportKind kind = ImportKind::Mesh;
};

/// Descriptors sent with a task.
struct ImportEnds
{
    int source;   ///< the mesh or volume file
    int result;   ///< an empty memory file for the outcome
    int progress; ///< a pipe: one byte per step, 0 … kStructureByte - 1; kStructureByte for each structure that can be
                  ///< read while the child goes on; at last kDoneByte
    int control; ///< the keeper's end of a socket: returns the reader's exit status; hanging up ends the reader
};
inline constexpr std::uint8_t kStructureByte = 254;
inline constexpr std::uint8_t kDoneByte = 255;
inline constexpr std::size_t kMostTask = 8192; ///< including the path [bytes]

// Exit codes of a reader without an outcome.
inline constexpr int kNotConfined = 2;   ///< setting the limits failed
inline constexpr int kNotHandedBack = 3; ///< writing the outcome failed

/// Hook in the reader before reading, called with the path: lets a test simulate a failing reader.
using ReaderHook = void (*)(const char* path);

/// `startImportServer` with a hook.
core::Status startImportServer(const ImportLimits& limits, ReaderHook hook);

/// Serves tasks from a socket until the other end is closed. Never returns.
[[noreturn]] void serveImports(int socket, ReaderHook hook);

/// @return true when files are read in children
[[nodiscard]] bool hasImportServer();

/// Reads `file` in a child. A child that fails, crashes or is stopped gives an error that names the file, also after it
/// has handed over structures.
/// @par Thread Any number of concurrent calls, one child per call.
[[nodiscard]] core::Result<MeshFile> readInChild(const OpenFile& file, const std::filesystem::path& path,
                                                 const ReadOptions& options);

/// Same for a volume. @param frame, progress  as for `readVolume`
[[nodiscard]] core::Result<VoxelGrid> readVolumeInChild(const OpenFile& file, const std::filesystem::path& path,
                                                        core::FileFrame frame,
                                                        const std::function<bool(double)>& progress);
/// Same for a displacement field. @param frame  as for `readField`
[[nodiscard]] core::Result<FieldGrid> readFieldInChild(const OpenFile& file, const std::filesystem::path& path,
                                                       core::FileFrame frame);

} // namespace palpate::meshio::internal
