// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/MeshFile.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace palpate::meshio::internal {

class WireHeadReader;

// An outcome is a sequence of frames (Wire.h): the data common to all structures, each structure, and the end with the
// status. The reader process may hand over structures before the outcome is known.

/// Appends the last structure of `file` to a memory file, before it also the data common to all structures if it is
/// the first, and frees the mesh.
/// @return false when writing fails
[[nodiscard]] bool writeStructure(int descriptor, MeshFile& file);

/// Appends the rest of the outcome of a read, and frees each structure once written.
/// @param written  number of structures that `writeStructure` has written
/// @return false when writing fails
[[nodiscard]] bool writeOutcome(int descriptor, core::Result<MeshFile> outcome, std::size_t written = 0);

/// Reads an outcome from a memory file and releases the file's pages on the way, so that a large mesh is never in
/// memory twice. The content is untrusted: checks every size, index, coordinate and text of each frame on its own.
class OutcomeReader
{
  public:
    /// @param path  the mesh file, for messages
    OutcomeReader(int descriptor, const std::filesystem::path& path);
    /// Reads the next structure, which becomes the last of `file`.
    /// @return false if there is none or it is damaged; then `finish` has the outcome
    [[nodiscard]] bool readStructure();
    [[nodiscard]] MeshFile& file() noexcept { return m_file; }
    /// Reads the remaining frames, whose number must be as stated.
    [[nodiscard]] core::Result<MeshFile> finish() &&;

  private:
    struct Counts
    {
        std::uint64_t vertices, triangles;
    };
    void readNext();
    [[nodiscard]] core::Message takeCommon(WireHeadReader& head);
    [[nodiscard]] core::Message takeStructure(WireHeadReader& head, std::uint64_t begin, std::uint64_t size);
    [[nodiscard]] core::Message moveMesh(const Counts& counts, geometry::TriangleMesh& mesh);
    [[nodiscard]] core::Status takeEnd(WireHeadReader& head, bool isLast);

    int m_descriptor;
    std::string m_name; ///< of the mesh file
    std::uint64_t m_at = 0;
    MeshFile m_file;
    core::Status m_status;
    bool m_isBegun = false;
    bool m_isEnded = false; ///< the end or an error was read
};

/// Reads a complete outcome.
[[nodiscard]] core::Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
