// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/ChartAxis.h>

namespace palpate::evaluation {

using study::ChartAxis;
using study::escaped;
using study::shortNumber;

} // namespace palpate::evaluation
