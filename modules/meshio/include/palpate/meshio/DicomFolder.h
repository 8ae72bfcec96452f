// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <filesystem>

namespace palpate::meshio {

/// Recognises a folder of DICOM images, which Palpate does not read.
/// @return an error with the next step; Ok for any other folder, for a file, and for a folder that cannot be read
/// @par Cost Reads the beginning of at most 50 files.
[[nodiscard]] PALPATE_EXPORT core::Status dicomFolder(const std::filesystem::path& folder);

} // namespace palpate::meshio
