// SPDX-License-Identifier: BSD-3-Clause
// Runs the engine on every row of the table of hard cases; a new case is a row in
// modules/evaluation/src/cases/*Rows.cpp.
#include "HardCaseTest.h"

class HardCases : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void holds_data() { palpate::test::addHardCaseRows(false); }
    void holds() { palpate::test::checkHardCase(); }
};

PALPATE_TEST(HardCases)
#include "tst_HardCases.moc"
