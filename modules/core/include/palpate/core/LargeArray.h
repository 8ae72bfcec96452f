// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace palpate::core {

/// Allocator that requests huge pages for arrays spanning several of them: random access needs far fewer page walks,
/// and filling the array far fewer page faults.
template<class T>
struct LargeAllocator
{
    using value_type = T;

    LargeAllocator() = default;
    template<class U>
    LargeAllocator(const LargeAllocator<U>& /*other*/) noexcept
    {
    }

    /// @throws std::bad_alloc; a program without exceptions is aborted
    [[nodiscard]] T* allocate(std::size_t n)
    {
        const std::size_t bytes = n * sizeof(T); // no overflow: vectors limit n
        if (bytes < kLarge) {
            return static_cast<T*>(::operator new (bytes, std::align_val_t{alignof(T)}));
        }
        void* p = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
        if (p == nullptr) {
#if defined(__cpp_exceptions)
            throw std::bad_alloc();
#else
            std::abort();
#endif
        }
#if defined(__linux__)
        (void)::madvise(p, bytes, MADV_HUGEPAGE); // best effort: refusal only costs speed
#endif
        return static_cast<T*>(p);
    }
    void deallocate(T* p, std::size_t n) noexcept
    {
        if (n * sizeof(T) < kLarge) {
            ::operator delete (p, std::align_val_t{alignof(T)});
        } else {
            std::free(p);
        }
    }

    friend bool operator==(const LargeAllocator& /*a*/, const LargeAllocator& /*b*/) noexcept
    {
        return true;
    }
    /// Default-initialises elements, so that `resize` does not touch the memory of trivial types.
    template<class U>
    void construct(U* p) noexcept(std::is_nothrow_default_constructible_v<U>)
    {
        ::new (static_cast<void*>(p)) U;
    }
    template<class U, class... Arguments>
    void construct(U* p, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
    }

  private:
    static constexpr std::size_t kPage = std::size_t{2} << 20;
    static constexpr std::size_t kLarge =
        4 * kPage; // below this size, rounding up to whole pages would waste too much memory
};

template<class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

} // namespace palpate::core
