// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function that the servo thread may call: no allocation, lock, file or console I/O, exception, Qt or VTK
/// call. Compilers that can check it (clang >= 20, -fsanitize=realtime) do.
#if defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define PALPATE_NONBLOCKING [[clang::nonblocking]]
#endif
#endif
#ifndef PALPATE_NONBLOCKING
#define PALPATE_NONBLOCKING
#endif

/// For the parts of a function that every tick runs: one function to a reader, one to the compiler.
#define PALPATE_ALWAYS_INLINE inline __attribute__((always_inline))

namespace palpate::core {

/// Asks for the memory at `p` without waiting for it. Never changes a result; `p` need not be readable.
inline void prefetch(const void* p) noexcept PALPATE_NONBLOCKING
{
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    (void)p;
#endif
}

} // namespace palpate::core
