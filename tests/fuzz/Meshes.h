// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fuzz.h"
#include "formats/MeshFormat.h"

namespace palpate::fuzz {

/// Gives the bytes to a format's guard, and what that lets through to all of the reader; checks the mesh that comes
/// out.
void tryMesh(std::string_view bytes, const meshio::internal::MeshFormat& format, const char* name);

} // namespace palpate::fuzz
