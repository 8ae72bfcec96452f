// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/ChartAxis.h"

#include <palpate/study/SvgChart.h>

namespace palpate::evaluation {

using study::MarkShape;
using study::SvgChart;

} // namespace palpate::evaluation
