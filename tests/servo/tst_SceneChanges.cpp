// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using palpate::core::Vec3;
using palpate::device::DeviceState;
using palpate::haptics::HapticScene;
using palpate::haptics::HapticStructure;
using palpate::servo::GateLimits;
using palpate::servo::PassivityLimits;
using palpate::servo::TickRecord;

namespace {

using Scene = std::shared_ptr<const HapticScene>;

/// A ball in a ball, the inner one in a layer of its own or in the same one.
Scene nested(std::uint32_t innerLayer)
{
    std::vector<HapticStructure> structures{palpate::test::sphereScene(30.0, 0.5)->structures().front(),
                                            palpate::test::sphereScene(27.0, 3.0)->structures().front()};
    structures[1].layer = innerLayer;
    return std::make_shared<const HapticScene>(std::move(structures));
}

/// Two balls in one layer that meet in a groove along the circle of radius 24 mm around x = 18 mm.
Scene groove(double stiffness_N_per_mm, double other_N_per_mm)
{
    return std::make_shared<const HapticScene>(std::vector<HapticStructure>{
        palpate::test::sphereScene(30.0, stiffness_N_per_mm)->structures().front(),
        palpate::test::sphereScene(30.0, other_N_per_mm, 0.0, Vec3(36.0, 0.0, 0.0))->structures().front()});
}

/// Edits of a user under the hand: structures shown and hidden, stiffness and damping changed, meshes swapped, poses
/// and layers moved.
std::vector<Scene> scenes()
{
    return {nullptr,
            palpate::test::sphereScene(30.0, 0.5),
            palpate::test::sphereScene(30.0, 4.0),
            palpate::test::sphereScene(30.0, 1.0, 0.005),
            palpate::test::sphereScene(28.5, 2.0),
            palpate::test::sphereScene(31.5, 2.0),
            palpate::test::sphereScene(30.0, 2.0, 0.0, Vec3(2.0, -1.5, 1.0)),
            nested(0),
            nested(1)};
}

} // namespace

class SceneChanges : public QObject
{
    Q_OBJECT

    /// Presses a hand of 5 mm depth at the end of inspiration on a sphere that breathes by 15 mm, with another scene
    /// from tick 1900 on. @return the largest step of the sent force [N], beyond ease-in; negative after a fault
    static double largestStep(const std::shared_ptr<const palpate::geometry::SurfaceMotion>& before,
                              const std::shared_ptr<const palpate::geometry::SurfaceMotion>& after)
    {
        std::vector<HapticStructure> structures = palpate::test::sphereScene(30.0, 0.5)->structures();
        structures[0].tissue.damping_Ns_per_mm = 0.001;
        structures[0].motion = before;
        const HapticScene plays(structures);
        structures[0].motion = after;
        const HapticScene changed(structures);
        auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        info.workspaceRadius_mm = 0.0;
        palpate::servo::ServoCore core(GateLimits::forDevice(info), 1000.0, PassivityLimits::forDevice(info));
        core.borrowScene(&plays, 1);
        double most_N = 0.0;
        Vec3 last = Vec3::Zero();
        for (std::int64_t i = 0; i < 4000; ++i) {
            if (i == 1900) {
                core.borrowScene(&changed, 2);
            }
            DeviceState state;
            state.isPresent = true;
            state.p_D = Vec3(0.0, 0.0, 40.0);
            state.time_ns = 1'000'000 * i;
            const TickRecord tick = core.tick(state, state.time_ns);
            if (i > 1000) {
                most_N = std::max(most_N, (tick.fSent_W - last).norm());
            }
            last = tick.fSent_W;
        }
        return core.fault().kind == palpate::servo::FaultKind::None ? most_N : -1.0;
    }

  private Q_SLOTS:
    /// Held, twice as fast or flat: the force changes no faster than the tissue can, and not at once.
    void changeOfPaceDoesNotStepTheForce()
    {
        palpate::geometry::Breath breath;
        breath.amplitude_mm = Vec3(0.0, 0.0, 15.0);
        const auto motion =
            palpate::geometry::SurfaceMotion::breath(breath, {Vec3::Constant(-30.0), Vec3::Constant(30.0)}).value();
        // 15 mm in 0.3 s is 75 mm/s at most, and 0.5 N/mm of that in 1 ms; the damper adds its share.
        constexpr double kMost_N = 0.06;
        for (const palpate::geometry::SurfaceMotion::Pace pace :
             {palpate::geometry::SurfaceMotion::Pace{0.0, 0.0, 1.0}, {2.0, 2.0, 1.0}, {1.0, 1.0, 0.0}}) {
            const double step_N = largestStep(motion, motion->changedAt(2.0, 0.3, pace));
            QVERIFY2(step_N > 0.0 && step_N < kMost_N, qPrintable(QString::number(step_N)));
        }
        QVERIFY(largestStep(motion, motion->withAmplitude(0.0)) > 2.0 * kMost_N); // the step that is avoided
    }

