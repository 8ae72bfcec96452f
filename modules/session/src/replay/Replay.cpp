// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Replay.h"

#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace palpate::session {

void ReplayHand::borrowScene(const haptics::HapticScene* scene) noexcept
{
    m_palpator.borrowScene(scene);
    m_isDamped = scene != nullptr && scene->isDamped();
}

void ReplayHand::reset() noexcept
{
    m_track = servo::MotionTrack(0.0); // without the sensor steps that it has seen
    m_tick = 0;
}

servo::TickRecord ReplayHand::step(const Vec3& p_WH, double dt_s) noexcept
{
    servo::TickRecord record;
    record.tick = m_tick;
    record.time_ns = std::llround(static_cast<double>(m_tick) * dt_s * 1e9);
    record.scene = 1;
    record.p_WH = p_WH;
    record.flags = m_tick == 0 ? servo::kReset : 0;
    if (m_isDamped) {
        m_track.step(record.p_WH);
        record.v_WH = m_track.slope() / dt_s;
    }
    servo::feelTick(m_palpator, dt_s, record);
    record.fSent_W = record.felt.f_W;
    ++m_tick;
    return record;
}

void replay(const haptics::HapticScene& scene, const Motion& motion, const TickSink& sink)
{
    replay(scene, motion.p_WH, motion.dt_s, sink);
}

void replay(const haptics::HapticScene& scene, std::span<const Vec3> p_WH, double dt_s, const TickSink& sink)
{
    // Processes ticks in batches, so that the sink does not evict the solver's data from the caches after every tick.
    constexpr std::size_t kBatch = 4096;
    ReplayHand hand;
    hand.borrowScene(&scene);
    std::vector<servo::TickRecord> batch;
    batch.reserve(std::min(kBatch, p_WH.size()));
    for (std::size_t first = 0; first < p_WH.size(); first += kBatch) {
        batch.clear();
        for (const Vec3& hip : p_WH.subspan(first, std::min(kBatch, p_WH.size() - first))) {
            batch.push_back(hand.step(hip, dt_s));
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
