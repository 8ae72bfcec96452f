// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/MeasureSession.h>

#include <QString>
#include <QStringList>

#include <vector>

/// Table of session results; the first row is the header.
struct ResultTable
{
    QString title;
    std::vector<QStringList> rows;
};

/// Makes tables of the session results for display.
/// @param isFingertip  true: the coverage distance equals the fingertip radius
[[nodiscard]] std::vector<ResultTable> resultTables(const palpate::session::SessionMeasures& measures,
                                                    bool isFingertip);
/// Summarises the results in two sentences.
[[nodiscard]] QString summaryOf(const palpate::session::SessionMeasures& measures);
[[nodiscard]] QString toHtml(const std::vector<ResultTable>& tables);
/// Converts to tab-separated rows for spreadsheets, with an empty line between tables.
[[nodiscard]] QString toTsv(const std::vector<ResultTable>& tables);
