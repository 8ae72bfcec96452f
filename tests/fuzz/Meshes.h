// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fuzz.h"
#include "formats/MeshFormat.h"

namespace palpate::fuzz {

/// Passes the bytes to a format's guard and accepted input to the reader; checks the resulting mesh.
void tryMesh(std::string_view bytes, const meshio::internal::MeshFormat& format, const char* name);

} // namespace palpate::fuzz
