// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace palpate::device {

/// One servo tick of a motion.
struct PlaybackRow
{
    Vec3 p_W = Vec3::Zero(); ///< HIP [mm]
    std::uint32_t buttons = 0;
    bool isPresent = true; ///< false: the hand was away in this tick
};

/// Plays a motion, "playback": one row a servo tick at speed 1, positions interpolated between rows at other speeds.
/// D is the world frame. Forces are not felt. Control from any thread, wait-free, effective from the next tick.
///
/// Wherever the motion jumps (seek, loop) the hand is away for one tick, so that the god-object starts anew at the new
/// place. After the last row the hand is away: exactly as many ticks are solved as there are rows.
class PlaybackDevice final : public HapticDevice
{
  public:
    explicit PlaybackDevice(std::vector<PlaybackRow> rows);
    explicit PlaybackDevice(const std::vector<Vec3>& positions);

    void setLooping(bool isLooping) noexcept { m_isLooping.store(isLooping, std::memory_order_relaxed); }
    void setPaused(bool isPaused) noexcept { m_isPaused.store(isPaused, std::memory_order_relaxed); }
    /// @param speed  rows a tick, 0 to 100; clamped, and ignored when not finite
    void setSpeed(double speed) noexcept;
    /// @param row  clamped to the rows there are
    void seek(std::int64_t row) noexcept;

    [[nodiscard]] bool isPaused() const noexcept { return m_isPaused.load(std::memory_order_relaxed); }
    /// True from the tick after the last row until a seek or `start`; never while looping.
    [[nodiscard]] bool hasEnded() const noexcept { return m_hasEnded.load(std::memory_order_acquire); }
    /// The row last played. Any thread.
    [[nodiscard]] std::int64_t row() const noexcept { return m_row.load(std::memory_order_relaxed); }
    [[nodiscard]] std::int64_t rowCount() const noexcept { return static_cast<std::int64_t>(m_rows.size()); }

    [[nodiscard]] DeviceInfo info() const override;
    /// Goes back to the first row, or to the one last sought. Refuses an empty motion.
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    std::vector<PlaybackRow> m_rows;
    std::atomic<bool> m_isLooping{false};
    std::atomic<bool> m_isPaused{false};
    std::atomic<bool> m_hasEnded{false};
    std::atomic<double> m_speed{1.0};
    std::atomic<std::int64_t> m_seek{-1}; // -1: none
    std::atomic<std::int64_t> m_row{0};
    std::int64_t m_whole = 0; // servo thread's place: row m_whole plus the fraction m_part of the way to the next
    double m_part = 0.0;
};

} // namespace palpate::device
