// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QFontMetrics>
#include <QString>
#include <QStringList>

namespace palpate::ui {

/// Shortens a name in the middle, so that it can be told from other names: where these would have the same short form,
/// the part that differs is kept instead.
/// @param width  of the result [px]; @param others  names in the same list, with or without `name` itself
[[nodiscard]] PALPATE_EXPORT QString elidedName(const QString& name, const QFontMetrics& metrics, int width,
                                                const QStringList& others);

} // namespace palpate::ui
