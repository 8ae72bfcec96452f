// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Text.h>
#include <palpate/core/VisibleText.h>

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

    void showsWhatATerminalWouldActUpon()
    {
        QCOMPARE(core::visible("left lobe, Größe 5 mm"), std::string("left lobe, Größe 5 mm"));
        QCOMPARE(core::visible("\x1b[2J\x07"), std::string("\\x1b[2J\\x07"));
        QCOMPARE(core::visible("a\nb\rc\td\x7f"), std::string("a\\nb\\rc\\td\\x7f"));
        QCOMPARE(core::visible("\u009b1m"), std::string("\\x9b1m")); // C1: the same as ESC [
        QCOMPARE(core::visible("liver\u202egpj.exe"), std::string("liver\\u202egpj.exe"));
        QCOMPARE(core::visible("\u2066a\u2069\u200f\u2028"), std::string("\\u2066a\\u2069\\u200f\\u2028"));
        QCOMPARE(core::visible(std::string("a\0b", 3)), std::string("a\\x00b"));
        QCOMPARE(core::visible("\U0001F9EC"), std::string("\U0001F9EC"));
    }

    void showsBytesThatAreNotUtf8()
    {
        QCOMPARE(core::visible("caf\xe9"), std::string("caf\\xe9")); // Latin-1
        QCOMPARE(core::visible("\x9b"
                               "2J"),
                 std::string("\\x9b2J"));                                        // C1 as a single byte
        QCOMPARE(core::visible("\xc0\xaf"), std::string("\\xc0\\xaf"));          // overlong "/"
        QCOMPARE(core::visible("\xed\xa0\x80"), std::string("\\xed\\xa0\\x80")); // a surrogate
        QCOMPARE(core::visible("\xe2\x82"), std::string("\\xe2\\x82"));          // truncated
    }

    void keepsJsonTheSame()
    {
        QCOMPARE(core::visibleJson("{\n \"a\": \"\\u001b\u202e\x7f\"\n}"),
                 std::string("{\n \"a\": \"\\u001b\\u202e\\u007f\"\n}"));
    }

    void noCharacterIsCutInTwo()
    {
        std::string text(39, 'x');
        text += "äb"; // the two bytes are the 40th and the 41st
        QCOMPARE(core::inQuotes(text), '"' + std::string(39, 'x') + "…\"");
        QCOMPARE(core::inQuotes(std::string(60, '\x80')), std::string("\"…\"")); // no start of a character
    }
};

PALPATE_TEST(Text)
#include "tst_Text.moc"
