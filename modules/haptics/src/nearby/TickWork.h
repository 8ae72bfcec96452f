// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics::internal {

/// What is left of the work that one tick may do, in units of about 10 ns on a processor of today: a bound on time by
/// counts and not by a clock, so that a replay is exact.
///
/// What is charged must not depend on what is held between ticks: two ways to the same answer are charged alike. A
/// sweep is therefore charged a fixed price that covers everything the facets around can cost, and beyond it only for
/// facets that a traversal visits beyond as many as can be held.
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

/// The work of a tick, dealt out to its layers one after the other: each is sure of an equal part of the half of it,
/// and what a layer leaves of the rest is for those that follow.
class SharedWork
{
  public:
    /// @param units  of the whole tick; @param layers  how many share them; a single one has them all
    SharedWork(std::uint32_t units, std::size_t layers) noexcept
        : m_left(units)
        , m_sure(layers > 1 ? units / (2 * static_cast<std::uint32_t>(layers)) : 0)
        , m_kept(layers > 1 ? m_sure * static_cast<std::uint32_t>(layers) : 0)
    {
    }

    /// @return how many units the next layer may spend
    [[nodiscard]] std::uint32_t next() noexcept
    {
        m_kept -= m_sure;
        return m_left - m_kept;
    }
    /// Tells what that layer has spent, at most what it was given.
    void spend(std::uint32_t units) noexcept { m_left -= units; }

  private:
    std::uint32_t m_left;
    std::uint32_t m_sure; ///< of each layer
    std::uint32_t m_kept; ///< for the layers to come
};

/// How a sweep of one straight move ended.
enum class Sweep : std::uint8_t
{
    Free,    ///< nothing blocks it
    Blocked, ///< by the first crossing
    Unknown, ///< the tick's work was spent before that was known: the move must not be made
};

} // namespace palpate::haptics::internal
