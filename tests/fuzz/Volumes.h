// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fuzz.h"

namespace palpate::fuzz {

/// The samples of tests/meshio whose name ends so, with their numbers in the same file.
std::vector<std::string> volumeSeeds(std::string_view ending);

/// Reads a volume in this process, by its name, and hands the outcome over as the import process does.
/// @param name  its ending says what it is read as
void tryVolume(std::string_view bytes, const char* name);

/// Takes what an import process could have handed back.
void tryHandedBack(std::string_view bytes);

} // namespace palpate::fuzz
