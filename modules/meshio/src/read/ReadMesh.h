// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/FileImage.h"

#include "palpate/meshio/MeshFile.h"

namespace palpate::meshio::internal {

/// Decodes the bytes of a mesh file. A pure function of the bytes, the file name and the options, so that another
/// process can run it.
[[nodiscard]] core::Result<MeshFile> decodeMesh(FileImage image, const std::filesystem::path& path,
                                                const ReadOptions& options);

/// Reads a file in this process.
[[nodiscard]] core::Result<MeshFile> readHere(const std::filesystem::path& path, const ReadOptions& options);

} // namespace palpate::meshio::internal
