// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/HtmlStyle.h>

namespace palpate::evaluation {

using study::kChartStyle;
using study::kReportStyle;

} // namespace palpate::evaluation
