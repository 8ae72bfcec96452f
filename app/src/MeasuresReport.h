// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/MeasureSession.h>

#include <QJsonObject>

#include <string>

namespace palpate::app {

void printMeasures(const session::SessionMeasures& measures);
[[nodiscard]] std::string measuresJson(const session::SessionMeasures& measures);
/// The sums alone, as every JSON that the program writes says them.
[[nodiscard]] QJsonObject sumsJson(const session::Measures& sums);

} // namespace palpate::app
