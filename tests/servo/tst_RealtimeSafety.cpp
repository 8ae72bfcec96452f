// SPDX-License-Identifier: BSD-3-Clause
#include "Motions.h"
#include "RealtimeGuard.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/core/Clock.h>
#include <palpate/device/PlaybackDevice.h>
#include <palpate/device/PointerDevice.h>
#include <palpate/device/SimulatedHand.h>
#include <palpate/servo/ServoCore.h>
#include <palpate/servo/ServoLoop.h>

#include <QTemporaryFile>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <thread>
#include <unistd.h>
#include <vector>

using palpate::core::Vec3;
using palpate::device::DeviceState;
using palpate::servo::TickRecord;
using palpate::test::RealtimeGuard;

namespace {

/// A device whose servo thread is guarded from its first read to its last.
class GuardedDevice final : public palpate::device::HapticDevice
{
  public:
    explicit GuardedDevice(std::vector<Vec3> motion)
        : m_motion(std::move(motion))
    {
    }
    palpate::device::DeviceInfo info() const override
    {
        return palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
    }
    palpate::core::Status start() override { return {}; }
    void stop() noexcept override { m_guard.reset(); }
    DeviceState read(std::int64_t now_ns) noexcept override
    {
        if (!m_guard) {
            m_guard.emplace();
        }
        allocations.store(m_guard->allocations());
        locks.store(m_guard->locks());
        files.store(m_guard->files());
        DeviceState state;
        state.isPresent = m_tick % 700 != 699;
        state.time_ns = now_ns;
        state.p_D = m_motion[m_tick++ % m_motion.size()];
        reads.fetch_add(1);
        return state;
    }
    void write(const Vec3&) noexcept override {}

    std::atomic<std::uint64_t> allocations{0};
    std::atomic<std::uint64_t> locks{0};
    std::atomic<std::uint64_t> files{0};
    std::atomic<std::uint64_t> reads{0};

  private:
    std::vector<Vec3> m_motion;
    std::size_t m_tick = 0;
    std::optional<RealtimeGuard> m_guard;
};

/// Gives a structure friction, a law, and maps of stiffness, damping and friction.
void addTissue(palpate::haptics::HapticStructure& structure)
{
    structure.tissue.friction_static = 0.1;
    structure.tissue.friction_dynamic = 0.05;
    structure.tissue.friction_drag_Ns_per_mm = 1e-4;
    structure.tissue.law = palpate::core::usualLaw(palpate::core::LawKind::Exponential);
    auto corners = std::make_shared<std::vector<std::array<float, 3>>>(structure.surface->triangleCount());
    for (std::uint32_t i = 0; i < corners->size(); ++i) {
        const palpate::geometry::Triangle t = structure.surface->triangle(i);
        for (std::size_t k = 0; k < 3; ++k) {
            (*corners)[i][k] = static_cast<float>(1.0 + 0.02 * structure.surface->vertex(t[k]).x());
        }
    }
    const palpate::haptics::TissueMap map{std::move(corners)};
    structure.maps = {map, {map.corners, 1e-3}, map};
}

} // namespace

