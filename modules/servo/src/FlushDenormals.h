// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#elif defined(__aarch64__)
#include <cstdint>
#endif

namespace palpate::servo {

/// Scope guard that makes the calling thread treat denormal inputs and results as zero. No effect on processors without
/// support below.
/// @par Real-time Wait-free; about ten nanoseconds.
class FlushDenormals
{
  public:
#if defined(__SSE2__)
    FlushDenormals() noexcept PALPATE_NONBLOCKING : m_before(_mm_getcsr())
    {
        constexpr unsigned kFlushToZero = 0x8000;
        constexpr unsigned kDenormalsAreZero = 0x0040;
        _mm_setcsr(m_before | kFlushToZero | kDenormalsAreZero);
    }
    ~FlushDenormals()
    {
        _mm_setcsr(m_before);
    }
#elif defined(__aarch64__)
    FlushDenormals() noexcept PALPATE_NONBLOCKING
    {
        constexpr std::uint64_t kFlushToZero = std::uint64_t{1} << 24U;
        asm volatile("mrs %0, fpcr" : "=r"(m_before));
        asm volatile("msr fpcr, %0" : : "r"(m_before | kFlushToZero) : "memory");
    }
    ~FlushDenormals()
    {
        asm volatile("msr fpcr, %0" : : "r"(m_before) : "memory");
    }
#else
    FlushDenormals() noexcept = default;
    ~FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
#if defined(__SSE2__)
    unsigned m_before;
#elif defined(__aarch64__)
    std::uint64_t m_before = 0;
#endif
};

} // namespace palpate::servo
