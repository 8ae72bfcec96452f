// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace palpate::meshio::internal {

enum class FileKind : std::uint8_t
{
    StlBinary,
    StlAscii,
    Vtp,
    Obj,
    Ply
};

/// Tells what a file is from its bytes; the extension decides only where they leave it open.
/// @return an error that names what it is instead: empty, a web page, a Git LFS pointer, another known format
[[nodiscard]] core::Result<FileKind> fileKind(std::string_view bytes, const std::filesystem::path& path);

/// @return true for an extension of a mesh file that `readMesh` reads.
[[nodiscard]] bool hasMeshExtension(const std::filesystem::path& path);

} // namespace palpate::meshio::internal
