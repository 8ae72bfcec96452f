// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Quantity.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using palpate::core::appendNumber;
using palpate::core::parseNumber;

class Numbers : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsDecimalNumbers_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("integer") << QByteArray("12") << 12.0;
        QTest::newRow("fraction") << QByteArray("-0.5") << -0.5;
        QTest::newRow("plus") << QByteArray("+2.5") << 2.5;
        QTest::newRow("exponent") << QByteArray("1e3") << 1000.0;
        QTest::newRow("capital exponent") << QByteArray("1E-3") << 0.001;
        QTest::newRow("leading point") << QByteArray(".25") << 0.25;
        QTest::newRow("trailing point") << QByteArray("4.") << 4.0;
        QTest::newRow("blanks") << QByteArray(" \t3.5 \r") << 3.5;
        QTest::newRow("denormal") << QByteArray("5e-324") << std::numeric_limits<double>::denorm_min();
    }
    void readsDecimalNumbers()
    {
        QFETCH(QByteArray, text);
        QFETCH(double, value);
        const auto read = parseNumber({text.constData(), static_cast<std::size_t>(text.size())});
        QVERIFY(read.has_value());
        QVERIFY(*read == value);
    }

    void refusesWhatIsNoNumber_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const char* text :
             {"", " ", "+", "-", "+-1", "++1", "1,5", "1.5mm", "0x10", "1 2", "e3", ".", "1e", "--1"}) {
            QTest::newRow(text) << QByteArray(text);
        }
        QTest::newRow("zero byte") << QByteArray("1\0", 2);
    }
    void refusesWhatIsNoNumber()
    {
        QFETCH(QByteArray, text);
        QVERIFY(!parseNumber({text.constData(), static_cast<std::size_t>(text.size())}).has_value());
    }

    void leavesFinitenessToTheCaller()
    {
        QVERIFY(std::isnan(parseNumber("nan").value_or(0.0)));
        QVERIFY(std::isinf(parseNumber("-inf").value_or(0.0)));
    }

    void givesEveryDoubleBackBitForBit()
    {
        std::mt19937_64 random(20260101); // NOLINT: a fixed seed
        int wrong = 0;
        for (int i = 0; i < 200'000; ++i) {
            const auto value = std::bit_cast<double>(random());
            if (!std::isfinite(value)) {
                continue;
            }
            std::string text;
            appendNumber(text, value);
            const auto read = parseNumber(text);
            wrong += !read || std::bit_cast<std::uint64_t>(*read) != std::bit_cast<std::uint64_t>(value) ? 1 : 0;
        }
        QCOMPARE(wrong, 0);
        QCOMPARE(palpate::core::shortNumber(0.57), std::string("0.57"));
        QCOMPARE(palpate::core::shortNumber(-1e300), std::string("-10³⁰⁰"));
        QCOMPARE(palpate::core::shortNumber(2.0 / 3.0, 3), std::string("0.667"));
    }

    void messagesHaveNoExponents_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("digits");
        QTest::addColumn<QString>("text");
        QTest::newRow("body in ml") << 79312.4 << 3 << "79300";
        QTest::newRow("all digits known") << 79312.4 << 6 << "79312.4";
        QTest::newRow("rounded up to another digit") << 99999.0 << 3 << "100000";
        QTest::newRow("zeros at the end") << 12.5000 << 6 << "12.5";
        QTest::newRow("small") << 2.34e-5 << 2 << "0.000023";
        QTest::newRow("least") << -1e-6 << 6 << "-0.000001";
        QTest::newRow("smaller") << 2.34e-13 << 2 << "2.3·10⁻¹³";
        QTest::newRow("greatest") << 1e15 << 6 << "1000000000000000";
        QTest::newRow("greater") << 1.5e16 << 6 << "1.5·10¹⁶";
        QTest::newRow("zero") << 0.0 << 6 << "0";
        QTest::newRow("below zero by rounding") << -0.0 << 6 << "0";
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 3 << "inf";
    }
    void messagesHaveNoExponents()
    {
        QFETCH(double, value);
        QFETCH(int, digits);
        QTEST(QString::fromStdString(palpate::core::shortNumber(value, digits)), "text");
    }

    void sizesHaveTheUnitThatFits_data()
    {
        QTest::addColumn<palpate::core::Message>("size");
        QTest::addColumn<QString>("text");
        using namespace palpate::core;
        QTest::newRow("body") << volumeText(7.9312e7, 3) << "79.3 l";
        QTest::newRow("liver") << volumeText(1.52e6) << "1520 ml";
        QTest::newRow("ten litres by rounding") << volumeText(9999990.0) << "10 l";
        QTest::newRow("lump") << volumeText(4188.79) << "4.189 ml";
        QTest::newRow("nodule") << volumeText(33.51) << "33.51 mm³";
        QTest::newRow("room") << volumeText(2.5e9) << "2.5 m³";
        QTest::newRow("inside out") << volumeText(-4188.79) << "-4.189 ml";
        QTest::newRow("no volume") << volumeText(0.0) << "0 ml";
        QTest::newRow("skin") << areaText(1.834e6) << "1.834 m²";
        QTest::newRow("surface of a lump") << areaText(1256.6) << "12.57 cm²";
        QTest::newRow("contact") << areaText(78.54) << "78.54 mm²";
        QTest::newRow("path") << pathText(9999.0) << "9999 mm";
        QTest::newRow("long path") << pathText(79312.0) << "79.31 m";
    }
    void sizesHaveTheUnitThatFits()
    {
        QFETCH(palpate::core::Message, size);
        QTEST(QString::fromStdString(size.english()), "text");
    }

    void ignoresTheLocale()
    {
        const char* found = nullptr;
        for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"}) {
            if (std::setlocale(LC_ALL, name) != nullptr) {
                found = name;
                break;
            }
        }
        if (found == nullptr) {
            QSKIP("no locale with a decimal comma is installed");
        }
        std::string text;
        appendNumber(text, 1.5);
        const auto read = parseNumber("2.25");
        std::setlocale(LC_ALL, "C");
        QCOMPARE(text, std::string("1.5"));
        QVERIFY(read.has_value() && *read == 2.25);
    }
};

PALPATE_TEST(Numbers)
#include "tst_Numbers.moc"
