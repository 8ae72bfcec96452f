// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace palpate::core {

/// Passes the newest value from one writer thread to one reader thread, wait-free on both sides. Unfetched values are
/// overwritten: use for states, not for events.
///
///     TripleBuffer<Pose> pose;     // Pose: trivially copyable
///     pose.write(newest);          // writer thread
///     if (pose.fetch()) {          // reader thread
///         show(pose.value());
///     }
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

    /// Reader only. @return true if a newer value was fetched.
    bool fetch() noexcept PALPATE_NONBLOCKING
    {
        if ((m_middle.load(std::memory_order_relaxed) & kFresh) == 0) {
            return false;
        }
        m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
        return true;
    }

    /// Reader only: the last fetched value; before the first fetch, the initial value.
    [[nodiscard]] const T& value() const noexcept PALPATE_NONBLOCKING { return m_slots[m_front]; }

  private:
    static constexpr std::uint8_t kIndex = 3;
    static constexpr std::uint8_t kFresh = 4;

    std::array<T, 3> m_slots;
    alignas(64) std::atomic<std::uint8_t> m_middle{1};
    alignas(64) std::uint8_t m_back = 0;  // writer only
    alignas(64) std::uint8_t m_front = 2; // reader only
};

} // namespace palpate::core
