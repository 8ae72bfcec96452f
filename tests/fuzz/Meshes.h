// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fuzz.h"
#include "PreScan.h"

namespace palpate::fuzz {

using Scan = core::Result<meshio::internal::PreScan> (*)(meshio::internal::FileImage&,
                                                         const meshio::internal::ScanContext&);

/// Gives the bytes to a pre-scan, and what that lets through to all of the reader; checks the mesh that comes out.
void tryMesh(std::string_view bytes, Scan scan, const char* name);

} // namespace palpate::fuzz
