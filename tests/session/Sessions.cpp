// SPDX-License-Identifier: BSD-3-Clause
#include "Sessions.h"

#include "../support/Shapes.h"
#include "tables/Contacts.h"

#include <palpate/servo/ServoCore.h>
#include <palpate/session/RecordingWriter.h>

#include <QDebug>

#include <sqlite3.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <thread>

namespace palpate::test {

using core::Vec3;

namespace {

constexpr double kFirstStiffness = 0.5;
constexpr double kSecondStiffness = 0.9;
constexpr double kDamping = 0.001;

std::shared_ptr<const geometry::SurfaceIndex> boxSurface()
{
    static const auto surface = indexed(box(Vec3(-20, -20, -20), Vec3(20, 20, 20), 4));
    return surface;
}

std::vector<session::StructureSource> boxSource()
{
    session::StructureSource source;
    source.mesh = "box.stl";
    source.sha256 = "box";
    return {source};
}

} // namespace

std::shared_ptr<const haptics::HapticScene> boxScene(double stiffness_N_per_mm, double damping_Ns_per_mm)
{
    haptics::HapticStructure structure;
    structure.name = "box";
    structure.surface = boxSurface();
    structure.tissue = {stiffness_N_per_mm, damping_Ns_per_mm};
    return std::make_shared<haptics::HapticScene>(std::vector{structure});
}

session::SurfacesByHash boxSurfaces()
{
    return {{"box", boxSurface()}};
}

std::vector<servo::TickRecord> palpationTicks(int ticks)
{
    const auto soft = boxScene(kFirstStiffness, kDamping);
    const auto firm = boxScene(kSecondStiffness, kDamping);
    device::DeviceInfo info;
    info.maxForce_N = 20.0;
    servo::ServoCore core(servo::GateLimits::forDevice(info), 1000.0);
    core.borrowScene(soft.get(), 1);
    std::vector<servo::TickRecord> records;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick == 250) {
            core.borrowScene(firm.get(), 2);
        }
        const double t = tick * 1e-3;
        device::DeviceState state;
        state.time_ns = std::int64_t{tick} * 1'000'000;
        state.isPresent = tick < 400 || tick >= 420;
        state.p_D = Vec3(15.0 * std::sin(3.0 * t), 15.0 * std::cos(2.0 * t), 22.0 - 5.0 * std::sin(8.0 * t));
        records.push_back(core.tick(state, state.time_ns));
        records.back().solve_ns = static_cast<std::uint32_t>(100 + tick % 7); // no clock values in compared data
    }
    return records;
}

std::vector<session::SceneRecord> palpationScenes()
{
    return {session::describeScene(1, *boxScene(kFirstStiffness, kDamping), boxSource()),
            session::describeScene(2, *boxScene(kSecondStiffness, kDamping), boxSource())};
}

bool writeRecording(const std::filesystem::path& path, const std::vector<servo::TickRecord>& ticks, bool isFinished)
{
    session::RecordingInfo info;
    info.device.id = "test";
    info.firstTick = ticks.empty() ? 0 : ticks.front().tick;
    info.firstGeneration = 1;
    std::error_code none;
    std::filesystem::remove(path, none); // from an earlier row
    auto writer = session::RecordingWriter::create(path, info);
    core::Status status = writer.status();
    for (const auto& scene : palpationScenes()) {
        status = status.isOk() ? writer.value()->addScene(scene) : status;
    }
    for (auto tick = ticks.begin(); status.isOk() && tick != ticks.end(); ++tick) {
        status = writer.value()->append(*tick);
    }
    if (status.isOk() && isFinished) {
        status = writer.value()->finish();
    }
    if (!status.isOk()) {
        qWarning() << status.message().c_str();
    }
    return status.isOk();
}

bool letPass(const servo::ServoLoop& loop, std::uint64_t ticks)
{
    using namespace std::chrono_literals;
    const std::uint64_t goal = loop.timing().ticks + ticks;
    for (int i = 0; i < 60000 && loop.timing().ticks < goal; ++i) {
        std::this_thread::sleep_for(1ms);
    }
    return loop.timing().ticks >= goal;
}

bool isSameTick(const servo::TickRecord& a, const servo::TickRecord& b)
{
    const auto same = [](const Vec3& x, const Vec3& y) {
        for (int i = 0; i < 3; ++i) {
            if (std::bit_cast<std::uint64_t>(x[i]) != std::bit_cast<std::uint64_t>(y[i])) {
                return false;
            }
        }
        return true;
    };
    return a.tick == b.tick && a.time_ns == b.time_ns && same(a.p_WH, b.p_WH) && same(a.felt.p_WG, b.felt.p_WG) &&
           same(a.felt.f_W, b.felt.f_W) && same(a.fSent_W, b.fSent_W) && a.felt.structure == b.felt.structure &&
           (a.felt.structure < 0 || a.felt.triangle == b.felt.triangle) && a.scene == b.scene &&
           a.buttons == b.buttons && a.solve_ns == b.solve_ns && a.felt.iterations == b.felt.iterations &&
           a.flags == b.flags && a.felt.constraints == b.felt.constraints &&
           (a.felt.structure < 0 || same(a.felt.n_W, b.felt.n_W)) && session::internal::sameContacts(a.felt, b.felt);
}

bool runSql(const std::filesystem::path& path, const std::string& sql)
{
    sqlite3* database = nullptr;
    bool isDone = sqlite3_open(path.c_str(), &database) == SQLITE_OK;
    isDone = isDone && sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
    if (!isDone) {
        qWarning() << sqlite3_errmsg(database);
    }
    sqlite3_close(database);
    return isDone;
}

} // namespace palpate::test
