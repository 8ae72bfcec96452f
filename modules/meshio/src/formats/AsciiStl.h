// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"

namespace palpate::meshio::internal {

/// @return true for a text that begins as an ASCII STL does: with "solid", glued to a name or not.
[[nodiscard]] bool startsWithSolid(std::string_view bytes);

/// Same, or without "solid", or with other lines above: a text that contains a facet.
[[nodiscard]] bool looksLikeAsciiStl(std::string_view bytes);

/// Checks an ASCII STL line by line, or keyword by keyword if several are on a line, and rewrites the image as a binary
/// STL of the same facets: the dialects of the many writers end here, and VTK's reader neither splits long lines nor
/// mistakes a name for binary content.
[[nodiscard]] core::Result<PreScan> guardAsciiStl(FileImage& image, const ScanContext& context);

} // namespace palpate::meshio::internal
