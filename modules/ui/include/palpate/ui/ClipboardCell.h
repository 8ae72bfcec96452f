// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/CsvCell.h>

#include <QLocale>
#include <QString>

namespace palpate::ui {

/// A text as one cell of a tab-separated table on the clipboard: on one line, and with an apostrophe in front where a
/// spreadsheet would compute it as a formula. Numbers in the notation of the window's language or of C stay as they
/// are.
[[nodiscard]] inline QString clipboardCell(const QString& text)
{
    QString cell = text.simplified();
    bool isNumber = false;
    (void)QLocale().toDouble(cell, &isNumber);
    if (!isNumber) {
        (void)cell.toDouble(&isNumber);
    }
    return !isNumber && core::looksLikeFormula(cell.toStdString()) ? QLatin1Char('\'') + cell : cell;
}

} // namespace palpate::ui
