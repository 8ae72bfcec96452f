// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <Config.h>

using palpate::woodenhaptics::parseConfig;

class Config : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void takesAnOwnersFileAsItIs()
    {
        // With spaces, integers, an unknown field, and the trailing comma in some distributed files.
        const auto read =
            parseConfig("{\n \"variant\": 1,\n \"diameter_capstan_a\": 0.013,\n \"length_body_b\":   0.138,\n"
                        " \"workspace_origin_y\": 0,\n \"cpr_encoder_c\": 4000,\n \"max_linear_force\": 5,\n"
                        " \"calibrate_enc_b\": -12, \"colour\": \"birch\",\n \"g_constant\": 0,\n}\n",
                        "x.json");
        QVERIFY2(read.isOk(), read.status().message().c_str());
        QCOMPARE(read.value().variant, 1);
        QCOMPARE(read.value().capstanDiameter_m[0], 0.013);
        QCOMPARE(read.value().linkLength_m[1], 0.138);
        QCOMPARE(read.value().countsPerTurn[2], 4000.0);
        QCOMPARE(read.value().calibrationCounts[1], -12.0);
        QCOMPARE(read.value().linkLength_m[2], 0.245); // missing in the file: the kit's default
    }

    void refusesNamingFieldFoundAndExpected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("no json") << QByteArray("length_body_a = 3") << QByteArray("expected an object");
        QTest::newRow("cut off") << QByteArray("{\"length_body_a\": 0.08") << QByteArray("at byte");
        QTest::newRow("zero ratio") << QByteArray("{\"diameter_body_b\": 0}") << QByteArray("diameter_body_b: found 0");
        QTest::newRow("text") << QByteArray("{\"cpr_encoder_a\": \"many\"}")
                              << QByteArray("cpr_encoder_a: found no number");
        QTest::newRow("millimetres") << QByteArray("{\"length_body_b\": 205}")
                                     << QByteArray("length_body_b: found 205");
        QTest::newRow("no number") << QByteArray("{\"max_linear_force\": 1e999}") << QByteArray("x.json");
    }

    void refusesNamingFieldFoundAndExpected()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, said);
        const auto read = parseConfig(text.toStdString(), "x.json");
        QVERIFY(!read.isOk());
        QVERIFY2(read.status().message().find(said.toStdString()) != std::string::npos,
                 read.status().message().c_str());
    }
};

PALPATE_TEST(Config)
#include "tst_Config.moc"
