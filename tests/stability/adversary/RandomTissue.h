// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomScene.h"

namespace palpate::adversary {

/// Randomly gives the scene's structures friction, laws, and maps of stiffness, damping and friction.
void makeRough(RandomScene& scene, Chance& chance);

} // namespace palpate::adversary
