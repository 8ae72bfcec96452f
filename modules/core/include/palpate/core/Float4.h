// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace palpate::core {

/// Four floats as a SIMD vector (compiler vector extension), bit-identical on every machine. Comparisons yield a Mask4.
typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Mask4 __attribute__((vector_size(16)));

inline Float4 load4(const float* p) noexcept
{
    Float4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

inline Float4 splat4(float x) noexcept
{
    return Float4{x, x, x, x};
}

inline Float4 absolute(Float4 v) noexcept
{
    Mask4 bits;
    std::memcpy(&bits, &v, sizeof bits);
    bits &= Mask4{0x7fffffff, 0x7fffffff, 0x7fffffff, 0x7fffffff};
    std::memcpy(&v, &bits, sizeof v);
    return v;
}

inline Float4 least(Float4 a, Float4 b) noexcept
{
    return a < b ? a : b;
}

inline Float4 greatest(Float4 a, Float4 b) noexcept
{
    return a > b ? a : b;
}

/// @return bit i is set if lane i is all ones.
inline std::uint32_t laneBits(Mask4 mask) noexcept
{
#if defined(__SSE2__)
    __m128 v;
    std::memcpy(&v, &mask, sizeof v);
    return static_cast<std::uint32_t>(_mm_movemask_ps(v));
#else
    return (mask[0] & 1u) | (mask[1] & 2u) | (mask[2] & 4u) | (mask[3] & 8u);
#endif
}

} // namespace palpate::core
