// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fuzz.h"

namespace palpate::fuzz {

/// Returns the samples of tests/meshio with that name extension, with their voxels in the same file.
std::vector<std::string> volumeSeeds(std::string_view ending);

/// Returns label maps of this format, plain and packed, with names.
std::vector<std::string> labelSeeds(std::string_view ending);

/// Returns displacement fields of this format.
std::vector<std::string> fieldSeeds(std::string_view ending);

/// Reads a volume and a displacement field by name in this process and passes both results on as the import process
/// does.
/// @param name  its extension selects the format
void tryVolume(std::string_view bytes, const char* name);

/// Parses a possible reply of an import process.
void tryHandedBack(std::string_view bytes);

} // namespace palpate::fuzz
