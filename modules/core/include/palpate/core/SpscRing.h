// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace palpate::core {

/// Wait-free queue from one producer thread to one consumer thread. Values are dropped and counted if the queue is
/// full: the producer never waits.
template<class T>
class SpscRing
{
    static_assert(std::is_trivially_copyable_v<T>);
    static_assert(std::atomic<std::size_t>::is_always_lock_free);

  public:
    /// @param capacity  rounded up to a power of two; the only allocation
    explicit SpscRing(std::size_t capacity)
        : m_mask(std::bit_ceil(capacity < 2 ? std::size_t{2} : capacity) - 1)
        , m_items(std::make_unique<T[]>(m_mask + 1))
    {
    }

    /// Producer only. @return false if full; the value is dropped and counted.
    bool push(const T& item) noexcept PALPATE_NONBLOCKING
    {
        const std::size_t head = m_head.load(std::memory_order_relaxed);
        if (head - m_tailSeen > m_mask) {
            m_tailSeen = m_tail.load(std::memory_order_acquire);
            if (head - m_tailSeen > m_mask) {
                m_dropped.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
        }
        m_items[head & m_mask] = item;
        m_head.store(head + 1, std::memory_order_release);
        return true;
    }

    /// Consumer only. @return false if empty; `item` is then unchanged.
    bool pop(T& item) noexcept PALPATE_NONBLOCKING
    {
        const std::size_t tail = m_tail.load(std::memory_order_relaxed);
        if (tail == m_headSeen) {
            m_headSeen = m_head.load(std::memory_order_acquire);
            if (tail == m_headSeen) {
                return false;
            }
        }
        item = m_items[tail & m_mask];
        m_tail.store(tail + 1, std::memory_order_release);
        return true;
    }

    /// Number of dropped values since construction. Any thread.
    [[nodiscard]] std::uint64_t dropped() const noexcept { return m_dropped.load(std::memory_order_relaxed); }
    [[nodiscard]] std::size_t capacity() const noexcept { return m_mask + 1; }

  private:
    std::size_t m_mask;
    std::unique_ptr<T[]> m_items;
    alignas(64) std::atomic<std::size_t> m_head{0};
    std::size_t m_tailSeen = 0; // cached by the producer
    alignas(64) std::atomic<std::size_t> m_tail{0};
    std::size_t m_headSeen = 0; // cached by the consumer
    alignas(64) std::atomic<std::uint64_t> m_dropped{0};
};

} // namespace palpate::core
