// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TestRunner.h"

#include <palpate/evaluation/HardCases.h>

namespace palpate::test {

inline void addHardCaseRows(bool isLong)
{
    QTest::addColumn<int>("index");
    const auto& cases = evaluation::hardCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].isLong == isLong) {
            QTest::newRow(cases[i].name.c_str()) << static_cast<int>(i);
        }
    }
}

inline void checkHardCase()
{
    QFETCH(int, index);
    const evaluation::HardCaseResult result = evaluation::run(evaluation::hardCases()[static_cast<std::size_t>(index)]);
    QVERIFY(result.ticks > 0 && result.triangles > 0);
    QString failed, all;
    for (const evaluation::HardCaseFigure& f : result.figures) {
        all += QString("; %1 %2").arg(QString::fromStdString(f.what)).arg(f.measured);
        if (!f.passed()) {
            failed += QString("%1: %2, bound %3, at tick %4; ")
                          .arg(QString::fromStdString(f.what))
                          .arg(f.measured)
                          .arg(f.bound)
                          .arg(f.worstTick);
        }
    }
    qInfo("%s", qPrintable(QString("%1 triangles, %2 ticks").arg(result.triangles).arg(result.ticks) + all));
    QVERIFY2(failed.isEmpty(), qPrintable(failed));
}

} // namespace palpate::test
