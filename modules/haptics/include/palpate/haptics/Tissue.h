// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Tissue.h>

namespace palpate::haptics {

using core::Tissue;

} // namespace palpate::haptics
