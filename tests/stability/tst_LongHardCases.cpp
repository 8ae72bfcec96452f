// SPDX-License-Identifier: BSD-3-Clause
// Rows that are too slow for every build.
#include "HardCaseTest.h"

class LongHardCases : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void holds_data() { palpate::test::addHardCaseRows(true); }
    void holds() { palpate::test::checkHardCase(); }
};

PALPATE_TEST(LongHardCases)
#include "tst_LongHardCases.moc"
