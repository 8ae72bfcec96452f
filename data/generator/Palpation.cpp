// SPDX-License-Identifier: BSD-3-Clause
#include "Palpation.h"

#include "Phantom.h"

#include <palpate/device/SimulatedHand.h>
#include <palpate/servo/ServoCore.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/StructureSources.h>

#include <cmath>
#include <numbers>

namespace palpate::phantom {

namespace {

constexpr double kRate_Hz = 1000.0;

/// Collects hand targets in order. Depths are targets that the hand aims for; the tissue resists before they are
/// reached.
class ScriptBuilder
{
  public:
    /// Moves in a straight line to `p_W` in `duration_s`.
    void moveTo(const Vec3& p_W, double duration_s)
    {
        m_time_s += duration_s;
        m_targets.push_back({m_time_s, p_W});
    }

    /// Moves to a point on the organ, `depth_mm` below the surface or, when negative, above the surface.
    void moveTo(const Vec3& onSurface_W, double depth_mm, double duration_s)
    {
        moveTo(onSurface_W - depth_mm * outward(organDistance, onSurface_W), duration_s);
    }

    [[nodiscard]] std::vector<device::HandTarget> take() { return std::move(m_targets); }

  private:
    double m_time_s = 0.0;
    std::vector<device::HandTarget> m_targets;
};

/// Front surface point of the organ on a line parallel to the patient's anterior-posterior axis.
Vec3 front(double x, double z)
{
    Vec3 p(x, -120.0, z);
    while (organDistance(p) > 0.0) {
        p.y() += 0.25;
    }
    return onSurface(organDistance, p);
}

/// Strokes across the front from one point to another.
void stroke(ScriptBuilder& script, double x0, double z0, double x1, double z1, double depth_mm, double duration_s)
{
    constexpr int kSteps = 10;
    for (int i = 1; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        script.moveTo(front(x0 + t * (x1 - x0), z0 + t * (z1 - z0)), depth_mm, duration_s / kSteps);
    }
}

/// Presses a lump three times with increasing depth, then circles over the lump.
void pressOver(ScriptBuilder& script, const Lump& lump, double depth_mm)
{
    const Vec3& top = lump.over_W;
    const Vec3 n = outward(organDistance, top);
    for (const double share : {0.7, 0.85, 1.0}) {
        script.moveTo(top, share * depth_mm, 0.45);
        script.moveTo(top, share * depth_mm, 0.15);
        script.moveTo(top, -1.0, 0.4);
    }
    const Vec3 side = n.cross(Vec3::UnitX()).normalized();
    const Vec3 along = side.cross(n);
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSteps;
        const Vec3 offset = 0.7 * lump.radius_mm * (std::cos(angle) * along + std::sin(angle) * side);
        script.moveTo(onSurface(organDistance, top + offset), 0.8 * depth_mm, i == 0 ? 0.4 : 1.6 / kSteps);
    }
    script.moveTo(top, -6.0, 0.4);
}

} // namespace

device::HandScript palpationScript()
{
    const std::array<Lump, 2> both = lumps();
    ScriptBuilder script;
    script.moveTo(Vec3(-70, -150, 20), 0.1);
    script.moveTo(front(-85, 20), -4.0, 1.3);
    script.moveTo(front(-85, 20), 5.0, 0.4);
    stroke(script, -85, 20, -5, 34, 5.0, 1.8);
    stroke(script, -5, 34, -8, 14, 5.0, 0.4);
    script.moveTo(front(-8, 14), 16.0, 0.3);
    stroke(script, -8, 14, -82, -2, 16.0, 1.8); // deep stroke beside the larger lump
    script.moveTo(front(-82, -2), 5.0, 0.2);
    stroke(script, -82, -2, -70, -30, 5.0, 0.5);
    script.moveTo(front(-70, -30), -4.0, 0.3);
    script.moveTo(both[0].over_W, -4.0, 0.5);
    pressOver(script, both[0], 22.0);
    script.moveTo(front(0, 22), -5.0, 0.5);
    script.moveTo(front(10, 22), 5.0, 0.4);
    stroke(script, 10, 22, 88, 32, 5.0, 1.6);
    script.moveTo(front(88, 32), -4.0, 0.3);
    pressOver(script, both[1], 16.0);
    script.moveTo(Vec3(60, -150, 60), 1.2);
    script.moveTo(Vec3(60, -150, 60), 0.05);
    std::vector<device::HandTarget> targets = script.take();
    // Scale the timing to a total of 20 s.
    const double pace = 20.0 / targets.back().time_s;
    for (device::HandTarget& target : targets) {
        target.time_s *= pace;
    }
    return device::HandScript::make(std::move(targets)).value();
}

core::Status recordPalpation(const meshio::LoadedScene& loaded, const device::HandScript& script,
                             const std::filesystem::path& path)
{
    const std::shared_ptr<const haptics::HapticScene> scene = study::hapticScene(loaded);
    std::vector<session::StructureSource> sources = study::sourcesOf(loaded);
    for (session::StructureSource& source : sources) {
        source.mesh = std::filesystem::path(source.mesh).filename().string();
    }

    device::SimulatedHandOptions options;
    options.preset = *device::findDevicePreset("omega");
    options.rate_Hz = kRate_Hz;
    device::SimulatedHand hand(script, options);
    if (core::Status started = hand.start(); !started.isOk()) {
        return started;
    }

    constexpr std::uint32_t kGeneration = 1;
    servo::ServoCore servo(servo::GateLimits::forDevice(hand.info()), kRate_Hz);
    servo.borrowScene(scene.get(), kGeneration);

    session::RecordingInfo info;
    info.rate_Hz = kRate_Hz;
    info.dt_s = 1.0 / kRate_Hz;
    info.device = hand.info();
    info.scene = "phantom.palpate.json"; // in the recording's folder
    info.firstTick = servo.nextTick();
    info.firstGeneration = kGeneration;
    info.start = servo.palpatorState();
    core::Result<std::unique_ptr<session::RecordingWriter>> writer =
        session::RecordingWriter::create(path, info, session::RecordingWriter::Sync::AtEnd,
                                         session::RecordingWriter::Events::Derived, core::ExistingFile::Replace);
    if (!writer.isOk()) {
        return writer.status();
    }
    if (core::Status added = writer.value()->addScene(session::describeScene(kGeneration, *scene, sources));
        !added.isOk()) {
        return added;
    }
    const auto ticks = static_cast<std::int64_t>(std::lround(script.end_s() * kRate_Hz));
    for (std::int64_t tick = 0; tick < ticks; ++tick) {
        const std::int64_t now_ns = tick * 1'000'000;
        const servo::TickRecord felt = servo.tick(hand.read(now_ns), now_ns);
        hand.write(felt.fSent_W);
        if (core::Status appended = writer.value()->append(felt); !appended.isOk()) {
            return appended;
        }
    }
    return writer.value()->finish();
}

} // namespace palpate::phantom
