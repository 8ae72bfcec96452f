// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "OtherSurfaces.h"
#include "Samples.h"
#include "Volumes.h"

namespace palpate::fuzz {

namespace gzip {

std::vector<std::string> seeds()
{
    return {test::gzipped(test::offBox()), test::gzipped(test::asciiStl()),
            test::gzipped(test::mniBox()) + "\x1f\x8b\x08"};
}

/// Packed meshes of any format. Changed bytes rarely unpack, so that the bytes are also packed as they are.
void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kOff, "a.off.gz");
    if (!bytes.empty()) { // which qCompress does not pack
        tryMesh(test::gzipped(std::string(bytes)), meshio::internal::kOff, "a.stl.gz");
    }
}

} // namespace gzip

extern const Target kGzip{"gzip", 200, gzip::seeds, gzip::tryInput};

} // namespace palpate::fuzz
