// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace palpate::device {

/// Carries a T through SpscRing and TripleBuffer, which ask for trivially copyable types. Eigen 3.4 writes its vectors'
/// copy constructors out, so that structs with a Vec3 are not, though copying their bytes is all that those do.
template<class T>
class PlainCopy
{
    static_assert(std::is_trivially_destructible_v<T>, "owns something: its bytes are not all of it");

  public:
    /// Holds a T{}; of a bare Eigen vector that is whatever was in memory, so give one a value.
    PlainCopy() noexcept
        : PlainCopy(T{})
    {
    }
    PlainCopy(const T& value) noexcept { std::memcpy(m_bytes, static_cast<const void*>(&value), sizeof(T)); }

    [[nodiscard]] T get() const noexcept
    {
        T value;
        std::memcpy(static_cast<void*>(&value), m_bytes, sizeof(T));
        return value;
    }

  private:
    alignas(T) std::byte m_bytes[sizeof(T)];
};

} // namespace palpate::device
