// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Float4.h>
#include <palpate/core/Realtime.h>

/// Function multiversioning for eight-lane functions: an additional AVX2 version, selected at program start. Disabled
/// under the sanitizers, which are not yet initialised at that time.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PALPATE_WIDE_LANES __attribute__((target_clones("avx2", "default")))
#else
#define PALPATE_WIDE_LANES
#endif

namespace palpate::haptics::internal {

/// Eight floats as a SIMD vector (compiler vector extension). Comparisons yield a Mask8. Use a scalar operand to
/// broadcast: a broadcast function would be compiled for narrow lanes.
typedef float Float8 __attribute__((vector_size(32)));
typedef std::int32_t Mask8 __attribute__((vector_size(32)));

/// @param p  aligned to 32 bytes
PALPATE_ALWAYS_INLINE Float8 load8(const float* p) noexcept
{
    return *reinterpret_cast<const Float8*>(p);
}

PALPATE_ALWAYS_INLINE void store8(float* p, Float8 v) noexcept
{
    *reinterpret_cast<Float8*>(p) = v;
}

PALPATE_ALWAYS_INLINE Float8 absolute(Float8 v) noexcept
{
    return reinterpret_cast<Float8>(reinterpret_cast<Mask8>(v) & 0x7fffffff);
}

PALPATE_ALWAYS_INLINE Float8 least(Float8 a, Float8 b) noexcept
{
    return a < b ? a : b;
}

PALPATE_ALWAYS_INLINE Float8 greatest(Float8 a, Float8 b) noexcept
{
    return a > b ? a : b;
}

/// @return bit i is set if lane i is all ones.
PALPATE_ALWAYS_INLINE std::uint32_t laneBits(Mask8 mask) noexcept
{
    core::Mask4 half[2];
    std::memcpy(half, &mask, sizeof half);
    return core::laneBits(half[0]) | core::laneBits(half[1]) << 4;
}

} // namespace palpate::haptics::internal
