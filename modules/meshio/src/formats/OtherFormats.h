// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// @return the root element of an XML document; empty for other content
[[nodiscard]] std::string_view rootElement(std::string_view text);

/// Recognises mesh and scene formats that Palpate does not read.
/// @return an error with the name of the format and the next step; Ok for any other content
[[nodiscard]] core::Status otherMeshFormat(std::string_view bytes, const std::string& file);

} // namespace palpate::meshio::internal
