// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OpenFile.h"
#include "VolumeFile.h"

#include "palpate/meshio/ImportServer.h"
#include "palpate/meshio/MeshFile.h"

#include <array>
#include <cstdint>

namespace palpate::meshio::internal {

// Three processes: the client asks the server over a socket; the server forks a keeper, which forks the reader and
// tells the client how that one ended, or ends it when the client hangs up.

/// What a file is read as.
enum class ImportKind : std::uint8_t
{
    Mesh,
    Volume, ///< by its path: VTK's readers go by its ending, and some have their numbers in another file
};

/// What the reader does; sent with the descriptors below and followed by the path.
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

/// The descriptors that go with a task.
struct ImportEnds
{
    int source;   ///< the mesh file, or that of the volume
    int result;   ///< an empty memory file for the outcome
    int progress; ///< a pipe: one byte a step, 0 … kDoneByte - 1, then kDoneByte
    int control;  ///< the keeper's end of a socket: the reader's exit status comes out, hanging up ends the reader
};
inline constexpr std::uint8_t kDoneByte = 255;
inline constexpr std::size_t kMostTask = 8192; ///< with its path [bytes]

// Exit codes of a reader without an outcome.
inline constexpr int kNotConfined = 2;   ///< it could not set its own limits
inline constexpr int kNotHandedBack = 3; ///< it could not write the outcome

/// Called in the reader before it reads, with the path: lets a test stand in for a reader that goes wrong.
using ReaderHook = void (*)(const char* path);

/// `startImportServer` with a hook.
core::Status startImportServer(const ImportLimits& limits, ReaderHook hook);

/// Serves tasks from a socket until its other end is closed. Never returns.
[[noreturn]] void serveImports(int socket, ReaderHook hook);

/// @return true when files are read in children
[[nodiscard]] bool hasImportServer();

/// Reads `file` in a child. A child that fails, crashes or is stopped gives an error that names the file.
/// @par Thread Any number at a time, a child each.
[[nodiscard]] core::Result<MeshFile> readInChild(const OpenFile& file, const std::filesystem::path& path,
                                                 const ReadOptions& options);

/// The same for a volume. @param frame, progress  as for `readVolume`
[[nodiscard]] core::Result<VoxelGrid> readVolumeInChild(const OpenFile& file, const std::filesystem::path& path,
                                                        core::FileFrame frame,
                                                        const std::function<bool(double)>& progress);

} // namespace palpate::meshio::internal
