// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileImage.h"

#include "palpate/meshio/MeshFile.h"

namespace palpate::meshio::internal {

/// Makes a mesh of a file's bytes: a pure function of them, the file's name and the options, so that another process
/// can do it as well.
[[nodiscard]] core::Result<MeshFile> decodeMesh(FileImage image, const std::filesystem::path& path,
                                                const ReadOptions& options);

/// Reads a file in this process.
[[nodiscard]] core::Result<MeshFile> readHere(const std::filesystem::path& path, const ReadOptions& options);

} // namespace palpate::meshio::internal
