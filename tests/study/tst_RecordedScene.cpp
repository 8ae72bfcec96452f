// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/meshio/VtpFile.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScale.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace palpate;
using core::Vec3;

/// Tests opening the recorded scene from the recording alone.
class RecordedScene : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }

    void writeMesh(const char* name, double half_mm, bool hasMap) const
    {
        const geometry::TriangleMesh mesh = test::box(Vec3::Constant(-half_mm), Vec3::Constant(half_mm), 4);
        meshio::VtpFile file;
        file.points = mesh.vertices;
        for (const geometry::Triangle& t : mesh.triangles) {
            file.triangles.push_back(t);
        }
        if (hasMap) {
            std::vector<double> scale;
            for (const Vec3& p : mesh.vertices) {
                scale.push_back(1.0 + 0.01 * p.x());
            }
            file.pointArrays = {{"StiffnessScale", std::move(scale)}};
        }
        QVERIFY(core::writeAtomically(path(name), meshio::vtpBytes(file).value()).isOk());
    }

    void writeScene(const char* opacity) const
    {
        std::ofstream(path("s.palpate.json")) << R"({"version": 1, "structures": [
                 {"mesh": "organ.vtp", "name": "organ", "colour": [0.1, 0.2, 0.3], "opacity": )"
                                              << opacity << R"(, "tissue": {"stiffness_N_per_mm": 0.2}},
                 {"mesh": "lump.vtp", "name": "lump", "layer": 1, "tissue": {"stiffness_N_per_mm": 0.6}},
                 {"mesh": "lump.vtp", "name": "vein", "palpable": false},
                 {"mesh": "lump.vtp", "name": "hidden", "visible": false}]})";
    }

    /// Records a press on an edited scene: a stiffer organ, and a hidden structure without contact.
    void record(const char* name, bool embeds) const
    {
        auto loaded = meshio::loadScene(path("s.palpate.json"));
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        loaded.value().structures[0].description.tissue.stiffness_N_per_mm = 0.35;
        loaded.value().structures[0].description.tissue.law = core::usualLaw(core::LawKind::Exponential);
        loaded.value().structures[3].description.palpable = false;
        const auto felt = study::hapticScene(loaded.value());
        session::RecordingInfo info;
        info.firstGeneration = 1;
        study::setSceneSource(info, path("s.palpate.json"));
        std::filesystem::remove(path(name)); // from an earlier test
        auto writer = session::RecordingWriter::create(path(name), info, session::RecordingWriter::Sync::AtEnd);
        QVERIFY(writer.isOk());
        QVERIFY(writer.value()
                    ->addScene(session::describeScene(1, *felt, study::sourcesOf(loaded.value(), embeds)))
                    .isOk());
        session::Motion motion;
        for (int i = 0; i < 600; ++i) {
            motion.p_WH.emplace_back(0.3 + 0.01 * i, 0.2, 21.0 - 14.0 * std::sin(M_PI * i / 600.0));
        }
        core::Finding finding;
        finding.p_W = {1, 2, 20};
        session::replay(*felt, motion, [&](const servo::TickRecord& tick) {
            for (const char* mark : {"Finding 1", "Finding 2"}) {
                finding.name = mark;
                if (tick.tick == 300) {
                    (void)writer.value()->addEvent({300, "finding", session::findingJson(finding)});
                }
            }
            return writer.value()->append(tick).isOk();
        });
        (void)writer.value()->addEvent({590, "finding-undone", session::findingJson(finding)});
        QVERIFY(writer.value()->finish().isOk());
    }

    /// Checks that the opened scene reproduces the recording bit for bit.
    void isFeltAsRecorded(const meshio::LoadedScene& scene, const std::filesystem::path& file) const
    {
        const auto reader = session::RecordingReader::open(file);
        const auto felt = study::hapticScene(scene);
        const session::SceneRecord& record = reader.value()->scenes().front();
        const session::SceneRecord now = session::describeScene(1, *felt, study::sourcesOf(scene, false));
        QCOMPARE(now.structures.size(), record.structures.size());
        for (std::size_t i = 0; i < now.structures.size(); ++i) {
            QCOMPARE(now.structures[i].tissue == record.structures[i].tissue, true);
            QCOMPARE(now.structures[i].layer, record.structures[i].layer);
            QCOMPARE(now.structures[i].palpable, record.structures[i].palpable);
            QCOMPARE(now.structures[i].lawTable == record.structures[i].lawTable, true);
            QCOMPARE(now.structures[i].maps, record.structures[i].maps); // including their hashes
            QCOMPARE(now.structures[i].source.sha256, record.structures[i].source.sha256);
        }
        const auto again = session::resimulate(*reader.value(), study::indexedByHash(study::meshesByHash(scene)));
        QVERIFY2(again.isOk() && again.value().isSame(), again.status().message().c_str());
    }

  private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        writeMesh("organ.vtp", 20.0, true);
        writeMesh("lump.vtp", 10.0, false);
        writeScene("0.4");
    }

    void isAsItWasFeltAndLooksAsItsSceneFile_data()
    {
        QTest::addColumn<bool>("embeds");
        QTest::newRow("meshes in the recording") << true;
        QTest::newRow("meshes beside it") << false;
    }

    void isAsItWasFeltAndLooksAsItsSceneFile()
    {
        QFETCH(bool, embeds);
        record("r.palpate", embeds);
        const auto opened = study::openScene(path("r.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const meshio::LoadedScene& scene = opened.value();
        QCOMPARE(scene.losses.size(), std::size_t{0});
        const meshio::SceneStructure& organ = scene.structures.at(0).description;
        QCOMPARE(organ.tissue.stiffness_N_per_mm, 0.35);
        QCOMPARE(organ.tissue.law.kind, core::LawKind::Exponential);
        QCOMPARE(organ.opacity, 0.4);
        QCOMPARE(organ.colour[2], 0.3);
        QCOMPARE(scene.structures.at(1).description.layer, 1U);
        QVERIFY(!scene.structures.at(2).description.palpable && scene.structures.at(2).description.visible);
        // Not palpable while hidden; palpable when shown again.
        QVERIFY(scene.structures.at(3).description.palpable && !scene.structures.at(3).description.visible);
        QCOMPARE(scene.scene.findings.size(), std::size_t{1});
        QCOMPARE(scene.scene.findings[0].name, std::string("Finding 1"));
        meshio::LoadedScene shown = scene;
        shown.structures[3].description.palpable = false; // as the window treats hidden structures
        isFeltAsRecorded(shown, path("r.palpate"));
    }

    /// The recorded map applies, regardless of the current array in the mesh file, or without the file.
    void theRecordedMapIsFelt()
    {
        record("r.palpate", true);
        writeMesh("organ.vtp", 20.0, false);
        auto opened = study::openScene(path("r.palpate"));
        QVERIFY(opened.isOk());
        opened.value().structures[3].description.palpable = false;
        QCOMPARE(opened.value().structures[0].maps.size(), std::size_t{1});
        isFeltAsRecorded(opened.value(), path("r.palpate"));
    }

    /// The map's scale factor is not stored but follows from the force: live and replayed values are equal.
    void theScaleOfAMapIsFoundAgain()
    {
        auto loaded = meshio::loadScene(path("s.palpate.json"));
        QVERIFY(loaded.isOk());
        for (const bool isPlain : {true, false}) {
            core::Tissue& tissue = loaded.value().structures[0].description.tissue;
            tissue.damping_Ns_per_mm = 2e-3;
            tissue.law = isPlain ? core::ForceLaw{} : core::usualLaw(core::LawKind::Exponential);
            const auto felt = study::hapticScene(loaded.value());
            const session::SceneRecord scene =
                session::describeScene(1, *felt, study::sourcesOf(loaded.value(), false));
            session::Motion motion;
            for (int i = 0; i < 600; ++i) {
                motion.p_WH.emplace_back(-9.0 + 0.03 * i, 0.2, 21.0 - 6.0 * std::sin(M_PI * i / 600.0));
            }
            int scaled = 0;
            Vec3 before = motion.p_WH.front();
            session::replay(*felt, motion, [&](const servo::TickRecord& tick) {
                servo::TickRecord read = tick;
                for (haptics::Contact& contact : read.felt.contacts) {
                    contact.stiffnessScale = 1.0;
                }
                study::reconstructScales(read, scene, (tick.p_WH - before) * 1000.0);
                before = tick.p_WH;
                for (std::size_t i = 0; i < tick.felt.contactCount && tick.felt.contacts[i].depth_mm > 0.01; ++i) {
                    const double was = tick.felt.contacts[i].stiffnessScale;
                    scaled += std::abs(was - 1.0) > 0.05 ? 1 : 0;
                    if (std::abs(read.felt.contacts[i].stiffnessScale - was) > 1e-6) {
                        qWarning("tick %d: %g, was %g", int(tick.tick), read.felt.contacts[i].stiffnessScale, was);
                        scaled = -1000;
                    }
                }
                return true;
            });
            QVERIFY2(scaled > 50, qPrintable(QString::number(scaled)));
        }
    }

    void aMovedPairIsFound()
    {
        record("r.palpate", false);
        QVERIFY(QDir(m_folder->path()).mkdir("moved"));
        for (const char* name : {"r.palpate", "s.palpate.json", "organ.vtp", "lump.vtp"}) {
            std::filesystem::rename(path(name), path(std::string("moved/") + name));
        }
        const auto reader = session::RecordingReader::open(path("moved/r.palpate"));
        QCOMPARE(reader.value()->info().scene, std::string("s.palpate.json")); // relative to the recording
        QCOMPARE(reader.value()->info().sceneSha256, meshio::fileHash(path("moved/s.palpate.json")));
        QCOMPARE(study::recordedSceneFile(*reader.value()).value(), path("moved/s.palpate.json"));
        QVERIFY(study::recordedSurfaces(*reader.value()).isOk());
        const auto opened = study::openScene(path("moved/r.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QCOMPARE(opened.value().structures.size(), std::size_t{4});
        QCOMPARE(opened.value().structures[0].description.opacity, 0.4);
    }

    void withoutTheSceneFileTheTissueIsTheRecordedOne()
    {
        record("r.palpate", false);
        std::filesystem::remove(path("s.palpate.json"));
        const auto opened = study::openScene(path("r.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QCOMPARE(opened.value().structures.at(0).description.tissue.stiffness_N_per_mm, 0.35);
        QCOMPARE(opened.value().structures.at(0).description.opacity, 1.0);
        isFeltAsRecorded(opened.value(), path("r.palpate"));
    }

    void anotherMeshIsSaidAndOneThatIsGoneToo()
    {
        record("r.palpate", false);
        writeMesh("organ.vtp", 21.0, true);
        std::filesystem::remove(path("lump.vtp"));
        const auto opened = study::openScene(path("r.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QCOMPARE(opened.value().structures.size(), std::size_t{1});
        const auto says = [&](const char* what) { return test::mentions(opened.value().losses, what); };
        QVERIFY(says("organ: organ.vtp: is another surface now than was recorded"));
        QVERIFY(says("lump: lump.vtp: no such file, neither where it was nor beside the recording"));
        std::filesystem::remove(path("organ.vtp"));
        const auto none = study::openScene(path("r.palpate"));
        QCOMPARE(none.status().code(), core::StatusCode::NotFound);
        QVERIFY(none.status().message().starts_with("r.palpate: found none of the surfaces"));
    }

    /// Older recordings have absolute paths. The writer stores none, so one of the same length is put into the file.
    void anOlderRecordingIsFoundByItsWholePath()
    {
        std::filesystem::create_directory(path("elsewhere"));
        std::filesystem::copy_file(path("s.palpate.json"), path("elsewhere/other.palpate.json"),
                                   std::filesystem::copy_options::overwrite_existing);
        const std::string whole = path("elsewhere/other.palpate.json").string();
        session::RecordingInfo info;
        info.scene.assign(whole.size(), 'x');
        std::filesystem::remove(path("old.palpate"));
        QVERIFY(session::RecordingWriter::create(path("old.palpate"), info).isOk());
        QFile file(QString::fromStdString(path("old.palpate").string()));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray bytes =
            file.readAll().replace(QByteArray::fromStdString(info.scene), QByteArray::fromStdString(whole));
        file.seek(0);
        file.write(bytes);
        file.close();
        const auto reader = session::RecordingReader::open(path("old.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(study::recordedSceneFile(*reader.value()).value().string(), whole);
    }
};

PALPATE_TEST(RecordedScene)
#include "tst_RecordedScene.moc"
