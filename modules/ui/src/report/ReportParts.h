// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/study/Report.h>

#include <QFont>
#include <QRectF>
#include <QString>

class QPainter;

namespace palpate::ui::internal {

/// Translates a text of the report. Control characters and characters that would reorder other texts become visible;
/// line ends are kept.
[[nodiscard]] QString reportText(const core::MessageArgument& text);

/// Returns the typeface of a report. @param size_pt  [pt]; @param unit  length of a point on the device [px]
[[nodiscard]] QFont reportFont(double size_pt, double unit, bool isBold = false);

/// Draws the force over time with axes and the marks of the findings.
/// @param unit  length of a point on the device [px]
void drawForceCurve(QPainter& painter, const QRectF& in, const study::ForceCurve& force, double unit);

} // namespace palpate::ui::internal
