// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace palpate::core {

/// Hands the newest value from one writer thread to one reader thread, wait-free on both sides. Values that the reader
/// did not fetch in time are overwritten: use it for states, not for events.
template<class T>
class TripleBuffer
{
    static_assert(std::is_trivially_copyable_v<T>);
    static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

  public:
    explicit TripleBuffer(const T& initial = T{})
        : m_slots{initial, initial, initial}
    {
    }

    /// Writer only.
    void write(const T& value) noexcept PALPATE_NONBLOCKING
    {
        m_slots[m_back] = value;
        m_back = m_middle.exchange(static_cast<std::uint8_t>(m_back | kFresh), std::memory_order_acq_rel) & kIndex;
    }

    /// Reader only. @return true when a value newer than the last one fetched was taken.
    bool fetch() noexcept PALPATE_NONBLOCKING
    {
        if ((m_middle.load(std::memory_order_relaxed) & kFresh) == 0) {
            return false;
        }
        m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
        return true;
    }

    /// Reader only: the value last fetched, the initial one before that.
    [[nodiscard]] const T& value() const noexcept PALPATE_NONBLOCKING { return m_slots[m_front]; }

  private:
    static constexpr std::uint8_t kIndex = 3;
    static constexpr std::uint8_t kFresh = 4;

    std::array<T, 3> m_slots;
    alignas(64) std::atomic<std::uint8_t> m_middle{1};
    alignas(64) std::uint8_t m_back = 0;  // writer's
    alignas(64) std::uint8_t m_front = 2; // reader's
};

} // namespace palpate::core
