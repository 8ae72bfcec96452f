// SPDX-License-Identifier: BSD-3-Clause
// Messages of the Inverse Service, and whatever else may come from its port.
#include "TestRunner.h"
#include "Trials.h"

#include <Messages.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <clocale>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using namespace palpate::haply;
using palpate::core::Vec3;

namespace {

const std::string kMessage =
    R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3","device_info":{"device_type":)"
    R"("inverse3","id":1181},"basis":{"permutation":"XYZ"},"mount":{"position":{"x":0,"y":0,"z":0}}},"state":{)"
    R"("cursor_position":{"x":0.01,"y":-1.5e-1,"z":2E-1},"current_cursor_force":{"x":0,"y":0,"z":1.25},)"
    R"("transform":{}},"status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true}}],)"
    R"("wireless_verse_grip":[{"device_id":"61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},)"
    R"("buttons":{"a":false,"button_1":true}}}]})";

Reading readMessage(const std::string& text, Update& update)
{
    return readUpdate(text, "049D", "61576", false, update);
}

} // namespace

class HaplyMessages : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsAFullMessage()
    {
        Update update;
        QCOMPARE(readMessage(kMessage, update), Reading::Valid);
        QVERIFY((update.p_m - Vec3(0.01, -0.15, 0.2)).norm() < 1e-12);
        QVERIFY(update.f_N && update.f_N->z() == 1.25);
        QCOMPARE(update.axes, Axes::Default);
        QCOMPARE(update.buttons.value_or(0), 2U);
        QVERIFY(update.q && update.q->w() == 1.0);
        const auto inventory = readInventory(kMessage);
        QVERIFY(inventory && inventory->isNew);
        QCOMPARE(inventory->devices.size(), std::size_t{1});
        QCOMPARE(inventory->devices[0].type, std::string("inverse3"));
        QCOMPARE(inventory->grips, std::vector<std::string>{"61576"});
    }

    /// Any damage gives a refusal, or numbers that a device can have.
    void damagedMessagesGiveBoundedNumbers()
    {
        std::mt19937 random{7};
        const std::string pieces[] = {"1e308", "-1e999",  "NaN",      "null", "{}", "[]",
                                      "\"",    "\\u0000", "\xff\xfe", "{",    "]"};
        int valid = 0, refused = 0;
        for (int i = 0; i < palpate::test::trials(4000); ++i) {
            std::string text = kMessage;
            for (unsigned n = random() % 4; n < 4; ++n) {
                const std::size_t at = random() % text.size();
                switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                case 2:
                    text.insert(at, pieces[random() % std::size(pieces)]);
                    break;
                default:
                    text[at] = static_cast<char>('0' + random() % 10);
                }
                if (text.empty()) {
                    break;
                }
            }
            (void)readInventory(text);
            (void)readVersion(text);
            Update update;
            if (readMessage(text, update) != Reading::Valid) {
                ++refused;
                continue;
            }
            ++valid;
            QVERIFY(update.p_m.allFinite() && update.p_m.cwiseAbs().maxCoeff() <= 0.6);
            QVERIFY(!update.f_N || update.f_N->allFinite());
            QVERIFY(!update.q || std::abs(update.q->norm() - 1.0) < 1e-9);
        }
        QVERIFY(valid > 50 && refused > 50);
    }

    void deepNestingIsRefused()
    {
        Update update;
        for (const char* const open : {"[", "{\"a\":", "{\"inverse3\":["}) {
            std::string text;
            while (text.size() < 250'000) {
                text += open;
            }
            QCOMPARE(readMessage(text, update), Reading::Refused);
        }
    }

    /// Numbers have a point in every locale, and an identifier cannot leave its quotes.
    void commandsAreValidJson()
    {
        const char* const before = std::setlocale(LC_NUMERIC, nullptr);
        const std::string restored = before == nullptr ? "C" : before;
        const bool hasGerman = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
        const std::string id = "a\"},{\\\n";
        for (const ForceKey key : {ForceKey::Values, ForceKey::Vector}) {
            const std::string text = forceCommand(id, Vec3(0.5, -1e-9, 1.0 / 3.0), key);
            const QJsonObject device = QJsonDocument::fromJson(QByteArray::fromStdString(text))
                                           .object()
                                           .value(QLatin1String("inverse3"))
                                           .toArray()
                                           .at(0)
                                           .toObject();
            QCOMPARE(device.value(QLatin1String("device_id")).toString().toStdString(), id);
            const QJsonObject force = device.value(QLatin1String("commands"))
                                          .toObject()
                                          .value(QLatin1String("set_cursor_force"))
                                          .toObject()
                                          .value(QLatin1String(key == ForceKey::Vector ? "vector" : "values"))
                                          .toObject();
            QCOMPARE(force.value(QLatin1String("x")).toDouble(), 0.5);
            QCOMPARE(force.value(QLatin1String("y")).toDouble(), -1e-9);
            QCOMPARE(force.value(QLatin1String("z")).toDouble(), 1.0 / 3.0);
        }
        for (const bool isCentred : {false, true}) {
            const std::string text = firstCommand(id, ForceKey::Vector, isCentred);
            QVERIFY2(QJsonDocument::fromJson(QByteArray::fromStdString(text)).isObject(), text.c_str());
        }
        std::setlocale(LC_NUMERIC, restored.c_str());
        if (!hasGerman) {
            qInfo("without a German locale");
        }
    }

    void versionIsReadWithAndWithoutAnEnvelope()
    {
        const auto plain = readVersion(R"({"project_version":"3.12.1-rc2","git_tag":"x"})");
        QVERIFY(plain && plain->major == 3 && plain->minor == 12);
        const auto wrapped = readVersion(R"({"ok":true,"data":{"project_version":"3.5.0"}})");
        QVERIFY(wrapped && wrapped->minor == 5);
        for (const char* const text : {"", "[]", "{}", R"({"project_version":3.5})", R"({"project_version":"three"})",
                                       R"({"project_version":"3"})", R"({"project_version":"99999999999.1"})"}) {
            QVERIFY2(!readVersion(text), text);
        }
    }
};

PALPATE_TEST(HaplyMessages)
#include "tst_HaplyMessages.moc"
