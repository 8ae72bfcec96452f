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

/// Recognises a DICOM image by its content or by the extension .dcm. @param head  at least the first 132 bytes
[[nodiscard]] bool isDicom(std::string_view head, std::string_view file);
/// @param found  what was found, as a clause
/// @return the error about a DICOM image with the next step
[[nodiscard]] core::Status dicomFault(const std::string& file, const core::Message& found);

} // namespace palpate::meshio::internal