class RealtimeSafety : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void init()
    {
        if (!RealtimeGuard::isAvailable()) {
            QSKIP("a sanitizer owns the allocator here");
        }
    }

    void guardTripsOnWhateverAllocatesOrLocks()
    {
        static void* volatile sink = nullptr; // prevents the compiler from eliding allocations
        std::mutex mutex;
        std::vector<std::uint64_t> counts;
        counts.reserve(16);
        {
            const RealtimeGuard guard;
            counts.push_back(guard.allocations());
            sink = std::malloc(16);
            counts.push_back(guard.allocations());
            std::free(sink);
            counts.push_back(guard.allocations());
            sink = ::operator new(16);
            counts.push_back(guard.allocations());
            ::operator delete(sink);
            counts.push_back(guard.allocations());
            sink = ::operator new(64, std::align_val_t(64));
            ::operator delete(sink, std::align_val_t(64));
            counts.push_back(guard.allocations());
            try {
                throw std::runtime_error("caught below");
            } catch (const std::runtime_error&) {
            }
            counts.push_back(guard.allocations());
            counts.push_back(guard.locks());
            {
                const std::lock_guard lock(mutex);
            }
            counts.push_back(guard.locks());
            static_cast<void>(mutex.try_lock());
            counts.push_back(guard.locks());
            mutex.unlock();
        }
        sink = std::malloc(16);
        std::free(sink);
        QCOMPARE(counts[0], std::uint64_t{0});
        for (std::size_t i = 1; i < 7; ++i) {
            QVERIFY2(counts[i] > counts[i - 1], qPrintable(QString::number(i)));
        }
        QCOMPARE(counts[7], std::uint64_t{0});
        QCOMPARE(counts[8], std::uint64_t{1});
        QCOMPARE(counts[9], std::uint64_t{2});
    }

    void guardTripsOnWhateverReadsOrWrites()
    {
        QTemporaryFile file;
        QVERIFY(file.open());
        const QByteArray name = file.fileName().toLocal8Bit();
        std::vector<std::uint64_t> counts;
        counts.reserve(16);
        {
            const RealtimeGuard guard;
            counts.push_back(guard.files());
            const int handle = ::open(name.constData(), O_RDWR);
            counts.push_back(guard.files());
            static_cast<void>(!::write(handle, "x", 1));
            counts.push_back(guard.files());
            char byte = 0;
            static_cast<void>(!::read(handle, &byte, 1));
            counts.push_back(guard.files());
            ::close(handle);
            std::FILE* stream = std::fopen(name.constData(), "w");
            counts.push_back(guard.files());
            std::fprintf(stream, "%d", 1);
            counts.push_back(guard.files());
            std::fputs("some text", stream);
            counts.push_back(guard.files());
            std::fclose(stream);
            std::cerr << "" << std::flush;
            std::cerr << ' ';
            counts.push_back(guard.files());
        }
        QCOMPARE(counts[0], std::uint64_t{0});
        for (std::size_t i = 1; i < counts.size(); ++i) {
            QVERIFY2(counts[i] > counts[i - 1], qPrintable(QString::number(i)));
        }
    }

    void noKindOfTouchAllocatesLocksOrReads_data()
    {
        using namespace palpate::test;
        QTest::addColumn<QList<TriangleMesh>>("meshes"); // in separate layers if there are two
        QTest::addColumn<double>("radius");
        QTest::addColumn<int>("mostConstraints");
        QTest::addColumn<bool>("isTissue"); // friction, a law and maps
        const TriangleMesh bumpy = bumpySphere(24, 30.0, 0.05), cube = box({-24, -24, -24}, {24, 24, 24}, 6);
        TriangleMesh hollow = box({-18, -18, -18}, {18, 18, 18}, 6);
        for (palpate::geometry::Triangle& t : hollow.triangles) {
            std::swap(t[0], t[1]); // contact from inside
        }
        TriangleMesh crowd;
        for (int i = 0; i < 300; ++i) {
            const double z = 1.0 - (2.0 * i + 1.0) / 300.0, a = 2.399963 * i, r = std::sqrt(1.0 - z * z);
            const Vec3 centre = 29.0 * Vec3(r * std::cos(a), r * std::sin(a), z);
            append(crowd, transformed(sphere(3, 4.0), [&](const Vec3& v) { return Vec3(v + centre); }));
        }
        QTest::newRow("point on hills and hollows") << QList{bumpy} << 0.0 << 3 << false;
        QTest::newRow("point on corners") << QList{cube} << 0.0 << 1 << false;
        QTest::newRow("point in corners") << QList{hollow} << 0.0 << 2 << false;
        QTest::newRow("point among many") << QList{crowd} << 0.0 << 3 << false;
        QTest::newRow("point in two layers") << QList{bumpy, sphere(8, 28.0)} << 0.0 << 3 << false;
        QTest::newRow("ball on hills and hollows") << QList{bumpy} << 4.0 << 2 << false;
        QTest::newRow("ball on corners") << QList{cube} << 4.0 << 1 << false;
        QTest::newRow("ball in corners") << QList{hollow} << 1.0 << 2 << false;
        QTest::newRow("large ball among many") << QList{crowd} << 20.0 << 2 << false;
        QTest::newRow("ball in two layers") << QList{bumpy, sphere(8, 28.0)} << 1.0 << 2 << false;
        QTest::newRow("point on tissue with everything") << QList{bumpy, sphere(8, 28.0)} << 0.0 << 2 << true;
        QTest::newRow("point in corners of it") << QList{hollow} << 0.0 << 2 << true;
        QTest::newRow("ball on tissue with everything") << QList{bumpy, sphere(8, 28.0)} << 2.0 << 2 << true;
        QTest::newRow("ball in corners of it") << QList{hollow} << 1.0 << 2 << true;
    }
    void noKindOfTouchAllocatesLocksOrReads()
    {
        QFETCH(QList<palpate::test::TriangleMesh>, meshes);
        QFETCH(double, radius);
        QFETCH(int, mostConstraints);
        QFETCH(bool, isTissue);
        std::vector<palpate::haptics::HapticStructure> structures;
        for (const auto& mesh : meshes) {
            structures.push_back(
                {"it", palpate::test::indexed(mesh), {0.5, 1e-3}, static_cast<std::uint32_t>(structures.size())});
            if (isTissue) {
                addTissue(structures.back());
            }
        }
        const palpate::haptics::HapticScene scene(std::move(structures), radius);
        const auto motion = palpate::test::palpatingMotion(5000);
        palpate::haptics::Palpator palpator;
        std::uint64_t counted = 0;
        int most = 0, layers = 0, holds = 0, slides = 0;
        {
            const RealtimeGuard guard;
            palpator.borrowScene(&scene);
            for (const Vec3& hip : motion) {
                const auto tick = palpator.step(hip, 1e-3);
                most = std::max<int>(most, tick.constraints);
                layers = std::max<int>(layers, tick.contactCount);
                holds += tick.friction() == palpate::haptics::Friction::Holds ? 1 : 0;
                slides += tick.friction() == palpate::haptics::Friction::Slides ? 1 : 0;
                if (hip.x() > 0.0 && most == 1) {
                    palpator.restore(palpator.state());
                }
            }
            palpator.reset();
            counted = guard.all();
        }
        QCOMPARE(counted, std::uint64_t{0});
        QVERIFY2(most >= mostConstraints, qPrintable(QString::number(most)));
        QCOMPARE(layers, static_cast<int>(meshes.size()));
        QCOMPARE(holds + slides > 100, isTissue); // in a corner friction has no effect
        QVERIFY(!isTissue || slides > 100);
    }

    void tickNeitherAllocatesNorLocks_data()
    {
        QTest::addColumn<bool>("isTouching");
        QTest::addColumn<bool>("isHostile");
        QTest::newRow("free space") << false << false;
        QTest::newRow("in and out of contact") << true << false;
        QTest::newRow("bad inputs and faults") << true << true;
    }
    void tickNeitherAllocatesNorLocks()
    {
        QFETCH(bool, isTouching);
        QFETCH(bool, isHostile);
        const auto scene = palpate::test::sphereScene(isTouching ? 30.0 : 5.0, 0.5, 0.001);
        const auto motion = palpate::test::palpatingMotion(5000);
        palpate::device::DeviceInfo info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("touch"));
        info.workspaceRadius_mm = 0.0;
        palpate::servo::ServoCore core(palpate::servo::GateLimits::forDevice(info), 1000.0);
        int contacts = 0;
        int faults = 0;
        std::uint64_t counted = 0;
        {
            const RealtimeGuard guard;
            core.borrowScene(scene.get(), 1);
            for (int i = 0; i < 5000; ++i) {
                DeviceState state;
                state.isPresent = !isHostile || i % 97 != 0;
                state.time_ns = 1'000'000LL * i;
                state.p_D = motion[static_cast<std::size_t>(i)];
                if (isHostile && i % 211 == 0) {
                    state.p_D[i % 3] = std::numeric_limits<double>::quiet_NaN();
                }
                if (isHostile && i % 307 < 6) {
                    state.p_D *= 1e9;
                }
                const TickRecord record = core.tick(state, 1'000'000LL * i);
                contacts += record.felt.structure >= 0 ? 1 : 0;
                core.noteOverrun(isHostile && i % 400 < 30, 1'000'000LL * i);
                if (core.fault().kind != palpate::servo::FaultKind::None && i % 50 == 0) {
                    ++faults;
                    core.rearm();
                }
            }
            core.beginStop();
            counted = guard.all();
        }
        QCOMPARE(counted, std::uint64_t{0});
        QCOMPARE(contacts > 100, isTouching);
        QCOMPARE(faults > 5, isHostile);
    }

    void movingTissueNeitherAllocatesNorLocks()
    {
        using palpate::geometry::SurfaceMotion;
        const palpate::core::Box box(Vec3::Constant(-40), Vec3::Constant(40));
        std::vector<palpate::haptics::HapticStructure> structures = palpate::test::sphereScene(30.0, 0.5)->structures();
        addTissue(structures[0]);
        structures[0].motion = SurfaceMotion::pulse(0.8, 0.2, palpate::test::randomMotion(box, 10.0, 4, 1)).value();
        structures.push_back(palpate::test::sphereScene(25.0, 0.5)->structures()[0]);
        structures[1].motion = palpate::test::oscillation(Vec3(0, 0, 5), 2.0);
        const palpate::haptics::HapticScene scene(structures);
        structures[0].motion = structures[0].motion->withClock(0.5, 0.5, 0.0);
        const palpate::haptics::HapticScene held(structures);
        const std::vector<Vec3> motion = palpate::test::palpatingMotion(3000);
        palpate::servo::ServoCore core(palpate::test::limitsOf("omega"), 1000.0);
        core.borrowScene(&scene, 1);
        std::uint64_t counted = 0;
        int contacts = 0;
        {
            const RealtimeGuard guard;
            for (int i = 0; i < 3000; ++i) {
                if (i % 1000 == 500) {
                    core.borrowScene(i == 1500 ? &scene : &held, static_cast<std::uint32_t>(i));
                }
                DeviceState state;
                state.isPresent = true;
                state.time_ns = 1'000'000LL * i;
                state.p_D = motion[static_cast<std::size_t>(i)];
                contacts += core.tick(state, 1'000'000LL * i).felt.structure >= 0 ? 1 : 0;
            }
            counted = guard.all();
        }
        QCOMPARE(counted, std::uint64_t{0});
        QVERIFY(contacts > 500);
    }

    void builtInDevicesNeitherAllocateNorLock()
    {
        using palpate::device::HandScript;
        palpate::device::PointerDevice pointer;
        palpate::device::SimulatedHand hand(
            HandScript::make({{0.0, Vec3(0, 0, 5)}, {0.5, Vec3(1, 0, -5)}, {1.0, Vec3(0, 0, 5)}}).value());
        palpate::device::PlaybackDevice playback(palpate::test::palpatingMotion(500));
        playback.setLooping(true);
        QVERIFY(hand.start().isOk() && playback.start().isOk());
        std::uint64_t counted = 0;
        {
            const RealtimeGuard guard;
            for (int i = 0; i < 2000; ++i) {
                for (palpate::device::HapticDevice* device :
                     std::initializer_list<palpate::device::HapticDevice*>{&pointer, &hand, &playback}) {
                    static_cast<void>(device->read(i));
                    device->write(Vec3(0.0, 0.1, 0.2));
                }
            }
            counted = guard.all();
        }
        QCOMPARE(counted, std::uint64_t{0});
    }

    void loopNeitherAllocatesNorLocksWithScenesRecordingsAndFaults()
    {
        GuardedDevice device(palpate::test::palpatingMotion(3000));
        palpate::servo::ServoLoop loop;
        palpate::servo::ServoOptions options;
        options.lockMemory = true;
        options.rate_Hz = 2000.0;
        options.ringCapacity = 256; // covers overflow as well
        loop.setScene(palpate::test::sphereScene(30.0, 0.5));
        QVERIFY(loop.start(device, options).isOk());
        for (int i = 0; device.reads.load() < 2000; ++i) {
            if (i % 10 == 0) {
                loop.setScene(i % 20 == 0 ? nullptr : palpate::test::sphereScene(30.0, 0.4));
            }
            if (i % 7 == 0) {
                loop.startRecording();
            }
            palpate::servo::RecordingStart start;
            while (loop.fetchRecordingStart(start)) {
            }
            TickRecord record;
            for (int k = 0; k < 50 && loop.popTick(record); ++k) {
            }
            static_cast<void>(loop.fetchSnapshot(record));
            static_cast<void>(loop.ticksBeforeFault());
            loop.rearm();
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
        }
        const std::uint64_t allocations = device.allocations.load();
        const std::uint64_t locks = device.locks.load();
        const std::uint64_t files = device.files.load();
        loop.stop();
        QCOMPARE(allocations, std::uint64_t{0});
        QCOMPARE(locks, std::uint64_t{0});
        QCOMPARE(files, std::uint64_t{0});
    }
};

PALPATE_TEST(RealtimeSafety)
#include "tst_RealtimeSafety.moc"
