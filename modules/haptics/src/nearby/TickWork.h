// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace palpate::haptics::internal {

/// Remaining work budget of a tick, in units of about 10 ns on a current processor. Time is bounded by counting work
/// instead of reading a clock, so that replays are exact.
///
/// Charges must not depend on data cached between ticks: two ways to the same answer have the same price. A sweep
/// therefore has a fixed price that covers all cached facets, plus a charge for the facets that a traversal visits
/// beyond a fixed allowance. A walk is charged by the moves that it makes.
class TickWork
{
  public:
    explicit TickWork(std::uint32_t units) noexcept
        : m_left(units)
    {
    }

    void spend(std::uint32_t units) noexcept { m_left -= std::min(units, m_left); }
    [[nodiscard]] std::uint32_t left() const noexcept { return m_left; }
    [[nodiscard]] bool isSpent() const noexcept { return m_left == 0; }

  private:
    std::uint32_t m_left;
};

/// Work budget of a tick, shared by its layers: each layer has a small guaranteed part, and unused work passes to the
/// next layer.
class SharedWork
{
  public:
    /// @param units  budget of the whole tick; the guaranteed parts may come on top
    explicit SharedWork(std::uint32_t units) noexcept
        : m_sure(units / kParts)
        , m_left(units)
    {
    }

    [[nodiscard]] std::uint32_t next() const noexcept { return std::max(m_left, m_sure); }
    void spend(std::uint32_t units) noexcept { m_left -= std::min(units, m_left); }

  private:
    static constexpr std::uint32_t kParts = 32;

    std::uint32_t m_sure, m_left;
};

/// Result of a sweep along one straight move.
enum class Sweep : std::uint8_t
{
    Free,    ///< not blocked
    Blocked, ///< blocked by the first crossing
    Unknown, ///< undecided, because the work was spent: the move must not be made
};

} // namespace palpate::haptics::internal
