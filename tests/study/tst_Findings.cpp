// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace palpate;

class Findings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static core::Finding whole()
    {
        return {.name = "Finding 1",
                .p_W = {0.1, -2.0, 1e-300},
                .note = "hard, \"as a pea\"",
                .structure = "lobe of the lüver",
                .force_N = 1.25,
                .depth_mm = 0.0,
                .layers = {{"lobe of the lüver", 0.75, 12.5}, {"a \"pea\"", 1.0 / 3.0, 4.5}},
                .id = "f-1",
                .type = core::FindingType::HardArea,
                .size_mm = 12.1,
                .camera = core::ViewPose{{1.0 / 3.0, 2, 3}, {0, 1e-9, 0}, {0, 0.6, 0.8}, 31.7},
                .marked_utc = "2026-11-23T00:24:54Z"};
    }

    static void compare(const core::Finding& is, const core::Finding& was)
    {
        QCOMPARE(is.name, was.name);
        QCOMPARE(is.p_W, was.p_W);
        QCOMPARE(is.note, was.note);
        QCOMPARE(is.structure, was.structure);
        QVERIFY(is.force_N == was.force_N);
        QVERIFY(is.depth_mm == was.depth_mm);
        QVERIFY(is.layers == was.layers);
        QVERIFY(is == was);
    }

    static session::RecordingEvent event(std::int64_t tick, const char* kind, const core::Finding& finding)
    {
        return {tick, kind, session::findingJson(finding)};
    }

  private Q_SLOTS:
    void comesBackFromASceneAndFromARecordingAlike()
    {
        const core::Finding bare{.name = "bare"};
        const core::Finding note{.name = "Note 3", .note = "cirrhotic", .id = "n", .hasPlace = false};
        meshio::SceneFile scene;
        scene.findings = {whole(), bare, note};
        QVERIFY(meshio::writeScene(path("a.palpate.json"), scene).isOk());
        const auto read = meshio::readScene(path("a.palpate.json"));
        QVERIFY2(read.isOk(), read.status().message().c_str());

        auto writer = session::RecordingWriter::create(path("a.palpate"), {});
        QVERIFY(writer.isOk());
        for (const core::Finding& finding : scene.findings) {
            QVERIFY(writer.value()->addEvent(event(7, finding.hasPlace ? "finding" : "note", finding)).isOk());
        }
        QVERIFY(writer.value()->finish().isOk());
        const auto reader = session::RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const auto recorded = session::findingsOf(reader.value()->events());

        QCOMPARE(read.value().findings.size(), std::size_t{3});
        QCOMPARE(recorded.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            compare(read.value().findings[i], scene.findings[i]);
            compare(recorded[i].second, scene.findings[i]);
            QCOMPARE(recorded[i].first, std::int64_t{7});
        }
    }

    void whatIsTakenBackIsNoFinding()
    {
        core::Finding later = whole();
        later.p_W.x() = 5.0;
        const core::Finding other{.name = "Finding 2"};
        later.id.clear();
        core::Finding first = whole(); // as recorded by older versions: without an id
        first.id.clear();
        const auto left = session::findingsOf({event(1, "finding", first),
                                               event(2, "finding", later),
                                               event(3, "finding", other),
                                               event(4, "finding-undone", later),
                                               event(5, "finding-undone", {.name = "never marked"}),
                                               {6, "finding", "{\"name\": \"nowhere\"}"},
                                               {7, "note", session::findingJson(other)}});
        QCOMPARE(left.size(), std::size_t{2});
        QCOMPARE(left[0].first, std::int64_t{1});
        QCOMPARE(left[0].second.p_W, whole().p_W); // the newer finding of that name was removed
        QCOMPARE(left[1].second.name, std::string("Finding 2"));
    }

    void whatIsEditedIsThatOfItsId()
    {
        core::Finding same = whole();
        same.id = "f-2"; // of the same name
        core::Finding renamed = whole();
        renamed.name = "tumour";
        const core::Finding note{.name = "Note 3", .note = "soft", .id = "n", .hasPlace = false};
        core::Finding rewritten = note;
        rewritten.note = "softer";
        const auto left = session::findingsOf(
            {event(1, "finding", whole()), event(2, "finding", same), event(3, "note", note),
             event(4, "finding-edited", renamed), event(5, "finding-undone", same), event(6, "finding", same),
             event(7, "finding-edited", rewritten), event(8, "finding-edited", {.name = "of another", .id = "f-9"})});
        QCOMPARE(left.size(), std::size_t{3});
        QVERIFY(left[0].second == renamed);
        QVERIFY(left[1].second == same);
        QCOMPARE(left[1].first, std::int64_t{2}); // keeps its original time
        QVERIFY(left[2].second == rewritten);
    }

    void aNoteOfAnOlderRecordingIsItsText()
    {
        const auto left = session::findingsOf({{5, "note", R"({"text": "härter"})"}, {6, "note", "{}"}});
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(!left[0].second.hasPlace);
        QCOMPARE(left[0].second.note, std::string("härter"));
    }

    void anOlderScenesNoteIsTheStructureWhenItIsOnesName()
    {
        std::ofstream(path("old.palpate.json")) << R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "liver"}],
            "findings": [{"name": "1", "position": [1, 2, 3], "note": "liver"},
                         {"name": "2", "position": [1, 2, 3], "note": "hard"},
                         {"name": "3", "position": [1, 2, 3], "note": "liver", "structure": "lump"}]})";
        const auto read = meshio::readScene(path("old.palpate.json"));
        QVERIFY2(read.isOk(), read.status().message().c_str());
        const auto& findings = read.value().findings;
        QCOMPARE(findings[0].structure, std::string("liver"));
        QCOMPARE(findings[0].note, std::string());
        QCOMPARE(findings[1].note, std::string("hard"));
        QCOMPARE(findings[2].note, std::string("liver"));
        QCOMPARE(findings[2].structure, std::string("lump"));
    }

    void aRecordingIsKeptRelativeToTheScene()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("sub"));
        meshio::SceneFile scene;
        scene.findings = {whole()};
        scene.findings[0].recording =
            core::RecordedMoment{path("r.palpate").string(), std::string(64, 'a'), 123456789012, 1.0 / 3.0};
        QVERIFY(meshio::writeScene(path("sub/a.palpate.json"), scene).isOk());
        const auto read = meshio::readScene(path("sub/a.palpate.json"));
        QVERIFY2(read.isOk(), read.status().message().c_str());
        QVERIFY(read.value().findings == scene.findings);
        QFile file(m_folder.filePath("sub/a.palpate.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"../r.palpate\""));
    }
};

PALPATE_TEST(Findings)
#include "tst_Findings.moc"
