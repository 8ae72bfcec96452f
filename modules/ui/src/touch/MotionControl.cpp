// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MotionControl.h"

#include "palpate/ui/StructureModel.h"

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace {

using geometry::SurfaceMotion;

/// Pace of one motion.
SurfaceMotion::Pace paceOf(const SurfaceMotion& motion, const MotionSettings& settings)
{
    const double rate = settings.isPlaying ? settings.rate : 0.0;
    const bool breathes = motion.period_s() > 0.0;
    return {breathes && settings.isHeld ? 0.0 : rate, rate, breathes ? settings.amplitude : 1.0};
}

} // namespace

MotionControl::MotionControl(StructureModel& model, LiveTouch& live, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_live(live)
{
    m_retry.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &MotionControl::apply);
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        m_settings = {};
        Q_EMIT changed();
    });
    connect(&model, &QAbstractItemModel::rowsInserted, this, [this] {
        apply();
        Q_EMIT changed();
    });
}

bool MotionControl::hasMotion() const
{
    const auto& rows = m_model.rows();
    return std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.loaded.motion != nullptr; });
}

bool MotionControl::hasBreath() const
{
    const auto& rows = m_model.rows();
    return std::any_of(rows.begin(), rows.end(), [](const auto& row) {
        return row.loaded.motion != nullptr && row.loaded.motion->period_s() > 0.0;
    });
}

void MotionControl::set(const MotionSettings& settings)
{
    if (settings == m_settings) {
        return;
    }
    m_settings = settings;
    apply();
    Q_EMIT changed();
}

void MotionControl::apply()
{
    servo::TickRecord tick;
    (void)m_live.fetch(tick); // for the newest time
    const double start_s = m_live.time_s() + kLead_s;
    double wait_s = 0.0;
    m_model.changeMotions([&](const std::shared_ptr<const SurfaceMotion>& motion) {
        const SurfaceMotion::Pace pace = paceOf(*motion, m_settings);
        if (motion->pace() == pace) {
            return motion;
        }
        if (motion->settled_s() > start_s) {
            wait_s = std::max(wait_s, motion->settled_s() - start_s);
            return motion;
        }
        return motion->changedAt(start_s, kEase_s, pace);
    });
    if (wait_s > 0.0) {
        m_retry.start(static_cast<int>(std::ceil(1e3 * wait_s)));
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_MotionControl.cpp"
