// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/MeasureSession.h>

namespace palpate::app {

void printMeasures(const session::SessionMeasures& measures);

} // namespace palpate::app
