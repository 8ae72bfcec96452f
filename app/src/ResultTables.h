// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/MeasureSession.h>

#include <QString>
#include <QStringList>

#include <vector>

/// A table of what a session says; the first row is its head.
struct ResultTable
{
    QString title;
    std::vector<QStringList> rows;
};

/// What a session says in numbers, as a person reads it.
/// @param isFingertip  the distance of the coverage is the radius of the fingertip that touched
[[nodiscard]] std::vector<ResultTable> resultTables(const palpate::session::SessionMeasures& measures,
                                                    bool isFingertip);
[[nodiscard]] QString toHtml(const std::vector<ResultTable>& tables);
/// Rows of cells with a tab between them, as spreadsheets take them; an empty line between two tables.
[[nodiscard]] QString toTsv(const std::vector<ResultTable>& tables);
