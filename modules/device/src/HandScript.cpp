// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/HandScript.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate::device {

using core::Status;
using core::StatusCode;
using core::Vec3;

core::Result<HandScript> HandScript::make(std::vector<HandTarget> targets)
{
    if (targets.empty()) {
        return Status(StatusCode::Empty, PALPATE_TEXT("hand script: found no target, expected at least one"));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (!std::isfinite(targets[i].time_s) || !targets[i].p_W.allFinite()) {
            return Status(StatusCode::NonFinite, PALPATE_TEXT("hand script: target %1 is not finite"), i);
        }
        if (i > 0 && !(targets[i].time_s > targets[i - 1].time_s)) {
            return Status(StatusCode::OutOfRange,
                          PALPATE_TEXT("hand script: found target %1 at %2 s, expected a time after %3 s"), i,
                          targets[i].time_s, targets[i - 1].time_s);
        }
    }
    HandScript script;
    script.m_v_W.assign(targets.size(), Vec3::Zero());
    for (std::size_t i = 1; i + 1 < targets.size(); ++i) {
        const double before_s = targets[i].time_s - targets[i - 1].time_s;
        const double after_s = targets[i + 1].time_s - targets[i].time_s;
        const Vec3 in = (targets[i].p_W - targets[i - 1].p_W) / before_s;
        const Vec3 out = (targets[i + 1].p_W - targets[i].p_W) / after_s;
        const double inWeight = before_s + 2.0 * after_s;
        const double outWeight = 2.0 * before_s + after_s;
        for (int axis = 0; axis < 3; ++axis) {
            if ((in[axis] > 0.0 && out[axis] > 0.0) || (in[axis] < 0.0 && out[axis] < 0.0)) {
                script.m_v_W[i][axis] = (inWeight + outWeight) / (inWeight / in[axis] + outWeight / out[axis]);
            }
        }
        if (!script.m_v_W[i].allFinite()) {
            return Status(StatusCode::OutOfRange, PALPATE_TEXT("hand script: target %1 needs too high a speed"), i);
        }
    }
    script.m_targets = std::move(targets);
    return script;
}

HandScript::Motion HandScript::at(double time_s) const noexcept PALPATE_NONBLOCKING
{
    if (m_targets.empty()) {
        return {};
    }
    if (!(time_s > m_targets.front().time_s)) {
        return {m_targets.front().p_W, Vec3::Zero()};
    }
    if (time_s >= m_targets.back().time_s) {
        return {m_targets.back().p_W, Vec3::Zero()};
    }
    const auto after = std::upper_bound(m_targets.begin(), m_targets.end(), time_s,
                                        [](double t, const HandTarget& target) { return t < target.time_s; });
    const auto i = static_cast<std::size_t>(after - m_targets.begin()) - 1;
    const HandTarget& a = m_targets[i];
    const HandTarget& b = m_targets[i + 1];
    const double h = b.time_s - a.time_s;
    const double s = (time_s - a.time_s) / h;
    const double r = 1.0 - s;
    // Cubic Hermite basis relative to a, so that equal end points reproduce that position exactly.
    const Vec3 d = b.p_W - a.p_W;
    Motion motion;
    motion.p_W = a.p_W + s * s * (3.0 - 2.0 * s) * d + h * s * r * (r * m_v_W[i] - s * m_v_W[i + 1]);
    motion.v_W = 6.0 * s * r / h * d + r * (1.0 - 3.0 * s) * m_v_W[i] + s * (3.0 * s - 2.0) * m_v_W[i + 1];
    return motion;
}

} // namespace palpate::device
