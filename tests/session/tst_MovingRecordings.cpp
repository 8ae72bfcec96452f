// SPDX-License-Identifier: BSD-3-Clause
// Recordings of moving tissue: the motion is stored, and a replay gives the same bits.
#include "Motions.h"
#include "Sessions.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/servo/ServoCore.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/Replay.h>

#include <QTemporaryDir>

#include <cmath>

using namespace palpate;
using core::Vec3;

namespace {

struct Recorded
{
    session::SurfacesByHash surfaces;
    std::vector<session::SceneRecord> scenes;
    session::RecordingInfo info;
    std::vector<servo::TickRecord> ticks;
};

/// Presses a sphere in a random motion, which is held from tick 1600 on, with half of its amplitude. The recording
/// starts in contact at tick 700.
Recorded palpated()
{
    const core::Box box(Vec3::Constant(-60), Vec3::Constant(60));
    haptics::HapticStructure organ;
    organ.name = "organ";
    organ.surface = test::indexed(test::bumpySphere(12, 40.0, 0.03));
    organ.tissue.stiffness_N_per_mm = 0.4;
    organ.tissue.damping_Ns_per_mm = 0.001;
    organ.tissue.friction_static = 0.3;
    organ.tissue.friction_dynamic = 0.2;
    organ.motion = geometry::SurfaceMotion::pulse(0.8, 0.2, test::randomMotion(box, 12.0, 4, 21)).value();
    haptics::HapticStructure bone = organ;
    bone.name = "bone";
    bone.motion = test::oscillation(Vec3(0, 0, 8), 0.7);
    bone.layer = 1;
    bone.surface = test::indexed(test::sphere(8, 34.0));
    const haptics::HapticScene plays({organ, bone});
    organ.motion = organ.motion->changedAt(1.6, 0.3, {0.0, 2.0, 0.5});
    const haptics::HapticScene holds({organ, bone});
    Recorded out;
    out.surfaces = {{"organ", organ.surface}, {"bone", bone.surface}};
    session::StructureSource a, b;
    a.mesh = b.mesh = "meshes.vtp";
    a.sha256 = "organ";
    b.sha256 = "bone";
    const std::vector<session::StructureSource> sources{a, b};
    out.scenes = {session::describeScene(1, plays, sources), session::describeScene(2, holds, sources)};
    device::DeviceInfo device;
    device.maxForce_N = 20.0;
    servo::ServoCore core(servo::GateLimits::forDevice(device), 1000.0);
    core.borrowScene(&plays, 1);
    for (int i = 0; i < 2500; ++i) {
        if (i == 700) {
            out.info.start = core.palpatorState();
            out.info.firstTick = 700;
            out.info.firstGeneration = 1;
        }
        if (i == 1500) {
            core.borrowScene(&holds, 2);
        }
        const double t = i * 1e-3;
        device::DeviceState hand;
        hand.time_ns = 1'000'000LL * i;
        hand.isPresent = i < 2000 || i >= 2040;
        hand.p_D =
            (38.0 + 5.0 * std::cos(2.0 * t)) * Vec3(0.3 * std::sin(3.0 * t), 0.3 * std::cos(2.0 * t), 1.0).normalized();
        servo::TickRecord tick = core.tick(hand, hand.time_ns);
        tick.solve_ns = 100;
        if (i >= 700) {
            out.ticks.push_back(tick);
        }
    }
    return out;
}

bool write(const std::filesystem::path& path, const Recorded& recorded)
{
    auto writer = session::RecordingWriter::create(path, recorded.info);
    bool isOk = writer.isOk();
    for (const session::SceneRecord& scene : recorded.scenes) {
        isOk = isOk && writer.value()->addScene(scene).isOk();
    }
    for (const servo::TickRecord& tick : recorded.ticks) {
        isOk = isOk && writer.value()->append(tick).isOk();
    }
    return isOk && writer.value()->finish().isOk();
}

} // namespace

class MovingRecordings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    [[nodiscard]] std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

  private Q_SLOTS:
    void replayGivesTheSameBits()
    {
        const Recorded recorded = palpated();
        QVERIFY(recorded.ticks.front().felt.structure >= 0);
        QVERIFY(write(path("moving.palpate"), recorded));
        const auto reader = session::RecordingReader::open(path("moving.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->info().version, 5);
        QVERIFY(reader.value()->verify().isOk());
        QVERIFY(reader.value()->faults().empty());
        QVERIFY(*reader.value()->scenes()[0].structures[0].motion == *recorded.scenes[0].structures[0].motion);
        std::size_t both = 0, n = 0;
        const auto result = session::resimulate(*reader.value(), recorded.surfaces, [&](const servo::TickRecord& tick) {
            both += tick.felt.contactCount > 1 ? 1 : 0;
            return ++n > 0;
        });
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QCOMPARE(result.value().compared, std::int64_t{1800});
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
        QVERIFY(both > 200);
        int events = 0;
        for (const session::RecordingEvent& event : reader.value()->events()) {
            if (event.kind == "motion") {
                ++events;
                QCOMPARE(QString::fromStdString(event.json),
                         QStringLiteral(R"({"amplitude":0.5,"moves":true,"rate":0,"structure":"organ"})"));
            }
        }
        QCOMPARE(events, 1);
    }

    void otherMotionIsFound()
    {
        Recorded recorded = palpated();
        recorded.scenes[0].structures[0].motion = recorded.scenes[0].structures[0].motion->withAmplitude(0.99);
        recorded.scenes[0] = [&] { // with the hash of that motion
            session::SceneRecord scene = recorded.scenes[0];
            haptics::HapticStructure one;
            one.motion = scene.structures[0].motion;
            scene.structures[0].maps = session::describeScene(1, haptics::HapticScene({one}), {}).structures[0].maps;
            return scene;
        }();
        QVERIFY(write(path("other.palpate"), recorded));
        const auto reader = session::RecordingReader::open(path("other.palpate"));
        QVERIFY(reader.isOk());
        const auto result = session::resimulate(*reader.value(), recorded.surfaces);
        QVERIFY(result.isOk() && !result.value().isSame() && !result.value().isWithinRounding());
    }

    void damagedMotionIsNamedAndNotReplayed()
    {
        const Recorded recorded = palpated();
        QVERIFY(write(path("damaged.palpate"), recorded));
        QVERIFY(test::runSql(path("damaged.palpate"), "UPDATE maps SET corners = zeroblob(length(corners))"));
        const auto reader = session::RecordingReader::open(path("damaged.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QVERIFY(!reader.value()->verify().isOk());
        const auto result = session::resimulate(*reader.value(), recorded.surfaces);
        QVERIFY(!result.isOk());
        QVERIFY2(QString::fromStdString(result.status().message()).contains("its motion is not in the recording"),
                 result.status().message().c_str());
    }

    void recordingAtRestKeepsItsVersion()
    {
        QVERIFY(test::writeRecording(path("rest.palpate"), test::palpationTicks(600)));
        const auto reader = session::RecordingReader::open(path("rest.palpate"));
        QCOMPARE(reader.value()->info().version, 4);
    }
};

PALPATE_TEST(MovingRecordings)
#include "tst_MovingRecordings.moc"
