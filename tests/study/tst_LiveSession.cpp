// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/device/PlaybackDevice.h>
#include <palpate/geometry/Repair.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/LiveSession.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedLooks.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace palpate;
using core::Vec3;

class LiveSession : public QObject
{
    Q_OBJECT

    static meshio::LoadedScene box(double stiffness_N_per_mm)
    {
        meshio::LoadedScene loaded;
        meshio::LoadedStructure& one = loaded.structures.emplace_back();
        one.description.name = "box";
        one.description.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
        one.surface = std::make_shared<const geometry::RepairedMesh>(
            geometry::repair(test::box(Vec3::Constant(-20.0), Vec3::Constant(20.0), 4)));
        return loaded;
    }

    /// Returns a hand that presses the top repeatedly without end.
    static std::unique_ptr<device::PlaybackDevice> hand()
    {
        std::vector<Vec3> places;
        for (int i = 0; i < 1000; ++i) {
            places.emplace_back(0.3, 0.2, 20.0 - 2.0 * std::sin(0.02 * M_PI * i));
        }
        auto made = std::make_unique<device::PlaybackDevice>(places);
        made->setLooping(true);
        return made;
    }

    static void feel(session::LiveSession& live, const meshio::LoadedScene& loaded)
    {
        QVERIFY(live.setScene(study::hapticScene(loaded), study::sourcesOf(loaded, true)).isOk());
    }

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

  private Q_SLOTS:
    void recordsWhatItFeelsAndEachSceneOfIt_data()
    {
        QTest::addColumn<bool>("embeds");
        QTest::newRow("with the surfaces") << true;
        QTest::newRow("without") << false;
    }

