// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace palpate::test {

/// Counts calls that a real-time thread must not make. While an object lives: every malloc, calloc, realloc, aligned
/// allocation and free (and so every new, delete and throw), every lock of a mutex or read-write lock and wait on a
/// condition, and every opening, reading and writing of a file or the console, made by its thread through this
/// program's symbols. Interposes these functions in the test program.
class RealtimeGuard
{
  public:
    RealtimeGuard() noexcept;
    ~RealtimeGuard();
    RealtimeGuard(const RealtimeGuard&) = delete;
    RealtimeGuard& operator=(const RealtimeGuard&) = delete;

    /// Counts since construction.
    [[nodiscard]] std::uint64_t allocations() const noexcept;
    [[nodiscard]] std::uint64_t locks() const noexcept;
    [[nodiscard]] std::uint64_t files() const noexcept;
    [[nodiscard]] std::uint64_t all() const noexcept { return allocations() + locks() + files(); }

    /// Returns false under a sanitizer, which replaces these functions: nothing is counted then.
    [[nodiscard]] static bool isAvailable() noexcept;
};

} // namespace palpate::test
