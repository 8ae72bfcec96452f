// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "TestRunner.h"

#include <palpate/study/FindingsFile.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTemporaryDir>

#include <algorithm>
#include <limits>
#include <string>

using namespace palpate;
using core::Finding;
using core::FindingType;

/// Tests findings as a table and as markups: export for other programs, and import of their files.
class FindingsFile : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    static std::vector<Finding> several()
    {
        return {{.name = "=SUM(A1)",
                 .p_W = {0.1, -2.0, 1e-300},
                 .note = "hard,\n\"as a pea\"",
                 .structure = "liver",
                 .force_N = 2.5,
                 .depth_mm = 5.0,
                 .layers = {{"liver", 0.75, 5.0}, {"lump", 1.0 / 3.0, 2.0}},
                 .id = "a",
                 .type = FindingType::Lump,
                 .size_mm = 12.0,
                 .camera = core::ViewPose{{1, 2, 1.0 / 3.0}, {0, 0, 0}, {0, 0, 1}, 30},
                 .recording = core::RecordedMoment{"/somewhere/r.palpate", {}, 1500, 1.5},
                 .marked_utc = "2026-11-23T00:24:54Z"},
                {.name = "edge", .p_W = {-5, 6, 7}, .id = "b", .type = FindingType::KeepAway},
                {.name = "Gefäß 血管", .p_W = {1, 1, 1}, .id = "c", .type = FindingType::Lump, .size_mm = 20.0},
                {.name = "Note 4", .note = "-1 is no number", .id = "d", .hasPlace = false}};
    }

    core::Result<study::Markups> read(const QByteArray& text)
    {
        const QString path = m_folder.filePath("a.mrk.json");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
            return core::Status(core::StatusCode::Internal, PALPATE_TEXT("the test's file"));
        }
        file.close();
        return study::readMarkups(path.toStdString());
    }

    static QByteArray list(const char* fields, const char* points)
    {
        return "{\"@schema\": \"https://x/markups-schema-v1.0.3.json#\", \"markups\": [{\"type\": \"Fiducial\", " +
               QByteArray(fields) + "\"controlPoints\": [" + QByteArray(points) + "]}]}";
    }

    /// Checks the rules of 3D Slicer's schema 1.0.3 for the exported file.
    static void checkRules(const QJsonObject& document)
    {
        QVERIFY(document["@schema"].toString().contains("markups-schema-v1.0.3.json"));
        QVERIFY(document["markups"].isArray());
        const auto isNumbers = [](const QJsonValue& value, qsizetype count, double low, double high) {
            const QJsonArray numbers = value.toArray();
            return value.isArray() && numbers.size() == count &&
                   std::all_of(numbers.begin(), numbers.end(), [&](const QJsonValue& one) {
                       return one.isDouble() && one.toDouble() >= low && one.toDouble() <= high;
                   });
        };
        constexpr double kAny = std::numeric_limits<double>::max();
        for (const QJsonValue& value : document["markups"].toArray()) {
            const QJsonObject one = value.toObject();
            QVERIFY((QSet<QString>{"Fiducial", "Line", "Angle", "Curve", "ClosedCurve", "Plane", "ROI"})
                        .contains(one["type"].toString()));
            QVERIFY(one["name"].isString() && one["labelFormat"].isString());
            QVERIFY((QSet<QString>{"LPS", "RAS"}).contains(one["coordinateSystem"].toString()));
            QVERIFY((QSet<QString>{"mm", "um"}).contains(one["coordinateUnits"].toString()));
            QVERIFY(one["locked"].isBool() && one["fixedNumberOfControlPoints"].isBool());
            const QJsonObject display = one["display"].toObject();
            for (const char* colour : {"color", "selectedColor", "activeColor"}) {
                QVERIFY2(isNumbers(display[colour], 3, 0.0, 1.0), colour);
            }
            for (const char* flag :
                 {"visibility", "propertiesLabelVisibility", "pointLabelsVisibility", "useGlyphScale"}) {
                QVERIFY2(display[flag].isBool(), flag);
            }
            QVERIFY(display["opacity"].toDouble(-1) >= 0.0 && display["opacity"].toDouble(2) <= 1.0);
            for (const char* size : {"textScale", "glyphScale", "glyphSize"}) {
                QVERIFY2(display[size].toDouble(-1.0) >= 0.0, size);
            }
            QVERIFY((QSet<QString>{"Vertex2D", "Cross2D", "Sphere3D", "Diamond3D", "Circle2D"})
                        .contains(display["glyphType"].toString()));
            QSet<QString> ids;
            for (const QJsonValue& entry : one["controlPoints"].toArray()) {
                const QJsonObject point = entry.toObject();
                for (const char* text : {"id", "label", "description", "associatedNodeID"}) {
                    QVERIFY2(point[text].isString(), text);
                }
                QVERIFY(!ids.contains(point["id"].toString()));
                ids << point["id"].toString();
                QVERIFY(!point.contains("position") || isNumbers(point["position"], 3, -kAny, kAny));
                QVERIFY(isNumbers(point["orientation"], 9, -kAny, kAny));
                QVERIFY(point["selected"].isBool() && point["locked"].isBool() && point["visibility"].isBool());
                QVERIFY(
                    (QSet<QString>{"undefined", "preview", "defined"}).contains(point["positionStatus"].toString()));
                QCOMPARE(point["positionStatus"].toString() == "defined", point.contains("position"));
            }
        }
    }

  private Q_SLOTS:
    void aLineBecomesAFindingOfItsLength()
    {
        QByteArray text = list("\"name\": \"size\", \"coordinateSystem\": \"RAS\", ",
                               "{\"position\": [0, 0, 10]}, {\"position\": [6, 8, 10]}");
        text.replace("\"Fiducial\"", "\"Line\"");
        const auto markups = read(text);
        QVERIFY2(markups.isOk(), markups.status().message().c_str());
        QVERIFY(markups.value().losses.empty());
        QCOMPARE(markups.value().findings.size(), std::size_t{1});
        const core::Finding& line = markups.value().findings[0];
        QCOMPARE(line.name, std::string("size"));
        QVERIFY(line.hasPlace && line.p_W == core::Vec3(-3, -4, 10));
        QCOMPARE(line.size_mm, std::optional(10.0));
    }

    void theTableIsOneThatSpreadsheetsReadAndDoNotCompute()
    {
        const std::string expected =
            "id,name,type,structure,x_mm,y_mm,z_mm,frame,size_mm,force_N,depth_mm,felt_N_per_mm,marked_s,recording,"
            "note,"
            "inside,total_force_N\r\n"
            "a,'=SUM(A1),lump,liver,0.1,-2,1e-300,LPS,12,2.5,5,0.5,1.5,r.palpate,\"hard,\n\"\"as a pea\"\"\",,2.5\r\n"
            "b,edge,keep away,,-5,6,7,LPS,,,,,,,,,\r\n"
            "c,Gefäß 血管,lump,,1,1,1,LPS,20,,,,,,,,\r\n"
            "d,Note 4,other,,,,,,,,,,,,'-1 is no number,,\r\n";
        QCOMPARE(QString::fromStdString(study::findingsCsv(several())), QString::fromStdString(expected));
        // Below a depth of one millimetre there is no stiffness; without an id the number takes its place.
        const std::string shallow =
            study::findingsCsv({{.name = "@x", .p_W = {0, 0, 0}, .force_N = 1.0, .depth_mm = 0.5}});
        QVERIFY2(shallow.ends_with("\r\n1,'@x,other,,0,0,0,LPS,,1,0.5,,,,,,1\r\n"), shallow.c_str());
    }

    /// The structure in contact is named together with the enclosing organ and its own numbers; equally for a lump as a
    /// layer and a lump transmitted through its organ.
    void aLumpIsNamedWithItsOrgan()
    {
        core::Finding layer{.name = "a", .structure = "lump", .force_N = 3.5, .depth_mm = 5.0};
        layer.layers = {{"liver", 2.5, 12.5}, {"lump", 3.5, 5.0}};
        core::Finding through{.name = "b", .structure = "lump", .force_N = 2.0, .depth_mm = 8.0};
        through.layers = {{"liver", 2.0, 8.0}};
        QCOMPARE(study::organOf(layer), std::string("liver"));
        QCOMPARE(study::organOf(through), std::string("liver"));
        const std::string table = study::findingsCsv({layer, through});
        QVERIFY2(table.find("1,a,other,lump,0,0,0,LPS,,3.5,5,0.7,,,,liver,6\r\n") != std::string::npos, table.c_str());
        QVERIFY2(table.find("2,b,other,lump,0,0,0,LPS,,2,8,0.25,,,,liver,2\r\n") != std::string::npos, table.c_str());
        const std::string markups = study::findingsMarkups({layer, through});
        QVERIFY(markups.find("lump in liver, 3.50 N, 5.00 mm deep, 0.70 N/mm") != std::string::npos);
        QVERIFY(markups.find("lump in liver, 2.00 N, 8.00 mm deep, 0.25 N/mm") != std::string::npos);
    }

    void markupsFollowTheSchemaAndShowTheirColours()
    {
        const QByteArray text = QByteArray::fromStdString(study::findingsMarkups(several()));
        const QJsonObject document = QJsonDocument::fromJson(text).object();
        checkRules(document);
        const QJsonArray lists = document["markups"].toArray();
        QCOMPARE(lists.size(), 3); // lump, keep away, and the list for notes
        const QJsonObject lumps = lists[0].toObject();
        QCOMPARE(lumps["name"].toString(), QString("lump"));
        QCOMPARE(lumps["controlPoints"].toArray().size(), 2);
        const QJsonObject display = lumps["display"].toObject();
        QCOMPARE(display["selectedColor"], display["color"]); // points are selected: otherwise pink
        QCOMPARE(display["useGlyphScale"].toBool(true), false);
        QCOMPARE(display["glyphSize"].toDouble(), 20.0);
        QCOMPARE(lumps["controlPoints"].toArray()[0].toObject()["description"].toString(),
                 QString("hard,\n\"as a pea\"\nliver, 12.00 mm across, 2.50 N, 5.00 mm deep, 0.50 N/mm"));
        QVERIFY(!text.contains("/somewhere")); // paths may contain names of persons
    }

    void markupsComeBackEqual()
    {
        const auto markups = read(QByteArray::fromStdString(study::findingsMarkups(several())));
        QVERIFY2(markups.isOk(), markups.status().message().c_str());
        QVERIFY(markups.value().losses.empty());
        std::vector<Finding> back = markups.value().findings;
        std::sort(back.begin(), back.end(), [](const Finding& a, const Finding& b) { return a.id < b.id; });
        std::vector<Finding> expected = several();
        expected[0].recording.reset();
        QCOMPARE(back.size(), expected.size());
        for (std::size_t i = 0; i < back.size(); ++i) {
            QVERIFY2(back[i] == expected[i], expected[i].name.c_str());
        }
    }

    void foreignPointsAreTurnedAndScaled()
    {
        const auto markups = read(list(R"("name": "Hard area", "coordinateSystem": "RAS", "coordinateUnits": "um", )",
                                       R"({"label": "F-1", "description": "d", "position": [1000, -2000, 3000]})"));
        QVERIFY2(markups.isOk(), markups.status().message().c_str());
        QVERIFY(markups.value().losses.empty());
        QCOMPARE(markups.value().findings.size(), std::size_t{1});
        const Finding& one = markups.value().findings[0];
        QCOMPARE(one.p_W, core::Vec3(-1, 2, 3));
        QCOMPARE(one.name, std::string("F-1"));
        QCOMPARE(one.note, std::string("d"));
        QVERIFY(one.type == FindingType::HardArea && one.id.empty());
    }

    void whatIsBadIsNamedAndTheRestIsTaken_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("loss");
        const char* good = R"({"label": "good", "position": [1, 2, 3]})";
        const auto bad = [&](const char* name, const char* point, const char* loss) {
            QTest::newRow(name) << list("", (std::string(point) + ", " + point + ", " + good).c_str())
                                << "a.mrk.json: markups[0].controlPoints[0]" + QString(loss) + " (and 1 more)";
        };
        const QString noNumber = ".position: found a coordinate that is not a number within 10⁷ mm: left out";
        bad("nan", R"({"position": [NaN, 0, 0]})", qPrintable(noNumber));
        bad("infinite", R"({"position": [0, -Infinity, 1e5]})", qPrintable(noNumber));
        bad("far", R"({"position": [0, 0, 1e9]})", qPrintable(noNumber));
        bad("text", "{\"label\": \"NaN \\\" inf\", \"position\": [0, 0, \"3\"]}", qPrintable(noNumber));
        bad("none", R"({"label": "x"})", ": found no position: left out");
        bad("two", R"({"position": [1, 2]})", ": found no position: left out");
        bad("undefined", R"({"position": [1, 2, 3], "positionStatus": "undefined"})", ": found no position: left out");
        QByteArray schema = list("", good);
        QTest::newRow("schema 2")
            << QByteArray(schema).replace("v1.0.3", "v2.1.0")
            << "a.mrk.json: @schema: found version 2.1, expected 1.0: read as far as it is the same";
        // Another list in front of the valid list.
        const auto listBefore = [&](const char* name, const char* fields, const char* loss) {
            QByteArray text = list("", good);
            text.replace("\"markups\": [", "\"markups\": [{" + QByteArray(fields) + "}, ");
            QTest::newRow(name) << text << "a.mrk.json: markups[0]" + QString(loss);
        };
        listBefore("curve", "\"type\": \"Curve\", \"controlPoints\": []",
                   ".type: found \"Curve\", expected points or a line: left out");
        listBefore("line without points", "\"type\": \"Line\", \"controlPoints\": []",
                   ".controlPoints: found a line without two points: left out");
        listBefore("unit", "\"type\": \"Fiducial\", \"coordinateUnits\": \"furlong\"",
                   ".coordinateUnits: found another unit, expected mm or um: the list is left out");
        listBefore("frame", "\"type\": \"Fiducial\", \"coordinateSystem\": \"XYZ\"",
                   ".coordinateSystem: found \"XYZ\", expected LPS or RAS: the list is left out");
    }

    void whatIsBadIsNamedAndTheRestIsTaken()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, loss);
        const auto markups = read(text);
        QVERIFY2(markups.isOk(), markups.status().message().c_str());
        QCOMPARE(markups.value().losses.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(markups.value().losses[0].english()), loss);
        QCOMPARE(markups.value().findings.size(), std::size_t{1});
        QCOMPARE(markups.value().findings[0].name, std::string("good"));
        QCOMPARE(markups.value().findings[0].p_W, core::Vec3(1, 2, 3));
    }

    void thereAreBounds()
    {
        QByteArray points;
        for (std::size_t i = 0; i < study::kMaxMarkups + 2; ++i) {
            points += QByteArray(i > 0 ? "," : "") + R"({"position": [1, 2, 3]})";
        }
        const auto many = read(list("", points.constData()));
        QVERIFY(many.isOk());
        QCOMPARE(many.value().findings.size(), study::kMaxMarkups);
        QCOMPARE(test::english(many.value().losses),
                 std::vector<std::string>{"a.mrk.json: markups[0].controlPoints[10000]: found more than 10,000 points: "
                                          "left out (and 1 more)"});
        const QByteArray label = "{\"position\": [1, 2, 3], \"label\": \"" + QByteArray(1000000, 'x') + "\"}";
        const auto wordy = read(list("", label.constData()));
        QVERIFY(wordy.isOk());
        QCOMPARE(wordy.value().findings[0].name.size(), std::size_t{1000});
        QCOMPARE(test::english(wordy.value().losses),
                 std::vector<std::string>{"a.mrk.json: markups[0].controlPoints[0].label: found a text of 1,000,000 "
                                          "characters, expected at most 1,000: shortened"});
        const auto huge = read(QByteArray(65 * 1024 * 1024, ' '));
        QVERIFY(!huge.isOk());
        QVERIFY2(huge.status().message().find("found more than 64 MiB") != std::string::npos,
                 huge.status().message().c_str());
    }

    void whatIsNoMarkupsFileIsSaidSo()
    {
        for (const char* text : {"", "[1]", "{\"version\": 1}", "{\"markups\": {}}", "{\"markups\": [", "\xff\xfe"}) {
            const auto markups = read(text);
            QVERIFY2(!markups.isOk() && markups.status().code() == core::StatusCode::BadFormat, text);
            QVERIFY2(markups.status().message().starts_with("a.mrk.json: ") &&
                         markups.status().message().find("expected") != std::string::npos,
                     markups.status().message().c_str());
        }
        QVERIFY(!study::readMarkups(m_folder.filePath("none.mrk.json").toStdString()).isOk());
    }
};

PALPATE_TEST(FindingsFile)
#include "tst_FindingsFile.moc"
