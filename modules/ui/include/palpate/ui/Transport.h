// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

namespace palpate::ui {

/// Playback state of a recording: position, play, pause, seek, speed. The caller provides the time.
///
/// @par Example
/// @code
/// Transport transport;
/// transport.setDuration(20.0); // s
/// transport.setSpeed(0.5);
/// transport.play();
/// transport.advance(2.0); // position is 1 s
/// @endcode
class PALPATE_EXPORT Transport
{
  public:
    /// Rewinds and pauses. @param duration_s  >= 0
    void setDuration(double duration_s);
    [[nodiscard]] double duration_s() const noexcept { return m_duration_s; }
    [[nodiscard]] double position_s() const noexcept { return m_position_s; }
    [[nodiscard]] bool isPlaying() const noexcept { return m_isPlaying; }

    /// Starts playing, from the beginning when at the end.
    void play();
    void pause() { m_isPlaying = false; }
    /// Moves the position, clamped to 0 … duration.
    void seek(double position_s);
    /// @param speed  > 0; 1: original speed
    void setSpeed(double speed);
    /// Advances the position. Returns true when this step reached the end and paused.
    bool advance(double elapsed_s);

  private:
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    double m_speed = 1.0;
    bool m_isPlaying = false;
};

} // namespace palpate::ui
