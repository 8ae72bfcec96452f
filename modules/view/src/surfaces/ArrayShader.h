// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>

#include <string>

namespace palpate::view {

/// Replaces the colours of a surface by a fragment program that reads a point array as `shadedVSOutput`, a float or,
/// for two components, a vec2.
/// @param fragment  replaces //VTK::Color::Impl
void shadeByArray(vtkActor& actor, const char* array, int components, const std::string& fragment);

/// Removes the program of shadeByArray.
void removeArrayShader(vtkActor& actor);

} // namespace palpate::view
