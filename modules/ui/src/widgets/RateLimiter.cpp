// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/RateLimiter.h"

#include <utility>

namespace palpate::ui {

RateLimiter::RateLimiter(std::function<void()> act)
    : m_act(std::move(act))
{
    m_later.setSingleShot(true);
    m_later.setTimerType(Qt::PreciseTimer); // a coarse timer may fire early
    QObject::connect(&m_later, &QTimer::timeout, &m_later, [this] { actNow(); });
}

void RateLimiter::want()
{
    if (m_later.isActive()) {
        return;
    }
    if (!m_since.isValid() || m_since.hasExpired(kPause_ms)) {
        actNow();
    } else {
        m_later.start(kPause_ms - static_cast<int>(m_since.elapsed()) + 1);
    }
}

void RateLimiter::actNow()
{
    m_since.start();
    m_act();
}

} // namespace palpate::ui
