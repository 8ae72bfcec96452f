// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/PlaybackDevice.h"

#include "palpate/device/DevicePresets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::device {

static_assert(std::atomic<double>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

namespace {

constexpr double kLargestSpeed = 100.0;

std::vector<PlaybackRow> toRows(const std::vector<Vec3>& positions)
{
    std::vector<PlaybackRow> rows(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        rows[i].p_W = positions[i];
    }
    return rows;
}

} // namespace

PlaybackDevice::PlaybackDevice(std::vector<PlaybackRow> rows)
    : m_rows(std::move(rows))
{
}

PlaybackDevice::PlaybackDevice(const std::vector<Vec3>& positions)
    : m_rows(toRows(positions))
{
}

void PlaybackDevice::setSpeed(double speed) noexcept
{
    if (std::isfinite(speed)) {
        m_speed.store(std::clamp(speed, 0.0, kLargestSpeed), std::memory_order_relaxed);
    }
}

void PlaybackDevice::seek(std::int64_t row) noexcept
{
    m_seek.store(std::clamp<std::int64_t>(row, 0, std::max<std::int64_t>(rowCount() - 1, 0)),
                 std::memory_order_relaxed);
}

DeviceInfo PlaybackDevice::info() const
{
    DeviceInfo info;
    info.id = "playback";
    info.name = "Playback";
    info.buttons = 32;
    info.maxForce_N = kShownForceLimit_N;
    return info;
}

core::Status PlaybackDevice::start()
{
    if (m_rows.empty()) {
        return {core::StatusCode::Empty, PALPATE_TEXT("the motion to play has no rows")};
    }
    m_whole = std::max<std::int64_t>(m_seek.exchange(-1, std::memory_order_relaxed), 0);
    m_part = 0.0;
    m_row.store(m_whole, std::memory_order_relaxed);
    m_hasEnded.store(false, std::memory_order_release);
    return {};
}

void PlaybackDevice::stop() noexcept {}

DeviceState PlaybackDevice::read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    DeviceState state;
    state.time_ns = now_ns;
    const std::int64_t last = rowCount() - 1;

    const std::int64_t sought = m_seek.exchange(-1, std::memory_order_relaxed);
    const bool isPastEnd = m_whole > last || (m_whole == last && m_part > 0.0);
    if (sought >= 0 || (isPastEnd && m_isLooping.load(std::memory_order_relaxed))) {
        m_whole = std::max<std::int64_t>(sought, 0);
        m_part = 0.0;
        m_row.store(m_whole, std::memory_order_relaxed);
        m_hasEnded.store(false, std::memory_order_release);
        return state;
    }
    if (isPastEnd) {
        m_hasEnded.store(true, std::memory_order_release);
        return state;
    }

    const PlaybackRow& row = m_rows[static_cast<std::size_t>(m_whole)];
    state.p_D = row.p_W;
    state.buttons = row.buttons;
    state.isPresent = row.isPresent;
    if (m_part > 0.0) {
        const PlaybackRow& next = m_rows[static_cast<std::size_t>(m_whole) + 1];
        state.p_D += m_part * (next.p_W - row.p_W);
        state.isPresent = row.isPresent && next.isPresent;
    }
    m_row.store(m_whole, std::memory_order_relaxed);

    if (!m_isPaused.load(std::memory_order_relaxed)) {
        m_part += m_speed.load(std::memory_order_relaxed);
        const double whole = std::floor(m_part);
        m_whole += static_cast<std::int64_t>(whole);
        m_part -= whole;
    }
    return state;
}

void PlaybackDevice::write(const Vec3&) noexcept PALPATE_NONBLOCKING {}

} // namespace palpate::device
