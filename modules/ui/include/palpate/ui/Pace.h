// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <functional>

namespace palpate::ui {

/// Does something that is wanted often at most twice a second, with the newest state: what a screen reader is told.
/// @par Thread The GUI's.
class Pace
{
  public:
    static constexpr int kPause_ms = 500;

    explicit Pace(std::function<void()> act);
    /// Acts now when the last time is long enough ago, else once as soon as it is.
    void want();

  private:
    void actNow();

    std::function<void()> m_act;
    QElapsedTimer m_since;
    QTimer m_later;
};

} // namespace palpate::ui
