// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QElapsedTimer>
#include <QTimer>

#include <functional>

namespace palpate::ui {

/// Rate limiter: runs an action at most twice a second, always with the newest state. Used for screen reader
/// announcements.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT RateLimiter
{
  public:
    static constexpr int kPause_ms = 500;

    explicit RateLimiter(std::function<void()> act);
    /// Requests the action. Runs immediately when the last run is at least `kPause_ms` ago, else once at the end of the
    /// pause.
    void want();

  private:
    void actNow();

    std::function<void()> m_act;
    QElapsedTimer m_since;
    QTimer m_later;
};

} // namespace palpate::ui
