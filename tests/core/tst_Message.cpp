// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <limits>
#include <string>
#include <type_traits>

using palpate::core::Count;
using palpate::core::MessageArgument;
using palpate::core::StatusCode;

class Message : public QObject
{
    Q_OBJECT
    using Sentence = palpate::core::Message;

  private Q_SLOTS:
    void fillsEachPlace()
    {
        const Sentence message(PALPATE_TEXT("%2 of %1 at %3 % and %1"), std::filesystem::path("a.stl"), 7, 0.25);
        QCOMPARE(message.english(), std::string("7 of a.stl at 0.25 % and a.stl"));
        QCOMPARE(message.text(), std::string("%2 of %1 at %3 % and %1"));
    }

    void aNameIsNotATemplate()
    {
        QCOMPARE(Sentence(PALPATE_TEXT("%1: %2"), "100%2.stl", "b").english(), std::string("100%2.stl: b"));
    }

    void countsAreGrouped()
    {
        QCOMPARE(Sentence(PALPATE_TEXT("%1 triangles"), Count(1234567)).english(), std::string("1,234,567 triangles"));
        QCOMPARE(Sentence(PALPATE_TEXT("%1"), Count(std::numeric_limits<std::int64_t>::min())).english(),
                 std::string("-9,223,372,036,854,775,808"));
        QCOMPARE(Sentence(PALPATE_TEXT("tick %1"), 1234567).english(), std::string("tick 1234567"));
    }

    void holdsMessages()
    {
        const Sentence part(PALPATE_TEXT("line %1"), 12);
        const Sentence whole(PALPATE_TEXT("%1: found %2"), part, "x");
        QCOMPARE(whole.english(), std::string("line 12: found x"));
        QVERIFY(whole.arguments()[0].kind == MessageArgument::Kind::Message);
        QCOMPARE(whole.arguments()[0].message->text(), std::string("line %1"));
        QVERIFY(whole.arguments()[1].kind == MessageArgument::Kind::Name);
    }

    void joinsInOrder()
    {
        QVERIFY(palpate::core::joined({}).isEmpty());
        QCOMPARE(palpate::core::joined(
                     {Sentence(PALPATE_TEXT("a")), Sentence(PALPATE_TEXT("b")), Sentence(PALPATE_TEXT("c"))})
                     .english(),
                 std::string("a; b; c"));
    }

    void isMadeFromPartsOfAnotherProcess()
    {
        QCOMPARE(Sentence::fromParts("%1 and %2", {MessageArgument("x")}).english(), std::string("x and %2"));
        QCOMPARE(Sentence::untranslated("disk 50%1").english(), std::string("disk 50%1"));
        QVERIFY(Sentence::untranslated("").isEmpty());
    }

    /// Text that is put together at run time has no entry in a catalogue.
    void isNotMadeFromText()
    {
        QVERIFY((!std::is_constructible_v<Sentence, std::string>));
        QVERIFY((!std::is_constructible_v<Sentence, const char*>));
        QVERIFY((!std::is_constructible_v<palpate::core::Status, StatusCode, std::string>));
        QVERIFY((!std::is_constructible_v<palpate::core::Status, StatusCode, const char*>));
    }

    void roundsToTheWantedDigits()
    {
        const Sentence message(PALPATE_TEXT("%1 mm, %2 mm"), palpate::core::Rounded{0.61803, 2}, 0.6180339887);
        QCOMPARE(message.english(), std::string("0.62 mm, 0.618034 mm"));
    }

    void statusCarriesIt()
    {
        const palpate::core::Status status(StatusCode::Empty, PALPATE_TEXT("found %1 rows"), 0);
        QCOMPARE(status.message(), std::string("found 0 rows"));
        QCOMPARE(status.at("a.csv").message(), std::string("a.csv: found 0 rows"));
        QVERIFY(status.at("a.csv").code() == StatusCode::Empty);
        QVERIFY(palpate::core::Status().at("a.csv").isOk());
    }
};

PALPATE_TEST(Message)
#include "tst_Message.moc"
