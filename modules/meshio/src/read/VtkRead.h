// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/MeshFormat.h"
#include "guard/FileImage.h"
#include "guard/PreScan.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::meshio::internal {

/// Reads a pre-scanned image with VTK's reader of the format and compares the counts of points and cells with the
/// pre-scan. @return VTK's first error message on failure
[[nodiscard]] core::Result<vtkSmartPointer<vtkPolyData>> readWithVtk(const MeshFormat& format, const FileImage& image,
                                                                     const PreScan& scan, const ScanContext& context);

} // namespace palpate::meshio::internal
