// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace palpate::device {

/// Byte copy of a T for SpscRing and TripleBuffer, which require trivially copyable types. Eigen 3.4 vectors have
/// user-provided copy constructors, so structs with a Vec3 do not qualify, although a byte copy is equivalent.
template<class T>
class PlainCopy
{
    static_assert(std::is_trivially_destructible_v<T>, "owns something: its bytes are not all of it");

  public:
    /// Holds a T{}. A bare Eigen vector is then uninitialised, so pass a value for such types.
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
