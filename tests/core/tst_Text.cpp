// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Text.h>

#include <limits>

using namespace palpate;

class Text : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void digitsStandInThrees()
    {
        QCOMPARE(core::grouped(0), std::string("0"));
        QCOMPARE(core::grouped(999), std::string("999"));
        QCOMPARE(core::grouped(1000), std::string("1,000"));
        QCOMPARE(core::grouped(52114U), std::string("52,114"));
        QCOMPARE(core::grouped(std::size_t{1234567}), std::string("1,234,567"));
        QCOMPARE(core::grouped(-100), std::string("-100"));
        QCOMPARE(core::grouped(-123456), std::string("-123,456"));
        QCOMPARE(core::grouped(std::numeric_limits<long long>::min()), std::string("-9,223,372,036,854,775,808"));
        QCOMPARE(core::grouped(std::numeric_limits<std::uint64_t>::max()), std::string("18,446,744,073,709,551,615"));
    }

    void whatIsQuotedFitsALine()
    {
        QCOMPARE(core::inQuotes(""), std::string("\"\""));
        QCOMPARE(core::inQuotes("left lobe"), std::string("\"left lobe\""));
        QCOMPARE(core::inQuotes("a\nb\x7f\tc"), std::string("\"a?b??c\""));
        QCOMPARE(core::inQuotes(std::string(40, 'x')), '"' + std::string(40, 'x') + '"');
        QCOMPARE(core::inQuotes(std::string(41, 'x')), '"' + std::string(40, 'x') + "…\"");
    }

    void noCharacterIsCutInTwo()
    {
        std::string text(39, 'x');
        text += "äb"; // its two bytes are the 40th and the 41st
        QCOMPARE(core::inQuotes(text), '"' + std::string(39, 'x') + "…\"");
        QCOMPARE(core::inQuotes(std::string(60, '\x80')), std::string("\"…\"")); // no character begins
    }
};

PALPATE_TEST(Text)
#include "tst_Text.moc"