    /// However the scene changes under a pressing hand, no tick's force steps by more than the bound.
    void neverStepTheForce_data()
    {
        QTest::addColumn<QByteArray>("preset");
        for (const char* preset : {"touch", "omega", "delta"}) {
            QTest::newRow(preset) << QByteArray(preset);
        }
    }
    void neverStepTheForce()
    {
        QFETCH(QByteArray, preset);
        auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset(preset.constData()));
        info.workspaceRadius_mm = 0.0;
        const GateLimits limits = GateLimits::forDevice(info);
        const double bound = limits.maxForceRate_N_per_s * 0.001 + 1e-9;
        const std::vector<Scene> all = scenes();
        const auto motion = palpate::test::palpatingMotion(60'000);
        palpate::servo::ServoCore core(limits, 1000.0, PassivityLimits::forDevice(info));
        std::mt19937_64 random(17); // NOLINT: a fixed seed
        std::uint32_t generation = 0;
        Vec3 last = Vec3::Zero();
        double most = 0.0;
        std::size_t gated = 0;
        std::int64_t sinceChange = 1000;
        for (std::size_t i = 0; i < motion.size(); ++i) {
            if (random() % 40 == 0) {
                core.borrowScene(all[random() % all.size()].get(), ++generation);
                sinceChange = 0;
            }
            const auto now_ns = 1'000'000'000 + static_cast<std::int64_t>(i) * 1'000'000;
            DeviceState state;
            state.isPresent = true;
            state.p_D = motion[i];
            state.time_ns = now_ns;
            const TickRecord tick = core.tick(state, now_ns);
            const double step = (tick.fSent_W - last).norm();
            // A hand of 0.4 mm a tick that meets a surface by itself makes no larger step either.
            QVERIFY2(step <= bound,
                     qPrintable(QString("tick %1, %2 after a change: %3 N").arg(i).arg(sinceChange).arg(step)));
            gated += sinceChange < 2 && (tick.flags & palpate::servo::kOutputGated) != 0 ? 1 : 0;
            last = tick.fSent_W;
            most = std::max(most, last.norm());
            ++sinceChange;
        }
        QVERIFY(most > 0.5 * limits.maxForce_N); // contact was felt
        QVERIFY(gated > 50);                     // and changes did ask for more
    }

    /// Two structures of unequal stiffness hold the hand in their groove while their stiffness is changed.
    void unequalStructuresNeverStepTheForce()
    {
        auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        info.workspaceRadius_mm = 0.0;
        const GateLimits limits = GateLimits::forDevice(info);
        const double bound = limits.maxForceRate_N_per_s * 0.001 + 1e-9;
        const std::vector<Scene> all{groove(0.5, 4.0), groove(4.0, 0.5), groove(1.0, 1.0), groove(0.2, 0.3)};
        palpate::servo::ServoCore core(limits, 1000.0, PassivityLimits::forDevice(info));
        std::mt19937_64 random(23); // NOLINT: a fixed seed
        std::uint32_t generation = 0;
        Vec3 last = Vec3::Zero();
        int shared = 0, changedWhileShared = 0;
        for (int i = 0; i < 20'000; ++i) {
            const bool isChanged = i % 50 == 0;
            if (isChanged) {
                core.borrowScene(all[random() % all.size()].get(), ++generation);
            }
            const double t = 1e-3 * i;
            const auto now_ns = 1'000'000'000 + std::int64_t{i} * 1'000'000;
            DeviceState state;
            state.isPresent = true;
            // Down into the groove within 1 s, then across it and along it.
            state.p_D = Vec3(18.0 + 3.0 * std::sin(4.0 * t), 4.0 * std::sin(0.7 * t),
                             std::max(40.0 - 18.0 * t, 22.0) + std::sin(2.3 * t));
            state.time_ns = now_ns;
            const TickRecord tick = core.tick(state, now_ns);
            QVERIFY2((tick.fSent_W - last).norm() <= bound,
                     qPrintable(QString("tick %1: %2 N").arg(i).arg((tick.fSent_W - last).norm())));
            last = tick.fSent_W;
            const bool isShared = tick.felt.contactCount == 2;
            shared += isShared ? 1 : 0;
            changedWhileShared += isShared && isChanged ? 1 : 0;
        }
        QVERIFY2(shared > 5000 && changedWhileShared > 100,
                 qPrintable(QString("%1, %2").arg(shared).arg(changedWhileShared)));
    }

    /// A surface that appears around a hand gives no force until the hand has left and returned.
    void whatAppearsAroundAHandReleasesIt()
    {
        auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        palpate::servo::ServoCore core(GateLimits::forDevice(info), 1000.0, PassivityLimits::forDevice(info));
        const Scene ball = palpate::test::sphereScene(30.0, 4.0);
        for (int i = 0; i < 2000; ++i) {
            if (i == 700) {
                core.borrowScene(ball.get(), 1);
            }
            const auto now_ns = 1'000'000'000 + std::int64_t{i} * 1'000'000;
            DeviceState state;
            state.isPresent = true;
            state.p_D = Vec3(0, 0, 20.0 + 0.005 * i); // out through the surface at tick 2000
            state.time_ns = now_ns;
            const TickRecord tick = core.tick(state, now_ns);
            QVERIFY(tick.fSent_W.isZero(0.0) && tick.felt.structure == -1);
        }
    }
};

PALPATE_TEST(SceneChanges)
#include "tst_SceneChanges.moc"
