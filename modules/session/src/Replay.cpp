// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Replay.h"

#include <palpate/core/Clock.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>

namespace palpate::session {

namespace {

servo::TickRecord feel(haptics::Palpator& palpator, const Motion& motion, std::size_t tick)
{
    const Vec3& p_WH = motion.p_WH[tick];
    const std::uint16_t flags = tick == 0 ? servo::kReset : 0;
    const std::int64_t start_ns = core::monotonicNow_ns();
    const haptics::TickResult result = servo::feelTick(palpator, p_WH, flags, motion.dt_s);
    const std::int64_t end_ns = core::monotonicNow_ns();

    servo::TickRecord record;
    record.tick = static_cast<std::int64_t>(tick);
    record.time_ns = std::llround(static_cast<double>(tick) * motion.dt_s * 1e9);
    record.scene = 1;
    record.p_WH = p_WH;
    record.p_WG = result.p_WG;
    record.n_W = result.n_W;
    record.f_W = result.f_W;
    record.fSent_W = result.f_W;
    record.structure = result.structure;
    record.triangle = result.triangle;
    record.solve_ns = core::shortDuration_ns(end_ns - start_ns);
    record.iterations = result.iterations;
    record.constraints = result.constraints;
    record.flags = flags;
    if (result.status == haptics::TickStatus::IterationLimit) {
        record.flags |= servo::kIterationLimit;
    }
    return record;
}

} // namespace

void replay(const haptics::HapticScene& scene, const Motion& motion, const TickSink& sink)
{
    // In batches, so that what the sink does with a tick does not cost the next ones their caches.
    constexpr std::size_t kBatch = 4096;
    haptics::Palpator palpator;
    palpator.setScene(&scene);
    std::vector<servo::TickRecord> batch;
    batch.reserve(std::min(kBatch, motion.p_WH.size()));
    for (std::size_t first = 0; first < motion.p_WH.size(); first += kBatch) {
        batch.clear();
        for (std::size_t tick = first; tick < std::min(first + kBatch, motion.p_WH.size()); ++tick) {
            batch.push_back(feel(palpator, motion, tick));
        }
        for (const servo::TickRecord& record : batch) {
            if (!sink(record)) {
                return;
            }
        }
    }
}

haptics::HapticScene withTissue(const haptics::HapticScene& scene, std::optional<double> stiffness,
                                std::optional<double> damping)
{
    std::vector<haptics::HapticStructure> structures = scene.structures();
    for (auto& structure : structures) {
        structure.tissue.stiffness_N_per_mm = stiffness.value_or(structure.tissue.stiffness_N_per_mm);
        structure.tissue.damping_Ns_per_mm = damping.value_or(structure.tissue.damping_Ns_per_mm);
    }
    return haptics::HapticScene(std::move(structures), scene.fingertip_mm());
}

} // namespace palpate::session
