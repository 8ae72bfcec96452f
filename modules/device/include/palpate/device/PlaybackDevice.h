// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <palpate/core/Export.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace palpate::device {

/// One servo tick of a recorded motion.
struct PlaybackRow
{
    Vec3 p_W = Vec3::Zero(); ///< HIP position [mm]
    std::uint32_t buttons = 0;
    bool isPresent = true; ///< false: no hand in this tick
};

/// Plays back a motion ("playback"): one row per servo tick at speed 1, with positions interpolated at other speeds. D
/// is the world frame. Forces have no effect. The controls are wait-free, callable from any thread, and take effect at
/// the next tick.
///
/// At discontinuities (seek, loop) the hand is absent for one tick, so that the god-object restarts at the new
/// position. After the last row the hand is absent: the number of solved ticks equals the number of rows.
class PALPATE_EXPORT PlaybackDevice final : public HapticDevice
{
  public:
    explicit PlaybackDevice(std::vector<PlaybackRow> rows);
    explicit PlaybackDevice(const std::vector<Vec3>& positions);

    void setLooping(bool isLooping) noexcept { m_isLooping.store(isLooping, std::memory_order_relaxed); }
    void setPaused(bool isPaused) noexcept { m_isPaused.store(isPaused, std::memory_order_relaxed); }
    /// @param speed  rows per tick, clamped to 0 to 100; ignored if not finite
    void setSpeed(double speed) noexcept;
    /// @param row  clamped to the available rows
    void seek(std::int64_t row) noexcept;

    [[nodiscard]] bool isPaused() const noexcept { return m_isPaused.load(std::memory_order_relaxed); }
    /// True from the tick after the last row until a seek or `start`; never while looping.
    [[nodiscard]] bool hasEnded() const noexcept { return m_hasEnded.load(std::memory_order_acquire); }
    /// Row played last. Any thread.
    [[nodiscard]] std::int64_t row() const noexcept { return m_row.load(std::memory_order_relaxed); }
    [[nodiscard]] std::int64_t rowCount() const noexcept { return static_cast<std::int64_t>(m_rows.size()); }

    [[nodiscard]] DeviceInfo info() const override;
    /// Returns to the first row, or to the row of the last seek. Fails for an empty motion.
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
    // Playback position of the servo thread: row m_whole plus the fraction m_part towards the next row.
    std::int64_t m_whole = 0;
    double m_part = 0.0;
};

} // namespace palpate::device
