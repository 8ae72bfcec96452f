// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace palpate::haptics::internal {

/// What is left of the work that one tick may do, in units of about 10 ns on a processor of today: a bound on time by
/// counts and not by a clock, so that a replay is exact.
///
/// What is charged must not depend on what is held between ticks: two ways to the same answer are charged alike. A
/// sweep is therefore charged a fixed price that covers everything the facets around can cost, and beyond it only for
/// facets that a traversal visits beyond as many as can be held; a walk is charged for the moves that it makes.
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

/// The work of a tick, shared by its layers: what one leaves goes to the next, and each is sure of a little.
class SharedWork
{
  public:
    /// @param units  of the whole tick; the parts that layers are sure of may come on top
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

/// How a sweep of one straight move ended.
enum class Sweep : std::uint8_t
{
    Free,    ///< nothing blocks it
    Blocked, ///< by the first crossing
    Unknown, ///< the tick's work was spent before that was known: the move must not be made
};

} // namespace palpate::haptics::internal
