// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/VtpHeader.h"
#include "guard/FileImage.h"

namespace palpate::meshio::internal {

/// Removes padding behind the document, which is no XML.
[[nodiscard]] core::Status removePadding(FileImage& image, const ScanContext& context);

/// Overwrites the pieces without points by blanks: VTK's reader requires points in the first piece. Where the text does
/// not show clearly which pieces these are, the image stays as it is.
void removeEmptyPieces(FileImage& image, const VtpHeader& header);

/// Makes numbers in arrays of floating-point text readable to VTK, whose reader extracts them from a stream: it reads
/// "nan" and "inf" only with a character behind, neither "1.#QNAN" and "nan(ind)" of Microsoft's libraries nor numbers
/// beyond the range of the type. Only coordinates may be beyond the range: a point that no face uses does no harm.
[[nodiscard]] core::Status makeNumbersReadable(FileImage& image, const ScanContext& context);

} // namespace palpate::meshio::internal
