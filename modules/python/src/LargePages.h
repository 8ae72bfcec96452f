// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace palpate::python {

inline constexpr std::size_t kLargePage_bytes = std::size_t{2} << 20;

/// Asks for pages of 2 MiB where memory was not used yet. On a virtual machine, the first use of a page of 4 KiB can
/// take 17 us, as long as many ticks.
inline void adviseLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef MADV_HUGEPAGE
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + kLargePage_bytes - 1) & ~(kLargePage_bytes - 1);
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kLargePage_bytes - 1);
    if (begin < end) {
        (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE); // only faster
    }
#endif
}

/// Allocator for containers of many megabytes.
template<class T>
struct LargePages
{
    using value_type = T;

    LargePages() = default;
    template<class U>
    LargePages(const LargePages<U>&) noexcept
    {
    }
    [[nodiscard]] T* allocate(std::size_t count)
    {
        T* const memory = std::allocator<T>().allocate(count); // which may have been used already
        adviseLargePages(memory, count * sizeof(T));
        return memory;
    }
    void deallocate(T* memory, std::size_t count) noexcept { std::allocator<T>().deallocate(memory, count); }
    friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

} // namespace palpate::python
