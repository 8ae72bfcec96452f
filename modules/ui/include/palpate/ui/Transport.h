// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::ui {

/// Where a recording stands and how it runs: play, pause, seek, speed. Time comes from the caller.
class Transport
{
  public:
    /// Rewinds and pauses. @param duration_s  >= 0
    void setDuration(double duration_s);
    [[nodiscard]] double duration_s() const noexcept { return m_duration_s; }
    [[nodiscard]] double position_s() const noexcept { return m_position_s; }
    [[nodiscard]] bool isPlaying() const noexcept { return m_isPlaying; }

    /// At the end it starts again from the beginning.
    void play();
    void pause() { m_isPlaying = false; }
    /// Clamped to 0 … duration.
    void seek(double position_s);
    /// @param speed  > 0; 1 is as it was recorded
    void setSpeed(double speed);
    /// Lets time pass. @return true when the end was reached in this step; it then pauses there
    bool advance(double elapsed_s);

  private:
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    double m_speed = 1.0;
    bool m_isPlaying = false;
};

} // namespace palpate::ui
