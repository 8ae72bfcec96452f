// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>
#include <string_view>

namespace palpate::meshio::internal {

/// Writes a file whole or not at all, as QSaveFile does.
[[nodiscard]] core::Status writeAtomically(const std::filesystem::path& path, std::string_view bytes);

} // namespace palpate::meshio::internal
