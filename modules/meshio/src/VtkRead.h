// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileImage.h"
#include "FileKind.h"
#include "PreScan.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::meshio::internal {

/// Reads a pre-scanned image with VTK's reader of its kind and compares what came with what the pre-scan counted.
/// @return VTK's own words when it fails
[[nodiscard]] core::Result<vtkSmartPointer<vtkPolyData>> readWithVtk(FileKind kind, const FileImage& image,
                                                                     const PreScan& scan, const ScanContext& context);

} // namespace palpate::meshio::internal
