// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileImage.h"
#include "PreScan.h"
#include "formats/MeshFormat.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::meshio::internal {

/// Reads a pre-scanned image with VTK's reader of its format and compares what came with what the pre-scan counted.
/// @return VTK's own words when it fails
[[nodiscard]] core::Result<vtkSmartPointer<vtkPolyData>> readWithVtk(const MeshFormat& format, const FileImage& image,
                                                                     const PreScan& scan, const ScanContext& context);

} // namespace palpate::meshio::internal