    void recordsWhatItFeelsAndEachSceneOfIt()
    {
        QFETCH(bool, embeds);
        std::filesystem::remove(path("r.palpate")); // from the previous row
        const auto device = hand();
        session::LiveSession live;
        feel(live, box(0.3));
        QVERIFY(live.start(*device, {}).isOk());
        const std::string looks = study::looksText({{"box", {0.1, 0.25, 1.0}, 0.5}});
        session::RecordingInfo info;
        info.looks = looks;
        study::setSceneSource(info, "box.palpate.json");
        QVERIFY(live.startRecording(path("r.palpate"), embeds ? session::Embed::Yes : session::Embed::No, info).isOk());
        PALPATE_TRY_VERIFY(live.recording().ticks > 300);
        feel(live, box(0.9)); // stiffer from now on
        live.note("note", R"({"text": "harder"})");
        const std::int64_t before = live.recording().ticks;
        PALPATE_TRY_VERIFY(live.recording().ticks > before + 600);
        QVERIFY(live.stopRecording().isOk());
        live.stop();
        QVERIFY(!live.loop().isRunning());

        const auto opened = session::RecordingReader::open(path("r.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const session::RecordingReader& reader = *opened.value();
        QVERIFY(reader.verify().isOk());
        const std::filesystem::path found = (path("r.palpate").parent_path() / reader.info().scene).lexically_normal();
        QVERIFY(!std::filesystem::path(reader.info().scene).is_absolute());
        QCOMPARE(found, std::filesystem::absolute("box.palpate.json"));
        QCOMPARE(reader.info().device.id, device->info().id);
        QCOMPARE(reader.scenes().size(), std::size_t{2});
        QCOMPARE(reader.scenes()[0].structures.at(0).tissue.stiffness_N_per_mm, 0.3);
        QCOMPARE(reader.scenes()[1].structures.at(0).tissue.stiffness_N_per_mm, 0.9);
        QCOMPARE(reader.embeddedHashes().size(), std::size_t{embeds ? 1U : 0U});
        const auto isNote = [](const session::RecordingEvent& event) { return event.kind == "note"; };
        QCOMPARE(std::count_if(reader.events().begin(), reader.events().end(), isNote), 1);

        const auto again =
            session::resimulate(reader, study::indexedByHash(study::meshesByHash(box(0.3))),
                                [contacts = 0](const servo::TickRecord&) mutable { return ++contacts > 0; });
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QVERIFY2(again.value().isSame(), again.value().difference.english().c_str());
        QVERIFY(again.value().compared > 900);
        if (embeds) { // the file is self-contained
            const auto whole = study::openScene(path("r.palpate"));
            QVERIFY2(whole.isOk(), whole.status().message().c_str());
            const meshio::SceneStructure& one = whole.value().structures.at(0).description;
            QCOMPARE(one.tissue.stiffness_N_per_mm, 0.3);
            QVERIFY(one.colour == (std::array<double, 3>{0.1, 0.25, 1.0}) && one.opacity == 0.5);
        }
    }

    void looksThatAreNotValidAreLeftOut()
    {
        const auto looks = study::looksFrom(R"([{"name":"a","colour":[0,0.5,2],"opacity":1},7,
            {"name":"b","colour":[0,0.5,1],"opacity":"1"},{"name":"c","colour":[0,0.5,1],"opacity":0.25}])");
        QCOMPARE(looks.size(), std::size_t{4});
        QVERIFY(looks[0].name.empty() && looks[1].name.empty() && looks[2].name.empty());
        QVERIFY(looks[3].name == "c" && looks[3].colour[1] == 0.5 && looks[3].opacity == 0.25);
        QVERIFY(study::looksFrom("{").empty() && study::looksFrom("").empty());

        meshio::SceneStructure lump;
        lump.name = "tumour";
        lump.inside = "liver";
        lump.young_ratio = 4.5;
        const auto kept = study::looksFrom(study::looksText({study::lookOf(lump)}));
        QVERIFY(kept.at(0).inside == "liver" && kept[0].youngRatio == 4.5 && !kept[0].young_kPa);
        const auto bad = study::looksFrom(
            R"([{"name":"a","colour":[0,0,0],"opacity":1,"inside":7,"young_ratio":-1,"felt_contact_radius_mm":"5"}])");
        QVERIFY(bad.at(0).inside.empty() && !bad[0].youngRatio && !bad[0].feltContactRadius_mm);
    }

    void givesTicksToWhoTakesThemOneself()
    {
        const auto device = hand();
        session::LiveSession live;
        QCOMPARE(live.takeTicks().status().code(), core::StatusCode::Internal); // not running
        feel(live, box(0.3));
        QVERIFY(live.start(*device, {}).isOk());
        const auto start = live.takeTicks();
        QVERIFY2(start.isOk(), start.status().message().c_str());
        servo::TickRecord tick;
        int ticks = 0, touching = 0, outOfOrder = 0;
        const auto drain = [&] {
            while (live.loop().popTick(tick)) {
                outOfOrder += tick.tick != start.value().tick + ticks++ ? 1 : 0;
                touching += tick.felt.structure == 0 ? 1 : 0;
            }
            return ticks > 300;
        };
        PALPATE_TRY_VERIFY(drain());
        QCOMPARE(outOfOrder, 0);
        QVERIFY(touching > 50);
    }

    /// A host that knows only its surfaces: they are embedded by their computed hash.
    void embedsSurfacesWithoutAHash()
    {
        std::filesystem::remove(path("e.palpate"));
        const auto device = hand();
        session::LiveSession live;
        const meshio::LoadedScene loaded = box(0.3);
        session::StructureSource source;
        source.embed = loaded.structures[0].surface;
        QVERIFY(live.setScene(study::hapticScene(loaded), {source}).isOk());
        QVERIFY(live.start(*device, {}).isOk());
        QVERIFY(live.startRecording(path("e.palpate"), session::Embed::Yes).isOk());
        PALPATE_TRY_VERIFY(live.recording().ticks > 300);
        QCOMPARE(live.setScene(study::hapticScene(box(0.9)), {}).code(), core::StatusCode::Mismatch);
        QVERIFY(live.stopRecording().isOk());

        const auto opened = session::RecordingReader::open(path("e.palpate"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const session::RecordingReader& reader = *opened.value();
        QCOMPARE(reader.scenes()[0].structures.at(0).source.sha256,
                 session::geometryHash(loaded.structures[0].surface->mesh));
        QCOMPARE(reader.embeddedHashes(), std::vector{reader.scenes()[0].structures[0].source.sha256});
    }

    void refusesToEmbedWhatIsMissing()
    {
        const auto device = hand();
        session::LiveSession live;
        QVERIFY(live.setScene(study::hapticScene(box(0.3)), {}).isOk());
        QVERIFY(live.start(*device, {}).isOk());
        const core::Status status = live.startRecording(path("m.palpate"), session::Embed::Yes);
        QCOMPARE(status.code(), core::StatusCode::Mismatch);
        QVERIFY2(status.message().find("m.palpate: structure 0 (box) has no surface to embed") != std::string::npos,
                 status.message().c_str());
        QVERIFY(!std::filesystem::exists(path("m.palpate")));
        QVERIFY(live.startRecording(path("m.palpate")).isOk()); // without surfaces
    }

    void reportsAFaultOnce()
    {
        std::vector<Vec3> places(200, Vec3(0, 0, 19));
        places.push_back(Vec3::Constant(std::nan("")));
        device::PlaybackDevice device(places);
        device.setLooping(true);
        session::LiveSession live;
        feel(live, box(0.3));
        QVERIFY(!live.poll());
        QVERIFY(live.start(device, {}).isOk());
        QVERIFY(live.startRecording(path("f.palpate")).isOk());
        std::optional<servo::FaultReport> fault;
        const auto hasFault = [&] {
            fault = fault ? fault : live.poll();
            return fault.has_value();
        };
        PALPATE_TRY_VERIFY(hasFault());
        QCOMPARE(fault->fault.kind, servo::FaultKind::NonFiniteInput);
        QVERIFY(!fault->message.isEmpty());
        QVERIFY(!live.poll()); // latched, reported once
        QVERIFY(live.loop().fault().isFaulted());
        fault.reset();
        live.loop().rearm();
        PALPATE_TRY_VERIFY(hasFault()); // the next loop of the positions
        QVERIFY(live.stopRecording().isOk());
        const auto opened = session::RecordingReader::open(path("f.palpate"));
        QVERIFY(opened.isOk());
        const auto isFault = [](const session::RecordingEvent& event) { return event.kind == "fault"; };
        QVERIFY(std::count_if(opened.value()->events().begin(), opened.value()->events().end(), isFault) >= 2);
    }

    void refusesToRecordWhatDoesNotRun()
    {
        session::LiveSession live;
        const core::Status status = live.startRecording(path("no.palpate"));
        QVERIFY(!status.isOk());
        QVERIFY2(status.message().find("no.palpate: cannot be recorded") != std::string::npos,
                 status.message().c_str());
        QVERIFY(!std::filesystem::exists(path("no.palpate")));
    }
};

PALPATE_TEST(LiveSession)
#include "tst_LiveSession.moc"
