// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Replay.h"

#include <palpate/servo/MotionTrack.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>

namespace palpate::session {

namespace {

/// @param hand  null if no structure needs the velocity
servo::TickRecord feel(haptics::Palpator& palpator, servo::MotionTrack* hand, const Motion& motion, std::size_t tick)
{
    servo::TickRecord record;
    record.tick = static_cast<std::int64_t>(tick);
    record.time_ns = std::llround(static_cast<double>(tick) * motion.dt_s * 1e9);
    record.scene = 1;
    record.p_WH = motion.p_WH[tick];
    record.flags = tick == 0 ? servo::kReset : 0;
    if (hand != nullptr) {
        hand->step(record.p_WH);
        record.v_WH = hand->slope() / motion.dt_s;
    }
    servo::feelTick(palpator, motion.dt_s, record);
    record.fSent_W = record.felt.f_W;
    return record;
}

} // namespace

void replay(const haptics::HapticScene& scene, const Motion& motion, const TickSink& sink)
{
    // Processes ticks in batches, so that the sink does not evict the solver's data from the caches after every tick.
    constexpr std::size_t kBatch = 4096;
    haptics::Palpator palpator;
    palpator.borrowScene(&scene);
    servo::MotionTrack hand(0.0); // a motion has no information about sensor resolution
    std::vector<servo::TickRecord> batch;
    batch.reserve(std::min(kBatch, motion.p_WH.size()));
    for (std::size_t first = 0; first < motion.p_WH.size(); first += kBatch) {
        batch.clear();
        for (std::size_t tick = first; tick < std::min(first + kBatch, motion.p_WH.size()); ++tick) {
            batch.push_back(feel(palpator, scene.isDamped() ? &hand : nullptr, motion, tick));
        }
        for (const servo::TickRecord& record : batch) {
            if (!sink(record)) {
                return;
            }
        }
    }
}

haptics::HapticScene withTissue(const haptics::HapticScene& scene, const TissueOverride& given)
{
    std::vector<haptics::HapticStructure> structures = scene.structures();
    for (auto& structure : structures) {
        if (std::any_of(given.begin(), given.end(), [](const auto& value) { return value.has_value(); })) {
            for (const core::TissueTerm& term : core::kTissueTerms) {
                if (term.option.empty()) {
                    structure.tissue.*term.member = 0.0;
                }
            }
            structure.tissue.law = {};
            structure.law = nullptr;
            structure.maps = {};
        }
        for (std::size_t i = 0; i < given.size(); ++i) {
            double& own = structure.tissue.*core::kTissueTerms[i].member;
            own = given[i].value_or(own);
        }
    }
    return haptics::HapticScene(std::move(structures), scene.fingertip_mm());
}

} // namespace palpate::session
