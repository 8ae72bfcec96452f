// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QTemporaryDir>
#include <QTest>

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
                .layers = {{"lobe of the lüver", 0.75, 12.5}, {"a \"pea\"", 1.0 / 3.0, 4.5}}};
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
    }

  private Q_SLOTS:
    void comesBackFromASceneAndFromARecordingAlike()
    {
        const core::Finding bare{.name = "bare"};
        meshio::SceneFile scene;
        scene.findings = {whole(), bare};
        QVERIFY(meshio::writeScene(path("a.palpate.json"), scene).isOk());
        const auto read = meshio::readScene(path("a.palpate.json"));
        QVERIFY2(read.isOk(), read.status().message().c_str());

        auto writer = session::RecordingWriter::create(path("a.palpate"), {});
        QVERIFY(writer.isOk());
        for (const core::Finding& finding : scene.findings) {
            QVERIFY(writer.value()->addEvent({7, "finding", session::findingJson(finding)}).isOk());
        }
        QVERIFY(writer.value()->finish().isOk());
        const auto reader = session::RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const auto recorded = session::findingsOf(reader.value()->events());

        QCOMPARE(read.value().findings.size(), std::size_t{2});
        QCOMPARE(recorded.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
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
        const auto event = [](std::int64_t tick, const char* kind, const core::Finding& finding) {
            return session::RecordingEvent{tick, kind, session::findingJson(finding)};
        };
        const auto left = session::findingsOf({event(1, "finding", whole()),
                                               event(2, "finding", later),
                                               event(3, "finding", other),
                                               event(4, "finding-undone", later),
                                               event(5, "finding-undone", {.name = "never marked"}),
                                               {6, "finding", "{\"name\": \"nowhere\"}"},
                                               {7, "note", session::findingJson(other)}});
        QCOMPARE(left.size(), std::size_t{2});
        QCOMPARE(left[0].first, std::int64_t{1});
        QCOMPARE(left[0].second.p_W, whole().p_W); // the newer one of that name went
        QCOMPARE(left[1].second.name, std::string("Finding 2"));
    }
};

PALPATE_TEST(Findings)
#include "tst_Findings.moc"
