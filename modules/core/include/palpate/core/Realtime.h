// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that is safe on the servo thread: no allocation, lock, file or console I/O, exception, Qt or VTK
/// call. Verified by compilers with function effect analysis (clang >= 20, -fsanitize=realtime).
#if defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define PALPATE_NONBLOCKING [[clang::nonblocking]]
#endif
#endif
#ifndef PALPATE_NONBLOCKING
#define PALPATE_NONBLOCKING
#endif

/// Forces inlining of helpers on the per-tick path, so that splitting a function for readability costs nothing.
#define PALPATE_ALWAYS_INLINE inline __attribute__((always_inline))

namespace palpate::core {

/// Prefetches the memory at `p` without waiting. Never changes a result; `p` need not be readable.
inline void prefetch(const void* p) noexcept PALPATE_NONBLOCKING
{
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    (void)p;
#endif
}

} // namespace palpate::core
